#include "btHybridPairEngine.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btAabbUtil2.h>

using scatter::ChildPair;
using scatter::pairs::ContactPoint;

namespace
{
// What this library takes the error reduction of a point away with.
const int c_easeFlags = BT_CONTACT_FLAG_HAS_CONTACT_ERP | BT_CONTACT_FLAG_HAS_CONTACT_CFM;

btPersistentManifold* manifoldAt(void* contact)
{
	return static_cast<btPersistentManifold*>(contact);
}

const btPersistentManifold* manifoldAt(const void* contact)
{
	return static_cast<const btPersistentManifold*>(contact);
}
}  // namespace

btHybridPairEngine::LevelScope::LevelScope(const btHybridPairCall& call, const btHybridPairBodies& bodies)
    : m_result(call.m_result),
      m_before{m_result->getBody0Wrap(), m_result->getBody1Wrap()},
      m_levels{{0, bodies.m_bodies[0]->getShape(), call.m_wraps[0]->getCollisionObject(), call.m_wraps[0]->getWorldTransform(), -1, -1},
               {0, bodies.m_bodies[1]->getShape(), call.m_wraps[1]->getCollisionObject(), call.m_wraps[1]->getWorldTransform(), -1, -1}}
{
	m_result->setBody0Wrap(&m_levels[0]);
	m_result->setBody1Wrap(&m_levels[1]);
}

btHybridPairEngine::LevelScope::~LevelScope()
{
	m_result->setBody0Wrap(m_before[0]);
	m_result->setBody1Wrap(m_before[1]);
}

void btHybridPairBodies::take(int level, btHybridObjects& objects)
{
	if (level == m_level)
		return;
	for (int i = 0; i < 2; i++)
		m_bodies[i] = objects.getBody(m_objects[i], m_objects[i]->getLevelIn(level));
	m_level = level;
}

const btCollisionObjectWrapper* btHybridPairEngine::getWrap(int body)
{
	if (!m_switches)
		return m_call.m_wraps[body];
	if (!m_scope)
		m_scope.emplace(m_call, m_bodies);
	return m_scope->getWrap(body);
}

const btCollisionShape* btHybridPairEngine::getShapeNow(int body) const
{
	return m_switches ? m_bodies.m_bodies[body]->getShapeNow() : m_call.m_wraps[body]->getCollisionShape();
}

const scatter::PartList::Part& btHybridPairEngine::getPart(int body, int part) const
{
	return m_bodies.m_bodies[body]->getBody().parts().part(part);
}

bool btHybridPairEngine::follow(scatter::pairs::PlacedBodies& bodies)
{
	for (int i = 0; i < 2; i++)
	{
		if (!m_objects.update(m_bodies.m_bodies[i], getShapeNow(i), m_call.m_wraps[i]->getWorldTransform()))
			return false;
		bodies.versions[i] = m_bodies.m_bodies[i]->getVersion();
	}
	bodies.a = &m_bodies.m_bodies[0]->getBody();
	bodies.b = &m_bodies.m_bodies[1]->getBody();
	return true;
}

bool btHybridPairEngine::place(int level, scatter::pairs::PlacedBodies& bodies)
{
	m_scope.reset();
	m_bodies.take(level, m_objects);
	if (!follow(bodies))
		return false;
	releaseFallback();
	return true;
}

const scatter::PartList& btHybridPairEngine::partsOf(int body, int level)
{
	btHybridLevelBodies* object = m_bodies.m_objects[body];
	return m_objects.getBody(object, object->getLevelIn(level))->getBody().parts();
}

scatter::Frame btHybridPairEngine::frameOf(int body) const
{
	return btHybridFrameOf(m_call.m_wraps[body]->getWorldTransform());
}

// As the dispatcher gives it to manifolds.
float btHybridPairEngine::threshold() const
{
	const btScalar most = gContactBreakingThreshold;
	if (!(m_dispatcher->getDispatcherFlags() & btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD))
		return most;
	btScalar least = BT_LARGE_FLOAT;
	for (int i = 0; i < 2; i++)
		least = btMin(least, m_call.m_wraps[i]->getCollisionObject()->getCollisionShape()->getContactBreakingThreshold(most));
	return least;
}

