#include "btHybridManifolds.h"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <limits>

using scatter::pairs::ContactPoint;
using scatter::pairs::ContactTally;

namespace
{
bool presses(const btManifoldPoint& point)
{
	return !(point.m_contactPointFlags & BT_CONTACT_FLAG_HAS_CONTACT_ERP) || point.m_contactERP > 0;
}
}  // namespace

ContactPoint btHybridContacts::read(const btManifoldPoint& point)
{
	ContactPoint plain;
	plain.position = btHybridVec3(point.m_positionWorldOnB);
	plain.normal = btHybridVec3(point.m_normalWorldOnB);
	plain.distance = point.getDistance();
	plain.impulse = point.m_appliedImpulse;
	plain.partA = btMax(point.m_index0, 0);
	plain.partB = btMax(point.m_index1, 0);
	plain.presses = presses(point);
	plain.eased =
	    (point.m_contactPointFlags & c_easeFlags) == c_easeFlags && point.m_contactERP == 0 && point.m_contactCFM == 0;
	return plain;
}

void btHybridContacts::addTo(ContactTally& tally, const btPersistentManifold& manifold)
{
	++tally.manifolds;
	for (int i = 0; i < manifold.getNumContacts(); i++)
	{
		const btManifoldPoint& point = manifold.getContactPoint(i);
		tally.addPoint(point.getDistance(), presses(point));
	}
}

void btHybridContacts::write(const ContactPoint& plain, btManifoldPoint& point)
{
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

// As a manifold result does it; the end is told by the manifold.
void btHybridContacts::move(btManifoldPoint& point, btPersistentManifold* to)
{
	to->addManifoldPoint(point);
	point.m_userPersistentData = 0;
	if (gContactStartedCallback && to->getNumContacts() == 1)
		gContactStartedCallback(to);
}

void btHybridContacts::addImpulses(const btManifoldPoint& from, btManifoldPoint& to)
{
	to.m_appliedImpulse += from.m_appliedImpulse;
	to.m_appliedImpulseLateral1 += from.m_appliedImpulseLateral1;
	to.m_appliedImpulseLateral2 += from.m_appliedImpulseLateral2;
}

float btHybridContacts::carry(btPersistentManifold* manifold, const btCollisionObject* a, const btCollisionObject* b)
{
	manifold->refreshContactPoints(a->getWorldTransform(), b->getWorldTransform());
	btScalar least = BT_LARGE_FLOAT;
	for (int i = 0; i < manifold->getNumContacts(); i++)
	{
		const btManifoldPoint& point = manifold->getContactPoint(i);
		const btVector3 between = point.m_positionWorldOnA - point.m_positionWorldOnB;
		btSetMin(least, (between - point.m_normalWorldOnB * point.getDistance()).length2());
	}
	return manifold->getNumContacts() > 0 ? float(btSqrt(least)) : std::numeric_limits<float>::infinity();
}

// The manifolds of a pile do not fit into a cache: of one with a single point, what is looked at.
void btHybridContacts::prefetch(const void* manifold)
{
#if defined(__GNUC__)
	const char* bytes = static_cast<const char*>(manifold);
	for (size_t i = 0; i < sizeof(btManifoldPoint); i += 64)
		__builtin_prefetch(bytes + i, 1);
#endif
	prefetchObjects(manifold);
}

// Behind its points, in its last 32 bytes.
void btHybridContacts::prefetchObjects(const void* manifold)
{
#if defined(__GNUC__)
	__builtin_prefetch(static_cast<const char*>(manifold) + sizeof(btPersistentManifold) - 32, 1);
#else
	(void)manifold;
#endif
}

// Calls use(between the places on both bodies, distance, normal) for the points that
// btPersistentManifold::refreshContactPoints is going to leave.
template <class Use>
static void forEachLasting(const btPersistentManifold& manifold, Use use)
{
	const btTransform& poseA = manifold.getBody0()->getWorldTransform();
	const btTransform& poseB = manifold.getBody1()->getWorldTransform();
	const btScalar most = manifold.getContactBreakingThreshold();
	for (int i = 0; i < manifold.getNumContacts(); i++)
	{
		const btManifoldPoint& point = manifold.getContactPoint(i);
		const btVector3 onA = poseA(point.m_localPointA);
		const btVector3 onB = poseB(point.m_localPointB);
		const btScalar distance = (onA - onB).dot(point.m_normalWorldOnB);
		const btVector3 aside = onB - (onA - point.m_normalWorldOnB * distance);
		if (distance <= most && !(aside.dot(aside) > most * most))
			use(onA - onB, distance, point.m_normalWorldOnB);
	}
}

bool btHybridContacts::wouldOutlast(const btPersistentManifold& manifold)
{
	bool isAny = false;
	forEachLasting(manifold, [&isAny](const btVector3&, btScalar, const btVector3&) { isAny = true; });
	return isAny;
}

float btHybridContacts::wouldSlide(const btPersistentManifold& manifold)
{
	btScalar least = BT_LARGE_FLOAT;
	bool isAny = false;
	forEachLasting(manifold,
	               [&](const btVector3& between, btScalar distance, const btVector3& normal)
	               {
		               isAny = true;
		               btSetMin(least, (between - normal * distance).length2());
	               });
	return isAny ? float(btSqrt(least)) : std::numeric_limits<float>::infinity();
}

// As the dispatcher gives it to manifolds.
btScalar btHybridContacts::getThreshold(const btCollisionDispatcher* dispatcher, const btCollisionObject* a,
                                        const btCollisionObject* b)
{
	const btScalar most = gContactBreakingThreshold;
	if (!(dispatcher->getDispatcherFlags() & btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD))
		return most;
	return btMin(a->getCollisionShape()->getContactBreakingThreshold(most),
	             b->getCollisionShape()->getContactBreakingThreshold(most));
}
