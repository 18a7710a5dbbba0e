#ifndef BT_HYBRID_PIECES_H
#define BT_HYBRID_PIECES_H

#include <BulletCollision/CollisionShapes/btTriangleCallback.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <LinearMath/btAabbUtil2.h>

#include <memory>
#include <vector>

/// A shape and where it is.
struct btHybridPlacedShape
{
	const btCollisionShape* m_shape;
	btTransform m_transform;

	/// Its bounds, this much wider.
	void getAabb(btScalar wider, btVector3& aabbMin, btVector3& aabbMax) const;
};

/// A convex shape or a plane, and its bounds.
struct btHybridPiece
{
	btHybridPlacedShape m_placed;
	btVector3 m_min;
	btVector3 m_max;

	bool isPlane() const
	{
		return m_placed.m_shape->getShapeType() == STATIC_PLANE_PROXYTYPE;
	}
	const btConvexShape* asConvex() const
	{
		return static_cast<const btConvexShape*>(m_placed.m_shape);
	}
};

/// The convex pieces and planes of which shapes are made: of compounds the children, of meshes the triangles. Owns the
/// triangles; the shapes must outlive it.
class btHybridPieces : public btTriangleCallback
{
	std::vector<btHybridPiece> m_pieces;
	std::vector<std::unique_ptr<btTriangleShape>> m_triangles;
	btTransform m_mesh;
	btScalar m_meshMargin;

	void add(const btHybridPlacedShape& placed);
	void collectChildren(const btHybridPlacedShape& placed, const btVector3& aabbMin, const btVector3& aabbMax);
	void collectTriangles(const btHybridPlacedShape& placed, const btVector3& aabbMin, const btVector3& aabbMax);

public:
	btHybridPieces() : m_meshMargin(0)
	{
	}

	const std::vector<btHybridPiece>& get() const
	{
		return m_pieces;
	}

	/// Adds what lies in the box. Shapes that hand out neither children nor triangles have no pieces.
	void collect(const btHybridPlacedShape& placed, const btVector3& aabbMin, const btVector3& aabbMax);

	virtual void processTriangle(btVector3* triangle, int part, int index);
};

/// Calls `visit` with every two pieces of two shapes that are not further apart, by their bounds, than `reach` metres,
/// until it returns false.
template <class Visit>
void btHybridVisitPieces(const btHybridPlacedShape& a, const btHybridPlacedShape& b, btScalar reach, const Visit& visit)
{
	btVector3 aabbMin, aabbMax;
	btHybridPieces piecesA, piecesB;
	b.getAabb(reach, aabbMin, aabbMax);
	piecesA.collect(a, aabbMin, aabbMax);
	a.getAabb(reach, aabbMin, aabbMax);
	piecesB.collect(b, aabbMin, aabbMax);
	const btVector3 wide(reach, reach, reach);
	for (const btHybridPiece& pieceA : piecesA.get())
		for (const btHybridPiece& pieceB : piecesB.get())
			if (TestAabbAgainstAabb2(pieceA.m_min - wide, pieceA.m_max + wide, pieceB.m_min, pieceB.m_max) &&
			    !visit(pieceA, pieceB))
				return;
}

#endif  // BT_HYBRID_PIECES_H
