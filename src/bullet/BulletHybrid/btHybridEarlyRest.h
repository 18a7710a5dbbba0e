#ifndef BT_HYBRID_EARLY_REST_H
#define BT_HYBRID_EARLY_REST_H

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btAlignedObjectArray.h>

class btHybridObjects;
class btHybridPlanner;

/// Lets bodies that lie still fall asleep in a quarter of the time that Bullet gives them, while a budget gives
/// something up: those that touch nothing below its finest level, and are of no importance to policies.
class btHybridEarlyRest
{
public:
	/// Whether at least half of those that are awake lie still.
	static bool areStill(const btAlignedObjectArray<btRigidBody*>& bodies);

	/// After a step, before Bullet looks at how long bodies have been at rest. How many are going to be asleep sooner.
	static int hasten(const btAlignedObjectArray<btRigidBody*>& bodies, const btHybridObjects& objects,
	                  const btHybridPlanner& planner, btScalar timeStep);
};

#endif  // BT_HYBRID_EARLY_REST_H
