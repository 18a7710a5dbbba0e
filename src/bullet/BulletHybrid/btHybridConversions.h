#ifndef BT_HYBRID_CONVERSIONS_H
#define BT_HYBRID_CONVERSIONS_H

#include <LinearMath/btTransform.h>

#include "collision/frame.h"

/// As src/collision has it. Exact.
inline scatter::Vec3 btHybridVec3(const btVector3& v)
{
	return scatter::Vec3(v.x(), v.y(), v.z());
}

inline scatter::Frame btHybridFrameOf(const btTransform& transform)
{
	scatter::Frame frame;
	for (int i = 0; i < 3; i++)
		frame.row[i] = btHybridVec3(transform.getBasis()[i]);
	frame.origin = btHybridVec3(transform.getOrigin());
	return frame;
}

inline btTransform btHybridTransformOf(const scatter::Frame& frame)
{
	const scatter::Vec3* row = frame.row;
	const btMatrix3x3 basis(row[0].x, row[0].y, row[0].z, row[1].x, row[1].y, row[1].z, row[2].x, row[2].y, row[2].z);
	return btTransform(basis, btVector3(frame.origin.x, frame.origin.y, frame.origin.z));
}

#endif  // BT_HYBRID_CONVERSIONS_H
