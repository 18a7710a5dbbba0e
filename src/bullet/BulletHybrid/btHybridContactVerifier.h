#ifndef BT_HYBRID_CONTACT_VERIFIER_H
#define BT_HYBRID_CONTACT_VERIFIER_H

#include "BulletHybrid/btHybridCollision.h"
#include "btHybridParallelWorld.h"

/// Compares the contacts of hybrid bodies with those that Bullet has: in a parallel world, whose manifolds begin every
/// step with the points that ours began it with, so that a difference is of this step and not of one long ago.
/// See btHybridContactReport for what is counted.
class btHybridContactVerifier
{
	btHybridContactReport m_report;
	btHybridParallelWorld* m_parallel;
	btAlignedObjectArray<btHybridChildManifold> m_ours;
	btAlignedObjectArray<btHybridChildManifold> m_bullets;
	btAlignedObjectArray<btHybridChildKey> m_unshared;  ///< had points before the step that Bullet could not be given
	btAlignedObjectArray<btHybridChildKey> m_extras;    ///< of the last step

	btHybridContactVerifier(const btHybridContactVerifier&);
	btHybridContactVerifier& operator=(const btHybridContactVerifier&);

	void collectOurs(btCollisionWorld* world);
	void collectBullets();
	void sharePoints();
	void compare(btHybridContactReport& report);
	void takeDifference(const btHybridChildKey& key, const btPersistentManifold* ours,
	                    const btPersistentManifold* bullets, btHybridContactReport& report);
	bool isCompared(const btHybridChildKey& key) const;

public:
	btHybridContactVerifier();
	~btHybridContactVerifier();

	void reset();

	/// Before the narrowphase of every step. planner: 0 in body switching.
	void begin(const btHybridPlanner* planner, btCollisionWorld* world);

	/// After it, before anything moves. Takes the step into the report, or not. Leaves the world, its dispatcher and
	/// Bullet's global callbacks as they are, and calls no contact callback.
	void finish(btCollisionWorld* world, bool reports);

	const btHybridContactReport& getReport() const
	{
		return m_report;
	}
};

#endif  // BT_HYBRID_CONTACT_VERIFIER_H
