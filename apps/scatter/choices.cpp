#include "choices.h"

#include <scatter/bullet/bullet_physics.h>

namespace scatter::app {

const std::vector<WorldChoice>& worldChoices() {
  static const std::vector<WorldChoice> choices{
      {"hybrid", "switches levels, as the policy says", WorldKind::kHybrid},
      {"standard", "the plain engine, always at the finest level", WorldKind::kStandard},
      {"finest", "a hybrid world with the policy finest", WorldKind::kHybrid, Policy::kFinest},
      {"coarsest", "a hybrid world with the policy coarsest", WorldKind::kHybrid, Policy::kCoarsest},
      {"hybrid-bullet", "the world hybrid with Bullet's own collision", WorldKind::kHybrid, std::nullopt,
       Narrowphase::kEngine},
      {"finest-bullet", "the world finest with Bullet's own collision", WorldKind::kHybrid, Policy::kFinest,
       Narrowphase::kEngine},
  };
  return choices;
}

const std::vector<PolicyChoice>& policyChoices() {
  static const std::vector<PolicyChoice> choices{
      {"proximity", "coarser when others come near, finer when free", Policy::kProximity},
      {"finest", "everything at level n, always", Policy::kFinest},
      {"coarsest", "everything at level 1, always", Policy::kCoarsest},
      {"none", "only what the scene asks for", Policy::kNone},
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

const std::vector<EngineChoice>& engineChoices() {
  static const std::vector<EngineChoice> choices{
      {"bullet", makeBulletPhysics({})->engine(),
       [](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> { return makeBulletPhysics(def); }},
  };
  return choices;
}

const std::vector<SwitchingChoice>& switchingChoices() {
  static const std::vector<SwitchingChoice> choices{
      {"body", "a body has one level at a time, the same for all its neighbours"},
  };
  return choices;
}

}  // namespace scatter::app
