#ifndef BT_HYBRID_RIGID_BODY_H
#define BT_HYBRID_RIGID_BODY_H

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "BulletHybrid/btHybridLevelSet.h"
#include "BulletHybrid/btHybridRequest.h"

class btDynamicsWorld;
class btHybridDynamicsWorld;

/// A rigid body with several encapsulation levels, of which one is its collision shape: in pair switching always the
/// finest, once it is in the world. In any other world than btHybridDynamicsWorld it is an ordinary rigid body that
/// stays at the level it has.
/// Mass and inertia are the caller's and do not change with the level.
class btHybridRigidBody : public btRigidBody
{
	friend class btHybridBodySwitching;
	friend class btHybridDynamicsWorld;
	friend class btHybridRequests;

	const btHybridLevelSet* m_levels;
	int m_finestLevel;
	int m_level;
	btHybridRequest m_request;
	int m_lonelySteps;
	btHybridDynamicsWorld* m_world;
	btDynamicsWorld* m_home;  ///< the same, to leave it
	int m_hybridIndex;
	bool m_isHeld;

public:
	BT_DECLARE_ALIGNED_ALLOCATOR();

	/// The body starts at startLevel; 0, the default, is the finest. Below 0 it acts as 1, above the finest as the
	/// finest. levels must outlive the body, which has those that are there now.
	///
	/// If levels is 0 or empty, this is an ordinary rigid body, in every world, that has no levels: its shape is
	/// constructionInfo.m_collisionShape, or a btEmptyShape if that is 0. With levels constructionInfo.m_collisionShape
	/// is ignored.
	btHybridRigidBody(const btRigidBodyConstructionInfo& constructionInfo, const btHybridLevelSet* levels,
	                  int startLevel = 0);

	/// Leaves its btHybridDynamicsWorld first, if it is still in one. Its constraints must have left before, and it
	/// must not end inside a step.
	virtual ~btHybridRigidBody();

	/// The btHybridDynamicsWorld that it is in; 0 if it is in none, or in a world of another kind.
	btHybridDynamicsWorld* getWorld() const
	{
		return m_world;
	}

	/// An empty set if the body has no levels.
	const btHybridLevelSet& getLevels() const
	{
		return *m_levels;
	}

	/// The level in use, 1 the coarsest. In pair switching: the one that the program holds its pairs to, unless a
	/// policy or the budget asks for a coarser one. 0 if the body has no levels.
	int getLevel() const
	{
		return m_level;
	}

	/// The number of levels that the body has; levels that were added to the set after the body was made do not count.
	int getFinestLevel() const
	{
		return m_finestLevel;
	}

	/// The user has it in hand, so that its contacts matter most: the policy "held" looks at it.
	void setHeld(bool held)
	{
		m_isHeld = held;
	}
	bool isHeld() const
	{
		return m_isHeld;
	}

	const btHybridRequest& getRequest() const
	{
		return m_request;
	}

	/// The hybrid that this object is, or 0; a body without levels is none.
	static btHybridRigidBody* upcast(btCollisionObject* object)
	{
		btHybridRigidBody* hybrid = dynamic_cast<btHybridRigidBody*>(object);
		return hybrid && hybrid->m_finestLevel > 0 ? hybrid : 0;
	}
	static const btHybridRigidBody* upcast(const btCollisionObject* object)
	{
		const btHybridRigidBody* hybrid = dynamic_cast<const btHybridRigidBody*>(object);
		return hybrid && hybrid->m_finestLevel > 0 ? hybrid : 0;
	}
};

#endif  // BT_HYBRID_RIGID_BODY_H
