#ifndef BT_HYBRID_QUAD_H
#define BT_HYBRID_QUAD_H

#include <LinearMath/btVector3.h>

#include "solver/lanes.h"

inline scatter::solver::Quad btHybridQuad(const btVector3& vector, btScalar w = 0)
{
	return {float(vector.x()), float(vector.y()), float(vector.z()), float(w)};
}

inline btVector3 btHybridVectorOf(const scatter::solver::Quad& quad)
{
	return btVector3(quad.x, quad.y, quad.z);
}

#endif  // BT_HYBRID_QUAD_H
