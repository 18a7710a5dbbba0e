#ifndef BT_HYBRID_LEVEL_BODIES_H
#define BT_HYBRID_LEVEL_BODIES_H

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <LinearMath/btAlignedObjectArray.h>

#include "pairs/planned_body.h"

class btHybridPartBody;
class btHybridRigidBody;

/// A collision object as its pairs see it: one body of parts for each level that a pair has used. An object that
/// does not switch by pairs has one, with its collision shape, as level 0.
class btHybridLevelBodies : public scatter::pairs::PlannedBody
{
	const btCollisionObject* m_object;
	const btHybridRigidBody* m_hybrid;                 ///< 0 unless it switches by pairs
	btAlignedObjectArray<btHybridPartBody*> m_bodies;  ///< by level; 0 as long as none was needed
	int m_users;

	friend class btHybridObjects;

	btHybridLevelBodies(const btCollisionObject* object, const btHybridRigidBody* hybrid);

public:
	const btCollisionObject* getObject() const
	{
		return m_object;
	}

	/// Levels in pairs: 0 if it has none.
	int getNumLevels() const;

	/// At its finest level.
	int getNumParts() const;

	virtual const void* object() const
	{
		return m_object;
	}
	virtual unsigned int index() const
	{
		return m_object->getWorldArrayIndex();
	}
	/// The level that the program holds its pairs to, or has requested; 0: none.
	virtual int askedLevel() const;
	virtual bool hasResponse() const
	{
		return m_object->hasContactResponse();
	}

	virtual bool easesContacts() const
	{
		return !(m_object->getCollisionFlags() & btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING);
	}

	virtual bool isMovable() const
	{
		return !m_object->isStaticOrKinematicObject();
	}

	/// The object's own level in a pair that is at `pairLevel`: bodies with fewer levels take part with their finest.
	int getLevelIn(int pairLevel) const;

	/// 0: the collision shape, as far as known.
	const btCollisionShape* getShape(int level) const;
};

#endif  // BT_HYBRID_LEVEL_BODIES_H
