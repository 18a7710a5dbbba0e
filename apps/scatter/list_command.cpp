#include <scatter/world/scene.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "choices.h"
#include "command.h"

namespace scatter::app {

namespace {

template <class Choice>
void printChoices(const char* heading, const std::vector<Choice>& choices) {
  fmt::print("\n{}\n", heading);
  for (const Choice& choice : choices) {
    fmt::print("  {:<13}  {}{}\n", choice.name, choice.summary,
               &choice == &choices.front() && choices.size() > 1 ? " (default)" : "");
  }
}

void printScenes() {
  fmt::print("Scenes (frames of 1/60 s)\n");
  for (const SceneInfo* scene : SceneRegistry::instance().all()) {
    fmt::print("  {:<13}  {} ({} frames)\n", scene->name, scene->summary, scene->frames);
  }
}

ExitStatus list() {
  printScenes();
  printChoices("Worlds (--world)", worldChoices());
  printChoices("Policies of a hybrid world (--policy)", policyChoices());
  printChoices("Switching modes of a hybrid world (--switching)", switchingChoices());
  printChoices("Collision of hybrid bodies in a hybrid world (--collision)", collisionChoices());
  printChoices("Engines (--engine)", engineChoices());
  return ExitStatus::kOk;
}

}  // namespace

Command addListCommand(CLI::App& program) {
  return {program.add_subcommand(
              "list", "Show the scenes, worlds, policies, switching modes, collision algorithms and engines"),
          list};
}

}  // namespace scatter::app
