#ifndef BT_HYBRID_CONTACT_VERIFIER_H
#define BT_HYBRID_CONTACT_VERIFIER_H

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include "BulletHybrid/btHybridCollision.h"

class btDispatcher;

/// Compares the contacts of hybrid bodies with what brute force finds.
class btHybridContactVerifier
{
	btHybridContactReport m_report;

public:
	void reset()
	{
		m_report = btHybridContactReport();
	}

	/// Of all pairs with a hybrid. Leaves pairs, manifolds and the dispatcher as they are.
	void verify(btBroadphasePairArray& pairs, btDispatcher* dispatcher);

	const btHybridContactReport& getReport() const
	{
		return m_report;
	}
};

#endif  // BT_HYBRID_CONTACT_VERIFIER_H
