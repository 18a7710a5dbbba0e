#include "BulletHybrid/btHybridObservation.h"

#include "BulletHybrid/btHybridDynamicsWorld.h"
#include "btHybridNarrowphase.h"
#include "btHybridPairAlgorithm.h"
#include "btHybridPlanner.h"

// What is seen of worlds, planners and pairs between two steps.

using scatter::lod::PlannedPair;

static void addManifold(const btPersistentManifold* manifold, btScalar credit, bool isHeld, btAlignedObjectArray<btHybridManifoldView>& manifolds)
{
	const btHybridManifoldView view = {manifold, credit, isHeld};
	manifolds.push_back(view);
}

void btHybridGetManifolds(const btBroadphasePair& pair, btAlignedObjectArray<btHybridManifoldView>& manifolds)
{
	if (!pair.m_algorithm)
		return;
	if (const btHybridPairAlgorithm* own = dynamic_cast<const btHybridPairAlgorithm*>(pair.m_algorithm))
	{
		own->getManifolds(manifolds);
		return;
	}
	btManifoldArray all;
	pair.m_algorithm->getAllContactManifolds(all);
	for (int i = 0; i < all.size(); i++)
		addManifold(all[i], 0, false, manifolds);
}

void btHybridPairAlgorithm::getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const
{
	btManifoldArray others;
	if (m_fallback)
		m_fallback->getAllContactManifolds(others);
	for (int i = 0; i < others.size(); i++)
		addManifold(others[i], 0, false, manifolds);
	for (int i = 0; i < m_memory->m_held.getNumManifolds(); i++)
		addManifold(m_memory->m_held.getManifold(i), 0, true, manifolds);
	const std::vector<scatter::ChildPair>& children = m_pair->children();
	for (size_t i = 0; i < children.size(); i++)
		if (children[i].contact)
			addManifold(static_cast<const btPersistentManifold*>(children[i].contact), m_memory->m_credit.of(children[i].a, children[i].b), false, manifolds);
}

bool btHybridPairAlgorithm::overlapsFinely(btScalar depth) const
{
	const scatter::PartList* parts[2];
	for (int i = 0; i < 2; i++)
		parts[i] = &m_narrowphase->getBody(m_objects[i], m_objects[i]->getNumLevels())->getBody().parts();
	const scatter::Frame frame = scatter::relativeFrame(btHybridFrameOf(m_objects[0]->getObject()->getWorldTransform()), btHybridFrameOf(m_objects[1]->getObject()->getWorldTransform()));
	return !m_narrowphase->getQuery().isSeparated(*parts[0], *parts[1], frame, -depth);
}

btHybridPairView btHybridDynamicsWorld::viewPair(const btBroadphasePair& pair) const
{
	btHybridPairView view;
	if (m_planner && pair.m_algorithm)
		view = m_planner->viewPair(pair.m_algorithm);
	if (view.m_level > 0)
		return view;
	const btCollisionObject* const objects[2] = {static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject), static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject)};
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

btHybridRequestView btHybridDynamicsWorld::viewRequest(const btHybridRigidBody* body) const
{
	btHybridRequestView view;
	if (!body || body->m_world != this || !body->m_request.isStanding())
		return view;
	const btHybridRequest& request = body->m_request;
	view.m_targetLevel = request.m_targetLevel;
	view.m_scope = request.m_scope;
	view.m_policy = request.m_byProximity ? "proximity" : "program";
	view.m_waitingSteps = m_step - request.m_stepMade;
	view.m_tried = m_planner ? request.m_acknowledged : request.m_tries > 0;
	if (!view.m_tried)
		return view;
	view.m_blockedBy = request.m_blockedBy;
	view.m_retrySteps = btMax(request.m_nextTry - m_step, 1);
	if (m_planner)
		m_planner->viewObstacle(body, view);
	return view;
}

btHybridPairView btHybridPlanner::viewPair(const btCollisionAlgorithm* algorithm) const
{
	btHybridPairView view;
	const btHybridPairAlgorithm* found = dynamic_cast<const btHybridPairAlgorithm*>(algorithm);
	if (!found)
		return view;
	const int pair = found->getPlanIndex();
	const PlannedPair& planned = m_planned[pair];
	view.m_level = planned.view.level;
	view.m_finestLevel = planned.view.finest;
	view.m_credited = planned.view.credited;
	if (!m_pairs[pair].m_requested)
		return view;
	view.m_request.m_targetLevel = planned.target;
	view.m_request.m_policy = whoAsks(pair, view.m_request.m_scope);
	view.m_request.m_waitingSteps = m_step - m_pairs[pair].m_stepRequested;
	view.m_request.m_tried = m_pairs[pair].m_acknowledged;
	view.m_request.m_retrySteps = view.m_request.m_tried ? btMax(int(planned.blockedSteps), 1) : 0;
	return view;
}

void btHybridPlanner::viewObstacle(const btCollisionObject* body, btHybridRequestView& request) const
{
	const int pair = findFinerPair(body);
	request.m_retrySteps = 1;
	if (pair < 0)
		return;
	const btHybridLevelBodies* const* objects = m_pairs[pair].m_objects;
	request.m_blockedBy = objects[objects[0]->getObject() == body ? 1 : 0]->getObject();
	request.m_retrySteps = btMax(int(m_planned[pair].blockedSteps), 1);
}

int btHybridPlanner::countDeepPairs(btScalar depth) const
{
	int count = 0;
	for (size_t i = 0; i < m_pairs.size(); i++)
		count += m_planned[i].view.credited && m_pairs[i].m_algorithm->overlapsFinely(depth) ? 1 : 0;
	return count;
}
