// What is in a btHybridDynamicsWorld.
#include <LinearMath/btIDebugDraw.h>

#include "BulletHybrid/btHybridDynamicsWorld.h"
#include "btHybridCoarsestBounds.h"
#include "btHybridPlanner.h"
#include "btHybridRequests.h"

bool btHybridDynamicsWorld::owns(const btCollisionObject* object) const
{
	if (!object)
		return false;
	const int index = object->getWorldArrayIndex();
	return index >= 0 && index < m_collisionObjects.size() && m_collisionObjects[index] == object;
}

bool btHybridDynamicsWorld::refuse(const char* reason)
{
	m_refusal = reason;
	if (m_debugDrawer)
		m_debugDrawer->reportErrorWarning(reason);
	return false;
}

// What is in a world has a place in its broadphase.
bool btHybridDynamicsWorld::accepts(const btCollisionObject* object)
{
	m_refusal = 0;
	if (!object)
		return refuse("0 was to be added to a btHybridDynamicsWorld; give it an object");
	if (owns(object))
		return refuse("an object was to be added twice to a btHybridDynamicsWorld; remove it first");
	if (object->getBroadphaseHandle())
		return refuse(
		    "an object that is in another world was to be added to a btHybridDynamicsWorld; remove it from there "
		    "first");
	return true;
}

void btHybridDynamicsWorld::registerHybrid(btRigidBody* body)
{
	btHybridRigidBody* hybrid = dynamic_cast<btHybridRigidBody*>(body);
	if (!hybrid || !owns(body))
		return;
	hybrid->m_world = this;
	hybrid->m_home = this;
	if (hybrid->getFinestLevel() == 0)
		return;
	m_isIndexed = false;
	hybrid->m_hybridIndex = m_hybrids.size();
	hybrid->m_lonelySteps = 0;
	m_hybrids.push_back(hybrid);
	m_coarsestBounds->add();
	if (!m_planner)
		return;
	hybrid->setCollisionShape(hybrid->m_levels->getLevelShape(hybrid->getFinestLevel()));
	findAsked();
}

void btHybridDynamicsWorld::unregisterHybrid(btHybridRigidBody* hybrid)
{
	hybrid->m_world = 0;
	hybrid->m_home = 0;
	if (hybrid->m_hybridIndex < 0)
		return;
	m_requests->retract(hybrid, BT_HYBRID_RETRACTED_BY_REMOVAL);
	btHybridRigidBody* last = m_hybrids[m_hybrids.size() - 1];
	m_hybrids[hybrid->m_hybridIndex] = last;
	m_coarsestBounds->remove(hybrid->m_hybridIndex);
	last->m_hybridIndex = hybrid->m_hybridIndex;
	m_hybrids.pop_back();
	hybrid->m_hybridIndex = -1;
}

void btHybridDynamicsWorld::addRigidBody(btRigidBody* body)
{
	if (!accepts(body))
		return;
	btDiscreteDynamicsWorld::addRigidBody(body);
	registerHybrid(body);
}

void btHybridDynamicsWorld::addRigidBody(btRigidBody* body, int group, int mask)
{
	if (!accepts(body))
		return;
	btDiscreteDynamicsWorld::addRigidBody(body, group, mask);
	registerHybrid(body);
}

void btHybridDynamicsWorld::addCollisionObject(btCollisionObject* collisionObject, int group, int mask)
{
	if (accepts(collisionObject))
		btDiscreteDynamicsWorld::addCollisionObject(collisionObject, group, mask);
}

void btHybridDynamicsWorld::removeRigidBody(btRigidBody* body)
{
	m_refusal = 0;
	if (!owns(body))
	{
		refuse("a body was to be removed from a btHybridDynamicsWorld that it is not in");
		return;
	}
	if (btHybridRigidBody* hybrid = dynamic_cast<btHybridRigidBody*>(body))
		unregisterHybrid(hybrid);
	m_isIndexed = false;
	forget(body);
	btDiscreteDynamicsWorld::removeRigidBody(body);
}

void btHybridDynamicsWorld::removeCollisionObject(btCollisionObject* collisionObject)
{
	m_refusal = 0;
	if (!owns(collisionObject))
	{
		refuse("an object was to be removed from a btHybridDynamicsWorld that it is not in");
		return;
	}
	m_isIndexed = false;
	forget(collisionObject);
	btDiscreteDynamicsWorld::removeCollisionObject(collisionObject);
}

void btHybridDynamicsWorld::forget(btCollisionObject* object)
{
	for (int i = 0; i < m_hybrids.size(); i++)
		if (m_hybrids[i]->m_request.m_blockedBy == object)
			m_hybrids[i]->m_request.m_blockedBy = 0;
	if (m_held.findLinearSearch2(object) >= 0)
		setHeld(object, false);
}

bool btHybridDynamicsWorld::setHeld(btCollisionObject* object, bool held)
{
	if (!owns(object))
		return false;
	if (btHybridRigidBody* hybrid = btHybridRigidBody::upcast(object))
		hybrid->setHeld(held);
	m_held.remove(object);
	if (held)
		m_held.push_back(object);
	if (m_planner)
		m_planner->setHeld(m_held);
	return true;
}
