#ifndef BT_HYBRID_RIGID_BODY_H
#define BT_HYBRID_RIGID_BODY_H

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "BulletHybrid/btHybridLevelSet.h"
#include "BulletHybrid/btHybridRequest.h"

/// A rigid body with several encapsulation levels, of which one is its collision shape. In any other world
/// than btHybridDynamicsWorld it is an ordinary rigid body that stays at the level it has.
/// Mass and inertia are the caller's and do not change with the level.
class btHybridRigidBody : public btRigidBody
{
	friend class btHybridDynamicsWorld;

	const btHybridLevelSet* m_levels;
	int m_level;
	btHybridRequest m_request;
	int m_lonelySteps;
	int m_hybridIndex;

public:
	BT_DECLARE_ALIGNED_ALLOCATOR();

	/// constructionInfo.m_collisionShape is ignored: the body starts at startLevel, by default the finest.
	/// levels must outlive the body.
	btHybridRigidBody(const btRigidBodyConstructionInfo& constructionInfo, const btHybridLevelSet* levels, int startLevel = 0);

	const btHybridLevelSet& getLevels() const
	{
		return *m_levels;
	}

	/// The level in use, 1 the coarsest.
	int getLevel() const
	{
		return m_level;
	}

	int getFinestLevel() const
	{
		return m_levels->getNumLevels();
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
