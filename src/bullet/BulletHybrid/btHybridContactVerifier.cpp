#include "btHybridContactVerifier.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <LinearMath/btAabbUtil2.h>

#include "BulletHybrid/btHybridRigidBody.h"

namespace
{
// Takes Bullet's global contact callbacks away while it lives: they are the user's and may keep state.
class CallbackSilence
{
	ContactAddedCallback m_added;
	ContactProcessedCallback m_processed;
	ContactDestroyedCallback m_destroyed;
	ContactStartedCallback m_started;
	ContactEndedCallback m_ended;
	CalculateCombinedCallback m_combiners[4];

	CallbackSilence(const CallbackSilence&);
	CallbackSilence& operator=(const CallbackSilence&);

public:
	CallbackSilence()
	    : m_added(gContactAddedCallback), m_processed(gContactProcessedCallback), m_destroyed(gContactDestroyedCallback), m_started(gContactStartedCallback), m_ended(gContactEndedCallback)
	{
		m_combiners[0] = gCalculateCombinedRestitutionCallback;
		m_combiners[1] = gCalculateCombinedFrictionCallback;
		m_combiners[2] = gCalculateCombinedRollingFrictionCallback;
		m_combiners[3] = gCalculateCombinedSpinningFrictionCallback;
		gContactAddedCallback = 0;
		gContactProcessedCallback = 0;
		gContactDestroyedCallback = 0;
		gContactStartedCallback = 0;
		gContactEndedCallback = 0;
		gCalculateCombinedRestitutionCallback = &btManifoldResult::calculateCombinedRestitution;
		gCalculateCombinedFrictionCallback = &btManifoldResult::calculateCombinedFriction;
		gCalculateCombinedRollingFrictionCallback = &btManifoldResult::calculateCombinedRollingFriction;
		gCalculateCombinedSpinningFrictionCallback = &btManifoldResult::calculateCombinedSpinningFriction;
	}
	~CallbackSilence()
	{
		gContactAddedCallback = m_added;
		gContactProcessedCallback = m_processed;
		gContactDestroyedCallback = m_destroyed;
		gContactStartedCallback = m_started;
		gContactEndedCallback = m_ended;
		gCalculateCombinedRestitutionCallback = m_combiners[0];
		gCalculateCombinedFrictionCallback = m_combiners[1];
		gCalculateCombinedRollingFrictionCallback = m_combiners[2];
		gCalculateCombinedSpinningFrictionCallback = m_combiners[3];
	}
};

btScalar largestComponent(const btVector3& v)
{
	const btVector3 positive = v.absolute();
	return positive[positive.maxAxis()];
}

// A convex child at its world pose.
struct Child
{
	const btCollisionShape* m_shape;
	btTransform m_transform;
	btVector3 m_min;
	btVector3 m_max;
	const btDbvtNode* m_leaf;  // in its compound's tree; 0 without one
	int m_index;
	btScalar m_rounding;  // metres: what single precision may lose on the way to a distance or a bound

	Child(const btCollisionShape* shape, const btTransform& body, const btTransform& transform, int index, const btDbvtNode* leaf)
	    : m_shape(shape), m_transform(transform), m_leaf(leaf), m_index(index)
	{
		shape->getAabb(transform, m_min, m_max);
		const btVector3& origin = body.getOrigin();
		const btScalar reach = largestComponent(m_min) + largestComponent(m_max) + largestComponent(origin) + largestComponent(transform.getOrigin() - origin);
		m_rounding = btScalar(4) * SIMD_EPSILON * reach;
	}
};

struct Side
{
	const btCollisionObject* m_object;
	const btCompoundShape* m_compound;  // 0 for a bare convex shape
	btAlignedObjectArray<Child> m_children;

