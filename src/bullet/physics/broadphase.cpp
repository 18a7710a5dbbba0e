#include "bullet/physics/broadphase.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <algorithm>
#include <cstdlib>

namespace scatter {

namespace {

/// Takes out `count` leaves, spread over the tree, and inserts them where they now fit best.
void reinsertLeaves(btDbvt& tree, int count) {
  if (tree.m_root == nullptr) return;
  for (int i = 0; i < count; ++i) {
    btDbvtNode* node = tree.m_root;
    for (unsigned bit = 0; node->isinternal(); bit = (bit + 1) % 32) {
      node = node->childs[(tree.m_opath >> bit) & 1U];
    }
    tree.update(node);
    ++tree.m_opath;
  }
}

/// While it lives, btDbvtBroadphase::collide() works out that no leaves of this tree are to be optimised:
/// 1 + leaves * share / 100 = 0. It uses the number of leaves for nothing else.
class NoIncrementalOptimisation {
 public:
  NoIncrementalOptimisation(btDbvt& tree, int& share) : tree_(tree), share_(share) {
    std::swap(tree_.m_leaves, leaves_);
    std::swap(share_, otherShare_);
  }
  NoIncrementalOptimisation(const NoIncrementalOptimisation&) = delete;
  NoIncrementalOptimisation& operator=(const NoIncrementalOptimisation&) = delete;
  ~NoIncrementalOptimisation() {
    // Leaves that moved between the trees meanwhile have been counted.
    tree_.m_leaves += leaves_ - kLeaves;
    share_ = otherShare_;
  }

 private:
  static constexpr int kLeaves = 100;
  btDbvt& tree_;
  int& share_;
  int leaves_ = kLeaves;
  int otherShare_ = -1;
};

}  // namespace

bool BulletPairFilter::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
  const auto* first = static_cast<const btCollisionObject*>(a->m_clientObject);
  const auto* second = static_cast<const btCollisionObject*>(b->m_clientObject);
  return (a->m_collisionFilterGroup & b->m_collisionFilterMask) != 0 &&
         (b->m_collisionFilterGroup & a->m_collisionFilterMask) != 0 &&
         !(first->isStaticOrKinematicObject() && second->isStaticOrKinematicObject());
}

BulletBroadphase::BulletBroadphase() {
  getOverlappingPairCache()->setOverlapFilterCallback(&filter_);
}

void BulletBroadphase::calculateOverlappingPairs(btDispatcher* dispatcher) {
  if (getenv("PLAIN")) { btDbvtBroadphase::calculateOverlappingPairs(dispatcher); return; }
  // The rates of btDbvtBroadphase's defaults.
  reinsertLeaves(m_sets[0], 1);
  if (m_fixedleft > 0) {
    const int count = 1 + m_sets[1].m_leaves / 100;
    reinsertLeaves(m_sets[1], count);
    m_fixedleft = std::max(0, m_fixedleft - count);
  }
  const int fixedLeft = m_fixedleft;
  {
    const NoIncrementalOptimisation dynamicSet(m_sets[0], m_dupdates);
    const NoIncrementalOptimisation fixedSet(m_sets[1], m_fupdates);
    btDbvtBroadphase::calculateOverlappingPairs(dispatcher);
  }
  // Set from the number of leaves that was not the true one.
  if (m_fixedleft != fixedLeft) m_fixedleft = m_sets[1].m_leaves;
}

}  // namespace scatter
