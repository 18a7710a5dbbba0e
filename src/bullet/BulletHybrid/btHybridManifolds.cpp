#include "btHybridManifolds.h"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

using scatter::pairs::ContactPoint;

ContactPoint btHybridContacts::read(const btManifoldPoint& point)
{
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

// The manifolds of a pile do not fit into a cache: of one with a single point, what is looked at.
void btHybridContacts::prefetch(const void* manifold)
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

// As the dispatcher gives it to manifolds.
btScalar btHybridContacts::getThreshold(const btCollisionDispatcher* dispatcher, const btCollisionObject* a, const btCollisionObject* b)
{
	const btScalar most = gContactBreakingThreshold;
	if (!(dispatcher->getDispatcherFlags() & btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD))
		return most;
	return btMin(a->getCollisionShape()->getContactBreakingThreshold(most), b->getCollisionShape()->getContactBreakingThreshold(most));
}
