#include "btHybridPartBody.h"

#include <LinearMath/btAabbUtil2.h>

#include "BulletHybrid/btHybridRigidBody.h"

btHybridPartBody::btHybridPartBody(const btCollisionObject* object, btHybridParts* parts)
    : m_object(object),
      m_parts(parts),
      m_body(parts->getList(), this),
      m_changes(btHybridRigidBody::upcast(object) == 0),
      m_version(0),
      m_checkedStep(-1)
{
}

void btHybridPartBody::boundsOf(int part, const scatter::Frame& frame, scatter::Vec3& low, scatter::Vec3& high) const
{
	btVector3 aabbMin, aabbMax;
	getChildShape(part)->getAabb(getChildTransform(part, btHybridTransformOf(frame)), aabbMin, aabbMax);
	low = scatter::Vec3(aabbMin.x(), aabbMin.y(), aabbMin.z());
	high = scatter::Vec3(aabbMax.x(), aabbMax.y(), aabbMax.z());
}

void btHybridPartBody::moveTo(const btTransform& transform)
{
	m_body.moveTo(btHybridFrameOf(transform));
}

const btCollisionShape* btHybridPartBody::getChildShape(int part) const
{
	return m_parts->getPartShape(part);
}

btTransform btHybridPartBody::getChildTransform(int part, const btTransform& body) const
{
	return m_parts->getPartIndex(part) < 0 ? body : body * m_parts->getPartTransform(part);
}

bool btHybridPartBody::hasLeaves() const
{
	const btCollisionShape* shape = m_parts->getShape();
	return shape->isCompound() && static_cast<const btCompoundShape*>(shape)->getDynamicAabbTree();
}

void btHybridPartBody::getLeaf(int part, btVector3& aabbMin, btVector3& aabbMax) const
{
	getChildShape(part)->getAabb(getChildTransform(part, btTransform::getIdentity()), aabbMin, aabbMax);
}

void btHybridPartBody::getLeafIn(int part, const btTransform& body, btVector3& aabbMin, btVector3& aabbMax) const
{
	if (!hasLeaves())
	{
		m_parts->getShape()->getAabb(body, aabbMin, aabbMax);
		return;
	}
	btVector3 leafMin, leafMax;
	getLeaf(part, leafMin, leafMax);
	btTransformAabb(leafMin, leafMax, 0, body, aabbMin, aabbMax);
}
