#include "btHybridPartBody.h"

#include <LinearMath/btAabbUtil2.h>

#include "BulletHybrid/btHybridRigidBody.h"

btHybridPartBody::btHybridPartBody(const btCollisionObject* object, btHybridParts* parts)
    : m_object(object), m_parts(parts), m_body(parts->getList(), this), m_changes(btHybridRigidBody::upcast(object) == 0), m_version(0), m_checkedStep(-1)
{
}

scatter::Frame btHybridFrameOf(const btTransform& transform)
{
	scatter::Frame frame;
	for (int i = 0; i < 3; i++)
	{
		const btVector3& row = transform.getBasis()[i];
		frame.row[i] = scatter::Vec3(row.x(), row.y(), row.z());
	}
	const btVector3& origin = transform.getOrigin();
	frame.origin = scatter::Vec3(origin.x(), origin.y(), origin.z());
	return frame;
}

// Exact: a frame has the same numbers.
static btTransform transformOf(const scatter::Frame& frame)
{
	const scatter::Vec3* row = frame.row;
	const btMatrix3x3 basis(row[0].x, row[0].y, row[0].z, row[1].x, row[1].y, row[1].z, row[2].x, row[2].y, row[2].z);
	return btTransform(basis, btVector3(frame.origin.x, frame.origin.y, frame.origin.z));
}

void btHybridPartBody::boundsOf(int part, const scatter::Frame& frame, scatter::Vec3& low, scatter::Vec3& high) const
{
	btVector3 aabbMin, aabbMax;
	getChildShape(part)->getAabb(getChildTransform(part, transformOf(frame)), aabbMin, aabbMax);
	low = scatter::Vec3(aabbMin.x(), aabbMin.y(), aabbMin.z());
	high = scatter::Vec3(aabbMax.x(), aabbMax.y(), aabbMax.z());
}

void btHybridPartBody::moveTo(const btTransform& transform)
{
	m_body.moveTo(btHybridFrameOf(transform));
}

const btCollisionShape* btHybridPartBody::getChildShape(int part) const
{
	const btCollisionShape* shape = m_parts->getShape();
	return shape->isCompound() ? static_cast<const btCompoundShape*>(shape)->getChildShape(part) : shape;
}

btTransform btHybridPartBody::getChildTransform(int part, const btTransform& body) const
{
	const btCollisionShape* shape = m_parts->getShape();
	return shape->isCompound() ? body * static_cast<const btCompoundShape*>(shape)->getChildTransform(part) : body;
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
