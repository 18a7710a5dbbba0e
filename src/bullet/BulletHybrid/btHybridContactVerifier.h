#ifndef BT_HYBRID_CONTACT_VERIFIER_H
#define BT_HYBRID_CONTACT_VERIFIER_H

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include "BulletHybrid/btHybridCollision.h"

class btDispatcher;
class btHybridPlanner;

/// Compares the contacts of hybrid bodies with what brute force finds: Bullet's own algorithms, made anew
/// for every child pair that Bullet's midphase would let through at the present poses.
class btHybridContactVerifier
{
	btHybridContactReport m_report;

public:
	void reset()
	{
		m_report = btHybridContactReport();
	}

	/// Of all pairs with a hybrid that are at their finest level (planner: 0 in body switching), that the dispatcher processes and whose shapes are convex or compounds of
	/// convex children. Call it after the narrowphase, before anything moves. Leaves pairs, manifolds, the
	/// dispatcher and Bullet's global callbacks as they are, and calls no contact callback.
	void verify(btBroadphasePairArray& pairs, btDispatcher* dispatcher, const btHybridPlanner* planner);

	const btHybridContactReport& getReport() const
	{
		return m_report;
	}
};

#endif  // BT_HYBRID_CONTACT_VERIFIER_H