float btHybridPairEngine::pointDistance() const
{
	return gContactBreakingThreshold;
}

void btHybridPairEngine::fallBack()
{
	if (!m_fallback)
		m_fallback = m_dispatcher->findAlgorithm(m_call.m_wraps[0], m_call.m_wraps[1], 0, BT_CONTACT_POINT_ALGORITHMS);
	m_fallback->processCollision(m_call.m_wraps[0], m_call.m_wraps[1], m_call.m_info, m_call.m_result);
}

void btHybridPairEngine::releaseFallback()
{
	if (!m_fallback)
		return;
	m_fallback->~btCollisionAlgorithm();
	m_dispatcher->freeCollisionAlgorithm(m_fallback);
	m_fallback = 0;
}

bool btHybridPairEngine::outlasts(void* contact) const
{
	btPersistentManifold* manifold = manifoldAt(contact);
	manifold->refreshContactPoints(m_call.m_wraps[0]->getCollisionObject()->getWorldTransform(), m_call.m_wraps[1]->getCollisionObject()->getWorldTransform());
	return manifold->getNumContacts() > 0;
}

void* btHybridPairEngine::newManifold()
{
	return m_dispatcher->getNewManifold(m_call.m_wraps[0]->getCollisionObject(), m_call.m_wraps[1]->getCollisionObject());
}

void btHybridPairEngine::release(void* manifold)
{
	m_dispatcher->releaseManifold(manifoldAt(manifold));
}

int btHybridPairEngine::countPoints(const void* manifold) const
{
	return manifoldAt(manifold)->getNumContacts();
}

bool btHybridPairEngine::isFull(const void* manifold) const
{
	return manifoldAt(manifold)->getNumContacts() == MANIFOLD_CACHE_SIZE;
}

ContactPoint btHybridPairEngine::point(const void* manifold, int index) const
{
	const btManifoldPoint& point = manifoldAt(manifold)->getContactPoint(index);
	ContactPoint plain;
	plain.position = btHybridVec3(point.m_positionWorldOnB);
	plain.normal = btHybridVec3(point.m_normalWorldOnB);
	plain.distance = point.getDistance();
	plain.impulse = point.m_appliedImpulse;
	plain.partA = btMax(point.m_index0, 0);
	plain.partB = btMax(point.m_index1, 0);
	plain.presses = !(point.m_contactPointFlags & BT_CONTACT_FLAG_HAS_CONTACT_ERP) || point.m_contactERP > 0;
	plain.eased = (point.m_contactPointFlags & c_easeFlags) == c_easeFlags && point.m_contactERP == 0 && point.m_contactCFM == 0;
	return plain;
}

void btHybridPairEngine::write(void* manifold, int index, const ContactPoint& plain)
{
	btManifoldPoint& point = manifoldAt(manifold)->getContactPoint(index);
	point.setDistance(plain.distance);
	if (!plain.eased)
	{
		point.m_contactPointFlags &= ~c_easeFlags;
		return;
	}
	// Springs that a program has given its bodies have no error reduction.
	if (point.m_contactPointFlags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING)
		return;
	point.m_contactPointFlags |= c_easeFlags;
	point.m_contactERP = 0;
	point.m_contactCFM = 0;
}

float btHybridPairEngine::distanceNow(const void* manifold, int index) const
{
	const btManifoldPoint& point = manifoldAt(manifold)->getContactPoint(index);
	return (m_call.m_wraps[0]->getWorldTransform()(point.m_localPointA) - m_call.m_wraps[1]->getWorldTransform()(point.m_localPointB)).dot(point.m_normalWorldOnB);
}

// As a manifold result does it; the end is told by the manifold.
void btHybridPairEngine::move(void* from, int index, void* to)
{
	btManifoldPoint& point = manifoldAt(from)->getContactPoint(index);
	btPersistentManifold* manifold = manifoldAt(to);
	manifold->addManifoldPoint(point);
	point.m_userPersistentData = 0;
	if (gContactStartedCallback && manifold->getNumContacts() == 1)
		gContactStartedCallback(manifold);
}

