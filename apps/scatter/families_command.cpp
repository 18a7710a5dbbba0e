#include <scatter/lab/output_folder.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "family_arguments.h"
#include "lab/text.h"
#include "messages.h"
#include "scenes/families.h"

namespace scatter::app {

namespace {

struct FamiliesArguments {
  FamilyArguments families;
  std::vector<std::string> only;
  std::optional<std::string> out;
};

ExitStatus listFamilies() {
  std::string text = "Families of scenes\n";
  for (const FamilyInfo& family : sceneFamilies()) {
    text += fmt::format("  {:<15}  {}\n", family.name, family.summary);
  }
  fmt::print("{}", lab::fitTerminal(text));
  return ExitStatus::kOk;
}

ExitStatus writeScenes(const FamiliesArguments& arguments) {
  if (!arguments.out) {
    return listFamilies();
  }
  // Whole or not at all: what is there is moved into place when all of it is.
  auto folder = StagedFolder::create(*arguments.out);
  if (!folder) {
    return refuse(folder.error());
  }
  const auto names = arguments.only.empty() ? familyNames() : arguments.only;
  const auto scenes = writeFamilies(names, arguments.families, folder->path());
  if (!scenes) {
    return refuse(scenes.error());
  }
  if (auto moved = folder->commit(); !moved) {
    return refuse(moved.error());
  }
  for (const auto& scene : *scenes) {
    fmt::print("{}\n", (std::filesystem::path(*arguments.out) / scene.filename()).string());
  }
  return ExitStatus::kOk;
}

}  // namespace

Command addFamiliesCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "families", "Write scene files whose numbers are drawn from seeds, or list their families");
  auto arguments = std::make_shared<FamiliesArguments>();
  command
      ->add_option("--out", arguments->out,
                   "The folder for the scenes and their models; without it, the families are listed")
      ->type_name("DIR");
  command->add_option("--only", arguments->only, "These families [all]")
      ->type_name("NAME,NAME")
      ->delimiter(',');
  addFamilyArguments(*command, arguments->families);
  return {command, [arguments] { return writeScenes(*arguments); }};
}

}  // namespace scatter::app
