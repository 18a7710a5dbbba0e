#ifndef BT_HYBRID_LEVEL_SET_H
#define BT_HYBRID_LEVEL_SET_H

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <LinearMath/btAlignedObjectArray.h>

/// Whether addLevel looks if a level lies inside the one before it.
enum btHybridNesting
{
	BT_HYBRID_PROVE_NESTING,

	/// For levels that are known to be nested, because the proof was made when they were, say. Where they are not,
	/// pairs that switch push their bodies apart.
	BT_HYBRID_NESTING_IS_PROVEN
};

/// The encapsulation levels of a model, coarsest first. Each level is a convex shape or a btCompoundShape
/// of convex shapes, in the same frame (that of the body's centre of mass), and lies inside the level
/// before it. Shared by any number of bodies; does not own the shapes, which must not change any more.
class btHybridLevelSet
{
	friend class btHybridCoarsestBounds;

	btAlignedObjectArray<btCollisionShape*> m_levels;
	btAlignedObjectArray<float>
	    m_balls;  ///< of which level 1 is the hull: all x, all y, all z, all radii; none where Bullet's bounds do
	btAlignedObjectArray<char> m_mistake;
	btScalar m_coarsestRadius;

	const char* refuse(const char* mistake);
	void findBalls();

public:
	btHybridLevelSet() : m_coarsestRadius(0)
	{
	}

	/// Adds the next finer level; bodies that were made before do not have it. Returns 0, or what is wrong and how to
	/// mend it, valid until the next call, and then the level is not added:
	/// - no shape; one that is neither convex nor a compound (a plane, mesh, height field, empty shape); a compound
	/// without
	///   children or with a child that is not convex (another compound, say); a hull without points;
	/// - more than 65535 children, or points of a hull; more than 250 levels;
	/// - a bound, child's place, margin or hull's point that is not finite; a negative margin;
	/// - a level that does not lie inside the one before it, collision margins included: hulls and cones reach out by
	///   their margin (0.04 by default, see btCollisionShape::setMargin), boxes and cylinders hold theirs.
	///
	/// A child may stick out by a ten-thousandth of the coarser level's largest side, so that levels that share a face,
	/// or were computed in single precision, count as nested: half a millimetre for 5 m, where contacts begin at 2 cm.
	/// What is accepted is nested to within twice that, the second part of it for Bullet's computation of hulls. A
	/// child that lies inside a single child of the coarser level is never refused, if both are of Bullet's convex
	/// shapes with a volume: box, sphere, capsule, cylinder, cone, hull, tetrahedron, and uniformly scaled ones. One
	/// that lies inside several of them together is judged exactly if these are boxes, tetrahedra and hulls, and it is
	/// a box, a tetrahedron, or a hull with the margin of theirs. Else the judgement is conservative: round ones stand
	/// for polytopes within them, or around it, that are off by up to 1 % of the radius, and the rounding by a hull's
	/// margin for one that is off by 8 % of it. So do shapes of other kinds, and multi-spheres, for what is found by
	/// looking in 482 directions. A hull without volume holds nothing but itself.
	///
	/// The proof takes about half a millisecond for 64 hulls that each lie in one of eight, and as much for each
	/// child that lies in several together (bench/nesting_cost). It grows with the product of the points of the two
	/// hulls: two of 4000 points take a fifth of a second.
	const char* addLevel(btCollisionShape* shape, btHybridNesting nesting = BT_HYBRID_PROVE_NESTING);

	int getNumLevels() const
	{
		return m_levels.size();
	}

	/// level counts from 1, the coarsest, to getNumLevels(), the finest; 0 if there is no such level.
	btCollisionShape* getLevelShape(int level) const
	{
		return level >= 1 && level <= m_levels.size() ? m_levels[level - 1] : 0;
	}

	/// Of a ball around the origin of the frame that holds level 1, by its bounding sphere in Bullet; metres, 0
	/// without levels.
	btScalar getCoarsestRadius() const
	{
		return m_coarsestRadius;
	}

	/// World bounds of level 1, which hold every level. Where it is made of hulls, boxes, spheres and capsules with at
	/// most 64 corners in all, they fit it however it is turned; Bullet's own, of other levels, are often those of a
	/// box that turns with it. Without levels those of the transform's origin.
	void getCoarsestAabb(const btTransform& transform, btVector3& aabbMin, btVector3& aabbMax) const;
};

#endif  // BT_HYBRID_LEVEL_SET_H
