#include "btHybridLevelBodies.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include "BulletHybrid/btHybridRigidBody.h"

btHybridLevelBodies::btHybridLevelBodies(const btCollisionObject* object, const btHybridRigidBody* hybrid)
    : m_object(object), m_hybrid(hybrid), m_users(0)
{
	m_bodies.resize(hybrid ? hybrid->getFinestLevel() + 1 : 1, 0);
}

int btHybridLevelBodies::getNumLevels() const
{
	return m_hybrid ? m_hybrid->getFinestLevel() : 0;
}

int btHybridLevelBodies::getNumParts() const
{
	const btCollisionShape* shape = getShape(getNumLevels());
	return shape->isCompound() ? static_cast<const btCompoundShape*>(shape)->getNumChildShapes() : 1;
}

int btHybridLevelBodies::askedLevel() const
{
	if (!m_hybrid)
		return 0;
	return m_hybrid->getRequest().isStanding() ? m_hybrid->getRequest().m_targetLevel : m_hybrid->getLevel();
}

int btHybridLevelBodies::getLevelIn(int pairLevel) const
{
	return btMin(pairLevel, getNumLevels());
}

const btCollisionShape* btHybridLevelBodies::getShape(int level) const
{
	return level > 0 ? m_hybrid->getLevels().getLevelShape(level) : m_object->getCollisionShape();
}
