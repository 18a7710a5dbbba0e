#ifndef BT_HYBRID_COARSEST_BOUNDS_H
#define BT_HYBRID_COARSEST_BOUNDS_H

#include <LinearMath/btAlignedObjectArray.h>

#include "BulletHybrid/btHybridLevelSet.h"

/// World bounds of the coarsest levels of bodies, which have numbers. Where bodies are near each other they fit them,
/// so that fewer pairs overlap; those of a body that has hardly turned since they were found are the same but for its
/// place, and a little wider. Elsewhere they are Bullet's, which are found sooner.
class btHybridCoarsestBounds
{
	/// Around the body's origin.
	struct Turned
	{
		btMatrix3x3 m_basis;
		btVector3 m_min;
		btVector3 m_max;
	};
	btAlignedObjectArray<Turned> m_turned;
	bool m_fits;

	static void find(const btHybridLevelSet& levels, const btMatrix3x3& basis, Turned& turned);

public:
	btHybridCoarsestBounds() : m_fits(false)
	{
	}

	/// `pairs`: of the broadphase, as the last step has left them.
	void beginStep(int pairs);

	/// The number of the next body is that of bodies so far.
	void add();

	/// The last body has its number from then on.
	void remove(int body);

	/// `body` must have had these levels since it was added.
	void getAabb(int body, const btHybridLevelSet& levels, const btTransform& transform, btVector3& aabbMin,
	             btVector3& aabbMax);
};

#endif  // BT_HYBRID_COARSEST_BOUNDS_H
