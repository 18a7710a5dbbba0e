#ifndef BT_HYBRID_RIGID_BODY_H
#define BT_HYBRID_RIGID_BODY_H

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "BulletHybrid/btHybridLevelSet.h"
#include "BulletHybrid/btHybridRequest.h"

/// A rigid body with several encapsulation levels, of which one is its collision shape: in pair switching always the
/// finest, once it is in the world. In any other world than btHybridDynamicsWorld it is an ordinary rigid body that
/// stays at the level it has.
/// Mass and inertia are the caller's and do not change with the level.
class btHybridRigidBody : public btRigidBody
{
	friend class btHybridDynamicsWorld;
	friend class btHybridPlanner;

	const btHybridLevelSet* m_levels;
	int m_level;
	btHybridRequest m_request;
	int m_lonelySteps;
	int m_hybridIndex;
	bool m_isHeld;

public:
	BT_DECLARE_ALIGNED_ALLOCATOR();

	/// constructionInfo.m_collisionShape is ignored: the body starts at startLevel, by default the finest.
	/// levels must outlive the body.
	btHybridRigidBody(const btRigidBodyConstructionInfo& constructionInfo, const btHybridLevelSet* levels, int startLevel = 0);

	const btHybridLevelSet& getLevels() const
	{
		return *m_levels;
	}

	/// The level in use, 1 the coarsest. In pair switching: the one that the program holds its pairs to, unless a
	/// policy or the budget asks for a coarser one.
	int getLevel() const
	{
		return m_level;
	}

	int getFinestLevel() const
	{
		return m_levels->getNumLevels();
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

	/// The hybrid that this object is, or 0.
	static btHybridRigidBody* upcast(btCollisionObject* object)
	{
		return dynamic_cast<btHybridRigidBody*>(object);
	}
	static const btHybridRigidBody* upcast(const btCollisionObject* object)
	{
		return dynamic_cast<const btHybridRigidBody*>(object);
	}
};

#endif  // BT_HYBRID_RIGID_BODY_H
