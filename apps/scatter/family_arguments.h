#pragma once

#include <scatter/result.h>

#include <cstdint>
#include <filesystem>
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

/// `arguments` must outlive the parsing.
void addFamilyArguments(CLI::App& command, FamilyArguments& arguments);

/// Writes a scene for each family and seed into an existing folder; their files. Fails on an unknown name.
[[nodiscard]] Result<std::vector<std::filesystem::path>> writeFamilies(
    const std::vector<std::string>& families, const FamilyArguments& arguments,
    const std::filesystem::path& folder);

/// Of all families.
[[nodiscard]] std::vector<std::string> familyNames();

}  // namespace scatter::app
