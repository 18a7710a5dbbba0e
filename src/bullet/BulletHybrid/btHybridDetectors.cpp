#include "btHybridDetectors.h"

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionDispatch/btCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btConvexPlaneCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/NarrowPhaseCollision/btDiscreteCollisionDetectorInterface.h>

void btHybridCollideBoxes(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo& info, btManifoldResult* result)
{
	btDiscreteCollisionDetectorInterface::ClosestPointInput input;
	input.m_maximumDistanceSquared = BT_LARGE_FLOAT;
	input.m_transformA = a->getWorldTransform();
	input.m_transformB = b->getWorldTransform();
	btBoxBoxDetector detector(static_cast<const btBoxShape*>(a->getCollisionShape()),
	                          static_cast<const btBoxShape*>(b->getCollisionShape()));
	detector.getClosestPoints(input, *result, info.m_debugDraw);
}

// A program may have asked for more points than one a step.
static void collideWithPlane(btCollisionDispatcher* dispatcher, const btCollisionObjectWrapper* convex,
                             const btCollisionObjectWrapper* plane, btPersistentManifold* manifold,
                             const btDispatcherInfo& info, btManifoldResult* result)
{
	btCollisionAlgorithmCreateFunc* create = dispatcher->getCollisionConfiguration()->getCollisionAlgorithmCreateFunc(
	    convex->getCollisionShape()->getShapeType(), STATIC_PLANE_PROXYTYPE);
	const btConvexPlaneCollisionAlgorithm::CreateFunc* known =
	    dynamic_cast<btConvexPlaneCollisionAlgorithm::CreateFunc*>(create);
	btCollisionAlgorithmConstructionInfo construction;
	construction.m_dispatcher1 = dispatcher;
	btConvexPlaneCollisionAlgorithm algorithm(manifold, construction, convex, plane, false,
	                                          known ? known->m_numPerturbationIterations : 0,
	                                          known ? known->m_minimumPointsPerturbationThreshold : 0);
	algorithm.processCollision(convex, plane, info, result);
}

void btHybridDetect(btCollisionDispatcher* dispatcher, const btCollisionObjectWrapper* a,
                    const btCollisionObjectWrapper* b, btPersistentManifold* manifold, const btDispatcherInfo& info,
                    btManifoldResult* result)
{
	const int types[2] = {a->getCollisionShape()->getShapeType(), b->getCollisionShape()->getShapeType()};
	if (types[0] == BOX_SHAPE_PROXYTYPE && types[1] == BOX_SHAPE_PROXYTYPE)
		return btHybridCollideBoxes(a, b, info, result);
	if (types[1] == STATIC_PLANE_PROXYTYPE)
		return collideWithPlane(dispatcher, a, b, manifold, info, result);
	btCollisionAlgorithm* algorithm = dispatcher->findAlgorithm(a, b, manifold, BT_CONTACT_POINT_ALGORITHMS);
	algorithm->processCollision(a, b, info, result);
	algorithm->~btCollisionAlgorithm();
	dispatcher->freeCollisionAlgorithm(algorithm);
}
