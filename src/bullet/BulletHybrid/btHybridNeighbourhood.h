#ifndef BT_HYBRID_NEIGHBOURHOOD_H
#define BT_HYBRID_NEIGHBOURHOOD_H

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "BulletHybrid/btHybridRigidBody.h"

/// Who is near each hybrid in the step under way: overlapping pairs, and moving bodies that could soon overlap.
class btHybridNeighbourhood
{
	/// The pairs of hybrid i are m_pairs[m_firstPair[i]] up to m_pairs[m_firstPair[i + 1]].
	btAlignedObjectArray<int> m_firstPair;
	btAlignedObjectArray<btBroadphasePair*> m_pairs;

	// By world array index.
	btAlignedObjectArray<int> m_hybridOfObject;      ///< index of the hybrid; -1 for other objects
	btAlignedObjectArray<btScalar> m_speedOfObject;  ///< of its fastest point; 0 if static
	btScalar m_topSpeed;

	int hybridOf(const btBroadphaseProxy* proxy) const;

public:
	btHybridNeighbourhood() : m_topSpeed(0)
	{
	}

	/// Must be called again when an object has come, gone or moved in the world's array.
	void indexHybrids(int numObjects, const btAlignedObjectArray<btHybridRigidBody*>& hybrids);

	int getNumObjects() const
	{
		return m_hybridOfObject.size();
	}

	/// The index of the hybrid that has this world array index, or -1.
	int hybridOfObject(int worldArrayIndex) const
	{
		return m_hybridOfObject[worldArrayIndex];
	}

	/// Sorts the broadphase's pairs by hybrid; valid until the pairs change.
	void collectPairs(btBroadphasePairArray& pairs, int numHybrids);
	void measureSpeeds(const btAlignedObjectArray<btRigidBody*>& nonStaticBodies);

	int getNumPairs(int hybrid) const
	{
		return m_firstPair[hybrid + 1] - m_firstPair[hybrid];
	}
	btBroadphasePair* getPair(int hybrid, int index) const
	{
		return m_pairs[m_firstPair[hybrid] + index];
	}

	/// Whether a body that is not static could reach the hybrid's bounds within `seconds` at present speeds.
	bool hasMovingNeighbour(const btHybridRigidBody* body, int hybrid, btScalar seconds,
	                        btBroadphaseInterface* broadphase) const;
};

#endif  // BT_HYBRID_NEIGHBOURHOOD_H