void btHybridPairEngine::addImpulses(const void* from, int index, void* to, int indexTo)
{
	const btManifoldPoint& point = manifoldAt(from)->getContactPoint(index);
	btManifoldPoint& other = manifoldAt(to)->getContactPoint(indexTo);
	other.m_appliedImpulse += point.m_appliedImpulse;
	other.m_appliedImpulseLateral1 += point.m_appliedImpulseLateral1;
	other.m_appliedImpulseLateral2 += point.m_appliedImpulseLateral2;
}

// A filter that a program may have set for the children of compounds.
bool btHybridPairEngine::letsThrough(const ChildPair& child) const
{
	const btHybridPartBody& bodyA = *m_bodies.m_bodies[0];
	const btHybridPartBody& bodyB = *m_bodies.m_bodies[1];
	const bool isChildA = bodyA.getChildIndex(child.a) >= 0;
	if (isChildA && bodyB.getChildIndex(child.b) >= 0)
		return !gCompoundCompoundChildShapePairCallback || gCompoundCompoundChildShapePairCallback(bodyA.getChildShape(child.a), bodyB.getChildShape(child.b));
	if (!gCompoundChildShapePairCallback)
		return true;
	// Bullet names the compound's child last.
	return isChildA ? gCompoundChildShapePairCallback(bodyB.getChildShape(child.b), bodyA.getChildShape(child.a)) : gCompoundChildShapePairCallback(bodyA.getChildShape(child.a), bodyB.getChildShape(child.b));
}

// The test of the leaves that Bullet's compound algorithms make before a child pair comes into contact.
bool btHybridPairEngine::mayBegin(const ChildPair& child) const
{
	const btHybridPartBody& bodyA = *m_bodies.m_bodies[0];
	const btHybridPartBody& bodyB = *m_bodies.m_bodies[1];
	if (!bodyA.hasLeaves() && !bodyB.hasLeaves())
		return true;
	const btTransform& frameA = m_call.m_wraps[0]->getWorldTransform();
	const btTransform& frameB = m_call.m_wraps[1]->getWorldTransform();
	btVector3 minA, maxA, minB, maxB;
	if (bodyA.hasLeaves())
	{
		bodyA.getLeaf(child.a, minA, maxA);
		bodyB.getLeafIn(child.b, frameA.inverseTimes(frameB), minB, maxB);
	}
	else
	{
		bodyA.getChildShape(child.a)->getAabb(frameB.inverseTimes(bodyA.getChildTransform(child.a, frameA)), minA, maxA);
		bodyB.getLeaf(child.b, minB, maxB);
	}
	return TestAabbAgainstAabb2(minA, maxA, minB, maxB);
}

// Of a compound with a tree and one without, in this order, Bullet does not look at the second one's children while the
// leaf of the first one's child does not reach the second: what contacts they have stay.
bool btHybridPairEngine::overlooks(const ChildPair& child) const
{
	const btHybridPartBody& bodyA = *m_bodies.m_bodies[0];
	const btHybridPartBody& bodyB = *m_bodies.m_bodies[1];
	const btCollisionShape* whole = bodyB.getShape();
	if (!bodyA.hasLeaves() || bodyB.hasLeaves() || !whole->isCompound() || mayBegin(child))
		return false;
	btVector3 minA, maxA, minB, maxB;
	const btTransform poseA = bodyA.getChildTransform(child.a, m_call.m_wraps[0]->getWorldTransform());
	bodyA.getChildShape(child.a)->getAabb(poseA, minA, maxA);
	whole->getAabb(m_call.m_wraps[1]->getWorldTransform(), minB, maxB);
	return TestAabbAgainstAabb2(minA, maxA, minB, maxB);
}

// The callback hears of new contacts too, as far as Bullet keeps them.
void btHybridPairEngine::looked(const ChildPair& child)
{
	if (gContactProcessedCallback && !areSpheres(child))
		static_cast<void>(outlasts(child.contact));
}

// The manifolds of a pile do not fit into a cache: of one with a single point, what is looked at.
void btHybridPairEngine::prefetch(const void* manifold) const
{
#if defined(__GNUC__)
	const char* bytes = static_cast<const char*>(manifold);
	for (size_t i = 0; i < sizeof(btManifoldPoint); i += 64)
		__builtin_prefetch(bytes + i, 1);
	__builtin_prefetch(bytes + sizeof(btPersistentManifold) - 64, 1);
#else
	(void)manifold;
#endif
}
