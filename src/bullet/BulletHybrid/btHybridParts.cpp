#include "btHybridParts.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <limits>
#include <vector>

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

scatter::Vec3 vec3(const btVector3& v)
{
	return scatter::Vec3(v.x(), v.y(), v.z());
}

scatter::Mat3 mat3(const btMatrix3x3& m)
{
	return scatter::Mat3(vec3(m.getColumn(0)), vec3(m.getColumn(1)), vec3(m.getColumn(2)));
}

void addCorners(scatter::PartDef& part, const btTransform& transform, const btVector3& center, const btVector3& half)
{
	for (int corner = 0; corner < 8; corner++)
	{
		const btVector3 local((corner & 1) ? half.x() : -half.x(), (corner & 2) ? half.y() : -half.y(), (corner & 4) ? half.z() : -half.z());
		part.core.push_back(vec3(transform(center + local)));
	}
}

void addHull(scatter::PartDef& part, const btTransform& transform, const btConvexHullShape* hull)
{
	for (int i = 0; i < hull->getNumPoints(); i++)
		part.core.push_back(vec3(transform(hull->getScaledPoint(i))));
}

void addCapsule(scatter::PartDef& part, const btTransform& transform, const btCapsuleShape* capsule)
{
	btVector3 end(0, 0, 0);
	end[capsule->getUpAxis()] = capsule->getHalfHeight();
	part.core.push_back(vec3(transform(end)));
	part.core.push_back(vec3(transform(-end)));
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

// Bullet bounds every convex shape by its local box, turned; only of a sphere it does not turn it.
void bound(scatter::PartDef& part, const btTransform& transform, const btConvexShape* shape)
{
	btVector3 aabbMin, aabbMax;
	shape->getAabb(btTransform::getIdentity(), aabbMin, aabbMax);
	const btVector3 half = btScalar(0.5) * (aabbMax - aabbMin);
	part.boundsCenter = vec3(transform(btScalar(0.5) * (aabbMin + aabbMax)));
	part.boundsAxes = mat3(transform.getBasis());
	part.boundsHalf = vec3(half);
}

void addBox(scatter::PartDef& part, const btTransform& transform, const btBoxShape* box)
{
	const btVector3 core = box->getHalfExtentsWithoutMargin();
	part.kind = scatter::PartKind::kBox;
	if (core[core.minAxis()] >= 0)
		return addCorners(part, transform, btVector3(0, 0, 0), core);
	// The margin is thicker than the box, and Bullet's GJK sees a core turned inside out.
	part.kind = scatter::PartKind::kEnclosed;
	part.margin = 0;
	addEnclosingBox(part, transform, box);
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
			part.core.push_back(vec3(transform.getOrigin()));
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
			part.kind = scatter::PartKind::kEnclosed;
			part.margin = 0;
			addEnclosingBox(part, transform, shape);
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
