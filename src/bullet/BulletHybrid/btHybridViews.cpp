#include "BulletHybrid/btHybridDynamicsWorld.h"
#include "BulletHybrid/btHybridObservation.h"
#include "btHybridAlgorithm.h"
#include "btHybridNarrowphase.h"
#include "btHybridPlanner.h"
#include "btHybridRequests.h"

// What is seen of worlds and pairs between two steps.

static const btHybridAlgorithm* ownAlgorithm(const btCollisionAlgorithm* algorithm)
{
	return dynamic_cast<const btHybridAlgorithm*>(algorithm);
}

void btHybridGetManifolds(const btBroadphasePair& pair, btAlignedObjectArray<btHybridManifoldView>& manifolds)
{
	if (!pair.m_algorithm)
		return;
	if (const btHybridAlgorithm* own = ownAlgorithm(pair.m_algorithm))
	{
		own->getManifolds(manifolds);
		return;
	}
	btManifoldArray all;
	pair.m_algorithm->getAllContactManifolds(all);
	for (int i = 0; i < all.size(); i++)
	{
		const btHybridManifoldView view = {all[i], 0, false};
		manifolds.push_back(view);
	}
}

btHybridPairView btHybridDynamicsWorld::viewPair(const btBroadphasePair& pair) const
{
	btHybridPairView view;
	const btHybridAlgorithm* own = m_planner ? ownAlgorithm(pair.m_algorithm) : 0;
	if (own && own->getPlanIndex() >= 0)
		view = m_planner->viewPair(own->getPlanIndex());
	if (view.m_level > 0)
		return view;
	const btCollisionObject* const objects[2] = {static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject),
	                                             static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject)};
	for (int i = 0; i < 2; i++)
	{
		const btHybridRigidBody* hybrid = btHybridRigidBody::upcast(objects[i]);
		if (!hybrid)
			continue;
		view.m_finestLevel = btMax(view.m_finestLevel, hybrid->getFinestLevel());
		view.m_level = btMax(view.m_level, m_planner ? hybrid->getFinestLevel() : hybrid->getLevel());
	}
	return view;
}

void btHybridDynamicsWorld::viewCoarserObjects(btAlignedObjectArray<btHybridCoarserObject>& objects) const
{
	if (m_planner)
		m_planner->viewCoarserObjects(objects);
}

btHybridRequestView btHybridDynamicsWorld::viewRequest(const btHybridRigidBody* body) const
{
	btHybridRequestView view;
	if (!body || body->m_world != this || !body->m_request.isStanding())
		return view;
	const btHybridRequest& request = body->m_request;
	view.m_targetLevel = request.m_targetLevel;
	view.m_scope = request.m_scope;
	view.m_policy = request.m_byProximity ? "proximity" : "program";
	view.m_waitingSteps = m_requests->getStep() - request.m_stepMade;
	view.m_tried = m_planner ? request.m_acknowledged : request.m_tries > 0;
	if (!view.m_tried)
		return view;
	view.m_blockedBy = request.m_blockedBy;
	view.m_retrySteps = btMax(request.m_nextTry - m_requests->getStep(), 1);
	if (m_planner)
		m_planner->viewObstacle(body, view);
	return view;
}
