#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <cstdint>

namespace scatter {

/// Pairs that went through the narrowphase.
struct PairCounts {
  std::uint32_t all = 0;
  std::uint32_t withHybrid = 0;
  std::uint32_t finest = 0;  ///< Both bodies at their finest level.
};

/// Bullet's dispatcher, which counts its pairs as the near callback of the report does (section 4.3.2), but
/// before they are dispatched: so pairs that are apart need not be. All objects of its world are
/// BulletBodies.
class BulletDispatcher final : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;

  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override;

  [[nodiscard]] const PairCounts& counts() const { return counts_; }
  void resetCounts() { counts_ = {}; }

 private:
  void count(const btBroadphasePair& pair);

  PairCounts counts_;
};

/// While it lives, counts the contact points added on all threads, through Bullet's global contact-added
/// callback, which it puts back afterwards.
///
/// Exact: the callback is also made when a point replaces one close by, but that keeps its age. A point
/// is new if its age is zero; it is then made one, so that a replacement in the same step is not counted
/// again. Nothing in Bullet reads the age.
class NewContactCounter {
 public:
  NewContactCounter();
  NewContactCounter(const NewContactCounter&) = delete;
  NewContactCounter& operator=(const NewContactCounter&) = delete;
  ~NewContactCounter();

  [[nodiscard]] static std::uint32_t count();

 private:
  ContactAddedCallback before_;
};

}  // namespace scatter
