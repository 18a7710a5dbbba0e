#include <scatter/world/scene.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "choices.h"
#include "command.h"
#include "lod/policy_catalog.h"

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

// The parameters of a policy, each on a line of its own.
void printParameters(const lod::PolicyInfo& policy) {
  for (const lod::ParameterInfo& parameter : policy.parameters) {
    fmt::print("  {:<13}    {}={:g}{}{}: {}\n", "", parameter.name, parameter.standard,
               parameter.unit.empty() ? "" : " ", parameter.unit, parameter.meaning);
  }
}

void printPolicies() {
  fmt::print("\nPolicies of a hybrid world (--policy), one of\n");
  for (const PolicyChoice& choice : policyChoices()) {
    fmt::print("  {:<13}  {}\n", choice.name, choice.summary);
  }
  fmt::print("and with pair switching any of these, with parameters as in --policy speed:from=5,held\n");
  for (const lod::PolicyInfo& policy : lod::knownPolicies()) {
    fmt::print("  {:<13}  {} ({})\n", policy.name, policy.summary, lod::nameOf(policy.scope));
    printParameters(policy);
  }
}

void printScenes() {
  fmt::print("Scenes (frames of 1/60 s)\n");
  for (const auto& scene : SceneRegistry::instance().all()) {
    fmt::print("  {:<13}  {} ({} frames)\n", scene->name, scene->summary, scene->frames);
  }
}

ExitStatus list() {
  printScenes();
  printChoices("Worlds (--world)", worldChoices());
  printChoices("Switching modes of a hybrid world (--switching)", switchingChoices());
  printPolicies();
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
