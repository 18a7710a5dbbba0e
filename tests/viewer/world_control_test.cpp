#include "viewer/world_control.h"

#include <gmock/gmock.h>
#include <scatter/bullet/bullet_physics.h>

#include <memory>
#include <optional>
#include <vector>

#include "viewer/body_looks.h"
#include "viewer/renderers.h"

namespace scatter::viewer {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A standard and a hybrid world of resting stacks, without a display.
class WorldControlTest : public testing::Test {
 protected:
  WorldControlTest() {
    add({.world = WorldKind::kStandard});
    add({.world = WorldKind::kHybrid});
    control_.emplace(panes_);
  }

  void add(const PhysicsDef& physics) {
    RunOptions options;
    options.scene = "quiet_hybrids";
    options.engine = [](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
      return makeBulletPhysics(def);
    };
    options.physics = physics;
    panes_.push_back(Pane::create(options, looks_).value());
  }

  void step(int steps) {
    for (int i = 0; i < steps; ++i) {
      for (const auto& pane : panes_) ASSERT_TRUE(pane->experiment().step().has_value());
    }
  }
  [[nodiscard]] const Physics& hybrid() const { return panes_.back()->experiment().world().physics(); }

  std::unique_ptr<Renderer> renderer_ = makeRenderer("null", {}).value();
  BodyLooks looks_{*renderer_};
  std::vector<std::unique_ptr<Pane>> panes_;
  std::optional<WorldControl> control_;
};

TEST_F(WorldControlTest, ABudgetHoldsFromTheNextStepOn) {
  step(5);
  EXPECT_EQ(hybrid().switching().budgetUnits().given, 0.0);
  control_->setBudgetMilliseconds(0.5);
  EXPECT_THAT(control_->message(), IsEmpty());
  step(3);
  EXPECT_GT(hybrid().switching().budgetUnits().given, 0.0);
  control_->setBudgetMilliseconds(0.0);
  step(3);
  EXPECT_EQ(hybrid().switching().budgetUnits().given, 0.0);
}

TEST_F(WorldControlTest, AWorldBesideOneWithABudgetStaysAsItIs) {
  PhysicsDef governed{.world = WorldKind::kHybrid};
  governed.switching.budget.units = 5000.0;
  add(governed);
  control_.emplace(panes_);
  EXPECT_EQ(control_->now().budget.units, 5000.0);
  control_->setBudgetMilliseconds(0.5);
  EXPECT_EQ(panes_[1]->experiment().options().physics.switching.budget.milliseconds, 0.0);
  EXPECT_EQ(panes_[2]->experiment().options().physics.switching.budget.milliseconds, 0.5);
}

TEST_F(WorldControlTest, PoliciesChangeWhatPairsMeetWith) {
  step(30);
  EXPECT_GT(hybrid().counters().finestPairs, 0U);
  control_->setPolicies(Policy::kCoarsest, {});
  step(60);
  EXPECT_GT(hybrid().counters().creditedPairs, 0U);
  control_->setPolicies(Policy::kNone, {"nonsense"});
  EXPECT_THAT(control_->message(), HasSubstr("nonsense"));
  EXPECT_EQ(control_->now().policy, Policy::kCoarsest);
}

TEST_F(WorldControlTest, SwitchingChangesAndOutlivesARestart) {
  step(5);
  control_->setSwitching(Switching::kBody);
  EXPECT_THAT(control_->message(), IsEmpty());
  EXPECT_EQ(control_->now().switching, Switching::kBody);
  control_->setBudgetMilliseconds(4.0);
  EXPECT_THAT(control_->message(), HasSubstr("pairs"));
  ASSERT_TRUE(panes_.back()->experiment().restart().has_value());
  EXPECT_EQ(panes_.back()->experiment().options().physics.switching.switching, Switching::kBody);
}

}  // namespace
}  // namespace scatter::viewer
