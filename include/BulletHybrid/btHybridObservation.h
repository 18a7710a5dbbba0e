#ifndef BT_HYBRID_OBSERVATION_H
#define BT_HYBRID_OBSERVATION_H

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <LinearMath/btAlignedObjectArray.h>

#include "BulletHybrid/btHybridRequest.h"

class btPersistentManifold;

/// A wish to change a level, as it stands between two steps.
struct btHybridRequestView
{
	int m_targetLevel;  ///< 0: no request stands
	btHybridScope m_scope;
	const char* m_policy;  ///< who asks, as in btHybridPairEvent; a constant
	int m_waitingSteps;
	bool m_tried;
	int m_retrySteps;                      ///< tried: steps until the next try, at least 1
	const btCollisionObject* m_blockedBy;  ///< the object that the last try found in the way; 0 if not known

	btHybridRequestView()
	    : m_targetLevel(0),
	      m_scope(BT_HYBRID_LOCAL),
	      m_policy(""),
	      m_waitingSteps(0),
	      m_tried(false),
	      m_retrySteps(0),
	      m_blockedBy(0)
	{
	}
};

/// A broadphase pair of a btHybridDynamicsWorld, for debug drawing.
struct btHybridPairView
{
	int m_level;        ///< in use, 1 the coarsest; 0 if neither object is a hybrid
	int m_finestLevel;  ///< that it could have; 0 as before
	bool m_credited;
	btHybridRequestView m_request;  ///< pair switching
	btScalar m_units;               ///< pair switching: what it took of the last step, as budgets count; -1: not known

	btHybridPairView() : m_level(0), m_finestLevel(0), m_credited(false), m_units(-1)
	{
	}
};

/// An object of a pair that is coarser than it could be.
struct btHybridCoarserObject
{
	const btCollisionObject* m_object;
	int m_level;  ///< the coarsest over all such pairs of it
};

/// Contacts of a pair.
struct btHybridManifoldView
{
	const btPersistentManifold* m_manifold;
	btScalar m_credit;  ///< that is counted in the distances of its points
	bool m_isHeld;      ///< of the finest shapes, while the pair is on credit at a coarser level
};

/// Adds the manifolds of a pair, of any world; valid until the next step.
void btHybridGetManifolds(const btBroadphasePair& pair, btAlignedObjectArray<btHybridManifoldView>& manifolds);

#endif  // BT_HYBRID_OBSERVATION_H
