#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "btHybridDetectors.h"
#include "btHybridPairEngine.h"

// How two parts get their contacts from Bullet.

using scatter::ChildPair;

namespace
{
/// Tells a manifold result which parts are at work, as Bullet's compound algorithms do, for as long as it lives.
class ChildScope
{
	btManifoldResult* m_result;
	const btCollisionObjectWrapper* m_before[2];
	btTransform m_transforms[2];
	btCollisionObjectWrapper m_children[2];
	const btCollisionObjectWrapper* m_wraps[2];

public:
	ChildScope(btManifoldResult* result, const btHybridPairBodies& bodies, const ChildPair& child)
	    : ChildScope(result, *bodies.m_bodies[0], child.a, *bodies.m_bodies[1], child.b)
	{
	}
	ChildScope(btManifoldResult* result, const btHybridPartBody& bodyA, int partA, const btHybridPartBody& bodyB,
	           int partB)
	    : m_result(result),
	      m_before{result->getBody0Wrap(), result->getBody1Wrap()},
	      m_transforms{bodyA.getChildTransform(partA, m_before[0]->getWorldTransform()),
	                   bodyB.getChildTransform(partB, m_before[1]->getWorldTransform())},
	      m_children{{m_before[0], bodyA.getChildShape(partA), m_before[0]->getCollisionObject(), m_transforms[0], -1,
	                  bodyA.getChildIndex(partA)},
	                 {m_before[1], bodyB.getChildShape(partB), m_before[1]->getCollisionObject(), m_transforms[1], -1,
	                  bodyB.getChildIndex(partB)}}
	{
		m_wraps[0] = bodyA.getChildIndex(partA) < 0 ? m_before[0] : &m_children[0];
		m_wraps[1] = bodyB.getChildIndex(partB) < 0 ? m_before[1] : &m_children[1];
		m_result->setBody0Wrap(m_wraps[0]);
		m_result->setBody1Wrap(m_wraps[1]);
		m_result->setShapeIdentifiersA(-1, bodyA.getChildIndex(partA));
		m_result->setShapeIdentifiersB(-1, bodyB.getChildIndex(partB));
	}
	~ChildScope()
	{
		m_result->setPersistentManifold(0);
		m_result->setBody0Wrap(m_before[0]);
		m_result->setBody1Wrap(m_before[1]);
	}

	const btCollisionObjectWrapper* getWrap(int body) const
	{
		return m_wraps[body];
	}
};

/// Keeps the one point that Bullet's GJK finds.
struct PointResult : public btDiscreteCollisionDetectorInterface::Result
{
	btVector3 m_normal;
	btVector3 m_point;
	btScalar m_distance;
	bool m_found;

	PointResult() : m_normal(0, 0, 0), m_point(0, 0, 0), m_distance(0), m_found(false)
	{
	}
	virtual void setShapeIdentifiersA(int, int)
	{
	}
	virtual void setShapeIdentifiersB(int, int)
	{
	}
	virtual void addContactPoint(const btVector3& normalOnBInWorld, const btVector3& pointInWorld, btScalar depth)
	{
		m_normal = normalOnBInWorld;
		m_point = pointInWorld;
		m_distance = depth;
		m_found = true;
	}
};

/// Takes contacts of two shapes in the other order.
class FlippedResult : public btManifoldResult
{
	btManifoldResult* m_result;

public:
	FlippedResult(btManifoldResult* result, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b)
	    : btManifoldResult(b, a), m_result(result)
	{
		setPersistentManifold(result->getPersistentManifold());
	}
	virtual void addContactPoint(const btVector3& normalOnBInWorld, const btVector3& pointInWorld, btScalar depth)
	{
		m_result->addContactPoint(-normalOnBInWorld, pointInWorld + normalOnBInWorld * depth, depth);
	}
};

btVector3 toWorld(const scatter::Frame& frame, const scatter::Vec3& point)
{
	const scatter::Vec3 world = frame(point);
	return btVector3(world.x, world.y, world.z);
}

// As btSphereSphereCollisionAlgorithm does it.
void collideSpheres(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, btManifoldResult* result)
{
	const btScalar radiusA = static_cast<const btSphereShape*>(a->getCollisionShape())->getRadius();
	const btScalar radiusB = static_cast<const btSphereShape*>(b->getCollisionShape())->getRadius();
	const btVector3 between = a->getWorldTransform().getOrigin() - b->getWorldTransform().getOrigin();
	const btScalar length = between.length();
	if (length > radiusA + radiusB)
		return;
	const btVector3 normal = length > SIMD_EPSILON ? between / length : btVector3(1, 0, 0);
	result->addContactPoint(normal, b->getWorldTransform().getOrigin() + radiusB * normal,
	                        length - (radiusA + radiusB));
}

bool areBoth(int type, const btCollisionShape* a, const btCollisionShape* b)
{
	return a->getShapeType() == type && b->getShapeType() == type;
}
}  // namespace

btPersistentManifold* btHybridPairEngine::manifoldOf(ChildPair& child)
{
	if (!child.contact)
		child.contact = newManifold();
	return static_cast<btPersistentManifold*>(child.contact);
}

