#ifndef BT_HYBRID_GHOST_PAIRS_H
#define BT_HYBRID_GHOST_PAIRS_H

#include <BulletCollision/CollisionDispatch/btGhostObject.h>

/// The pairs that a ghost keeps beside those of the broadphase, with algorithms of their own, and that a character
/// dispatches when it moves; 0 if the object keeps none.
inline btOverlappingPairCache* btHybridGhostPairs(const btCollisionObject* object)
{
	if (object->getInternalType() != btCollisionObject::CO_GHOST_OBJECT)
		return 0;
	btPairCachingGhostObject* ghost = dynamic_cast<btPairCachingGhostObject*>(const_cast<btCollisionObject*>(object));
	return ghost ? ghost->getOverlappingPairCache() : 0;
}

#endif  // BT_HYBRID_GHOST_PAIRS_H
