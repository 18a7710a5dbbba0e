#ifndef BT_HYBRID_FIDELITY_H
#define BT_HYBRID_FIDELITY_H

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <LinearMath/btAlignedObjectArray.h>

/// How true the contacts of hybrid bodies are to their finest levels, at one moment.
struct btHybridFidelitySample
{
	int m_touchingPairs;  ///< pairs with a contact point that is closer than the touching distance

	/// Of those, [0] at the pair's finest level, [1] one level coarser, and so on.
	btAlignedObjectArray<int> m_touchingByLevel;

	int m_visibleOverlapPairs;  ///< touching or not, whose finest levels overlap by more than the visible depth

	/// Of each pair that touches at a coarser level: the distance of its finest levels, 0 if they overlap.
	btAlignedObjectArray<btScalar> m_contactGaps;

	btHybridFidelitySample() : m_touchingPairs(0), m_visibleOverlapPairs(0)
	{
	}
};

/// Compares where the finest levels of bodies are with the contacts that the last step was solved with. Looks at
/// the pairs whose broadphase bounds overlap and of which at least one object has levels; not at sensors, and not at
/// pairs that joints or filters keep from colliding. Works in any world, also for bodies at rest. Slow: brute force
/// with a memory of nothing. Leaves no trace in the world.
class btHybridFidelity
{
	const btCollisionWorld* m_world;

public:
	btScalar m_touchingDistance;  ///< metres; 0.01
	btScalar m_visibleDepth;      ///< metres; 0.05

	/// The world must outlive it; of 0 all samples are empty.
	explicit btHybridFidelity(const btCollisionWorld* world);
	virtual ~btHybridFidelity()
	{
	}

	/// How many levels an object has; 1 unless it is a btHybridRigidBody. Override it for a world in which other
	/// objects count too; their shape is their finest level.
	virtual int getNumLevels(const btCollisionObject* object) const;

	btHybridFidelitySample measure() const;
};

#endif  // BT_HYBRID_FIDELITY_H
