#include "btHybridBruteForce.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <LinearMath/btAabbUtil2.h>

namespace
{
btScalar largestComponent(const btVector3& v)
{
	const btVector3 positive = v.absolute();
	return positive[positive.maxAxis()];
}

// False for anything that is not a number.
bool overlap(const btVector3& minA, const btVector3& maxA, const btVector3& minB, const btVector3& maxB, btScalar slack)
{
	for (int axis = 0; axis < 3; axis++)
		if (!(minA[axis] <= maxB[axis] + slack && minB[axis] <= maxA[axis] + slack))
			return false;
	return true;
}

// The test of the leaves in btCompoundCompoundCollisionAlgorithm and btCompoundCollisionAlgorithm.
bool leavesOverlap(const btHybridConvexSide& a, const btHybridConvexChild& childA, const btHybridConvexSide& b, const btHybridConvexChild& childB, btScalar slack)
{
	const btTransform bInA = a.m_object->getWorldTransform().inverse() * b.m_object->getWorldTransform();
	btVector3 lower, upper;
	if (childA.m_leaf)
	{
		if (childB.m_leaf)
			btTransformAabb(childB.m_leaf->volume.Mins(), childB.m_leaf->volume.Maxs(), btScalar(0), bInA, lower, upper);
		else
			b.m_object->getCollisionShape()->getAabb(bInA, lower, upper);
		return overlap(childA.m_leaf->volume.Mins(), childA.m_leaf->volume.Maxs(), lower, upper, slack);
	}
	if (childB.m_leaf)
	{
		childA.m_shape->getAabb(b.m_object->getWorldTransform().inverse() * childA.m_transform, lower, upper);
		return overlap(childB.m_leaf->volume.Mins(), childB.m_leaf->volume.Maxs(), lower, upper, slack);
	}
	return true;
}

bool userLetsThrough(const btHybridConvexSide& a, const btHybridConvexChild& childA, const btHybridConvexSide& b, const btHybridConvexChild& childB)
{
	if (a.m_compound && b.m_compound)
		return !gCompoundCompoundChildShapePairCallback || gCompoundCompoundChildShapePairCallback(childA.m_shape, childB.m_shape);
	if (!gCompoundChildShapePairCallback)
		return true;
	return a.m_compound ? gCompoundChildShapePairCallback(childB.m_shape, childA.m_shape) : gCompoundChildShapePairCallback(childA.m_shape, childB.m_shape);
}

const btConvexShape* asConvex(const btHybridConvexChild& child)
{
	return static_cast<const btConvexShape*>(child.m_shape);
}

// The point of a child's core that is furthest along a world direction, seen from the child's origin.
btVector3 furthest(const btHybridConvexChild& child, const btVector3& direction)
{
	return child.m_transform.getBasis() * asConvex(child)->localGetSupportVertexWithoutMarginNonVirtual(direction * child.m_transform.getBasis());
}

class PrivateDispatcher : public btCollisionDispatcher
{
public:
	PrivateDispatcher(btCollisionConfiguration* configuration, const btDispatcher* model)
	    : btCollisionDispatcher(configuration)
	{
		// The flags say whether the contact breaking threshold is relative to the shapes.
		if (const btCollisionDispatcher* dispatcher = dynamic_cast<const btCollisionDispatcher*>(model))
			setDispatcherFlags(dispatcher->getDispatcherFlags() & CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
	}

	// The world's dispatcher has decided; some algorithms ask again when they are made.
	virtual bool needsCollision(const btCollisionObject* /*a*/, const btCollisionObject* /*b*/)
	{
		return true;
	}
};

btDefaultCollisionConstructionInfo smallPools()
{
	btDefaultCollisionConstructionInfo info;
	info.m_defaultMaxPersistentManifoldPoolSize = 4;
	info.m_defaultMaxCollisionAlgorithmPoolSize = 4;
	return info;
}
}  // namespace

btHybridConvexChild::btHybridConvexChild(const btCollisionShape* shape, const btTransform& body, const btTransform& transform, int index, const btDbvtNode* leaf)
    : m_shape(shape), m_transform(transform), m_leaf(leaf), m_index(index)
{
	shape->getAabb(transform, m_min, m_max);
	const btVector3& origin = body.getOrigin();
	const btScalar reach = largestComponent(m_min) + largestComponent(m_max) + largestComponent(origin) + largestComponent(transform.getOrigin() - origin);
	m_rounding = btScalar(4) * SIMD_EPSILON * reach;
}

bool btHybridConvexSide::collect(const btCollisionObject* object)
{
	m_object = object;
	m_children.resizeNoInitialize(0);
	const btCollisionShape* shape = object->getCollisionShape();
	const btTransform& body = object->getWorldTransform();
	m_compound = shape->isCompound() ? static_cast<const btCompoundShape*>(shape) : 0;
	if (!m_compound)
	{
		if (shape->isConvex())
			m_children.push_back(btHybridConvexChild(shape, body, body, -1, 0));
		return shape->isConvex();
	}
	for (int i = 0; i < m_compound->getNumChildShapes(); i++)
	{
		const btCollisionShape* child = m_compound->getChildShape(i);
		if (!child->isConvex())
			return false;
		// Bullet's getter of the child list is not const.
		const btDbvtNode* leaf = m_compound->getDynamicAabbTree() ? const_cast<btCompoundShape*>(m_compound)->getChildList()[i].m_node : 0;
		m_children.push_back(btHybridConvexChild(child, body, body * m_compound->getChildTransform(i), i, leaf));
	}
	return true;
}

bool btHybridMidphaseKeeps(const btHybridConvexSide& a, const btHybridConvexChild& childA, const btHybridConvexSide& b, const btHybridConvexChild& childB, bool isNew, btScalar slack)
{
	if (!a.m_compound && !b.m_compound)
		return true;
	return overlap(childA.m_min, childA.m_max, childB.m_min, childB.m_max, slack) && (!isNew || leavesOverlap(a, childA, b, childB, slack)) && userLetsThrough(a, childA, b, childB);
}

bool btHybridAreBoxes(const btHybridConvexChild& childA, const btHybridConvexChild& childB)
{
	return childA.m_shape->getShapeType() == BOX_SHAPE_PROXYTYPE && childB.m_shape->getShapeType() == BOX_SHAPE_PROXYTYPE;
}

bool btHybridIsProvenApart(const btHybridConvexChild& childA, const btHybridConvexChild& childB, btScalar threshold)
{
	const int mostIterations = 1000;
	const btScalar gap = threshold + asConvex(childA)->getMarginNonVirtual() + asConvex(childB)->getMarginNonVirtual() + childA.m_rounding + childB.m_rounding;
	const btVector3 between = childA.m_transform.getOrigin() - childB.m_transform.getOrigin();
	// A point of A less a point of B; it moves towards the origin.
	btVector3 nearest = between + furthest(childA, btVector3(1, 0, 0)) - furthest(childB, btVector3(-1, 0, 0));
	for (int i = 0; i < mostIterations; i++)
	{
		const btScalar distance = nearest.length();
		if (!(distance > gap))
			return false;
		const btVector3 direction = nearest / distance;
		const btVector3 next = between + furthest(childA, -direction) - furthest(childB, direction);
		if (next.dot(direction) > gap)
			return true;
		const btVector3 step = next - nearest;
		const btScalar along = -nearest.dot(step) / step.length2();
		if (!(along > 0))
			return false;
		nearest += btMin(along, btScalar(1)) * step;
	}
	return false;
}

btHybridBruteForce::btHybridBruteForce(const btDispatcher* model)
    : m_configuration(smallPools()), m_dispatcher(new PrivateDispatcher(&m_configuration, model)), m_threshold(0)
{
	silenceCallbacks();
}

void btHybridBruteForce::silenceCallbacks()
{
	m_added = gContactAddedCallback;
	m_processed = gContactProcessedCallback;
	m_destroyed = gContactDestroyedCallback;
	m_started = gContactStartedCallback;
	m_ended = gContactEndedCallback;
	m_combiners[0] = gCalculateCombinedRestitutionCallback;
	m_combiners[1] = gCalculateCombinedFrictionCallback;
	m_combiners[2] = gCalculateCombinedRollingFrictionCallback;
	m_combiners[3] = gCalculateCombinedSpinningFrictionCallback;
	m_combiners[4] = gCalculateCombinedContactDampingCallback;
	m_combiners[5] = gCalculateCombinedContactStiffnessCallback;
	gContactAddedCallback = 0;
	gContactProcessedCallback = 0;
	gContactDestroyedCallback = 0;
	gContactStartedCallback = 0;
	gContactEndedCallback = 0;
	gCalculateCombinedRestitutionCallback = &btManifoldResult::calculateCombinedRestitution;
	gCalculateCombinedFrictionCallback = &btManifoldResult::calculateCombinedFriction;
	gCalculateCombinedRollingFrictionCallback = &btManifoldResult::calculateCombinedRollingFriction;
	gCalculateCombinedSpinningFrictionCallback = &btManifoldResult::calculateCombinedSpinningFriction;
	gCalculateCombinedContactDampingCallback = &btManifoldResult::calculateCombinedContactDamping;
	gCalculateCombinedContactStiffnessCallback = &btManifoldResult::calculateCombinedContactStiffness;
}

btHybridBruteForce::~btHybridBruteForce()
{
	delete m_dispatcher;
	gContactAddedCallback = m_added;
	gContactProcessedCallback = m_processed;
	gContactDestroyedCallback = m_destroyed;
	gContactStartedCallback = m_started;
	gContactEndedCallback = m_ended;
	gCalculateCombinedRestitutionCallback = m_combiners[0];
	gCalculateCombinedFrictionCallback = m_combiners[1];
	gCalculateCombinedRollingFrictionCallback = m_combiners[2];
	gCalculateCombinedSpinningFrictionCallback = m_combiners[3];
	gCalculateCombinedContactDampingCallback = m_combiners[4];
	gCalculateCombinedContactStiffnessCallback = m_combiners[5];
}

// A compound's children come first, and with compounds of which one lacks a tree, the second one's.
bool btHybridBruteForce::findContact(const btHybridConvexSide& a, const btHybridConvexChild& childA, const btHybridConvexSide& b, const btHybridConvexChild& childB, bool reversed, btScalar& distance)
{
	const bool secondFirst = b.m_compound && !(childA.m_leaf && childB.m_leaf);
	return secondFirst != reversed ? ask(b, childB, a, childA, distance) : ask(a, childA, b, childB, distance);
}

bool btHybridBruteForce::ask(const btHybridConvexSide& a, const btHybridConvexChild& childA, const btHybridConvexSide& b, const btHybridConvexChild& childB, btScalar& distance)
{
	// The wrappers carry the bodies, so that thresholds and poses are those of the world's manifolds.
	btCollisionObjectWrapper wrapA(0, childA.m_shape, a.m_object, childA.m_transform, -1, childA.m_index);
	btCollisionObjectWrapper wrapB(0, childB.m_shape, b.m_object, childB.m_transform, -1, childB.m_index);
	btCollisionAlgorithm* algorithm = m_dispatcher->findAlgorithm(&wrapA, &wrapB, 0, BT_CONTACT_POINT_ALGORITHMS);
	btManifoldResult result(&wrapA, &wrapB);
	algorithm->processCollision(&wrapA, &wrapB, m_info, &result);
	m_manifolds.resize(0);
	algorithm->getAllContactManifolds(m_manifolds);
	bool found = false;
	distance = BT_LARGE_FLOAT;
	for (int i = 0; i < m_manifolds.size(); i++)
		found |= readManifold(*m_manifolds[i], childA, childB, distance);
	algorithm->~btCollisionAlgorithm();
	m_dispatcher->freeCollisionAlgorithm(algorithm);
	return found;
}

// A point at the threshold itself may come and go by rounding; a ten-thousandth of the threshold covers
// the tolerance at which Bullet's GJK stops. Boxes touch only when they overlap, or nearly so.
bool btHybridBruteForce::readManifold(const btPersistentManifold& manifold, const btHybridConvexChild& childA, const btHybridConvexChild& childB, btScalar& distance)
{
	m_threshold = manifold.getContactBreakingThreshold();
	const btScalar rounding = childA.m_rounding + childB.m_rounding;
	const btScalar safe = btHybridAreBoxes(childA, childB) ? btScalar(-2) * SIMD_EPSILON - rounding : m_threshold - btScalar(1e-4) * m_threshold - rounding;
	bool found = false;
	for (int i = 0; i < manifold.getNumContacts(); i++)
	{
		distance = btMin(distance, manifold.getContactPoint(i).getDistance());
		found |= manifold.getContactPoint(i).getDistance() <= safe;
	}
	return found;
}
