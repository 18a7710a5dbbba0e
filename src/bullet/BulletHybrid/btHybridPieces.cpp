#include "btHybridPieces.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>

void btHybridPlacedShape::getAabb(btScalar wider, btVector3& aabbMin, btVector3& aabbMax) const
{
	m_shape->getAabb(m_transform, aabbMin, aabbMax);
	const btVector3 wide(wider, wider, wider);
	aabbMin -= wide;
	aabbMax += wide;
}

void btHybridPieces::add(const btHybridPlacedShape& placed)
{
	btHybridPiece piece;
	piece.m_placed = placed;
	placed.getAabb(0, piece.m_min, piece.m_max);
	m_pieces.push_back(piece);
}

void btHybridPieces::collect(const btHybridPlacedShape& placed, const btVector3& aabbMin, const btVector3& aabbMax)
{
	const btCollisionShape* shape = placed.m_shape;
	if (shape->getShapeType() == STATIC_PLANE_PROXYTYPE)
		return add(placed);
	btVector3 lower, upper;
	placed.getAabb(0, lower, upper);
	if (shape->getShapeType() == EMPTY_SHAPE_PROXYTYPE || !TestAabbAgainstAabb2(lower, upper, aabbMin, aabbMax))
		return;
	if (shape->isConvex())
		return add(placed);
	if (shape->isCompound())
		return collectChildren(placed, aabbMin, aabbMax);
	if (shape->isConcave())
		collectTriangles(placed, aabbMin, aabbMax);
}

void btHybridPieces::collectChildren(const btHybridPlacedShape& placed, const btVector3& aabbMin,
                                     const btVector3& aabbMax)
{
	const btCompoundShape* compound = static_cast<const btCompoundShape*>(placed.m_shape);
	for (int i = 0; i < compound->getNumChildShapes(); i++)
		collect({compound->getChildShape(i), placed.m_transform * compound->getChildTransform(i)}, aabbMin, aabbMax);
}

void btHybridPieces::collectTriangles(const btHybridPlacedShape& placed, const btVector3& aabbMin,
                                      const btVector3& aabbMax)
{
	m_mesh = placed.m_transform;
	m_meshMargin = placed.m_shape->getMargin();
	btVector3 lower, upper;
	btTransformAabb(aabbMin, aabbMax, m_meshMargin, m_mesh.inverse(), lower, upper);
	static_cast<const btConcaveShape*>(placed.m_shape)->processAllTriangles(this, lower, upper);
}

void btHybridPieces::processTriangle(btVector3* triangle, int, int)
{
	m_triangles.push_back(std::make_unique<btTriangleShape>(triangle[0], triangle[1], triangle[2]));
	m_triangles.back()->setMargin(m_meshMargin);
	add({m_triangles.back().get(), m_mesh});
}
