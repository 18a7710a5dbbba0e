#include "btHybridParts.h"

#include <BulletCollision/CollisionShapes/btBox2dShape.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTetrahedronShape.h>

#include <limits>
#include <typeinfo>
#include <vector>

#include "btHybridConversions.h"
#include "btHybridHull.h"

namespace
{
const int c_mostParts = std::numeric_limits<unsigned short>::max();

const btCompoundShape* asCompound(const btCollisionShape* shape)
{
	return shape->isCompound() ? static_cast<const btCompoundShape*>(shape) : 0;
}

/// A convex shape in a compound, or in a compound in it.
struct Leaf
{
	const btCollisionShape* m_shape;
	btTransform m_transform;
	int m_index;  ///< in the compound whose child it is; -1 if it is the whole shape
};

// Compounds in compounds end somewhere; whoever puts one into itself has worse to fear.
void collectLeaves(const btCollisionShape* shape, const btTransform& transform, int index, std::vector<Leaf>& leaves)
{
	const btCompoundShape* compound = asCompound(shape);
	if (!compound)
	{
		const Leaf leaf = {shape, transform, index};
		leaves.push_back(leaf);
		return;
	}
	for (int i = 0; i < compound->getNumChildShapes(); i++)
		collectLeaves(compound->getChildShape(i),
		              index < 0 ? compound->getChildTransform(i) : transform * compound->getChildTransform(i), i,
		              leaves);
}

std::vector<Leaf> leavesOf(const btCollisionShape* shape)
{
	std::vector<Leaf> leaves;
	collectLeaves(shape, btTransform::getIdentity(), -1, leaves);
	return leaves;
}

scatter::Mat3 mat3(const btMatrix3x3& m)
{
	return scatter::Mat3(btHybridVec3(m.getColumn(0)), btHybridVec3(m.getColumn(1)), btHybridVec3(m.getColumn(2)));
}

void addCorners(scatter::PartDef& part, const btTransform& transform, const btVector3& center, const btVector3& half)
{
	for (int corner = 0; corner < 8; corner++)
	{
		const btVector3 local((corner & 1) ? half.x() : -half.x(), (corner & 2) ? half.y() : -half.y(),
		                      (corner & 4) ? half.z() : -half.z());
		part.core.push_back(btHybridVec3(transform(center + local)));
	}
}

void addCapsule(scatter::PartDef& part, const btTransform& transform, const btCapsuleShape* capsule)
{
	btVector3 end(0, 0, 0);
	end[capsule->getUpAxis()] = capsule->getHalfHeight();
	part.core.push_back(btHybridVec3(transform(end)));
	part.core.push_back(btHybridVec3(transform(-end)));
}

// From the shape's own support function: getAabb is too small for a few (a cylinder of two radii, say).
void addEnclosingBox(scatter::PartDef& part, const btTransform& transform, const btConvexShape* shape)
{
	btVector3 low, high;
	for (int axis = 0; axis < 3; axis++)
	{
		btVector3 direction(0, 0, 0);
		direction[axis] = 1;
		high[axis] = shape->localGetSupportingVertex(direction)[axis];
		low[axis] = shape->localGetSupportingVertex(-direction)[axis];
	}
	addCorners(part, transform, btScalar(0.5) * (low + high), btScalar(0.5) * (high - low));
}

template <class Shape>
bool isExactly(const btConvexShape* shape)
{
	return typeid(*shape) == typeid(Shape);
}

// Whether the shape's bounds are known to be its local box, turned with it, or those of a ball. A program's own
// shapes may bound themselves as they like, whatever they are derived from.
bool turnsItsBox(const btConvexShape* shape)
{
	return isExactly<btBoxShape>(shape) || isExactly<btConvexHullShape>(shape) || isExactly<btSphereShape>(shape) ||
	       isExactly<btCapsuleShape>(shape) || isExactly<btCapsuleShapeX>(shape) || isExactly<btCapsuleShapeZ>(shape) ||
	       isExactly<btCylinderShape>(shape) || isExactly<btCylinderShapeX>(shape) ||
	       isExactly<btCylinderShapeZ>(shape) || isExactly<btMultiSphereShape>(shape) ||
	       isExactly<btBox2dShape>(shape) || isExactly<btBU_Simplex1to4>(shape) ||
	       isExactly<btConvexPointCloudShape>(shape) || isExactly<btConvexTriangleMeshShape>(shape);
}

// The shape's local box. Others than those that Bullet turns with the shape are asked for their bounds at every pose:
// cones, triangles, sums and scaled shapes bound themselves by their support function.
void bound(scatter::PartDef& part, const btTransform& transform, const btConvexShape* shape)
{
	btVector3 aabbMin, aabbMax;
	shape->getAabb(btTransform::getIdentity(), aabbMin, aabbMax);
	const btVector3 half = btScalar(0.5) * (aabbMax - aabbMin);
	part.boundsCenter = btHybridVec3(transform(btScalar(0.5) * (aabbMin + aabbMax)));
	part.boundsAxes = mat3(transform.getBasis());
	part.boundsHalf = btHybridVec3(half);
	part.asksBounds = !turnsItsBox(shape);
}

// One of 27 directions; the middle one, 13, is none.
btVector3 towards(int code)
{
	const int y = code / 3 % 3;
	const int z = code / 9;
	return btVector3(btScalar(code % 3 - 1), btScalar(y - 1), btScalar(z - 1));
}

// Whether the points that Bullet's GJK is given are those of a convex core. Where the margin is thicker than the shape,
// the core is turned inside out, and reaches further to the back than to the front.
bool isSound(const btConvexShape* shape)
{
	const btScalar rounding = btScalar(1e-5);
	for (int code = 1; code < 27; code++)
	{
		const btVector3 direction = towards(code);
		const btVector3 vertex = shape->localGetSupportVertexWithoutMarginNonVirtual(direction);
		for (int other = 1; other < 27; other++)
		{
			const btVector3 d = towards(other);
			const btVector3 furthest = shape->localGetSupportVertexWithoutMarginNonVirtual(d);
			if (vertex.dot(d) > furthest.dot(d) + rounding * (vertex.length() + furthest.length()))
				return false;
		}
	}
	return true;
}

// Bullet's contacts of two shapes of the plane leave out the third axis, but for their bounds.
bool isOpaque(const btConvexShape* shape)
{
	return shape->isConvex2d() || !isSound(shape);
}

// Wherever the part's bounds may be, with its body turned in any way.
void addReach(scatter::PartDef& part)
{
	const btVector3 center(part.boundsCenter.x, part.boundsCenter.y, part.boundsCenter.z);
	const btScalar radius =
	    btVector3(part.boundsHalf.x, part.boundsHalf.y, part.boundsHalf.z).length() + part.boundsMargin;
	part.kind = scatter::PartKind::kOpaque;
	part.margin = 0;
	addCorners(part, btTransform::getIdentity(), center, btVector3(radius, radius, radius));
}

void addOther(scatter::PartDef& part, const btTransform& transform, const btConvexShape* shape)
{
	if (isOpaque(shape))
		return addReach(part);
	part.kind = scatter::PartKind::kEnclosed;
	part.margin = 0;
	addEnclosingBox(part, transform, shape);
}

void addBox(scatter::PartDef& part, const btTransform& transform, const btBoxShape* box)
{
	const btVector3 core = box->getHalfExtentsWithoutMargin();
	part.kind = scatter::PartKind::kBox;
	if (core[core.minAxis()] >= 0)
		return addCorners(part, transform, btVector3(0, 0, 0), core);
	addReach(part);
}

// A hull whose polyhedral features are there is only known to be around its points.
void addHull(scatter::PartDef& part, const btTransform& transform, const btConvexShape* shape)
{
	const std::vector<btVector3> points = btHybridHullPoints(shape);
	if (!points.empty() && points.size() <= size_t(c_mostParts))
	{
		part.kind = scatter::PartKind::kHull;
		for (const btVector3& point : points)
			part.core.push_back(btHybridVec3(transform(point)));
		return;
	}
	if (!points.empty() || shape->getShapeType() != CONVEX_HULL_SHAPE_PROXYTYPE)
		return addOther(part, transform, shape);
	const btConvexHullShape* hull = static_cast<const btConvexHullShape*>(shape);
	part.kind = scatter::PartKind::kEnclosed;
	for (int i = 0; i < hull->getNumPoints(); i++)
		part.core.push_back(btHybridVec3(transform(hull->getScaledPoint(i))));
}

scatter::PartDef makePart(const btConvexShape* shape, const btTransform& transform)
{
	scatter::PartDef part;
	bound(part, transform, shape);
	part.margin = shape->getMargin();
	switch (shape->getShapeType())
	{
		case SPHERE_SHAPE_PROXYTYPE:
			part.kind = scatter::PartKind::kSphere;
			part.core.push_back(btHybridVec3(transform.getOrigin()));
			part.margin = static_cast<const btSphereShape*>(shape)->getRadius();
			part.boundsMargin = part.margin;
			part.boundsHalf = scatter::Vec3(0.0f);
			break;
		case CAPSULE_SHAPE_PROXYTYPE:
			part.kind = scatter::PartKind::kCapsule;
			addCapsule(part, transform, static_cast<const btCapsuleShape*>(shape));
			part.margin = static_cast<const btCapsuleShape*>(shape)->getRadius();
			break;
		case BOX_SHAPE_PROXYTYPE:
			addBox(part, transform, static_cast<const btBoxShape*>(shape));
			break;
		case CONVEX_HULL_SHAPE_PROXYTYPE:
		case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE:
			addHull(part, transform, shape);
			break;
		default:
			addOther(part, transform, shape);
	}
	return part;
}

std::vector<scatter::PartDef> makeParts(const btCollisionShape* shape)
{
	std::vector<scatter::PartDef> parts;
	for (const Leaf& leaf : leavesOf(shape))
		parts.push_back(makePart(static_cast<const btConvexShape*>(leaf.m_shape), leaf.m_transform));
	return parts;
}

bool isPart(const btCollisionShape* shape)
{
	if (!shape->isConvex())
		return false;
	if (shape->getShapeType() != CONVEX_HULL_SHAPE_PROXYTYPE)
		return true;
	const int points = static_cast<const btConvexHullShape*>(shape)->getNumPoints();
	return points > 0 && points <= c_mostParts;
}
}  // namespace

