#ifndef BT_HYBRID_BODY_SWITCHING_H
#define BT_HYBRID_BODY_SWITCHING_H

#include "btHybridNeighbourhood.h"
#include "btHybridRequests.h"

/// The report's technique: a body has one level in use, which is its collision shape. Between broadphase and
/// narrowphase the proximity policy makes and retracts requests, and those that stand are tried.
class btHybridBodySwitching
{
public:
	/// What a step is planned with.
	struct Step
	{
		const btAlignedObjectArray<btHybridRigidBody*>& m_hybrids;
		const btAlignedObjectArray<btRigidBody*>& m_nonStaticBodies;
		const btAlignedObjectArray<const btCollisionObject*>& m_held;
		btBroadphaseInterface* m_broadphase;
		btDispatcher* m_dispatcher;
		const btHybridSwitchingInfo& m_info;  ///< as it acts
		btScalar m_timeStep;
		bool m_loadIsFine;
	};

private:
	btHybridRequests& m_requests;
	btHybridNeighbourhood& m_neighbourhood;

	void followProximity(btHybridRigidBody* body, const Step& step);
	void followHand(btHybridRigidBody* body);
	void tryRequest(btHybridRigidBody* body, const Step& step);
	bool isSafe(btHybridRigidBody* body, int level, const Step& step);
	const btCollisionObject* findObstacle(const btHybridRigidBody* body, int level, btScalar gap);
	void switchLevel(btHybridRigidBody* body, int level, const Step& step);

public:
	/// Both must outlive it; the neighbourhood must know the hybrids when a step is planned.
	btHybridBodySwitching(btHybridRequests& requests, btHybridNeighbourhood& neighbourhood)
	    : m_requests(requests), m_neighbourhood(neighbourhood)
	{
	}

	void plan(const Step& step);
};

#endif  // BT_HYBRID_BODY_SWITCHING_H
