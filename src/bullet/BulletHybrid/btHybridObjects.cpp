#include "btHybridObjects.h"

#include "BulletHybrid/btHybridCollision.h"
#include "BulletHybrid/btHybridRigidBody.h"

btHybridParts* btHybridObjects::acquireParts(const btCollisionShape* shape)
{
	btHybridParts** known = m_parts.find(btHashPtr(shape));
	btHybridParts* parts = known ? *known : 0;
	if (!parts || !parts->isCurrent(true))
	{
		// Bodies that still use the old one let go of it when they notice.
		parts = new btHybridParts(shape);
		m_parts.insert(btHashPtr(shape), parts);
	}
	parts->m_users++;
	return parts;
}

void btHybridObjects::releaseParts(btHybridParts* parts)
{
	if (--parts->m_users > 0)
		return;
	btHybridParts** known = m_parts.find(btHashPtr(parts->getShape()));
	if (known && *known == parts)
		m_parts.remove(btHashPtr(parts->getShape()));
	delete parts;
}

btHybridLevelBodies* btHybridObjects::acquire(const btCollisionObject* object, bool hasLevels)
{
	btHybridLevelBodies** known = m_objects.find(btHashPtr(object));
	btHybridLevelBodies* bodies = known ? *known : 0;
	if (!bodies)
	{
		bodies = new btHybridLevelBodies(object, hasLevels ? btHybridRigidBody::upcast(object) : 0);
		m_objects.insert(btHashPtr(object), bodies);
	}
	bodies->m_users++;
	return bodies;
}

void btHybridObjects::release(btHybridLevelBodies* object)
{
	if (--object->m_users > 0)
		return;
	m_objects.remove(btHashPtr(object->m_object));
	for (int level = 0; level < object->m_bodies.size(); level++)
	{
		if (!object->m_bodies[level])
			continue;
		releaseParts(object->m_bodies[level]->m_parts);
		delete object->m_bodies[level];
	}
	delete object;
}

btHybridPartBody* btHybridObjects::getBody(btHybridLevelBodies* object, int level)
{
	btHybridPartBody*& body = object->m_bodies[level];
	if (!body)
		body = new btHybridPartBody(object->m_object, acquireParts(object->getShape(level)));
	return body;
}

void btHybridObjects::replaceParts(btHybridPartBody* body, const btCollisionShape* shape)
{
	btHybridParts* old = body->m_parts;
	body->m_parts = acquireParts(shape);
	body->m_body.setParts(body->m_parts->getList());
	body->m_version++;
	releaseParts(old);
}

bool btHybridObjects::update(btHybridPartBody* body, const btCollisionShape* shape, const btTransform& transform)
{
	const bool isChecked = m_dispatches && body->m_checkedStep == m_step && shape == body->m_parts->getShape();
	if (isChecked)
		return true;
	if (shape != body->m_parts->getShape() || !body->m_parts->isCurrent(body->m_changes && m_isTold))
	{
		if (!btHybridParts::isPartList(shape))
			return false;
		replaceParts(body, shape);
	}
	if (m_dispatches)
		body->m_checkedStep = m_step;
	body->moveTo(transform);
	return true;
}

bool btHybridObjects::refresh(btHybridPartBody* body, const btTransform& transform)
{
	return !body->m_changes || update(body, body->getShapeNow(), transform);
}

void btHybridObjects::count(btHybridCollisionMemory& memory) const
{
	for (int i = 0; i < m_objects.size(); i++)
	{
		const btAlignedObjectArray<btHybridPartBody*>& bodies = (*m_objects.getAtIndex(i))->m_bodies;
		for (int level = 0; level < bodies.size(); level++)
			if (bodies[level])
				memory.m_bodyBytes += sizeof(btHybridPartBody) + bodies[level]->getBody().bytes();
	}
	for (int i = 0; i < m_parts.size(); i++)
		memory.m_partBytes += (*m_parts.getAtIndex(i))->getBytes();
}
