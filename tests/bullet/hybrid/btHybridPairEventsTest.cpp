#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "RandomShapes.h"
#include "ScriptedMotion.h"
#include "ScriptedWorld.h"
#include "trials.h"

// What a program may do to bodies and shapes between two steps.

namespace scatter::test {
namespace {

/// Four hybrids of two levels, an ordinary compound and a sphere, all in motion around one point.
class Crowd : public ScriptedWorld {
 public:
  explicit Crowd(std::uint64_t seed, bool pairAlgorithm = true) : ScriptedWorld(pairAlgorithm), shapes(seed) {
    world.getSwitchingInfo().m_safetyConditions = false;
    for (int i = 0; i < 6; ++i) {
      const auto motion = static_cast<Motion>(shapes.random.index(kMotions));
      motions_.emplace_back(motion, shapes.random, 1.0F, 0.7F, btVector3(0, 0, 0));
    }
    for (int i = 0; i < 4; ++i) {
      const btTransform pose = motions_[static_cast<std::size_t>(i)].next(shapes.random);
      btCompoundShape* fine = shapes.compound(12, 1);
      hybrids.push_back(addHybrid(shapes.twoLevels(shapes.boxesAround(*fine), fine), pose));
    }
    partner = shapes.compound(8, 1);
    addOther(1, partner, motions_[4].next(shapes.random));
    addOther(1, shapes.make<btSphereShape>(0.4F), motions_[5].next(shapes.random));
  }

  void moveAll() {
    for (int i = 0; i < 6; ++i) place(i, motions_[static_cast<std::size_t>(i)].next(shapes.random));
  }

  /// Bullet's own algorithms keep manifolds with the contact breaking threshold of the shape as it was.
  void noteResize(btRigidBody* of) {
    if (!world.getCollisionInfo().m_pairAlgorithm) cleanPairs(of);
  }

  btRigidBody* body(int i) { return bodies[static_cast<std::size_t>(i)].get(); }
  bool isIn(int i) { return body(i)->getBroadphaseHandle() != nullptr; }

  void cleanPairs(btRigidBody* of) {
    if (of->getBroadphaseHandle() == nullptr) return;
    broadphase.getOverlappingPairCache()->cleanProxyFromPairs(of->getBroadphaseHandle(), &dispatcher);
  }

  RandomShapes shapes;
  std::vector<btHybridRigidBody*> hybrids;
  btCompoundShape* partner;

