#ifndef BT_HYBRID_CONVEX_PART_H
#define BT_HYBRID_CONVEX_PART_H

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <optional>
#include <vector>

#include "levels/polytope.h"

/// In double precision, so that the rounding of the proof is far below that of the shapes.
typedef glm::dvec3 btHybridPoint;

struct btHybridBall
{
	btHybridPoint m_center;
	double m_radius;
};

/// What a profile sweeps around an axis: the core of a sphere, capsule, cylinder or cone. The profile goes from the
/// axis outwards, up, and back to the axis, as pairs of radius and height.
struct btHybridRevolved
{
	btHybridPoint m_origin;
	btHybridPoint m_axis;
	std::vector<glm::dvec2> m_profile;

	/// Negative inside.
	double getSignedDistance(const btHybridPoint& point) const;
};

/// A convex part of a level as a proof of nesting sees it, in the level's frame and in two roles. As what must be held
/// it is the convex hull of balls. As what holds others it is a core with a margin around it.
class btHybridConvexPart
{
	const btConvexShape* m_shape;
	btTransform m_transform;
	std::vector<btHybridBall> m_balls;
	scatter::levels::DoubleBounds m_bounds;
	std::optional<btHybridRevolved> m_revolved;
	std::vector<btHybridPoint> m_around;  ///< the core's corners; of a round core those of a prism or pyramid around it
	std::vector<btHybridPoint> m_within;  ///< the same within it
	double m_margin;
	bool m_isHull;
	mutable std::optional<scatter::levels::Polytope> m_core;

	friend struct btHybridPartMaker;

	const scatter::levels::Polytope& getCore() const;
	double getCoreDistance(const btHybridPoint& point, double limit) const;

public:
	btHybridConvexPart(const btConvexShape* shape, const btTransform& transform);

	/// They hold the part, and are exactly it if its kind is known: a circle is a polygon of 256 corners around it.
	const std::vector<btHybridBall>& getBalls() const
	{
		return m_balls;
	}
	const scatter::levels::DoubleBounds& getBounds() const
	{
		return m_bounds;
	}

	/// How far the balls reach along a unit direction.
	double getSupport(const btHybridPoint& direction) const;

	/// The radius of all balls; -1 if they differ.
	double getRadius() const;

	/// A hull: a core of flat sides in a margin.
	bool isHull() const
	{
		return m_isHull;
	}

	/// Whether it can hold others: a hull without volume holds itself alone.
	bool isSolid() const
	{
		return m_revolved || !getCore().isEmpty();
	}

	/// The same shape at the same place.
	bool isSame(const btHybridConvexPart& other) const;

	/// How far a part sticks out of this one at least, and where; 0 or less if it is held. It must not be a hull
	/// without volume.
	double getProtrusion(const btHybridConvexPart& part, btHybridPoint& furthest) const;
	bool holds(const btHybridConvexPart& part, double tolerance) const;

	/// A polytope around the core, without margin; empty if the core has no volume.
	scatter::levels::Polytope getOuterCore() const;

	/// A polytope around the whole part, which touches it in the given directions.
	scatter::levels::Polytope getOuter(const std::vector<btHybridPoint>& tangents, double epsilon) const;

	/// A polytope of points that are at least `inset` inside; empty if there are none, or none that can be told.
	scatter::levels::Polytope getInner(double inset, double epsilon) const;
};

#endif  // BT_HYBRID_CONVEX_PART_H
