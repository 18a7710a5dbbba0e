#ifndef BT_HYBRID_REDUCIBLE_H
#define BT_HYBRID_REDUCIBLE_H

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

/// Whether other contacts may stand for this one: what a program has said about a contact is about that very
/// contact.
inline bool btHybridIsReducible(const btManifoldPoint& point)
{
	const int own = BT_CONTACT_FLAG_HAS_CONTACT_CFM | BT_CONTACT_FLAG_HAS_CONTACT_ERP |
	                BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING | BT_CONTACT_FLAG_FRICTION_ANCHOR;
	return (point.m_contactPointFlags & own) == 0 && !(point.m_combinedRollingFriction > 0);
}

/// Whether a solver sees a contact of a manifold.
inline bool btHybridIsNear(const btPersistentManifold& manifold, const btManifoldPoint& point)
{
	return point.getDistance() <= manifold.getContactProcessingThreshold();
}

#endif  // BT_HYBRID_REDUCIBLE_H
