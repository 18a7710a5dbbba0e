#pragma once

#include <scatter/lab/run.h>
#include <scatter/result.h>
#include <scatter/world/physics.h>

#include <optional>
#include <string>
#include <vector>

#include "unknown_name.h"

namespace scatter::app {

/// What the command line calls a world. A world may bring its switching mode, policy, narrowphase and solver
/// with it, how far contacts are recycled and how many the solver is shown.
struct WorldChoice {
  std::string name;
  std::string summary;
  WorldKind kind = WorldKind::kStandard;
  std::optional<Switching> switching{};
  std::optional<Policy> policy{};
  std::optional<Narrowphase> narrowphase{};
  std::optional<ContactSolver> solver{};
  float recycling = 0.0F;        ///< PairSteps::recycling, unless another one is asked for.
  int contactsPerDirection = 0;  ///< PhysicsDef::contactsPerDirection, likewise.
};

/// A policy that every switching mode has; pair switching has more, see lod::knownPolicies().
struct PolicyChoice {
  std::string name;
  std::string summary;
  Policy policy = Policy::kNone;
};

struct CollisionChoice {
  std::string name;
  std::string summary;
  Narrowphase narrowphase = Narrowphase::kScatter;
};

struct SolverChoice {
  std::string name;
  std::string summary;
  ContactSolver solver = ContactSolver::kEngine;
};

struct EngineChoice {
  std::string name;
  std::string summary;
  EngineFactory make;
};

struct SwitchingChoice {
  std::string name;
  std::string summary;
  Switching switching = Switching::kPair;
  Policy policy = Policy::kNone;  ///< Unless another one is asked for.
};

/// The first of each is the default; of policies, the switching mode's.
[[nodiscard]] const std::vector<WorldChoice>& worldChoices();
[[nodiscard]] const std::vector<PolicyChoice>& policyChoices();
[[nodiscard]] const std::vector<CollisionChoice>& collisionChoices();
[[nodiscard]] const std::vector<SolverChoice>& solverChoices();
[[nodiscard]] const std::vector<EngineChoice>& engineChoices();
[[nodiscard]] const std::vector<SwitchingChoice>& switchingChoices();

/// Such as "pair, body".
template <class Choice>
[[nodiscard]] std::string namesOf(const std::vector<Choice>& choices) {
  std::string names;
  for (const Choice& choice : choices) {
    names += (names.empty() ? "" : ", ") + choice.name;
  }
  return names;
}

/// The choice of that name. Fails with a line that lists the known ones and the nearest.
template <class Choice>
[[nodiscard]] Result<Choice> choose(const std::vector<Choice>& choices, const std::string& kind,
                                    const std::string& name) {
  std::vector<std::string> known;
  for (const Choice& choice : choices) {
    if (choice.name == name) {
      return choice;
    }
    known.push_back(choice.name);
  }
  return fail(unknownName(kind, name, known));
}

}  // namespace scatter::app
