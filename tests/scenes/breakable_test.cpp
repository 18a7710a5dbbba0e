#include "scenes/breakable.h"

#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/levels/containment.h>
#include <scatter/world/world.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "scenes/worlds.h"

namespace scatter::test {
namespace {

struct Kind {
  const char* name;
  Result<Breakable> (*make)(Random&);
  std::size_t middleParts;
  std::size_t finestParts;
  std::size_t gibs;
};

class EveryBreakable : public testing::TestWithParam<Kind> {
 protected:
  void SetUp() override {
    Random random(7);
    auto made = GetParam().make(random);
    ASSERT_TRUE(made) << made.error().message;
    object_ = *std::move(made);
  }

  Breakable object_;
};

TEST_P(EveryBreakable, HasItsLevelsAndGibs) {
  ASSERT_EQ(object_.whole->count(), 3);
  EXPECT_EQ(object_.whole->coarsest().parts.size(), 1U);
  EXPECT_EQ(object_.whole->level(2).parts.size(), GetParam().middleParts);
  EXPECT_EQ(object_.whole->finest().parts.size(), GetParam().finestParts);
  EXPECT_GT(object_.mass, 10.0F);
  ASSERT_EQ(object_.gibs.size(), GetParam().gibs);
  for (const auto& gib : object_.gibs) {
    ASSERT_EQ(gib->count(), 2);
    EXPECT_EQ(gib->coarsest().parts.size(), 1U);
    EXPECT_EQ(gib->finest().parts.size(), 2U);
  }
}

TEST_P(EveryBreakable, HoldsItsGibsAtEveryLevel) {
  for (const auto& gib : object_.gibs) {
    const auto gap = findContainmentGap(gib->coarsest(), object_.whole->finest(), gib->hullMargin());
    ASSERT_TRUE(gap) << gap.error().message;
    EXPECT_FALSE(*gap) << gib->name() << " sticks out by " << (*gap)->distance;
  }
}

TEST_P(EveryBreakable, HasGibsThatDoNotPushOneAnotherAtAnyLevel) {
  for (const WorldCase& kind : everyWorld()) {
    World world(makeBulletPhysics(kind.def));
    BodyDef def;
    def.mayRest = false;
    const BodyState still;
    for (BodyDef& gib : breakApart(object_, def, still, 0.0F)) ASSERT_TRUE(world.add(std::move(gib)));
    for (int i = 0; i < 30; ++i) world.step(1.0F / 60.0F);
    EXPECT_EQ(world.physics().maxPenetration(), 0.0) << kind.name;
    EXPECT_EQ(world.physics().kineticEnergy(), 0.0) << kind.name;
  }
}

/// Sums over bodies, about the world's origin.
struct Momenta {
  double mass = 0.0;
  glm::dvec3 linear{0.0};
  glm::dvec3 angular{0.0};

  void add(const LevelSet& levels, const BodyDef& def, const BodyState& state) {
    const auto m = static_cast<double>(def.mass);
    const glm::dvec3 velocity(state.linearVelocity);
    const glm::dmat3 turn = glm::mat3_cast(glm::dquat(state.pose.rotation));
    const glm::dmat3 inertia = turn * glm::dmat3(levels.mass().inertia) * glm::transpose(turn);
    mass += m;
    linear += m * velocity;
    angular += m * (inertia * glm::dvec3(state.angularVelocity) +
                    glm::cross(glm::dvec3(state.centerOfMass), velocity));
  }
};

TEST_P(EveryBreakable, KeepsMassAndMomentaWhenItBreaks) {
  Random random(5);
  BodyDef def;
  def.mass = object_.mass;
  BodyState state;
  state.pose = {5.0F * random.insideUnitBall(), random.orientation()};
  state.linearVelocity = 10.0F * random.insideUnitBall();
  state.angularVelocity = 5.0F * random.insideUnitBall();
  state.centerOfMass = state.pose(object_.whole->mass().centerOfMass);
  Momenta before;
  before.add(*object_.whole, def, state);
  for (const float burst : {0.0F, 3.0F}) {
    Momenta after;
    const auto gibs = breakApart(object_, def, state, burst);
    ASSERT_EQ(gibs.size(), object_.gibs.size());
    for (std::size_t i = 0; i < gibs.size(); ++i) {
      BodyState moving;
      moving.pose = gibs[i].pose;
      moving.linearVelocity = gibs[i].linearVelocity;
      moving.angularVelocity = gibs[i].angularVelocity;
      moving.centerOfMass = gibs[i].pose(object_.gibs[i]->mass().centerOfMass);
      after.add(*object_.gibs[i], gibs[i], moving);
    }
    EXPECT_NEAR(after.mass, before.mass, 1e-5 * before.mass);
    EXPECT_LT(glm::length(after.linear - before.linear), 1e-4 * glm::length(before.linear));
    EXPECT_LT(glm::length(after.angular - before.angular), 1e-4 * glm::length(before.angular));
  }
}

TEST_P(EveryBreakable, FliesApartOnlyWithABurst) {
  const BodyState still;
  for (const BodyDef& gib : breakApart(object_, BodyDef{}, still, 0.0F)) {
    EXPECT_EQ(glm::length(gib.linearVelocity), 0.0F);
  }
  float fastest = 0.0F;
  for (const BodyDef& gib : breakApart(object_, BodyDef{}, still, 2.0F)) {
    fastest = std::max(fastest, glm::length(gib.linearVelocity));
  }
  // The furthest gibs are about half a metre from the middle.
  EXPECT_GT(fastest, 0.6F);
  EXPECT_LT(fastest, 1.4F);
}

TEST_P(EveryBreakable, MultipliesThePairsByTheSquareOfGibsOverParts) {
  constexpr std::size_t kObjects = 16;
  const double ratio = static_cast<double>(GetParam().gibs) / static_cast<double>(GetParam().finestParts);
  const PrimitiveCount worst = countPrimitives(object_, kObjects, /*finestGibs=*/false);
  EXPECT_EQ(worst.whole, kObjects * GetParam().finestParts);
  EXPECT_EQ(worst.broken, kObjects * GetParam().gibs);
  EXPECT_NEAR(worst.pairGrowth(), ratio * ratio, 0.01 * ratio * ratio);
  // A gib has two parts at its finest level.
  const double finest = countPrimitives(object_, kObjects, /*finestGibs=*/true).pairGrowth();
  EXPECT_NEAR(finest, 4.0 * ratio * ratio, 0.04 * ratio * ratio);
  RecordProperty("pairGrowth", std::to_string(worst.pairGrowth()));
  RecordProperty("pairGrowthAtTheFinestLevel", std::to_string(finest));
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryBreakable,
                         testing::Values(Kind{"urn", makeUrn, 4, 25, 51},
                                         Kind{"box", makeBoardBox, 6, 12, 24}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(PairGrowth, IsThatOfTheReportsJug) {
  // Figure 3.2: 3 primitives become 7. Of ten jugs, 30 · 29 / 2 = 435 pairs become 70 · 69 / 2 = 2415.
  const PrimitiveCount jugs{30, 70};
  EXPECT_DOUBLE_EQ(jugs.pairGrowth(), 2415.0 / 435.0);
}

}  // namespace
}  // namespace scatter::test