 private:
  std::vector<ScriptedMotion> motions_;
};

/// Does something to the crowd every few steps and verifies every step; Bullet's own algorithms must pass as
/// well.
void verifyWith(const char* what, const std::function<void(Crowd&, int)>& event, long leastExpected = 300) {
  for (const std::uint64_t seed : seeds(100, 5)) {
    for (const bool pairAlgorithm : {true, false}) {
      Crowd w(seed, pairAlgorithm);
      const std::string where = std::string(what) + ", seed " + std::to_string(seed) + ", pair algorithm " +
                                std::to_string(static_cast<int>(pairAlgorithm));
      for (int step = 0; step < 60; ++step) {
        w.moveAll();
        event(w, step);
        w.detect();
        ASSERT_EQ(w.report().m_missed, 0) << where << ", step " << step;
      }
      EXPECT_GT(w.report().m_expected, leastExpected) << where;
      EXPECT_LE(w.report().m_extra * 100, w.report().m_expected + 100) << where;
    }
  }
}

class PairEvents : public InBothModes {};
INSTANTIATE_TEST_SUITE_P(Modes, PairEvents, bothModes(), nameOfMode);

TEST_P(PairEvents, BodiesAreRemovedAndInsertedAgain) {
  verifyWith(
      "removal",
      [](Crowd& w, int step) {
        if (step % 3 != 0) return;
        const int body = w.shapes.random.index(6);
        if (w.isIn(body)) {
          w.world.removeRigidBody(w.body(body));
        } else {
          w.world.addRigidBody(w.body(body));
        }
        if (step % 6 == 0 && !w.isIn(body)) w.world.addRigidBody(w.body(body));
      },
      50);
}

TEST_P(PairEvents, ShapesAreReplaced) {
  verifyWith("another shape", [](Crowd& w, int step) {
    if (step % 4 != 0) return;
    btRigidBody* body = w.body(4 + w.shapes.random.index(2));
    body->setCollisionShape(w.shapes.random.chance(0.5F) ? static_cast<btCollisionShape*>(w.shapes.compound(
                                                               1 + w.shapes.random.index(9), 1))
                                                         : w.shapes.convex(1));
    w.cleanPairs(body);
  });
}

TEST_P(PairEvents, APartnerIsScaled) {
  verifyWith("scaling", [](Crowd& w, int step) {
    if (step % 5 != 0) return;
    const float scale = w.shapes.random.between(0.5F, 1.5F);
    w.partner->setLocalScaling(btVector3(scale, scale, scale));
    w.noteResize(w.body(4));
  });
}

TEST_P(PairEvents, AHybridsLevelIsScaled) {
  verifyWith("scaling a hybrid", [](Crowd& w, int step) {
    if (step % 9 != 0) return;
    const float scale = w.shapes.random.between(0.7F, 1.3F);
    w.hybrids[0]->getCollisionShape()->setLocalScaling(btVector3(scale, scale, scale));
    w.cleanPairs(w.hybrids[0]);
  });
}

TEST_P(PairEvents, APartnersChildrenMoveComeAndGo) {
  verifyWith("children", [](Crowd& w, int step) {
    Random& random = w.shapes.random;
    if (step % 2 == 0)
      w.partner->updateChildTransform(random.index(w.partner->getNumChildShapes()), random.pose(0.4F));
    if (step % 5 == 1) w.partner->addChildShape(random.pose(0.3F), w.shapes.convex(0.4F));
    if (step % 5 == 3 && w.partner->getNumChildShapes() > 2) {
      w.partner->removeChildShapeByIndex(random.index(w.partner->getNumChildShapes()));
    }
    w.noteResize(w.body(4));
  });
}

TEST_P(PairEvents, APartnerLosesAllItsChildren) {
  verifyWith(
      "no children",
      [](Crowd& w, int step) {
        if (step == 20) {
          while (w.partner->getNumChildShapes() > 0) w.partner->removeChildShapeByIndex(0);
        }
        if (step == 40) w.partner->addChildShape(btTransform::getIdentity(), w.shapes.convex(1));
      },
      100);
}

// What is expected of a pair at a coarser level is known in body switching only: there the level is the
// shape.
class PairEventsByBodies : public PairEvents {};
INSTANTIATE_TEST_SUITE_P(Modes, PairEventsByBodies, testing::Values(BT_HYBRID_BODY_SWITCHING), nameOfMode);

TEST_P(PairEventsByBodies, LevelsAreSwitched) {
  verifyWith("levels", [](Crowd& w, int step) {
    if (step % 3 != 0) return;
    btHybridRigidBody* body = w.hybrids[static_cast<std::size_t>(w.shapes.random.index(4))];
    ASSERT_TRUE(w.world.requestLevel(body, 3 - body->getLevel()));
  });
}

TEST_P(PairEvents, BodiesFallAsleepAndWakeUp) {
  verifyWith(
      "sleep",
      [](Crowd& w, int step) {
        for (int i = 0; i < 6; ++i) {
          w.body(i)->forceActivationState(w.shapes.random.chance(0.5F) ? ISLAND_SLEEPING : ACTIVE_TAG);
        }
        if (step % 10 == 0) {
          for (int i = 0; i < 6; ++i) w.body(i)->forceActivationState(ISLAND_SLEEPING);
        }
      },
      100);
}

TEST_P(PairEvents, SleepingBodiesAreMoved) {
  Crowd w(7);
  for (int step = 0; step < 60; ++step) {
    // Nothing looks at the pairs while they sleep and move.
    const int state = step % 4 == 3 ? ACTIVE_TAG : ISLAND_SLEEPING;
    for (int i = 0; i < 6; ++i) w.body(i)->forceActivationState(state);
    w.moveAll();
    w.detect();
    ASSERT_EQ(w.report().m_missed, 0) << "step " << step;
  }
  EXPECT_GT(w.report().m_expected, 50);
}

TEST_P(PairEvents, FiltersChange) {
  verifyWith(
      "filters",
      [](Crowd& w, int step) {
        Random& random = w.shapes.random;
        const int a = random.index(6);
        const int b = (a + 1 + random.index(5)) % 6;
        w.body(a)->setIgnoreCollisionCheck(w.body(b), step % 2 == 0);
        w.body(b)->setIgnoreCollisionCheck(w.body(a), step % 2 == 0);
        if (step % 7 == 0) {
          btBroadphaseProxy* proxy = w.body(a)->getBroadphaseHandle();
          proxy->m_collisionFilterMask = step % 2 == 0 ? 0 : btBroadphaseProxy::AllFilter;
          w.world.refreshBroadphaseProxy(w.body(a));
        }
      },
      50);
}

TEST_P(PairEvents, FlagsChange) {
  verifyWith(
      "sensors and kinematic bodies",
      [](Crowd& w, int step) {
        const int flags[] = {0, btCollisionObject::CF_NO_CONTACT_RESPONSE,
                             btCollisionObject::CF_KINEMATIC_OBJECT,
                             btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK};
        w.body(step % 5)->setCollisionFlags(flags[w.shapes.random.index(4)]);
      },
      100);
}

TEST_P(PairEvents, MarginsChange) {
  verifyWith("margins", [](Crowd& w, int step) {
    if (step % 4 != 0) return;
    auto* part = static_cast<btConvexShape*>(w.partner->getChildShape(0));
    if (part->getShapeType() == SPHERE_SHAPE_PROXYTYPE || part->getShapeType() == CAPSULE_SHAPE_PROXYTYPE)
      return;
    part->setMargin(w.shapes.random.between(0, 0.1F));
    w.partner->updateChildTransform(0, w.partner->getChildTransform(0));
    w.noteResize(w.body(4));
  });
}

TEST_P(PairEvents, TheBreakingThresholdChanges) {
  const float before = gContactBreakingThreshold;
  verifyWith("threshold", [](Crowd& w, int step) {
    gContactBreakingThreshold = step % 20 < 10 ? 0.02F : 0.05F;
    if (step % 10 == 0) w.world.setCollisionInfo(w.world.getCollisionInfo());
  });
  gContactBreakingThreshold = before;
}

std::vector<PairSteps> stepVariants() {
  std::vector<PairSteps> result(1);
  bool PairSteps::*const switches[] = {&PairSteps::motionBound, &PairSteps::cachedAxis,
                                       &PairSteps::lazyManifolds, &PairSteps::ownGjk,
                                       &PairSteps::warmSimplex};
  for (const btHybridMidphase midphase :
       {BT_HYBRID_WORLD_BOXES, BT_HYBRID_PART_BOXES, BT_HYBRID_NEIGHBOUR_LIST}) {
    PairSteps bare;
    bare.midphase = midphase;
    for (const auto one : switches) {
      PairSteps without;
      without.midphase = midphase;
      without.*one = false;
      result.push_back(without);
      bare.*one = false;
    }
    result.push_back(bare);
    // Under sanitizers each step has been with others and been left out by now.
    if (kSanitized) continue;
    for (const auto one : switches) {
      PairSteps only = bare;
      only.*one = true;
      result.push_back(only);
    }
  }
  return result;
}

std::vector<btHybridCollisionInfo> variants() {
  std::vector<btHybridCollisionInfo> result;
  for (const PairSteps& steps : stepVariants()) {
    result.emplace_back();
    result.back().m_steps = steps;
  }
  return result;
}

TEST_P(PairEvents, EveryCombinationOfStepsFindsTheContacts) {
  for (const btHybridCollisionInfo& info : variants()) {
    Crowd w(11);
    w.world.setCollisionInfo(info);
    for (int step = 0; step < trials(60); ++step) {
      w.moveAll();
      w.detect();
    }
    EXPECT_EQ(w.report().m_missed, 0)
        << "midphase " << static_cast<int>(info.m_steps.midphase) << " motion " << info.m_steps.motionBound
        << " axis " << info.m_steps.cachedAxis << " lazy " << info.m_steps.lazyManifolds << " gjk "
        << info.m_steps.ownGjk << " warm " << info.m_steps.warmSimplex;
    EXPECT_GT(w.report().m_expected, trials(300));
    EXPECT_LE(w.report().m_extra * 100, w.report().m_expected);
  }
}

TEST_P(PairEvents, StepsAreTurnedOnAndOffInMidRun) {
  const std::vector<btHybridCollisionInfo> all = variants();
  verifyWith("settings", [&all](Crowd& w, int step) {
    if (step % 3 != 0) return;
    btHybridCollisionInfo info =
        all[static_cast<std::size_t>(w.shapes.random.index(static_cast<int>(all.size())))];
    info.m_pairAlgorithm = w.shapes.random.chance(0.8F);
    w.world.setCollisionInfo(info);
  });
}

/// The child pairs in contact, but for those so near the threshold that rounding decides.
std::set<ChildPair> clearContacts(ScriptedWorld& w) {
  std::set<ChildPair> result;
  for (const auto& [pair, contact] : w.contacts()) {
    if (contact.distance < 0.99F * contact.threshold) result.insert(pair);
  }
  return result;
}

struct Difference {
  long all = 0;
  long different = 0;
};

/// Contacts that one of two worlds has clearly and the other one lacks.
void compareContacts(ScriptedWorld& one, ScriptedWorld& other, Difference& difference) {
  ScriptedWorld* const worlds[] = {&one, &other};
  for (int k = 0; k < 2; ++k) {
    const std::map<ChildPair, ChildContact> there = worlds[1 - k]->contacts();
    for (const ChildPair& pair : clearContacts(*worlds[k])) {
      ++difference.all;
      difference.different += there.count(pair) == 0 ? 1 : 0;
    }
  }
}

TEST_P(PairEvents, EveryCombinationOfStepsHasTheSameContacts) {
  std::vector<std::unique_ptr<Crowd>> worlds;
  for (const btHybridCollisionInfo& info : variants()) {
    worlds.push_back(std::make_unique<Crowd>(12));
    worlds.back()->world.verifyContacts(0);
    worlds.back()->world.setCollisionInfo(info);
  }
  // Bullet's GJK, in the place of ours, misses a contact of two hulls now and then: the variants that use it
  // are compared with each other, and with ours but for one contact in a thousand.
  const auto usesOurs = [&worlds](std::size_t i) {
    return worlds[i]->world.getCollisionInfo().m_steps.ownGjk;
  };
  std::size_t firstOfBullets = 0;
  while (usesOurs(firstOfBullets)) ++firstOfBullets;
  Difference alike;
  Difference detectors;
  for (int step = 0; step < trials(60); ++step) {
    for (auto& w : worlds) {
      w->moveAll();
      w->detect();
    }
    for (std::size_t i = 1; i < worlds.size(); ++i) {
      compareContacts(*worlds[usesOurs(i) ? 0 : firstOfBullets], *worlds[i], alike);
    }
    compareContacts(*worlds[0], *worlds[firstOfBullets], detectors);
  }
  EXPECT_GT(alike.all, kSanitized ? 1000 : 10000);
  EXPECT_EQ(alike.different, 0) << "of " << alike.all;
  EXPECT_LE(detectors.different * 1000, detectors.all);
}

TEST_P(PairEvents, EverythingAtOnce) {
  for (const std::uint64_t seed : seeds(200, 6)) {
    Crowd w(seed);
    const std::vector<btHybridCollisionInfo> all = variants();
    for (int step = 0; step < 120; ++step) {
      Random& random = w.shapes.random;
      w.moveAll();
      const int body = random.index(6);
      switch (random.index(7)) {
        case 0:
          if (w.isIn(body)) {
            w.world.removeRigidBody(w.body(body));
          } else {
            w.world.addRigidBody(w.body(body));
          }
          break;
        case 1:
          w.partner->updateChildTransform(random.index(w.partner->getNumChildShapes()), random.pose(0.4F));
          break;
        case 2:
          if (w.partner->getNumChildShapes() > 3) w.partner->removeChildShapeByIndex(random.index(3));
          w.partner->addChildShape(random.pose(0.3F), w.shapes.convex(0.4F));
          break;
        case 3:
          if (body < 4 && w.isIn(body) && GetParam() == BT_HYBRID_BODY_SWITCHING)
            w.world.requestLevel(w.hybrids[static_cast<std::size_t>(body)], 1 + random.index(2));
          break;
        case 4:
          w.world.setCollisionInfo(all[static_cast<std::size_t>(random.index(static_cast<int>(all.size())))]);
          break;
        case 5:
          w.body(body)->forceActivationState(random.chance(0.5F) ? ISLAND_SLEEPING : ACTIVE_TAG);
          break;
        default:
          break;
      }
      w.detect();
      ASSERT_EQ(w.report().m_missed, 0) << "seed " << seed << ", step " << step;
    }
    EXPECT_GT(w.report().m_expected, 100) << "seed " << seed;
  }
}

}  // namespace
}  // namespace scatter::test
