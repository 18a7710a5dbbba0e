#ifndef BT_HYBRID_LEVEL_SET_H
#define BT_HYBRID_LEVEL_SET_H

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <LinearMath/btAlignedObjectArray.h>

/// The encapsulation levels of a model, coarsest first. Each level is a convex shape or a btCompoundShape
/// of convex shapes, in the same frame (that of the body's centre of mass), and lies inside the level
/// before it; this class does not check that. Shared by any number of bodies; does not own the shapes.
class btHybridLevelSet
{
	btAlignedObjectArray<btCollisionShape*> m_levels;

public:
	/// Adds the next finer level.
	void addLevel(btCollisionShape* shape)
	{
		btAssert(shape);
		m_levels.push_back(shape);
	}

	int getNumLevels() const
	{
		return m_levels.size();
	}

	/// level counts from 1, the coarsest, to getNumLevels(), the finest.
	btCollisionShape* getLevelShape(int level) const
	{
		return m_levels[level - 1];
	}

	/// World bounds of level 1, which hold every level.
	void getCoarsestAabb(const btTransform& transform, btVector3& aabbMin, btVector3& aabbMax) const
	{
		m_levels[0]->getAabb(transform, aabbMin, aabbMax);
	}
};

#endif  // BT_HYBRID_LEVEL_SET_H
