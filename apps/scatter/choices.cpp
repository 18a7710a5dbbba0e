#include "choices.h"

#include <scatter/bullet/bullet_physics.h>

namespace scatter::app {

const std::vector<WorldChoice>& worldChoices() {
  static const std::vector<WorldChoice> choices{
      {.name = "hybrid",
       .summary =
           "switches levels, as budget and policies say; hybrid@5ms and hybrid@3000units bring a budget",
       .kind = WorldKind::kHybrid},
      {.name = "standard", .summary = "the plain engine, always at the finest level"},
      {.name = "finest",
       .summary = "a hybrid world with the policy finest",
       .kind = WorldKind::kHybrid,
       .policy = Policy::kFinest},
      {.name = "recycled",
       .summary = "the world finest with contacts that move along with the bodies for a millimetre",
       .kind = WorldKind::kHybrid,
       .policy = Policy::kFinest,
       .recycling = kUsualRecycling},
      {.name = "wide",
       .summary = "the world finest with the solver wide",
       .kind = WorldKind::kHybrid,
       .policy = Policy::kFinest,
       .solver = ContactSolver::kWide},
      {.name = "lean",
       .summary = "the world finest with contacts recycled and reduced, and the solver wide",
       .kind = WorldKind::kHybrid,
       .policy = Policy::kFinest,
       .solver = ContactSolver::kWide,
       .recycling = kUsualRecycling,
       .contactsPerDirection = kUsualContactsPerDirection},
      {.name = "coarsest",
       .summary = "a hybrid world with the policy coarsest",
       .kind = WorldKind::kHybrid,
       .policy = Policy::kCoarsest},
      {.name = "hybrid-body",
       .summary = "a hybrid world that switches bodies, not pairs",
       .kind = WorldKind::kHybrid,
       .switching = Switching::kBody},
      {.name = "coarsest-body",
       .summary = "every body at level 1 from the start: the lowest cost there is",
       .kind = WorldKind::kHybrid,
       .switching = Switching::kBody,
       .policy = Policy::kCoarsest},
      {.name = "hybrid-bullet",
       .summary = "the world hybrid-body with Bullet's own collision",
       .kind = WorldKind::kHybrid,
       .switching = Switching::kBody,
       .narrowphase = Narrowphase::kEngine},
      {.name = "finest-bullet",
       .summary = "the world finest with Bullet's own collision",
       .kind = WorldKind::kHybrid,
       .switching = Switching::kBody,
       .policy = Policy::kFinest,
       .narrowphase = Narrowphase::kEngine},
  };
  return choices;
}

const std::vector<PolicyChoice>& policyChoices() {
  static const std::vector<PolicyChoice> choices{
      {"none", "only what the budget and the scene ask for; the default of pairs", Policy::kNone},
      {"proximity", "coarser when others come near, finer when free; the default of bodies",
       Policy::kProximity},
      {"finest", "everything at level n, always", Policy::kFinest},
      {"coarsest", "everything at level 1, always", Policy::kCoarsest},
  };
  return choices;
}

const std::vector<CollisionChoice>& collisionChoices() {
  static const std::vector<CollisionChoice> choices{
      {"scatter", "hybrid bodies meet by Scatter's pair algorithm", Narrowphase::kScatter},
      {"bullet", "all bodies meet by Bullet's own algorithms", Narrowphase::kEngine},
  };
  return choices;
}

const std::vector<SolverChoice>& solverChoices() {
  static const std::vector<SolverChoice> choices{
      {"bullet", "Bullet's solver, a contact at a time", ContactSolver::kEngine},
      {"wide", "the contacts of four pairs of bodies at a time", ContactSolver::kWide},
  };
  return choices;
}

const std::vector<EngineChoice>& engineChoices() {
  static const std::vector<EngineChoice> choices{
      {"bullet", makeBulletPhysics({})->engine(),
       [](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> { return makeBulletPhysics(def); }},
  };
  return choices;
}

const std::vector<SwitchingChoice>& switchingChoices() {
  static const std::vector<SwitchingChoice> choices{
      {"pair", "every pair of bodies has a level of its own", Switching::kPair, Policy::kNone},
      {"body", "a body has one level at a time, the same for all its neighbours", Switching::kBody,
       Policy::kProximity},
  };
  return choices;
}

}  // namespace scatter::app
