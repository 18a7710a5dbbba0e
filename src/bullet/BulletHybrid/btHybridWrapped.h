#ifndef BT_HYBRID_WRAPPED_H
#define BT_HYBRID_WRAPPED_H

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>

/// An object as the near callback of Bullet's dispatcher hands it to an algorithm.
inline btCollisionObjectWrapper btHybridWrapped(const btCollisionObject* object)
{
	return btCollisionObjectWrapper(0, object->getCollisionShape(), object, object->getWorldTransform(), -1, -1);
}

#endif  // BT_HYBRID_WRAPPED_H
