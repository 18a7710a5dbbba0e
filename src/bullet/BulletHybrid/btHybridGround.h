#ifndef BT_HYBRID_GROUND_H
#define BT_HYBRID_GROUND_H

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <LinearMath/btTransform.h>

#include <optional>

#include "levels/polytope.h"
#include "pairs/ground_pieces.h"

enum btHybridGroundKind
{
	BT_HYBRID_NO_GROUND,
	BT_HYBRID_HALF_SPACE,
	BT_HYBRID_TRIANGLES,  ///< a mesh, a scaled mesh, a height field
	BT_HYBRID_LARGE_BOX,
	BT_HYBRID_LARGE_HULL
};

/// What tells shapes of grounds apart, as far as they tell: a mesh may change in place.
struct btHybridGroundTraits
{
	const btCollisionShape* m_shape;
	btHybridGroundKind m_kind;
	btVector3 m_scaling;
	btVector3 m_min;
	btVector3 m_max;
	btScalar m_margin;

	btHybridGroundTraits()
	    : m_shape(0), m_kind(BT_HYBRID_NO_GROUND), m_scaling(0, 0, 0), m_min(0, 0, 0), m_max(0, 0, 0), m_margin(0)
	{
	}
	btHybridGroundTraits(const btCollisionShape* shape, btHybridGroundKind kind);

	bool operator==(const btHybridGroundTraits& other) const
	{
		return m_shape == other.m_shape && m_kind == other.m_kind && m_scaling == other.m_scaling &&
		       m_min == other.m_min && m_max == other.m_max && m_margin == other.m_margin;
	}
};

/// A shape that a body of parts may lie on: knows its convex pieces near the body. A large convex shape is one piece,
/// clipped to the body's neighbourhood: GJK on what is a hundred times as large loses its digits and runs on and on.
class btHybridGround
{
	btHybridGroundTraits m_traits;
	size_t m_numTriangles;  ///< of a mesh, as far as it tells
	int m_version;
	std::optional<scatter::levels::Polytope>
	    m_core;  ///< the hull's, once it was asked for; empty if it cannot be clipped

	btHybridGround(const btHybridGround&);
	btHybridGround& operator=(const btHybridGround&);

	const scatter::levels::Polytope& getCore();
	void collectBox(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces) const;
	void collectHull(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces);
	bool collectTriangles(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces) const;

public:
	btHybridGround() : m_numTriangles(0), m_version(0)
	{
	}

	/// What a shape is to a body whose parts lie in a ball of this radius, metres.
	static btHybridGroundKind kindOf(const btCollisionShape* shape, btScalar radius);

	/// The same, whatever the size of the body: a large shape may be one.
	static bool maybe(int shapeType);

	/// Takes in what shape the ground has now. Changes in place show by its scaling, margin and bounds.
	void follow(const btCollisionShape* shape, btScalar radius);

	btHybridGroundKind getKind() const
	{
		return m_traits.m_kind;
	}
	const btHybridGroundTraits& getTraits() const
	{
		return m_traits;
	}
	int getVersion() const
	{
		return m_version;
	}
	btScalar getMargin() const
	{
		return m_traits.m_margin;
	}

	/// See scatter::pairs::GroundEngine::reach().
	btScalar getReach(const btVector3& direction) const;

	/// Whether it is a mesh that may as well be known as a whole, by a body whose parts lie in a ball of this radius.
	bool isSmall(btScalar radius) const;

	/// All pieces of one that is small.
	void collectAll(scatter::pairs::GroundPieces& pieces) const;

	/// See scatter::pairs::GroundEngine. Not of a half-space.
	bool collect(const btVector3& low, const btVector3& high, scatter::pairs::GroundPieces& pieces);
};

#endif  // BT_HYBRID_GROUND_H
