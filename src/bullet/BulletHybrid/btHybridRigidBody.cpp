#include "BulletHybrid/btHybridRigidBody.h"

#include <BulletCollision/CollisionShapes/btEmptyShape.h>
#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

namespace
{
// Never destroyed, so that bodies may outlive everything.
const btHybridLevelSet* noLevels()
{
	static const btHybridLevelSet* const levels = new btHybridLevelSet;
	return levels;
}

btCollisionShape* noShape()
{
	static btCollisionShape* const shape = new btEmptyShape;
	return shape;
}

int startLevelOrFinest(const btHybridLevelSet* levels, int startLevel)
{
	const int finest = levels ? levels->getNumLevels() : 0;
	return startLevel == 0 ? finest : btMin(btMax(startLevel, 1), finest);
}

btRigidBody::btRigidBodyConstructionInfo withShape(btRigidBody::btRigidBodyConstructionInfo info,
                                                   const btHybridLevelSet* levels, int startLevel)
{
	const int level = startLevelOrFinest(levels, startLevel);
	if (level > 0)
		info.m_collisionShape = levels->getLevelShape(level);
	else if (!info.m_collisionShape)
		info.m_collisionShape = noShape();
	return info;
}
}  // namespace

btHybridRigidBody::btHybridRigidBody(const btRigidBodyConstructionInfo& constructionInfo,
                                     const btHybridLevelSet* levels, int startLevel)
    : btRigidBody(withShape(constructionInfo, levels, startLevel)),
      m_levels(levels ? levels : noLevels()),
      m_finestLevel(m_levels->getNumLevels()),
      m_level(startLevelOrFinest(levels, startLevel)),
      m_lonelySteps(0),
      m_world(0),
      m_home(0),
      m_hybridIndex(-1),
      m_isHeld(false)
{
}

btHybridRigidBody::~btHybridRigidBody()
{
	if (m_home)
		m_home->removeRigidBody(this);
}
