#include "btHybridBodySwitching.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include "BulletHybrid/btHybridSeparation.h"
#include "btHybridGhostPairs.h"

void btHybridBodySwitching::plan(const Step& step)
{
	if (!step.m_info.m_proximity && m_requests.getNumStanding() == 0 && step.m_held.size() == 0)
		return;
	m_neighbourhood.collectPairs(step.m_broadphase->getOverlappingPairCache()->getOverlappingPairArray(),
	                             step.m_hybrids.size());
	if (step.m_info.m_proximity)
		m_neighbourhood.measureSpeeds(step.m_nonStaticBodies);
	for (int i = 0; i < step.m_hybrids.size(); i++)
	{
		btHybridRigidBody* body = step.m_hybrids[i];
		if (!body->isActive())
			continue;
		if (step.m_held.findLinearSearch2(body) >= 0)
			followHand(body);
		else if (step.m_info.m_proximity)
			followProximity(body, step);
		if (body->m_request.isStanding() && m_requests.getStep() >= body->m_request.m_nextTry)
			tryRequest(body, step);
	}
}

static btCollisionObject* partnerIn(const btBroadphasePair* pair, const btCollisionObject* body)
{
	btCollisionObject* first = static_cast<btCollisionObject*>(pair->m_pProxy0->m_clientObject);
	return first == body ? static_cast<btCollisionObject*>(pair->m_pProxy1->m_clientObject) : first;
}

static bool canPush(const btCollisionObject* body, const btCollisionObject* partner)
{
	return body->hasContactResponse() && partner->hasContactResponse() && body->checkCollideWith(partner) &&
	       partner->checkCollideWith(body);
}

void btHybridBodySwitching::followProximity(btHybridRigidBody* body, const Step& step)
{
	const btHybridRequest& request = body->m_request;
	const bool mayReplace = !request.isStanding() || request.m_byProximity;
	const bool wantsCoarser = request.isStanding() && request.m_targetLevel < body->m_level;
	const btScalar lookAhead = step.m_info.m_proximitySteps * step.m_timeStep;
	if (m_neighbourhood.hasMovingNeighbour(body, body->m_hybridIndex, lookAhead, step.m_broadphase))
	{
		body->m_lonelySteps = 0;
		if (!mayReplace)
			return;
		if (request.isStanding() && !wantsCoarser)
			m_requests.retract(body, BT_HYBRID_RETRACTED_BY_APPROACH);
		if (step.m_loadIsFine)
			m_requests.retract(body, BT_HYBRID_RETRACTED_BY_LOAD);
		else if (body->m_level > 1)
			m_requests.make(body, 1, BT_HYBRID_LOCAL, true);
		return;
	}
	body->m_lonelySteps++;
	if (!mayReplace)
		return;
	if (wantsCoarser)
		m_requests.retract(body, BT_HYBRID_RETRACTED_BY_SEPARATION);
	if (body->m_lonelySteps >= step.m_info.m_quietSteps && body->m_level < body->getFinestLevel())
		m_requests.make(body, body->getFinestLevel(), BT_HYBRID_LOCAL, true);
}

// What the user holds asks for nothing coarser, whoever wants it.
void btHybridBodySwitching::followHand(btHybridRigidBody* body)
{
	body->m_lonelySteps = 0;
	if (body->m_level < body->getFinestLevel())
		m_requests.make(body, body->getFinestLevel(), BT_HYBRID_LOCAL, false);
	else
		m_requests.retract(body, BT_HYBRID_RETRACTED_BY_CALLER);
}

void btHybridBodySwitching::tryRequest(btHybridRigidBody* body, const Step& step)
{
	const btHybridRequest& request = body->m_request;
	m_requests.acknowledge(body);
	// The listener may have retracted it, or asked for something else.
	if (!request.isStanding() || request.m_targetLevel == body->m_level)
		return;
	m_requests.delay(body, step.m_info.m_retryInterval);
	if (request.m_targetLevel > body->m_level)
	{
		if (isSafe(body, request.m_targetLevel, step))
		{
			switchLevel(body, request.m_targetLevel, step);
			return;
		}
	}
	else
	{
		// The coarsest that is safe: part of the way helps, and the request for the rest stands.
		for (int level = request.m_targetLevel; level < body->m_level; level++)
		{
			if (isSafe(body, level, step))
			{
				switchLevel(body, level, step);
				return;
			}
		}
	}
	m_requests.block(body);
}

// Report, section 3.4.3: finer only if there is no contact, coarser only if the coarser level is free of
// collision. Free of contact is measured at the present level, which holds the finer one.
bool btHybridBodySwitching::isSafe(btHybridRigidBody* body, int level, const Step& step)
{
	if (!step.m_info.m_safetyConditions)
		return true;
	const btCollisionObject* obstacle = findObstacle(body, btMin(level, body->m_level), step.m_info.m_safetyGap);
	m_requests.setObstacle(body, obstacle);
	return obstacle == 0;
}

const btCollisionObject* btHybridBodySwitching::findObstacle(const btHybridRigidBody* body, int level, btScalar gap)
{
	const btCollisionShape* shape = body->m_levels->getLevelShape(level);
	for (int i = 0; i < m_neighbourhood.getNumPairs(body->m_hybridIndex); i++)
	{
		const btCollisionObject* partner = partnerIn(m_neighbourhood.getPair(body->m_hybridIndex, i), body);
		if (!canPush(body, partner))
			continue;
		m_requests.countQuery();
		if (!btHybridIsSeparated(shape, body->getWorldTransform(), partner->getCollisionShape(),
		                         partner->getWorldTransform(), gap))
			return partner;
	}
	return 0;
}

void btHybridBodySwitching::switchLevel(btHybridRigidBody* body, int level, const Step& step)
{
	body->setCollisionShape(body->m_levels->getLevelShape(level));
	// A cached algorithm was made for the old shape's type.
	for (int i = 0; i < m_neighbourhood.getNumPairs(body->m_hybridIndex); i++)
	{
		btBroadphasePair* pair = m_neighbourhood.getPair(body->m_hybridIndex, i);
		step.m_broadphase->getOverlappingPairCache()->cleanOverlappingPair(*pair, step.m_dispatcher);
		if (btOverlappingPairCache* own = btHybridGhostPairs(partnerIn(pair, body)))
			own->cleanProxyFromPairs(body->getBroadphaseHandle(), step.m_dispatcher);
	}
	m_requests.fulfil(body, level);
}
