#include "family_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "interrupt.h"
#include "number_checks.h"
#include "scenes/families.h"
#include "unknown_name.h"

namespace scatter::app {

void addScaleArgument(CLI::App& command, double& scale) {
  command
      .add_option("--scale", scale, "Times the number of bodies and the area of terrains, from 0.001 to 10")
      ->check(CLI::Range(0.001, 10.0))
      ->type_name("X")
      ->capture_default_str();
}

void addFamilyArguments(CLI::App& command, FamilyArguments& arguments) {
  command.add_option("--seeds", arguments.seeds, "A scene of each family for each of these seeds")
      ->check(wholeNumber<std::uint64_t>(0))
      ->type_name("N,N")
      ->delimiter(',')
      ->capture_default_str();
  addScaleArgument(command, arguments.scale);
}

Result<void> checkFamilyArguments(const CLI::App& command, bool draws, const std::string& asks) {
  for (const char* option : {"--seeds", "--scale"}) {
    if (command.count(option) > 0 && !draws) {
      return fail(std::string(option) + " has no meaning here; it goes with " + asks);
    }
  }
  return {};
}

Result<std::optional<StagedFolder>> makeFamilyFolder(bool asked) {
  if (!asked) {
    return std::nullopt;
  }
  std::error_code error;
  const auto place = std::filesystem::temp_directory_path(error);
  if (error) {
    return fail("there is no folder for temporary files (" + error.message() + "); set TMPDIR");
  }
  return StagedFolder::create(place / "families").map([](StagedFolder folder) {
    return std::optional(std::move(folder));
  });
}

std::vector<std::string> familyNames() {
  std::vector<std::string> names;
  for (const FamilyInfo& family : sceneFamilies()) {
    names.push_back(family.name);
  }
  return names;
}

Result<std::vector<std::filesystem::path>> writeFamilies(const std::vector<std::string>& families,
                                                         const FamilyArguments& arguments,
                                                         const std::filesystem::path& folder) {
  const std::vector<std::string> known = familyNames();
  std::vector<std::filesystem::path> scenes;
  for (const std::string& family : families) {
    if (std::find(known.begin(), known.end(), family) == known.end()) {
      return fail(unknownName("family", family, known));
    }
  }
  for (const std::uint64_t seed : arguments.seeds) {
    for (const std::string& family : families) {
      throwIfInterrupted();
      auto scene = writeFamily(family, {.seed = seed, .scale = arguments.scale}, folder);
      if (!scene) {
        return tl::unexpected(scene.error());
      }
      scenes.push_back(std::move(*scene));
    }
  }
  return scenes;
}

}  // namespace scatter::app