void btHybridPairEngine::add(ChildPair& child, const scatter::PartContact& contact)
{
	getWrap(0);
	const scatter::Frame& frameA = m_bodies.m_bodies[0]->getBody().frame();
	const scatter::Vec3 normal = -frameA.rotate(contact.axis);
	ChildScope scope(m_call.m_result, m_bodies, child);
	m_call.m_result->setPersistentManifold(manifoldOf(child));
	m_call.m_result->addContactPoint(btVector3(normal.x, normal.y, normal.z), toWorld(frameA, contact.pointB),
	                                 contact.distance);
}

void btHybridPairEngine::detect(scatter::PartPair& parts, ChildPair& child)
{
	getWrap(0);
	if (m_ownGjk)
		detectByAlgorithm(child);
	else
		detectByGjk(parts, child);
}

// What Bullet does with these two shapes, into this child pair's manifold. The algorithms for boxes and spheres
// insist on manifolds of their own, so their work is called directly.
void btHybridPairEngine::detectByAlgorithm(ChildPair& child)
{
	btPersistentManifold* manifold = manifoldOf(child);
	ChildScope scope(m_call.m_result, m_bodies, child);
	m_call.m_result->setPersistentManifold(manifold);
	const btCollisionObjectWrapper* a = scope.getWrap(0);
	const btCollisionObjectWrapper* b = scope.getWrap(1);
	if (areBoth(BOX_SHAPE_PROXYTYPE, a->getCollisionShape(), b->getCollisionShape()))
		return btHybridCollideBoxes(a, b, m_call.m_info, m_call.m_result);
	if (areBoth(SPHERE_SHAPE_PROXYTYPE, a->getCollisionShape(), b->getCollisionShape()))
	{
		manifold->clearManifold();
		return collideSpheres(a, b, m_call.m_result);
	}
	const bool isFlipped = looksFromB(child);
	FlippedResult flipped(m_call.m_result, a, b);
	if (isFlipped)
		btSwap(a, b);
	btHybridDetect(m_dispatcher, a, b, manifold, m_call.m_info, isFlipped ? &flipped : m_call.m_result);
}

// Bullet's GJK does not always find the same in both orders of two shapes. In Bullet a compound's children come first,
// and with two compounds of which one has no tree, the second one's. A bare box, sphere, capsule or hull comes first
// here, for the sake of results that are what they were; the order matters for shapes of other kinds.
bool btHybridPairEngine::looksFromB(const ChildPair& child) const
{
	const btHybridPartBody& bodyA = *m_bodies.m_bodies[0];
	const btHybridPartBody& bodyB = *m_bodies.m_bodies[1];
	if (!bodyB.getShape()->isCompound() || (bodyA.hasLeaves() && bodyB.hasLeaves()))
		return false;
	return bodyA.getShape()->isCompound() || isOdd(0, child.a) || isOdd(1, child.b);
}

bool btHybridPairEngine::isOdd(int body, int part) const
{
	const scatter::PartKind kind = getPart(body, part).kind;
	return kind == scatter::PartKind::kEnclosed || kind == scatter::PartKind::kOpaque;
}

bool btHybridPairEngine::areSpheres(const ChildPair& child) const
{
	return getPart(0, child.a).kind == scatter::PartKind::kSphere &&
	       getPart(1, child.b).kind == scatter::PartKind::kSphere;
}

// In the place of scatter's GJK, to measure what that is worth.
void btHybridPairEngine::detectByGjk(scatter::PartPair& parts, ChildPair& child)
{
	const btCollisionShape* shapes[2] = {m_bodies.m_bodies[0]->getChildShape(child.a),
	                                     m_bodies.m_bodies[1]->getChildShape(child.b)};
	if (areBoth(BOX_SHAPE_PROXYTYPE, shapes[0], shapes[1]) || areBoth(SPHERE_SHAPE_PROXYTYPE, shapes[0], shapes[1]))
		return detectByAlgorithm(child);
	ChildScope scope(m_call.m_result, m_bodies, child);
	btGjkPairDetector::ClosestPointInput input;
	input.m_transformA = scope.getWrap(0)->getWorldTransform();
	input.m_transformB = scope.getWrap(1)->getWorldTransform();
	const btScalar furthest = shapes[0]->getMargin() + shapes[1]->getMargin() + parts.threshold();
	input.m_maximumDistanceSquared = furthest * furthest;
	btVoronoiSimplexSolver simplex;
	btGjkEpaPenetrationDepthSolver penetration;
	btGjkPairDetector detector(static_cast<const btConvexShape*>(shapes[0]),
	                           static_cast<const btConvexShape*>(shapes[1]), &simplex, &penetration);
	PointResult result;
	detector.getClosestPoints(input, result, 0);
	btVector3 axis = result.m_found ? -result.m_normal : -detector.getCachedSeparatingAxis();
	if (axis.length2() > SIMD_EPSILON)
	{
		axis = m_call.m_wraps[0]->getWorldTransform().getBasis().transpose() * axis.normalized();
		parts.learnAxis(child, m_bodies.m_bodies[0]->getBody(), m_bodies.m_bodies[1]->getBody(),
		                scatter::Vec3(axis.x(), axis.y(), axis.z()));
	}
	if (!result.m_found || result.m_distance > parts.threshold())
		return;
	m_call.m_result->setPersistentManifold(manifoldOf(child));
	m_call.m_result->addContactPoint(result.m_normal, result.m_point, result.m_distance);
}
