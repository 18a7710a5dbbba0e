#include <scatter/world/scene.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>

#include "choices.h"
#include "command.h"
#include "lab/text.h"
#include "lod/policy_catalog.h"

namespace scatter::app {

namespace {

template <class Choice>
std::string describeChoices(const char* heading, const std::vector<Choice>& choices) {
  std::string text = fmt::format("\n{}\n", heading);
  for (const Choice& choice : choices) {
    text += fmt::format("  {:<13}  {}{}\n", choice.name, choice.summary,
                        &choice == &choices.front() && choices.size() > 1 ? " (default)" : "");
  }
  return text;
}

// The parameters of a policy, each on a line of its own.
std::string describeParameters(const lod::PolicyInfo& policy) {
  std::string text;
  for (const lod::ParameterInfo& parameter : policy.parameters) {
    text += fmt::format("  {:<13}  {}={:g}{}{}:  {}\n", "", parameter.name, parameter.standard,
                        parameter.unit.empty() ? "" : " ", parameter.unit, parameter.meaning);
  }
  return text;
}

std::string describePolicies() {
  std::string text = "\nPolicies of a hybrid world (--policy), one of\n";
  for (const PolicyChoice& choice : policyChoices()) {
    text += fmt::format("  {:<13}  {}\n", choice.name, choice.summary);
  }
  text += "and with pair switching any of these, with parameters as in --policy speed:from=5,held\n";
  for (const lod::PolicyInfo& policy : lod::knownPolicies()) {
    text += fmt::format("  {:<13}  {} ({})\n", policy.name, policy.summary, nameOf(policy.scope)) +
            describeParameters(policy);
  }
  return text;
}

std::string describeScenes() {
  std::string text = "Scenes (frames of 1/60 s)\n";
  for (const auto& scene : SceneRegistry::instance().all()) {
    text += fmt::format("  {:<13}  {} ({} frames)\n", scene->name, scene->summary, scene->frames);
  }
  return text;
}

ExitStatus list() {
  const std::string text =
      describeScenes() + describeChoices("Worlds (--world)", worldChoices()) +
      describeChoices("Switching modes of a hybrid world (--switching)", switchingChoices()) +
      describePolicies() +
      describeChoices("Collision of hybrid bodies in a hybrid world (--collision)", collisionChoices()) +
      describeChoices("Solver of contacts (--solver)", solverChoices()) +
      describeChoices("Engines (--engine)", engineChoices());
  fmt::print("{}", lab::fitTerminal(text));
  return ExitStatus::kOk;
}

}  // namespace

Command addListCommand(CLI::App& program) {
  return {program.add_subcommand(
              "list", "Show the scenes, worlds, policies, switching modes, collision algorithms and engines"),
          list};
}

}  // namespace scatter::app
