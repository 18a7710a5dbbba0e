#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "PairTestWorld.h"

namespace scatter::test {
namespace {

constexpr float kDegree = 0.01745329F;

/// Two ships that overlap a little and turn together, as if they were one body.
class Spinning : public PairTestWorld {
 public:
  Spinning() {
    for (const float x : {0.0F, 1.75F}) ships.push_back(addBody(ship, at(x, 0)));
    btHybridCollisionInfo info = world.getCollisionInfo();
    info.m_steps.recycling = 0.001F;
    world.setCollisionInfo(info);
  }

  void turnTo(float angle) {
    ships[0]->setWorldTransform(at(0, angle));
    ships[1]->setWorldTransform(at(1.75F, angle));
    world.performDiscreteCollisionDetection();
    counts = world.getCollisionCounts();
  }

  using Normals = std::map<const btPersistentManifold*, std::vector<btVector3>>;
  [[nodiscard]] Normals normals() const {
    Normals all;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = manifoldAt(i);
      for (int k = 0; k < manifold.getNumContacts(); ++k)
        all[&manifold].push_back(manifold.getContactPoint(k).m_normalWorldOnB);
    }
    return all;
  }

  std::vector<btHybridRigidBody*> ships;
  btHybridCollisionCounts counts;

 private:
  static btTransform at(float x, float angle) {
    const btTransform turn(btQuaternion(btVector3(0, 0, 1), angle));
    return turn * btTransform(btQuaternion::getIdentity(), btVector3(x, 0, 0));
  }
};

bool differ(const Spinning::Normals& a, const Spinning::Normals& b) {
  if (a.size() != b.size()) return true;
  for (const auto& [manifold, normals] : a) {
    const auto found = b.find(manifold);
    if (found == b.end() || found->second.size() != normals.size()) return true;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (normals[i].x() != found->second[i].x() || normals[i].y() != found->second[i].y()) return true;
    }
  }
  return false;
}

TEST(Recycling, LeavesNormalsAsTheyWereFoundForADegree) {
  Spinning w;
  for (int i = 0; i < 4; ++i) w.turnTo(0);
  ASSERT_GT(w.counts.recycled, 0);
  Spinning::Normals found = w.normals();
  int looks = 0;
  int lastLook = 0;
  int recycled = 0;
  for (int step = 1; step <= 200; ++step) {
    w.turnTo(0.15F * kDegree * static_cast<float>(step));
    if (w.counts.gjkRuns + w.counts.detectorRuns == 0) {
      ++recycled;
      EXPECT_FALSE(differ(found, w.normals())) << "step " << step;
      EXPECT_LE(step - lastLook, 6) << "they have turned by more than a degree";
    } else {
      ++looks;
      lastLook = step;
      found = w.normals();
    }
  }
  EXPECT_GT(looks, 25);
  EXPECT_GT(recycled, 100);
}

}  // namespace
}  // namespace scatter::test
