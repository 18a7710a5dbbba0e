#ifndef BT_HYBRID_PAIR_ALGORITHM_H
#define BT_HYBRID_PAIR_ALGORITHM_H

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include "BulletHybrid/btHybridObservation.h"
#include "btHybridPairEngine.h"
#include "pairs/pair.h"

class btHybridNarrowphase;

/// The narrowphase of two lists of convex parts, owned by their broadphase pair: hands Bullet's calls to the pair in the
/// narrowphase's table. Small, because Bullet's pool takes algorithms of any size without looking.
class btHybridPairAlgorithm : public btCollisionAlgorithm
{
	btHybridNarrowphase* m_narrowphase;
	btHybridPairBodies m_bodies;
	btCollisionAlgorithm* m_fallback;  ///< Bullet's own, while a shape is no list of parts any more
	int m_index;                       ///< of the pair, in its table, and in the planner if it switches
	bool m_switches;

	scatter::pairs::Pair& getPair() const;
	bool staysQuiet(btHybridPairEngine& engine) const;

public:
	btHybridPairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, btHybridNarrowphase* narrowphase, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap);
	virtual ~btHybridPairAlgorithm();

	/// In the planner; -1 if the pair does not switch.
	int getPlanIndex() const
	{
		return m_switches ? m_index : -1;
	}

	/// Whether it kept its contacts in the last step instead of looking for them, or was given those that were held.
	bool hasReused() const;

	/// Whether it began anew when it was last at work, because it was new, its level was, or a shape had changed.
	bool hasRestarted() const;

	virtual void processCollision(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);

	/// Not used by dynamics worlds, which sweep bodies themselves.
	virtual btScalar calculateTimeOfImpact(btCollisionObject* body0, btCollisionObject* body1, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);

	virtual void getAllContactManifolds(btManifoldArray& manifoldArray);

	/// The same, with the credit of each.
	void getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const;
};

#endif  // BT_HYBRID_PAIR_ALGORITHM_H