	// False if the shape is neither convex nor a compound of convex children.
	bool collect(const btCollisionObject* object)
	{
		m_object = object;
		m_children.resizeNoInitialize(0);
		const btCollisionShape* shape = object->getCollisionShape();
		const btTransform& body = object->getWorldTransform();
		m_compound = shape->isCompound() ? static_cast<const btCompoundShape*>(shape) : 0;
		if (!m_compound)
		{
			if (shape->isConvex())
				m_children.push_back(Child(shape, body, body, -1, 0));
			return shape->isConvex();
		}
		for (int i = 0; i < m_compound->getNumChildShapes(); i++)
		{
			const btCollisionShape* child = m_compound->getChildShape(i);
			if (!child->isConvex())
				return false;
			// Bullet's getter of the child list is not const.
			const btDbvtNode* leaf = m_compound->getDynamicAabbTree() ? const_cast<btCompoundShape*>(m_compound)->getChildList()[i].m_node : 0;
			m_children.push_back(Child(child, body, body * m_compound->getChildTransform(i), i, leaf));
		}
		return true;
	}
};

// False for anything that is not a number.
bool overlap(const btVector3& minA, const btVector3& maxA, const btVector3& minB, const btVector3& maxB, btScalar slack)
{
	for (int axis = 0; axis < 3; axis++)
		if (!(minA[axis] <= maxB[axis] + slack && minB[axis] <= maxA[axis] + slack))
			return false;
	return true;
}

// The test of the leaves in btCompoundCompoundCollisionAlgorithm and btCompoundCollisionAlgorithm.
bool leavesOverlap(const Side& a, const Child& childA, const Side& b, const Child& childB, btScalar slack)
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

bool userLetsThrough(const Side& a, const Child& childA, const Side& b, const Child& childB)
{
	if (a.m_compound && b.m_compound)
		return !gCompoundCompoundChildShapePairCallback || gCompoundCompoundChildShapePairCallback(childA.m_shape, childB.m_shape);
	if (!gCompoundChildShapePairCallback)
		return true;
	return a.m_compound ? gCompoundChildShapePairCallback(childB.m_shape, childA.m_shape) : gCompoundChildShapePairCallback(childA.m_shape, childB.m_shape);
}

// Whether Bullet's midphase hands a child pair on to a detector. Rounding must not decide: the sign of the
// slack says which way doubt goes.
bool midphaseKeeps(const Side& a, const Child& childA, const Side& b, const Child& childB, btScalar slack)
{
	if (!a.m_compound && !b.m_compound)
		return true;
	return overlap(childA.m_min, childA.m_max, childB.m_min, childB.m_max, slack) && leavesOverlap(a, childA, b, childB, slack) && userLetsThrough(a, childA, b, childB);
}

bool areBoxes(const Child& childA, const Child& childB)
{
	return childA.m_shape->getShapeType() == BOX_SHAPE_PROXYTYPE && childB.m_shape->getShapeType() == BOX_SHAPE_PROXYTYPE;
}

const btConvexShape* asConvex(const Child& child)
{
	return static_cast<const btConvexShape*>(child.m_shape);
}

// The point of a child's core that is furthest along a world direction, seen from the child's origin.
btVector3 furthest(const Child& child, const btVector3& direction)
{
	return child.m_transform.getBasis() * asConvex(child)->localGetSupportVertexWithoutMarginNonVirtual(direction * child.m_transform.getBasis());
}

// Whether a separating plane shows the children, as Bullet's GJK sees them, to be too far apart for a contact.
// Gilbert's algorithm: slow, and of the same accuracy at every scale. See Gilbert, "An iterative procedure for
// computing the minimum of a quadratic form on a convex set", 1966.
bool isProvenApart(const Child& childA, const Child& childB, btScalar threshold)
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

// A dispatcher of our own, so that no manifold appears in the world's: their order matters to its solver.
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

// Bullet's detector for one child pair, without memory of earlier steps.
class BruteForce
{
	btDefaultCollisionConfiguration m_configuration;
	PrivateDispatcher m_dispatcher;
	btDispatcherInfo m_info;
	btManifoldArray m_manifolds;
	btScalar m_threshold;  // of the last contact found

	BruteForce(const BruteForce&);
	BruteForce& operator=(const BruteForce&);

public:
	explicit BruteForce(const btDispatcher* model)
	    : m_configuration(smallPools()), m_dispatcher(&m_configuration, model), m_threshold(0)
	{
	}

	btScalar getThreshold() const
	{
		return m_threshold;
	}

