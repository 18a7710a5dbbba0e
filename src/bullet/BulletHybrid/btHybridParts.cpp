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

namespace
{
const int c_mostParts = std::numeric_limits<unsigned short>::max();

const btCompoundShape* asCompound(const btCollisionShape* shape)
{
	return shape->isCompound() ? static_cast<const btCompoundShape*>(shape) : 0;
}

int revisionOf(const btCollisionShape* shape)
{
	const btCompoundShape* compound = asCompound(shape);
	return compound ? compound->getUpdateRevision() : 0;
}

int numPartsOf(const btCollisionShape* shape)
{
	const btCompoundShape* compound = asCompound(shape);
	return compound ? compound->getNumChildShapes() : 1;
}

const btCollisionShape* partShape(const btCollisionShape* shape, int part)
{
	const btCompoundShape* compound = asCompound(shape);
	return compound ? compound->getChildShape(part) : shape;
}

btTransform partTransform(const btCollisionShape* shape, int part)
{
	const btCompoundShape* compound = asCompound(shape);
	return compound ? compound->getChildTransform(part) : btTransform::getIdentity();
}

scatter::Mat3 mat3(const btMatrix3x3& m)
{
	return scatter::Mat3(btHybridVec3(m.getColumn(0)), btHybridVec3(m.getColumn(1)), btHybridVec3(m.getColumn(2)));
}

void addCorners(scatter::PartDef& part, const btTransform& transform, const btVector3& center, const btVector3& half)
{
	for (int corner = 0; corner < 8; corner++)
	{
		const btVector3 local((corner & 1) ? half.x() : -half.x(), (corner & 2) ? half.y() : -half.y(), (corner & 4) ? half.z() : -half.z());
		part.core.push_back(btHybridVec3(transform(center + local)));
	}
}

void addHull(scatter::PartDef& part, const btTransform& transform, const btConvexHullShape* hull)
{
	for (int i = 0; i < hull->getNumPoints(); i++)
		part.core.push_back(btHybridVec3(transform(hull->getScaledPoint(i))));
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
	       isExactly<btCylinderShape>(shape) || isExactly<btCylinderShapeX>(shape) || isExactly<btCylinderShapeZ>(shape) ||
	       isExactly<btMultiSphereShape>(shape) || isExactly<btBox2dShape>(shape) || isExactly<btBU_Simplex1to4>(shape) ||
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
	const btScalar radius = btVector3(part.boundsHalf.x, part.boundsHalf.y, part.boundsHalf.z).length() + part.boundsMargin;
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
			// Hulls whose polyhedral features are there have contacts of their own kind in Bullet.
			part.kind = static_cast<const btConvexHullShape*>(shape)->getConvexPolyhedron() ? scatter::PartKind::kEnclosed : scatter::PartKind::kHull;
			addHull(part, transform, static_cast<const btConvexHullShape*>(shape));
			break;
		default:
			addOther(part, transform, shape);
	}
	return part;
}

std::vector<scatter::PartDef> makeParts(const btCollisionShape* shape)
{
	std::vector<scatter::PartDef> parts;
	parts.reserve(numPartsOf(shape));
	for (int i = 0; i < numPartsOf(shape); i++)
		parts.push_back(makePart(static_cast<const btConvexShape*>(partShape(shape, i)), partTransform(shape, i)));
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

bool btHybridParts::isPartList(const btCollisionShape* shape)
{
	const btCompoundShape* compound = asCompound(shape);
	if (!compound)
		return isPart(shape);
	const int count = compound->getNumChildShapes();
	for (int i = 0; i < count; i++)
		if (!isPart(compound->getChildShape(i)))
			return false;
	return count > 0 && count <= c_mostParts;
}

btHybridParts::Mark::Mark(const btCollisionShape* shape, const btTransform& transform)
    : m_shape(shape), m_points(0), m_features(0), m_transform(transform), m_scaling(shape->getLocalScaling()), m_margin(shape->getMargin()), m_type(shape->getShapeType()), m_numPoints(0)
{
	shape->getAabb(btTransform::getIdentity(), m_min, m_max);
	if (m_type != CONVEX_HULL_SHAPE_PROXYTYPE)
		return;
	const btConvexHullShape* hull = static_cast<const btConvexHullShape*>(shape);
	m_points = hull->getUnscaledPoints();
	m_features = hull->getConvexPolyhedron();
	m_numPoints = hull->getNumPoints();
}

bool btHybridParts::Mark::operator==(const Mark& other) const
{
	return m_shape == other.m_shape && m_type == other.m_type && m_points == other.m_points && m_numPoints == other.m_numPoints && m_features == other.m_features && m_transform == other.m_transform && m_scaling == other.m_scaling && m_min == other.m_min && m_max == other.m_max && m_margin == other.m_margin;
}

btHybridParts::btHybridParts(const btCollisionShape* shape)
    : m_shape(shape), m_scaling(shape->getLocalScaling()), m_margin(shape->getMargin()), m_revision(revisionOf(shape)), m_list(makeParts(shape)), m_users(0)
{
	m_marks.reserve(numPartsOf(shape));
	for (int i = 0; i < numPartsOf(shape); i++)
		m_marks.push_back(Mark(partShape(shape, i), partTransform(shape, i)));
}

bool btHybridParts::isCurrent(bool thorough) const
{
	if (m_revision != revisionOf(m_shape) || !(m_scaling == m_shape->getLocalScaling()) || m_margin != m_shape->getMargin() || m_marks.size() != numPartsOf(m_shape))
		return false;
	for (int i = 0; thorough && i < m_marks.size(); i++)
		if (!(m_marks[i] == Mark(partShape(m_shape, i), partTransform(m_shape, i))))
			return false;
	return true;
}
