#include <scatter/lab/hands.h>

#include "lab/play_scene.h"

#include <scatter/lab/selection.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace scatter {
namespace {

using test::object;
using test::play;
using testing::ElementsAre;
using testing::HasSubstr;

Vec3 centerOf(Experiment& experiment, const char* name) {
  return object(experiment, name).state().centerOfMass;
}

float meanDistance(Experiment& experiment, const Vec3& point) {
  float sum = 0.0F;
  float count = 0.0F;
  for (const auto& item : experiment.world().objects()) {
    if (item->def().motion != Motion::kDynamic) continue;
    sum += glm::distance(item->state().centerOfMass, point);
    count += 1.0F;
  }
  return sum / count;
}

TEST(Hands, PickTheFirstObjectOnTheRay) {
  const auto experiment = play(WorldKind::kStandard, false);
  const auto pick = experiment->hands().pick(Vec3(-20.0F, 0.6F, 0.0F), Vec3(20.0F, 0.6F, 0.0F));
  ASSERT_TRUE(pick);
  EXPECT_EQ(pick->object->name(), "crate-1");
  EXPECT_NEAR(pick->point.x, -0.45F, 0.06F);
  EXPECT_NEAR(pick->normal.x, -1.0F, 0.01F);
  EXPECT_FALSE(experiment->hands().pick(Vec3(-20.0F, 9.0F, 0.0F), Vec3(20.0F, 9.0F, 0.0F)));
}

// What a drag has to move, and by which point of it.
struct Dragged {
  const char* name;
  bool gravity;
  const char* body;
  Vec3 grip;  // from the centre
};

class HandsDrag : public testing::TestWithParam<Dragged> {};

TEST_P(HandsDrag, BringsTheGripToTheTargetAndKeepsItThere) {
  const auto& param = GetParam();
  const auto experiment = play(WorldKind::kHybrid, param.gravity);
  Hands& hands = experiment->hands();
  const BodyId body = object(*experiment, param.body).body();
  ASSERT_TRUE(hands.drag(body, centerOf(*experiment, param.body) + param.grip));
  EXPECT_EQ(hands.dragged(), body);
  const Vec3 target = hands.grip() + Vec3(-2.0F, 3.0F, 1.5F);
  hands.dragTo(target);
  const float distance = glm::distance(hands.grip(), target);
  float beyond = 0.0F;
  for (int frame = 0; frame < 180; ++frame) {
    test::run(*experiment, 1);
    const Vec3 way = target - (target - Vec3(-2.0F, 3.0F, 1.5F));
    beyond = std::max(beyond, glm::dot(hands.grip() - target, glm::normalize(way)));
  }
  EXPECT_LT(glm::distance(hands.grip(), target), 0.05F);
  EXPECT_LT(beyond, 0.1F * distance);
  EXPECT_LT(glm::length(object(*experiment, param.body).state().angularVelocity), 1.0F);
}

INSTANTIATE_TEST_SUITE_P(Cases, HandsDrag,
                         testing::Values(Dragged{"center_in_space", false, "crate-1", Vec3(0.0F)},
                                         Dragged{"corner_in_space", false, "crate-1", Vec3(0.45F)},
                                         Dragged{"corner_with_gravity", true, "crate-1", Vec3(0.45F)},
                                         Dragged{"end_of_plank", true, "plank", Vec3(0.95F, 0.0F, 0.0F)}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Hands, ADropKeepsTheVelocityAndEndsTheForce) {
  const auto experiment = play(WorldKind::kStandard, false);
  Hands& hands = experiment->hands();
  WorldObject& plank = object(*experiment, "plank");
  ASSERT_TRUE(hands.drag(plank.body(), plank.state().centerOfMass));
  hands.dragTo(Vec3(-4.0F, 5.0F, 0.0F));
  test::run(*experiment, 10);
  hands.drop();
  EXPECT_FALSE(hands.dragged());
  const Vec3 velocity = plank.state().linearVelocity;
  EXPECT_GT(velocity.y, 2.0F);
  test::run(*experiment, 30);
  EXPECT_NEAR(glm::distance(plank.state().linearVelocity, velocity), 0.0F, 1e-4F);
}

TEST(Hands, TellThePhysicsWhatTheyHold) {
  const auto experiment = play(WorldKind::kHybrid, true);
  const BodyId crate = object(*experiment, "crate-2").body();
  const auto held = [&] {
    Observation observed;
    experiment->world().physics().diagnostics().observe({.bodies = true, .pairs = false, .contacts = false},
                                                        observed);
    const auto found = std::find_if(observed.bodies.begin(), observed.bodies.end(),
                                    [crate](const ObservedBody& body) { return body.body == crate; });
    return found != observed.bodies.end() && found->held;
  };
  ASSERT_TRUE(experiment->hands().drag(crate, centerOf(*experiment, "crate-2")));
  EXPECT_TRUE(held());
  ASSERT_TRUE(experiment->hands().drag(object(*experiment, "plank").body(), centerOf(*experiment, "plank")));
  EXPECT_FALSE(held());
}

TEST(Hands, RefuseWhatCannotBeMoved) {
  const auto experiment = play(WorldKind::kStandard, true);
  Hands& hands = experiment->hands();
  const BodyId floor = object(*experiment, "floor").body();
  const BodyId nobody{12345};
  EXPECT_FALSE(hands.drag(floor, Vec3(0.0F)));
  EXPECT_FALSE(hands.drag(nobody, Vec3(0.0F)));
  EXPECT_FALSE(hands.push(floor, Vec3(1.0F), Vec3(0.0F)));
  EXPECT_FALSE(hands.remove(nobody));
  EXPECT_FALSE(hands.spawnLike(nobody, {}));
  EXPECT_FALSE(hands.throwLike(floor, Vec3(0.0F), Vec3(1.0F)));
  const BodyId crate = object(*experiment, "crate-1").body();
  EXPECT_FALSE(hands.throwLike(crate, Vec3(1.0F), Vec3(1.0F)));
  EXPECT_FALSE(hands.throwLike(crate, Vec3(0.0F), Vec3(1.0F), 0.0F));
  EXPECT_EQ(hands.freeze(std::array{floor, nobody}), 0U);
  hands.dragTo(Vec3(1.0F));
  hands.drop();
  hands.release();
  EXPECT_TRUE(hands.script().empty());
}

TEST(Hands, APushGivesItsImpulse) {
  const auto experiment = play(WorldKind::kStandard, false);
  WorldObject& crate = object(*experiment, "crate-1");
  ASSERT_TRUE(experiment->hands().push(crate.body(), Vec3(0.0F, 40.0F, 0.0F), crate.state().centerOfMass));
  test::run(*experiment, 1);
  // 40 N s on 20 kg.
  EXPECT_NEAR(crate.state().linearVelocity.y, 2.0F, 1e-4F);
}

class HandsThrow : public testing::TestWithParam<bool> {};

TEST_P(HandsThrow, GoesThroughThePoint) {
  const auto experiment = play(WorldKind::kHybrid, GetParam());
  const Vec3 through(2.0F, 3.0F, -6.0F);
  for (const auto& [from, speed] :
       {std::pair(Vec3(-8.0F, 6.0F, 14.0F), 12.0F), std::pair(Vec3(14.0F, 4.0F, 14.0F), 40.0F)}) {
    const auto thrown =
        experiment->hands().throwLike(object(*experiment, "crate-5").body(), from, through, speed);
    ASSERT_TRUE(thrown) << thrown.error().message;
    EXPECT_THAT((*thrown)->name(), HasSubstr("crate-5-copy-"));
    EXPECT_LT(glm::distance((*thrown)->state().centerOfMass, from), 1e-4F);
    float nearest = 1000.0F;
    Vec3 before = (*thrown)->state().centerOfMass;
    for (int frame = 0; frame < 240; ++frame) {
      test::run(*experiment, 1);
      const Vec3 now = (*thrown)->state().centerOfMass;
      const Vec3 way = now - before;
      const float share = std::clamp(glm::dot(through - before, way) / glm::dot(way, way), 0.0F, 1.0F);
      nearest = std::min(nearest, glm::distance(before + share * way, through));
      before = now;
    }
    EXPECT_LT(nearest, 0.02F);
    ASSERT_TRUE(experiment->hands().remove((*thrown)->body()));
  }
}

INSTANTIATE_TEST_SUITE_P(Gravity, HandsThrow, testing::Bool());

class HandsGather : public testing::TestWithParam<bool> {};

TEST_P(HandsGather, BringsEverythingTogetherAndLetsGo) {
  const auto experiment = play(WorldKind::kHybrid, GetParam());
  const Vec3 point(2.0F, 6.0F, 0.0F);
  test::run(*experiment, 60);
  const float before = meanDistance(*experiment, point);
  experiment->hands().gather(point);
  EXPECT_TRUE(experiment->hands().gathering());
  test::run(*experiment, 240);
  const float gathered = meanDistance(*experiment, point);
  EXPECT_LT(gathered, 1.3F);
  EXPECT_GT(before, 4.0F * gathered);
  experiment->hands().release();
  EXPECT_FALSE(experiment->hands().gathering());
  const Vec3 velocity = object(*experiment, "crate-1").state().linearVelocity;
  test::run(*experiment, 50);
  if (GetParam()) {
    EXPECT_GT(meanDistance(*experiment, point), gathered + 1.5F);
  } else {
    EXPECT_LT(glm::length(object(*experiment, "crate-1").state().linearVelocity - velocity), 1.0F);
  }
}

INSTANTIATE_TEST_SUITE_P(Gravity, HandsGather, testing::Bool());

TEST(Hands, GatherOnlyWhatIsChosen) {
  const auto experiment = play(WorldKind::kStandard, false);
  const Vec3 plank = centerOf(*experiment, "plank");
  experiment->hands().gather(Vec3(6.0F, 5.0F, 0.0F),
                             objectsNamedLike(experiment->world(), object(*experiment, "crate-1")));
  test::run(*experiment, 120);
  EXPECT_EQ(centerOf(*experiment, "plank"), plank);
  EXPECT_LT(glm::distance(centerOf(*experiment, "crate-1"), Vec3(6.0F, 5.0F, 0.0F)), 2.0F);
}

TEST(Hands, AHeldObjectMayBeDeletedByThemOrByOthers) {
  const auto experiment = play(WorldKind::kHybrid, true);
  Hands& hands = experiment->hands();
  for (const bool byOthers : {false, true}) {
    WorldObject& crate = object(*experiment, byOthers ? "crate-2" : "crate-1");
    ASSERT_TRUE(hands.drag(crate.body(), crate.state().centerOfMass));
    hands.gather(Vec3(0.0F, 3.0F, 0.0F));
    test::run(*experiment, 3);
    if (byOthers) {
      experiment->world().remove(crate);
    } else {
      ASSERT_TRUE(hands.remove(crate.body()));
    }
    EXPECT_FALSE(hands.dragged());
    hands.dragTo(Vec3(1.0F));
    test::run(*experiment, 3);
    hands.drop();
  }
  EXPECT_EQ(experiment->world().objects().size(), 5U);
}

TEST(Hands, SayWhatTheyAreAboutToDeleteAlsoAfterARestart) {
  std::vector<std::string> gone;
  ExperimentDef def{.run = test::playRun(WorldKind::kStandard, false)};
  def.hands.onRemove = [&gone](WorldObject& item) { gone.push_back(item.name()); };
  const auto experiment = test::makeExperiment(def);
  ASSERT_TRUE(experiment->hands().remove(object(*experiment, "plank").body()));
  ASSERT_TRUE(experiment->restart());
  ASSERT_TRUE(experiment->hands().remove(object(*experiment, "crate-2").body()));
  EXPECT_THAT(gone, ElementsAre("plank", "crate-2"));
}

TEST(Hands, WhatIsFrozenStaysUntilItThaws) {
  const auto experiment = play(WorldKind::kHybrid, true);
  Hands& hands = experiment->hands();
  const std::array crates{object(*experiment, "crate-1").body()};
  hands.gather(Vec3(0.0F, 6.0F, 0.0F));
  test::run(*experiment, 30);
  ASSERT_EQ(hands.freeze(crates), 1U);
  EXPECT_TRUE(hands.isFrozen(crates[0]));
  EXPECT_FALSE(hands.drag(crates[0], Vec3(0.0F)));
  const Vec3 place = centerOf(*experiment, "crate-1");
  EXPECT_GT(place.y, 1.0F);
  test::run(*experiment, 30);
  EXPECT_EQ(centerOf(*experiment, "crate-1"), place);
  hands.release();
  EXPECT_EQ(hands.thaw(crates), 1U);
  EXPECT_EQ(hands.thaw(crates), 0U);
  test::run(*experiment, 30);
  EXPECT_LT(centerOf(*experiment, "crate-1").y, place.y - 0.3F);
}

TEST(Hands, RequestsReachTheWorld) {
  RunOptions options = test::playRun(WorldKind::kHybrid, false);
  options.physics.switching.switching = Switching::kBody;
  const auto experiment = test::makeExperiment({.run = options});
  Hands& hands = experiment->hands();
  const WorldObject& crate = object(*experiment, "crate-2");
  const Physics& physics = experiment->world().physics();
  EXPECT_EQ(hands.requestLevel(std::array{crate.body()}, 1, Scope::kLocal), 1U);
  test::run(*experiment, 3);
  EXPECT_EQ(physics.switching().level(crate.body()), 1);
  EXPECT_EQ(physics.switching().level(object(*experiment, "crate-1").body()), 2);
  EXPECT_EQ(hands.requestLevel(objectsOfModel(experiment->world(), crate), 1, Scope::kGroup), 5U);
  test::run(*experiment, 3);
  EXPECT_EQ(physics.switching().level(object(*experiment, "crate-1").body()), 1);
  EXPECT_EQ(hands.requestLevel({}, 9, Scope::kGlobal), 0U);
  const auto kind = [&](LevelEventKind k) { return experiment->levelEvents()[static_cast<std::size_t>(k)]; };
  EXPECT_EQ(kind(LevelEventKind::kSwitched), 5U);
  hands.requestLevel({}, 2, Scope::kGlobal);
  hands.retract({});
  test::run(*experiment, 3);
  EXPECT_EQ(kind(LevelEventKind::kRetracted), 5U);
  EXPECT_EQ(physics.switching().level(crate.body()), 1);
}

// Uses every hand there is.
void playWithEverything(Experiment& experiment) {
  Hands& hands = experiment.hands();
  const BodyId first = object(experiment, "crate-1").body();
  const BodyId plank = object(experiment, "plank").body();
  ASSERT_TRUE(hands.drag(first, centerOf(experiment, "crate-1") + Vec3(0.3F)));
  for (int frame = 0; frame < 20; ++frame) {
    hands.dragTo(Vec3(0.1F * static_cast<float>(frame), 2.0F, 0.3F));
    test::run(experiment, 1);
  }
  hands.drop();
  ASSERT_TRUE(hands.push(plank, Vec3(3.0F, 2.0F, 1.0F), centerOf(experiment, "plank")));
  ASSERT_TRUE(hands.throwLike(first, Vec3(-3.0F, 4.0F, 9.0F), Vec3(6.0F, 0.5F, 0.0F)));
  const auto copy = hands.spawnLike(plank, {Vec3(3.0F, 5.0F, 0.0F), kNoRotation});
  ASSERT_TRUE(copy);
  hands.requestLevel({}, 1, Scope::kGlobal);
  test::run(experiment, 20);
  hands.gather(Vec3(3.0F, 4.0F, 0.0F));
  hands.freeze(std::array{object(experiment, "crate-4").body()});
  test::run(experiment, 40);
  hands.retract({});
  ASSERT_TRUE(hands.remove((*copy)->body()));
  hands.release();
  hands.thaw(std::array{object(experiment, "crate-4").body()});
  test::run(experiment, 40);
}

TEST(Hands, AScriptDoesTheSameAgain) {
  const auto experiment = play(WorldKind::kHybrid, true);
  playWithEverything(*experiment);
  const auto hashes = experiment->table().hashes("state_hash");
  const std::string text = experiment->hands().script().text();
  auto script = HandScript::parse(text, "recorded");
  ASSERT_TRUE(script) << script.error().message;
  ASSERT_TRUE(experiment->restart(std::move(*script)));
  test::run(*experiment, static_cast<int>(hashes.size()));
  EXPECT_EQ(experiment->scriptError(), "");
  EXPECT_EQ(experiment->table().hashes("state_hash"), hashes);
  EXPECT_EQ(experiment->hands().script().text(), text);
  ASSERT_TRUE(experiment->restart());
  test::run(*experiment, static_cast<int>(hashes.size()));
  EXPECT_NE(experiment->table().hashes("state_hash"), hashes);
}

TEST(Hands, AScriptThatDoesNotFitSaysSo) {
  const auto experiment = play(WorldKind::kStandard, false);
  HandScript script;
  script.add(2, DragAction{BodyId{99}, Vec3(0.0F)});
  script.add(3, RemoveAction{BodyId{98}});
  ASSERT_TRUE(experiment->restart(script));
  test::run(*experiment, 5);
  EXPECT_EQ(experiment->scriptError(),
            "frame 2: body 99 cannot be dragged; name a dynamic body that is there");
}

TEST(Selection, FindsNamesAndModels) {
  EXPECT_EQ(nameStem("crate-12"), "crate");
  EXPECT_EQ(nameStem("crate 1.2"), "crate 1");
  EXPECT_EQ(nameStem("12"), "12");
  EXPECT_EQ(nameStem("plank"), "plank");
  const auto experiment = play(WorldKind::kStandard, true);
  EXPECT_EQ(objectsNamedLike(experiment->world(), object(*experiment, "crate-3")).size(), 5U);
  EXPECT_EQ(objectsOfModel(experiment->world(), object(*experiment, "crate-3")).size(), 5U);
  const BodyId plank = object(*experiment, "plank").body();
  EXPECT_THAT(objectsOfModel(experiment->world(), object(*experiment, "plank")), ElementsAre(plank));
}

}  // namespace
}  // namespace scatter
