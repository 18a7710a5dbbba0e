#ifndef BT_HYBRID_PARTS_H
#define BT_HYBRID_PARTS_H

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <LinearMath/btAlignedObjectArray.h>

#include "collision/part_list.h"

/// The convex parts of a shape: its children if it is a compound, those of compounds in it too, else itself. Kept up to
/// date by asking isCurrent() and making it anew; not owned by bodies, but counted by them.
class btHybridParts
{
	/// What tells that a convex shape is still the same.
	struct Mark
	{
		const btCollisionShape* m_shape;
		int m_index;           ///< in the compound whose child it is; -1: in none
		const void* m_points;  ///< of a hull
		const void* m_features;
		btTransform m_transform;
		btVector3 m_scaling;
		btVector3 m_min;
		btVector3 m_max;
		btScalar m_margin;
		int m_type;
		int m_numPoints;

		Mark(const btCollisionShape* shape, const btTransform& transform, int index);
		bool operator==(const Mark& other) const;
	};

	/// What Bullet counts of a compound.
	struct Revision
	{
		const btCompoundShape* m_compound;
		int m_revision;
		int m_numChildren;
	};

	const btCollisionShape* m_shape;
	btVector3 m_scaling;
	btScalar m_margin;
	btAlignedObjectArray<Revision> m_revisions;
	btAlignedObjectArray<Mark> m_marks;
	scatter::PartList m_list;
	int m_users;

	friend class btHybridObjects;

	void addRevisions(const btCompoundShape* compound);

public:
	BT_DECLARE_ALIGNED_ALLOCATOR();

	/// `shape` is one that isPartList() allows.
	explicit btHybridParts(const btCollisionShape* shape);

	/// Whether a shape is convex or a compound of convex children, or of compounds of these: at least one, and not too
	/// many.
	static bool isPartList(const btCollisionShape* shape);

	/// Whether the shape is still what it was. A thorough look compares every part's shape, place, scaling, margin,
	/// bounds and number of points; a quick one only what Bullet counts as a revision, scaling and margin of the whole.
	bool isCurrent(bool thorough) const;

	const btCollisionShape* getShape() const
	{
		return m_shape;
	}
	const scatter::PartList& getList() const
	{
		return m_list;
	}

	/// Of a part: its convex shape, where it is in the whole one, and the index by which Bullet knows it, that of a
	/// compound's child.
	const btCollisionShape* getPartShape(int part) const
	{
		return m_marks[part].m_shape;
	}
	const btTransform& getPartTransform(int part) const
	{
		return m_marks[part].m_transform;
	}
	int getPartIndex(int part) const
	{
		return m_marks[part].m_index;
	}
	size_t getBytes() const
	{
		return sizeof(*this) - sizeof(m_list) + m_list.bytes() + m_marks.capacity() * sizeof(Mark);
	}
};

#endif  // BT_HYBRID_PARTS_H