	// Whether there is a contact safely within the threshold, and the smallest distance. The order of the
	// two is Bullet's, unless reversed: a compound's children come first, and with compounds of which one
	// lacks a tree, the second one's.
	bool findContact(const Side& a, const Child& childA, const Side& b, const Child& childB, bool reversed, btScalar& distance)
	{
		const bool secondFirst = b.m_compound && !(childA.m_leaf && childB.m_leaf);
		return secondFirst != reversed ? ask(b, childB, a, childA, distance) : ask(a, childA, b, childB, distance);
	}

private:
	bool ask(const Side& a, const Child& childA, const Side& b, const Child& childB, btScalar& distance)
	{
		// The wrappers carry the bodies, so that thresholds and poses are those of the world's manifolds.
		btCollisionObjectWrapper wrapA(0, childA.m_shape, a.m_object, childA.m_transform, -1, childA.m_index);
		btCollisionObjectWrapper wrapB(0, childB.m_shape, b.m_object, childB.m_transform, -1, childB.m_index);
		btCollisionAlgorithm* algorithm = m_dispatcher.findAlgorithm(&wrapA, &wrapB, 0, BT_CONTACT_POINT_ALGORITHMS);
		btManifoldResult result(&wrapA, &wrapB);
		algorithm->processCollision(&wrapA, &wrapB, m_info, &result);
		m_manifolds.resize(0);
		algorithm->getAllContactManifolds(m_manifolds);
		bool found = false;
		distance = BT_LARGE_FLOAT;
		for (int i = 0; i < m_manifolds.size(); i++)
			found |= readManifold(*m_manifolds[i], childA, childB, distance);
		algorithm->~btCollisionAlgorithm();
		m_dispatcher.freeCollisionAlgorithm(algorithm);
		return found;
	}

	// A point at the threshold itself may come and go by rounding; a ten-thousandth of the threshold covers
	// the tolerance at which Bullet's GJK stops. Boxes touch only when they overlap, or nearly so.
	bool readManifold(const btPersistentManifold& manifold, const Child& childA, const Child& childB, btScalar& distance)
	{
		m_threshold = manifold.getContactBreakingThreshold();
		const btScalar rounding = childA.m_rounding + childB.m_rounding;
		const btScalar safe = areBoxes(childA, childB) ? btScalar(-2) * SIMD_EPSILON - rounding : m_threshold - btScalar(1e-4) * m_threshold - rounding;
		bool found = false;
		for (int i = 0; i < manifold.getNumContacts(); i++)
		{
			distance = btMin(distance, manifold.getContactPoint(i).getDistance());
			found |= manifold.getContactPoint(i).getDistance() <= safe;
		}
		return found;
	}
};

// Names a child pair in contact; bodies by their broadphase ids, the smaller first.
struct ContactKey
{
	int m_key[4];  // two bodies, two children

	ContactKey()
	{
	}
	ContactKey(int body0, int body1, int child0, int child1)
	{
		const bool swap = body0 > body1;
		m_key[0] = swap ? body1 : body0;
		m_key[1] = swap ? body0 : body1;
		m_key[2] = swap ? child1 : child0;
		m_key[3] = swap ? child0 : child1;
	}

	static bool less(const ContactKey& a, const ContactKey& b)
	{
		for (int i = 0; i < 3; i++)
			if (a.m_key[i] != b.m_key[i])
				return a.m_key[i] < b.m_key[i];
		return a.m_key[3] < b.m_key[3];
	}
};

// The child pairs that have contact points in the world, sorted.
class ContactIndex
{
	btAlignedObjectArray<ContactKey> m_keys;

public:
	explicit ContactIndex(btDispatcher* dispatcher)
	{
		for (int i = 0; i < dispatcher->getNumManifolds(); i++)
			add(*dispatcher->getManifoldByIndexInternal(i));
		if (m_keys.size() > 1)
			m_keys.quickSort(ContactKey::less);
	}

	const ContactKey& operator[](int i) const
	{
		return m_keys[i];
	}

	// The first that is not less than the key.
	int lowerBound(const ContactKey& key) const
	{
		int first = 0;
		int last = m_keys.size();
		while (first < last)
		{
			const int middle = first + (last - first) / 2;
			if (ContactKey::less(m_keys[middle], key))
				first = middle + 1;
			else
				last = middle;
		}
		return first;
	}

	bool contains(const ContactKey& key) const
	{
		const int i = lowerBound(key);
		return i < m_keys.size() && !ContactKey::less(key, m_keys[i]);
	}

	bool isOfBodies(int i, int body0, int body1) const
	{
		return i < m_keys.size() && m_keys[i].m_key[0] == body0 && m_keys[i].m_key[1] == body1;
	}

private:
	void add(const btPersistentManifold& manifold)
	{
		const btBroadphaseProxy* proxy0 = manifold.getBody0()->getBroadphaseHandle();
		const btBroadphaseProxy* proxy1 = manifold.getBody1()->getBroadphaseHandle();
		if (!proxy0 || !proxy1)
			return;
		for (int i = 0; i < manifold.getNumContacts(); i++)
		{
			const btManifoldPoint& point = manifold.getContactPoint(i);
			m_keys.push_back(ContactKey(proxy0->m_uniqueId, proxy1->m_uniqueId, point.m_index0, point.m_index1));
		}
	}
};

// One verification of a world.
class Verification
{
	btDispatcher* m_dispatcher;
	btHybridContactReport& m_report;
	ContactIndex m_contacts;
	BruteForce m_bruteForce;
	Side m_a;
	Side m_b;

public:
	Verification(btDispatcher* dispatcher, btHybridContactReport& report)
	    : m_dispatcher(dispatcher), m_report(report), m_contacts(dispatcher), m_bruteForce(dispatcher)
	{
	}

