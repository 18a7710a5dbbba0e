#include "btHybridRequests.h"

void btHybridRequests::endStep()
{
	m_stepInfo = m_counting;
	m_stepInfo.m_standingRequests = m_standing;
	m_counting = btHybridStepInfo();
}

void btHybridRequests::make(btHybridRigidBody* body, int level, btHybridScope scope, bool byProximity)
{
	if (body->m_request.m_targetLevel == level)
	{
		body->m_request.m_scope = scope;
		body->m_request.m_byProximity = byProximity;
		return;
	}
	retract(body, BT_HYBRID_RETRACTED_BY_CALLER);
	m_standing++;
	btHybridRequest& request = body->m_request;
	request.m_targetLevel = level;
	request.m_scope = scope;
	request.m_byProximity = byProximity;
	request.m_stepMade = m_step;
	request.m_nextTry = m_step;
	if (m_listener)
		m_listener->requested(body, request);
}

void btHybridRequests::retract(btHybridRigidBody* body, btHybridRetraction reason)
{
	if (!body->m_request.isStanding())
		return;
	const btHybridRequest request = body->m_request;
	body->m_request = btHybridRequest();
	m_standing--;
	m_counting.m_retractions++;
	if (m_listener)
		m_listener->retracted(body, request, reason);
}

void btHybridRequests::acknowledge(btHybridRigidBody* body)
{
	if (body->m_request.m_acknowledged)
		return;
	body->m_request.m_acknowledged = true;
	if (m_listener)
		m_listener->acknowledged(body, body->m_request);
}

void btHybridRequests::delay(btHybridRigidBody* body, int retryInterval)
{
	body->m_request.m_nextTry = m_step + retryInterval;
}

void btHybridRequests::setObstacle(btHybridRigidBody* body, const btCollisionObject* obstacle)
{
	body->m_request.m_blockedBy = obstacle;
}

void btHybridRequests::block(btHybridRigidBody* body)
{
	body->m_request.m_tries++;
	m_counting.m_blockedTries++;
	if (m_listener)
		m_listener->blocked(body, body->m_request);
}

void btHybridRequests::fulfil(btHybridRigidBody* body, int level)
{
	const btHybridRequest request = body->m_request;
	const int from = body->m_level;
	body->m_level = level;
	if (level < from)
		m_counting.m_switchesCoarser++;
	else
		m_counting.m_switchesFiner++;
	if (request.m_targetLevel == level)
	{
		body->m_request = btHybridRequest();
		m_standing--;
	}
	if (m_listener)
		m_listener->switched(body, from, level, request);
}
