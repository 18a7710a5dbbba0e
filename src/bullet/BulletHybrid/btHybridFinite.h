#ifndef BT_HYBRID_FINITE_H
#define BT_HYBRID_FINITE_H

#include <LinearMath/btTransform.h>

#include <cmath>

/// Whether all numbers are: neither infinite nor not a number.
inline bool btHybridIsFinite(const btVector3& v)
{
	return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}
inline bool btHybridIsFinite(const btTransform& transform)
{
	const btMatrix3x3& basis = transform.getBasis();
	return btHybridIsFinite(transform.getOrigin()) && btHybridIsFinite(basis[0]) && btHybridIsFinite(basis[1]) &&
	       btHybridIsFinite(basis[2]);
}

#endif  // BT_HYBRID_FINITE_H
