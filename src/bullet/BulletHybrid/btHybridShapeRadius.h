#ifndef BT_HYBRID_SHAPE_RADIUS_H
#define BT_HYBRID_SHAPE_RADIUS_H

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

/// Of a ball around the origin of the shape's frame that holds the shape, by Bullet's bounding sphere; metres.
inline btScalar btHybridRadiusOf(const btCollisionShape* shape)
{
	btVector3 center;
	btScalar radius;
	shape->getBoundingSphere(center, radius);
	return center.length() + radius;
}

#endif  // BT_HYBRID_SHAPE_RADIUS_H
