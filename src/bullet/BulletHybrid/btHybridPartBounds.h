#ifndef BT_HYBRID_PART_BOUNDS_H
#define BT_HYBRID_PART_BOUNDS_H

#include <LinearMath/btVector3.h>

/// Of a part over a ground, in one step: its bounds in the ground's frame, and whether Bullet lets it come into
/// contact.
struct btHybridPartBounds
{
	btVector3 m_min;
	btVector3 m_max;
	bool m_isKnown;
	bool m_mayBegin;

	btHybridPartBounds() : m_isKnown(false), m_mayBegin(false)
	{
	}
};

#endif  // BT_HYBRID_PART_BOUNDS_H
