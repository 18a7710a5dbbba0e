#pragma once

#include <scatter/lab/output_folder.h>
#include <scatter/result.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace scatter::app {

/// What is drawn for each family of scenes.
struct FamilyArguments {
  std::vector<std::uint64_t> seeds{1};
  double scale = 1.0;
};

/// `arguments` and `scale` must outlive the parsing.
void addScaleArgument(CLI::App& command, double& scale);
void addFamilyArguments(CLI::App& command, FamilyArguments& arguments);

/// Refuses these options where no families are drawn; `asks` is what draws them.
[[nodiscard]] Result<void> checkFamilyArguments(const CLI::App& command, bool draws, const std::string& asks);

/// Writes a scene for each family and seed into an existing folder; their files. Fails on an unknown name.
[[nodiscard]] Result<std::vector<std::filesystem::path>> writeFamilies(
    const std::vector<std::string>& families, const FamilyArguments& arguments,
    const std::filesystem::path& folder);

/// If it is `asked` for, a folder for scenes; removed at its end.
[[nodiscard]] Result<std::optional<StagedFolder>> makeFamilyFolder(bool asked);

/// Of all families.
[[nodiscard]] std::vector<std::string> familyNames();

}  // namespace scatter::app
