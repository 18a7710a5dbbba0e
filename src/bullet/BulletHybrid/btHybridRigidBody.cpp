#include "BulletHybrid/btHybridRigidBody.h"

static btRigidBody::btRigidBodyConstructionInfo withShape(btRigidBody::btRigidBodyConstructionInfo info, btCollisionShape* shape)
{
	info.m_collisionShape = shape;
	return info;
}

static int startLevelOrFinest(const btHybridLevelSet* levels, int startLevel)
{
	btAssert(levels && levels->getNumLevels() > 0);
	btAssert(startLevel >= 0 && startLevel <= levels->getNumLevels());
	return startLevel == 0 ? levels->getNumLevels() : startLevel;
}

btHybridRigidBody::btHybridRigidBody(const btRigidBodyConstructionInfo& constructionInfo, const btHybridLevelSet* levels, int startLevel)
    : btRigidBody(withShape(constructionInfo, levels->getLevelShape(startLevelOrFinest(levels, startLevel)))),
      m_levels(levels),
      m_level(startLevelOrFinest(levels, startLevel)),
      m_lonelySteps(0),
      m_hybridIndex(-1),
      m_isHeld(false)
{
}
