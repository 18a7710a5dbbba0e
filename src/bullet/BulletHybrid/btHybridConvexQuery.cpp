#include "btHybridConvexQuery.h"

#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

namespace
{
bool isBox(const btConvexShape* shape)
{
	return shape->getShapeType() == BOX_SHAPE_PROXYTYPE;
}

btVector3 between(const btTransform& a, const btTransform& b)
{
	const btVector3 offset = b.getOrigin() - a.getOrigin();
	return offset.fuzzyZero() ? btVector3(1, 0, 0) : offset;
}

// How far a shape reaches along a world direction: its core and its margin, or with its edges sharp.
btScalar reach(const btConvexShape* shape, const btTransform& transform, const btVector3& direction, bool sharp)
{
	const btVector3 local = direction * transform.getBasis();
	const btVector3 corner = sharp ? shape->localGetSupportVertexNonVirtual(local)
	                               : shape->localGetSupportVertexWithoutMarginNonVirtual(local);
	return direction.dot(transform(corner)) + (sharp ? btScalar(0) : shape->getMarginNonVirtual());
}

// Two convex shapes and the directions in which they were tried to be moved apart.
class Parting
{
	const btConvexShape* m_shapes[2];
	const btTransform& m_a;
	const btTransform& m_b;
	bool m_sharp;
	btScalar m_least;

public:
	Parting(const btConvexShape* shapeA, const btTransform& a, const btConvexShape* shapeB, const btTransform& b)
	    : m_a(a), m_b(b), m_sharp(isBox(shapeA) && isBox(shapeB)), m_least(BT_LARGE_FLOAT)
	{
		m_shapes[0] = shapeA;
		m_shapes[1] = shapeB;
	}

	btScalar getLeast() const
	{
		return m_least;
	}

	// Both ways.
	void tryAlong(const btVector3& direction)
	{
		tryTowards(direction);
		tryTowards(-direction);
	}

	// False if Bullet finds no direction. Its guesses and normals are in A's frame.
	bool tryEpa(const btVector3& guess)
	{
		btGjkEpaSolver2::sResults results;
		if (!btGjkEpaSolver2::Penetration(m_shapes[0], m_a, m_shapes[1], m_b, guess * m_a.getBasis(), results, m_sharp))
			return false;
		tryAlong(m_a.getBasis() * results.normal);
		return true;
	}

	void tryOwnAxes()
	{
		for (int axis = 0; axis < 3; axis++)
		{
			tryAlong(m_a.getBasis().getColumn(axis));
			tryAlong(m_b.getBasis().getColumn(axis));
		}
	}

private:
	// B is moved along the direction.
	void tryTowards(const btVector3& direction)
	{
		const btScalar overlap =
		    reach(m_shapes[0], m_a, direction, m_sharp) + reach(m_shapes[1], m_b, -direction, m_sharp);
		m_least = btMin(m_least, overlap);
	}
};
}  // namespace

btScalar btHybridConvexDistance(const btConvexShape* shapeA, const btTransform& a, const btConvexShape* shapeB,
                                const btTransform& b)
{
	const btScalar tolerance = btScalar(1e-3);
	const btVector3 first = between(a, b);
	const btVector3 guesses[] = {first, -first, btVector3(1, 0, 0), btVector3(0, 1, 0), btVector3(0, 0, 1)};
	btScalar proven = 0;
	for (int i = 0; i < 5; i++)
	{
		btGjkEpaSolver2::sResults results;
		if (!btGjkEpaSolver2::Distance(shapeA, a, shapeB, b, guesses[i] * a.getBasis(), results))
			continue;
		const btVector3 normal = (results.witnesses[1] - results.witnesses[0]).normalized();
		const btScalar apart = -reach(shapeB, b, -normal, false) - reach(shapeA, a, normal, false);
		const btScalar claimed = results.distance - shapeA->getMarginNonVirtual() - shapeB->getMarginNonVirtual();
		proven = btMax(proven, apart);
		// It stops too early now and then; from elsewhere it does not.
		if (claimed - apart <= tolerance * (btScalar(1) + btFabs(claimed)))
			return btMax(btScalar(0), claimed);
	}
	return proven;
}

btScalar btHybridConvexDepth(const btConvexShape* shapeA, const btTransform& a, const btConvexShape* shapeB,
                             const btTransform& b)
{
	const btVector3 guess = between(a, b);
	Parting parting(shapeA, a, shapeB, b);
	parting.tryAlong(guess.normalized());
	parting.tryOwnAxes();
	// It gives up now and then; from the other side it does not.
	if (parting.tryEpa(guess) || parting.tryEpa(-guess))
		return parting.getLeast();
	btGjkEpaSolver2::sResults results;
	if (btGjkEpaSolver2::Distance(shapeA, a, shapeB, b, guess * a.getBasis(), results) &&
	    results.distance > SIMD_EPSILON)
		parting.tryAlong(a.getBasis() * results.normal);
	return parting.getLeast();
}

btScalar btHybridPlaneDepth(const btCollisionShape* plane, const btTransform& planeTransform,
                            const btConvexShape* shape, const btTransform& transform)
{
	const btStaticPlaneShape* halfSpace = static_cast<const btStaticPlaneShape*>(plane);
	const btVector3 normal = planeTransform.getBasis() * halfSpace->getPlaneNormal();
	return halfSpace->getPlaneConstant() + normal.dot(planeTransform.getOrigin()) +
	       reach(shape, transform, -normal, true);
}
