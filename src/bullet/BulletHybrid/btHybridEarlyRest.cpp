#include "btHybridEarlyRest.h"

#include "btHybridLevelBodies.h"
#include "btHybridObjects.h"
#include "btHybridPlanner.h"

namespace
{
// Of the speeds below which Bullet lets bodies fall asleep: usually 5 cm and 3.6 degrees a second. What is that slow
// cannot be seen to stop.
const btScalar c_still = btScalar(1.0 / 16);

// Times as fast: half a second in the place of two.
const btScalar c_haste = 4;

bool isStill(const btRigidBody* body)
{
	return body->getLinearVelocity().length() < c_still * body->getLinearSleepingThreshold() &&
	       body->getAngularVelocity().length() < c_still * body->getAngularSleepingThreshold();
}
}  // namespace

bool btHybridEarlyRest::areStill(const btAlignedObjectArray<btRigidBody*>& bodies)
{
	int more = 0;
	for (int i = 0; i < bodies.size(); i++)
		if (bodies[i]->isActive() && !bodies[i]->isStaticOrKinematicObject())
			more += isStill(bodies[i]) ? 1 : -1;
	return more >= 0;
}

int btHybridEarlyRest::hasten(const btAlignedObjectArray<btRigidBody*>& bodies, const btHybridObjects& objects,
                              const btHybridPlanner& planner, btScalar timeStep)
{
	int hastened = 0;
	for (int i = 0; planner.restsEarly() && i < bodies.size(); i++)
	{
		btRigidBody* body = bodies[i];
		if (!body->isActive() || body->isStaticOrKinematicObject() ||
		    body->getActivationState() == DISABLE_DEACTIVATION || !isStill(body))
			continue;
		const btHybridLevelBodies* known = objects.find(body);
		if (known && !planner.mayRestEarly(*known))
			continue;
		body->setDeactivationTime(body->getDeactivationTime() + (c_haste - 1) * timeStep);
		hastened++;
	}
	return hastened;
}
