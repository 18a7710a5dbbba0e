#ifndef BT_HYBRID_PART_BODY_H
#define BT_HYBRID_PART_BODY_H

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>

#include "btHybridConversions.h"
#include "btHybridParts.h"
#include "collision/part_body.h"

/// A collision object, with one of its shapes, as a body of parts: shared by its pair algorithms.
class btHybridPartBody : private scatter::EngineBounds
{
	const btCollisionObject* m_object;
	btHybridParts* m_parts;
	scatter::PartBody m_body;
	bool m_changes;     ///< its shape may change in place: it is not a hybrid's level
	int m_version;      ///< counts the changes of its parts
	int m_checkedStep;  ///< the last step in which its shape was looked at thoroughly

	friend class btHybridObjects;

	btHybridPartBody(const btCollisionObject* object, btHybridParts* parts);

	virtual void boundsOf(int part, const scatter::Frame& frame, scatter::Vec3& low, scatter::Vec3& high) const;

public:
	BT_DECLARE_ALIGNED_ALLOCATOR();

	scatter::PartBody& getBody()
	{
		return m_body;
	}
	const scatter::PartBody& getBody() const
	{
		return m_body;
	}
	int getVersion() const
	{
		return m_version;
	}

	void moveTo(const btTransform& transform);

	const btCollisionShape* getShape() const
	{
		return m_parts->getShape();
	}

	/// The same, unless it is the object's collision shape and that has been replaced.
	const btCollisionShape* getShapeNow() const
	{
		return m_changes ? m_object->getCollisionShape() : getShape();
	}

	/// The index by which Bullet knows a part: that of the compound's child, or -1.
	int getChildIndex(int part) const
	{
		return m_parts->getPartIndex(part);
	}
	const btCollisionShape* getChildShape(int part) const;

	/// Whether the shape is a compound with a tree of its children's bounds.
	bool hasLeaves() const;

	/// A part's bounds in the body's frame, as they are in its compound's tree.
	void getLeaf(int part, btVector3& aabbMin, btVector3& aabbMax) const;

	/// The same in another frame, in which the body is at `body`: a leaf turned, or without leaves the bounds of
	/// the whole shape.
	void getLeafIn(int part, const btTransform& body, btVector3& aabbMin, btVector3& aabbMax) const;

	/// World transform of a part, with the body at `body`.
	btTransform getChildTransform(int part, const btTransform& body) const;
};

#endif  // BT_HYBRID_PART_BODY_H