// How many parts a shape has; more than there may be if one of its leaves is none.
static int countParts(const btCollisionShape* shape)
{
	const btCompoundShape* compound = asCompound(shape);
	if (!compound)
		return isPart(shape) ? 1 : c_mostParts + 1;
	int count = 0;
	for (int i = 0; i < compound->getNumChildShapes() && count <= c_mostParts; i++)
		count += countParts(compound->getChildShape(i));
	return count;
}

// Asked for every new pair.
bool btHybridParts::isPartList(const btCollisionShape* shape)
{
	const int count = countParts(shape);
	return count > 0 && count <= c_mostParts;
}

btHybridParts::Mark::Mark(const btCollisionShape* shape, const btTransform& transform, int index)
    : m_shape(shape),
      m_index(index),
      m_points(0),
      m_features(0),
      m_transform(transform),
      m_scaling(shape->getLocalScaling()),
      m_margin(shape->getMargin()),
      m_type(shape->getShapeType()),
      m_numPoints(0)
{
	shape->getAabb(btTransform::getIdentity(), m_min, m_max);
	if (m_type != CONVEX_HULL_SHAPE_PROXYTYPE)
		return;
	const btConvexHullShape* hull = static_cast<const btConvexHullShape*>(shape);
	m_points = hull->getUnscaledPoints();
	m_features = hull->getConvexPolyhedron();
	m_numPoints = hull->getNumPoints();
}