	void verifyPair(const btBroadphasePair& pair)
	{
		const btCollisionObject* a = static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
		const btCollisionObject* b = static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject);
		if (!btHybridRigidBody::upcast(a) && !btHybridRigidBody::upcast(b))
			return;
		if (!m_dispatcher->needsCollision(a, b) || !m_a.collect(a) || !m_b.collect(b))
			return;
		for (int i = 0; i < m_a.m_children.size(); i++)
			for (int j = 0; j < m_b.m_children.size(); j++)
				verifyChildPair(m_a.m_children[i], m_b.m_children[j]);
		countExtras();
	}

private:
	ContactKey keyOf(int childA, int childB) const
	{
		return ContactKey(m_a.m_object->getBroadphaseHandle()->m_uniqueId, m_b.m_object->getBroadphaseHandle()->m_uniqueId, childA, childB);
	}

	void verifyChildPair(const Child& childA, const Child& childB)
	{
		if (!midphaseKeeps(m_a, childA, m_b, childB, -(childA.m_rounding + childB.m_rounding)))
			return;
		m_report.m_childPairs++;
		btHybridMissedContact contact;
		if (!m_bruteForce.findContact(m_a, childA, m_b, childB, false, contact.m_distance))
			return;
		const bool isThere = m_contacts.contains(keyOf(childA.m_index, childB.m_index));
		if (!isThere && isDoubtful(childA, childB))
			return;
		m_report.m_expected++;
		if (isThere)
			return;
		contact.m_bodyA = m_a.m_object;
		contact.m_bodyB = m_b.m_object;
		contact.m_childA = childA.m_index;
		contact.m_childB = childB.m_index;
		m_report.m_missed++;
		m_report.m_lastMissed.push_back(contact);
	}

	// Bullet's GJK finds contacts between parts of millimetres, or nearly flat ones, that are further apart
	// than its threshold, or finds them in one order of the two only. Nobody misses those.
	bool isDoubtful(const Child& childA, const Child& childB)
	{
		btScalar distance;
		if (areBoxes(childA, childB))
			return false;
		return isProvenApart(childA, childB, m_bruteForce.getThreshold()) || !m_bruteForce.findContact(m_a, childA, m_b, childB, true, distance);
	}

	void countExtras()
	{
		const ContactKey bodies = keyOf(-1, -1);
		const int body0 = bodies.m_key[0];
		const int body1 = bodies.m_key[1];
		const bool swapped = body0 != m_a.m_object->getBroadphaseHandle()->m_uniqueId;
		int before = -1;
		for (int i = m_contacts.lowerBound(bodies); m_contacts.isOfBodies(i, body0, body1); before = i++)
		{
			// One child pair has up to four points.
			if (before >= 0 && !ContactKey::less(m_contacts[before], m_contacts[i]))
				continue;
			const int first = m_contacts[i].m_key[2];
			const int second = m_contacts[i].m_key[3];
			m_report.m_extra += isExtra(swapped ? second : first, swapped ? first : second);
		}
	}

	bool isExtra(int childA, int childB) const
	{
		// Without a child it is not of the narrowphase: Bullet's continuous detection predicts such contacts.
		if ((m_a.m_compound && childA < 0) || (m_b.m_compound && childB < 0))
			return false;
		const Child* a = findChild(m_a, childA);
		const Child* b = findChild(m_b, childB);
		return !a || !b || !midphaseKeeps(m_a, *a, m_b, *b, a->m_rounding + b->m_rounding);
	}

	static const Child* findChild(const Side& side, int index)
	{
		const int position = side.m_compound ? index : index + 1;
		return position >= 0 && position < side.m_children.size() ? &side.m_children[position] : 0;
	}
};
}  // namespace

void btHybridContactVerifier::verify(btBroadphasePairArray& pairs, btDispatcher* dispatcher)
{
	const CallbackSilence silence;
	Verification verification(dispatcher, m_report);
	m_report.m_lastMissed.resize(0);
	for (int i = 0; i < pairs.size(); i++)
		verification.verifyPair(pairs[i]);
	m_report.m_steps++;
}
