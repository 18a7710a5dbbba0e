#ifndef BT_HYBRID_ALGORITHM_H
#define BT_HYBRID_ALGORITHM_H

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include "BulletHybrid/btHybridObservation.h"
#include "btHybridFallback.h"
#include "btHybridLookahead.h"
#include "btHybridStepMemory.h"

/// The narrowphase of a pair of objects of which at least one is a list of convex parts, owned by their broadphase
/// pair.
class btHybridAlgorithm : public btCollisionAlgorithm
{
protected:
	btHybridFallback m_fallback;

	/// Adds the manifolds of the fallback, which have no credit.
	void addFallback(btAlignedObjectArray<btHybridManifoldView>& manifolds) const
	{
		btManifoldArray own;
		m_fallback.getManifolds(own);
		for (int i = 0; i < own.size(); i++)
		{
			const btHybridManifoldView view = {own[i], 0, false};
			manifolds.push_back(view);
		}
	}

public:
	explicit btHybridAlgorithm(const btCollisionAlgorithmConstructionInfo& info) : btCollisionAlgorithm(info)
	{
	}

	/// Whether its step is likely to be one that can be foreseen. Changes nothing.
	virtual bool mayBeForeseen() const = 0;

	/// Moves its bodies to where its objects are, if its step is going to come. Whether they are there.
	virtual bool follow(btDispatcher* dispatcher) = 0;

	/// Fetches memory that foresee() is going to need soon.
	virtual void fetch(btHybridLookahead::Stage stage) const = 0;

	/// Finds out about its step what needs nothing of Bullet, or makes it. Any number of pairs at once.
	virtual void foresee(btHybridAhead& ahead, btHybridStepMemory& memory) = 0;

	/// Its step has not come, or has made use of what was found out.
	virtual void endForesight() = 0;

	/// In the planner; -1 if the pair does not switch.
	virtual int getPlanIndex() const = 0;

	/// Whether its contacts are others than a look finds: it kept those of the step before, was given some that were
	/// held, or holds a body that has passed through its ground.
	virtual bool hasOthers() const = 0;

	/// Whether it began anew when it was last at work, because it was new, its level was, or a shape had changed.
	virtual bool hasRestarted() const = 0;

	/// All manifolds, with the credit of each.
	virtual void getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const = 0;

	/// Not used by dynamics worlds, which sweep bodies themselves.
	virtual btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
	                                       btManifoldResult*)
	{
		return 1;
	}
};

#endif  // BT_HYBRID_ALGORITHM_H
