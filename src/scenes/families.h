#pragma once

#include <scatter/result.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scatter {

/// Scenes of one kind whose numbers are drawn from a seed.
struct FamilyInfo {
  std::string name{};
  std::string summary{};  ///< One line.
};

/// In the order in which they are listed and measured.
[[nodiscard]] const std::vector<FamilyInfo>& sceneFamilies();

struct FamilyOptions {
  std::uint64_t seed = 1;  ///< Of everything that is drawn, the scene's own seed too.

  /// Times the number of bodies and, down to 40 m a side, the area of terrains; above 0, at most 10.
  double scale = 1.0;
};

/// Writes FAMILY-SEED.toml into an existing folder, and its models and meshes into the folder FAMILY-SEED
/// below it. The same options give the same bytes. Returns the scene file; fails on an unknown family, a
/// scale that is out of range, and a file that cannot be written, and then leaves what was written before it.
[[nodiscard]] Result<std::filesystem::path> writeFamily(std::string_view family, const FamilyOptions& options,
                                                        const std::filesystem::path& folder);

}  // namespace scatter