// Bullet's own comparison takes in the fourth number, which nobody sets: some shapes leave it as it was in the bounds
// that they find.
static bool isSame(const btVector3& a, const btVector3& b)
{
	return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}

static bool isSame(const btTransform& a, const btTransform& b)
{
	return isSame(a.getBasis()[0], b.getBasis()[0]) && isSame(a.getBasis()[1], b.getBasis()[1]) &&
	       isSame(a.getBasis()[2], b.getBasis()[2]) && isSame(a.getOrigin(), b.getOrigin());
}

bool btHybridParts::Mark::operator==(const Mark& other) const
{
	return m_shape == other.m_shape && m_index == other.m_index && m_type == other.m_type &&
	       m_points == other.m_points && m_numPoints == other.m_numPoints && m_features == other.m_features &&
	       isSame(m_transform, other.m_transform) && isSame(m_scaling, other.m_scaling) && isSame(m_min, other.m_min) &&
	       isSame(m_max, other.m_max) && m_margin == other.m_margin;
}

// A compound before those that are in it.
void btHybridParts::addRevisions(const btCompoundShape* compound)
{
	const Revision revision = {compound, compound->getUpdateRevision(), compound->getNumChildShapes()};
	m_revisions.push_back(revision);
	for (int i = 0; i < compound->getNumChildShapes(); i++)
		if (const btCompoundShape* child = asCompound(compound->getChildShape(i)))
			addRevisions(child);
}

btHybridParts::btHybridParts(const btCollisionShape* shape)
    : m_shape(shape),
      m_scaling(shape->getLocalScaling()),
      m_margin(shape->getMargin()),
      m_list(makeParts(shape)),
      m_users(0)
{
	if (const btCompoundShape* compound = asCompound(shape))
		addRevisions(compound);
	for (const Leaf& leaf : leavesOf(shape))
		m_marks.push_back(Mark(leaf.m_shape, leaf.m_transform, leaf.m_index));
}

// A compound that is the same still has the compounds that it had; of one that has changed they may be gone.
bool btHybridParts::isCurrent(bool thorough) const
{
	if (!isSame(m_scaling, m_shape->getLocalScaling()) || m_margin != m_shape->getMargin())
		return false;
	for (int i = 0; i < m_revisions.size(); i++)
		if (m_revisions[i].m_compound->getUpdateRevision() != m_revisions[i].m_revision ||
		    m_revisions[i].m_compound->getNumChildShapes() != m_revisions[i].m_numChildren)
			return false;
	if (!thorough)
		return true;
	const std::vector<Leaf> leaves = leavesOf(m_shape);
	if (leaves.size() != size_t(m_marks.size()))
		return false;
	for (int i = 0; i < m_marks.size(); i++)
		if (!(m_marks[i] == Mark(leaves[i].m_shape, leaves[i].m_transform, leaves[i].m_index)))
			return false;
	return true;
}
