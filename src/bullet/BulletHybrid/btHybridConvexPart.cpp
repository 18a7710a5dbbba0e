#include "btHybridConvexPart.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvex2dShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <limits>

#include "btHybridHull.h"

using scatter::levels::HalfSpace;
using scatter::levels::Polytope;

namespace
{
typedef btHybridPoint Point;

const double c_pi = 3.14159265358979323846;

// So many corners that a polygon around a circle exceeds it by less than the tolerance of nesting.
const int c_circleCorners = 256;

// Of polytopes that stand for round shapes, and for the rounding of a hull by its margin.
const int c_roundSegments = 32;
const int c_marginSegments = 12;

// Point sets no thicker than this share of their extent have no volume.
const double c_flatness = 1e-6;

Point point(const btVector3& v)
{
	return Point(double(v.x()), double(v.y()), double(v.z()));
}

// Unit vectors on a grid of meridians and parallels.
std::vector<Point> ballDirections(int segments)
{
	std::vector<Point> directions;
	directions.push_back(Point(0, 1, 0));
	directions.push_back(Point(0, -1, 0));
	const double step = 2 * c_pi / segments;
	for (int ring = 1; ring < segments / 2; ring++)
	{
		const double around = std::sin(ring * step);
		for (int side = 0; side < segments; side++)
			directions.push_back(
			    Point(around * std::cos(side * step), std::cos(ring * step), around * std::sin(side * step)));
	}
	return directions;
}

// By how much the grid must grow to hold the unit ball: half a cell's diagonal is at most sqrt(2) pi / segments.
double circumscribing(int segments)
{
	return 1 / std::cos(std::sqrt(2.0) * c_pi / segments);
}

void addSphere(std::vector<Point>& points, const Point& center, double radius, int segments)
{
	const std::vector<Point> directions = ballDirections(segments);
	for (size_t i = 0; i < directions.size(); i++)
		points.push_back(center + radius * directions[i]);
}

// Every face moved out by the margin, the slopes between them left straight.
Polytope withFlatMargin(const Polytope& core, double margin)
{
	std::vector<Point> points;
	for (size_t i = 0; i < core.faces().size(); i++)
	{
		const Polytope::Face& face = core.faces()[i];
		for (const std::uint32_t vertex : core.loop(face))
			points.push_back(core.vertices()[vertex] + margin * face.plane.normal);
	}
	Polytope widened = btHybridHullOf(points);
	return widened.isEmpty() ? core : widened;
}

Polytope movedIn(Polytope core, double inset, double epsilon)
{
	const std::vector<Polytope::Face> faces = core.faces();
	for (size_t i = 0; i < faces.size() && !core.isEmpty(); i++)
		core = core.clipped(faces[i].plane.movedOut(-inset), epsilon);
	return core;
}
}  // namespace

double btHybridRevolved::getSignedDistance(const btHybridPoint& position) const
{
	const Point offset = position - m_origin;
	const double height = glm::dot(offset, m_axis);
	const glm::dvec2 p(glm::length(offset - height * m_axis), height);
	double depth = -std::numeric_limits<double>::infinity();
	double distance = glm::length(p - m_profile[0]);
	for (size_t i = 1; i < m_profile.size(); i++)
	{
		const glm::dvec2 edge = m_profile[i] - m_profile[i - 1];
		const glm::dvec2 fromStart = p - m_profile[i - 1];
		const double length2 = glm::dot(edge, edge);
		if (!(length2 > 0))
			continue;
		const double share = std::clamp(glm::dot(fromStart, edge) / length2, 0.0, 1.0);
		distance = std::min(distance, glm::length(fromStart - share * edge));
		depth = std::max(depth, (fromStart.x * edge.y - fromStart.y * edge.x) / std::sqrt(length2));
	}
	// A point or a line has no inside.
	return m_profile.size() > 2 && depth <= 0 ? depth : distance;
}

/// Makes parts of shapes, in the frame of the part's place.
struct btHybridPartMaker
{
	btHybridConvexPart& m_part;
	btTransform m_place;
	double m_scale;

	Point at(const Point& local) const
	{
		return point(m_place.getOrigin()) + m_scale * turned(local);
	}
	Point turned(const Point& local) const
	{
		const btMatrix3x3& basis = m_place.getBasis();
		return point(basis.getColumn(0)) * local.x + point(basis.getColumn(1)) * local.y +
		       point(basis.getColumn(2)) * local.z;
	}

	void addBall(const Point& local, double radius)
	{
		const btHybridBall ball = {at(local), m_scale * radius};
		m_part.m_balls.push_back(ball);
	}

	// A core whose corners are these.
	void addCorners(const std::vector<Point>& corners, double margin)
	{
		for (size_t i = 0; i < corners.size(); i++)
		{
			addBall(corners[i], margin);
			m_part.m_around.push_back(at(corners[i]));
		}
		m_part.m_within = m_part.m_around;
		m_part.m_margin = m_scale * margin;
	}

	void makeBox(const btVector3& half, const btVector3& center)
	{
		std::vector<Point> corners(8);
		for (int i = 0; i < 8; i++)
			corners[i] = point(center + half * btVector3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
		addCorners(corners, 0);
	}

	void makeHull(const btPolyhedralConvexShape* shape)
	{
		std::vector<Point> corners;
		for (int i = 0; i < shape->getNumVertices(); i++)
		{
			btVector3 vertex;
			shape->getVertex(i, vertex);
			corners.push_back(point(vertex));
		}
		addCorners(corners, double(shape->getMargin()));
		m_part.m_isHull = true;
	}

	// What is revolved around an axis of the shape, with a margin around it.
	void makeRevolved(int axis, const std::vector<glm::dvec2>& profile, double margin)
	{
		Point direction(0.0);
		direction[axis] = 1;
		btHybridRevolved revolved;
		revolved.m_origin = at(Point(0.0));
		revolved.m_axis = turned(direction);
		for (size_t i = 0; i < profile.size(); i++)
		{
			revolved.m_profile.push_back(m_scale * profile[i]);
			addRing(axis, profile[i], margin);
		}
		m_part.m_revolved = revolved;
		m_part.m_margin = m_scale * margin;
	}

	void addRing(int axis, const glm::dvec2& corner, double margin)
	{
		const double exceeding = corner.x / std::cos(c_pi / c_circleCorners);
		for (int i = 0; i < (corner.x > 0 ? c_circleCorners : 1); i++)
			addBall(onRing(axis, exceeding, corner.y, i, c_circleCorners), margin);
		for (int i = 0; i < (corner.x > 0 ? c_roundSegments : 1); i++)
		{
			m_part.m_within.push_back(at(onRing(axis, corner.x, corner.y, i, c_roundSegments)));
			m_part.m_around.push_back(
			    at(onRing(axis, corner.x / std::cos(c_pi / c_roundSegments), corner.y, i, c_roundSegments)));
		}
	}

	static Point onRing(int axis, double radius, double height, int corner, int corners)
	{
		const double angle = 2 * c_pi * corner / corners;
		Point result(0.0);
		result[axis] = height;
		result[(axis + 1) % 3] = radius * std::cos(angle);
		result[(axis + 2) % 3] = radius * std::sin(angle);
		return result;
	}

	void makeCylinder(const btCylinderShape* shape)
	{
		const btVector3 half = shape->getHalfExtentsWithoutMargin();
		const int axis = shape->getUpAxis();
		const double margin = double(shape->getMargin());
		const double height = double(half[axis]);
		const double radius = double(shape->getRadius()) - margin;
		if (!(height >= 0 && radius >= 0))
			return makeUnknown(shape);
		makeRevolved(axis, {{0, -height}, {radius, -height}, {radius, height}, {0, height}}, margin);
	}

	void makeCone(const btConeShape* shape)
	{
		const double half = 0.5 * double(shape->getHeight());
		makeRevolved(shape->getConeUpIndex(), {{0, -half}, {double(shape->getRadius()), -half}, {0, half}},
		             double(shape->getMargin()));
	}

	// Its spheres may have any radius; what it holds is found by looking in all directions.
	void makeMultiSphere(const btMultiSphereShape* shape)
	{
		const btVector3 scaling = shape->getLocalScaling();
		const double widest = double(btMax(btMax(btFabs(scaling.x()), btFabs(scaling.y())), btFabs(scaling.z())));
		for (int i = 0; i < shape->getSphereCount(); i++)
			addBall(point(shape->getSpherePosition(i) * scaling), widest * double(shape->getSphereRadius(i)));
		addSupports(shape);
	}

	void addSupports(const btConvexShape* shape)
	{
		const std::vector<Point> directions = ballDirections(c_roundSegments);
		for (size_t i = 0; i < directions.size(); i++)
		{
			const Point& d = directions[i];
			m_part.m_within.push_back(
			    at(point(shape->localGetSupportingVertex(btVector3(btScalar(d.x), btScalar(d.y), btScalar(d.z))))));
		}
	}

	// Held is the box around it, and it holds what is found by looking in all directions.
	void makeUnknown(const btConvexShape* shape)
	{
		btVector3 low, high;
		for (int axis = 0; axis < 3; axis++)
		{
			btVector3 direction(0, 0, 0);
			direction[axis] = 1;
			high[axis] = shape->localGetSupportingVertex(direction)[axis];
			low[axis] = shape->localGetSupportingVertex(-direction)[axis];
		}
		makeBox(btScalar(0.5) * (high - low), btScalar(0.5) * (high + low));
		m_part.m_within.clear();
		addSupports(shape);
	}

	void make(const btConvexShape* shape)
	{
		switch (shape->getShapeType())
		{
			case BOX_SHAPE_PROXYTYPE:
				return makeBox(static_cast<const btBoxShape*>(shape)->getHalfExtentsWithMargin(), btVector3(0, 0, 0));
			case SPHERE_SHAPE_PROXYTYPE:
				return makeRevolved(1, {{0, 0}}, double(static_cast<const btSphereShape*>(shape)->getRadius()));
			case CAPSULE_SHAPE_PROXYTYPE:
			{
				const btCapsuleShape* capsule = static_cast<const btCapsuleShape*>(shape);
				const double half = double(capsule->getHalfHeight());
				return makeRevolved(capsule->getUpAxis(), {{0, -half}, {0, half}}, double(capsule->getRadius()));
			}
			case CYLINDER_SHAPE_PROXYTYPE:
				return makeCylinder(static_cast<const btCylinderShape*>(shape));
			case CONE_SHAPE_PROXYTYPE:
				return makeCone(static_cast<const btConeShape*>(shape));
			case MULTI_SPHERE_SHAPE_PROXYTYPE:
				return makeMultiSphere(static_cast<const btMultiSphereShape*>(shape));
			case CONVEX_HULL_SHAPE_PROXYTYPE:
			case TETRAHEDRAL_SHAPE_PROXYTYPE:
			case TRIANGLE_SHAPE_PROXYTYPE:
				return makeHull(static_cast<const btPolyhedralConvexShape*>(shape));
			case UNIFORM_SCALING_SHAPE_PROXYTYPE:
				m_scale *= double(static_cast<const btUniformScalingShape*>(shape)->getUniformScalingFactor());
				return make(static_cast<const btUniformScalingShape*>(shape)->getChildShape());
			case CONVEX_2D_SHAPE_PROXYTYPE:
				return make(static_cast<const btConvex2dShape*>(shape)->getChildShape());
			default:
				return makeUnknown(shape);
		}
	}
};

btHybridConvexPart::btHybridConvexPart(const btConvexShape* shape, const btTransform& transform)
    : m_shape(shape), m_transform(transform), m_margin(0), m_isHull(false)
{
	btHybridPartMaker maker = {*this, transform, 1};
	maker.make(shape);
	for (size_t i = 0; i < m_balls.size(); i++)
	{
		m_bounds.add(m_balls[i].m_center + Point(m_balls[i].m_radius));
		m_bounds.add(m_balls[i].m_center - Point(m_balls[i].m_radius));
	}
}

const Polytope& btHybridConvexPart::getCore() const
{
	if (!m_core)
		m_core = btHybridHullOf(m_within);
	return *m_core;
}

double btHybridConvexPart::getSupport(const btHybridPoint& direction) const
{
	double reach = -std::numeric_limits<double>::infinity();
	for (size_t i = 0; i < m_balls.size(); i++)
		reach = std::max(reach, glm::dot(direction, m_balls[i].m_center) + m_balls[i].m_radius);
	return reach;
}

double btHybridConvexPart::getRadius() const
{
	for (size_t i = 1; i < m_balls.size(); i++)
		if (m_balls[i].m_radius != m_balls[0].m_radius)
			return -1;
	return m_balls[0].m_radius;
}

bool btHybridConvexPart::isSame(const btHybridConvexPart& other) const
{
	return m_shape == other.m_shape && m_transform == other.m_transform;
}

// Negative inside; exact up to `limit`.
double btHybridConvexPart::getCoreDistance(const btHybridPoint& position, double limit) const
{
	if (m_revolved)
		return m_revolved->getSignedDistance(position);
	const std::vector<Polytope::Face>& faces = getCore().faces();
	double depth = -std::numeric_limits<double>::infinity();
	for (size_t i = 0; i < faces.size(); i++)
		depth = std::max(depth, faces[i].plane.signedDistance(position));
	return depth > 0 && depth <= limit ? getCore().distance(position) : depth;
}

double btHybridConvexPart::getProtrusion(const btHybridConvexPart& part, btHybridPoint& furthest) const
{
	double most = -std::numeric_limits<double>::infinity();
	for (size_t i = 0; i < part.m_balls.size(); i++)
	{
		const btHybridBall& ball = part.m_balls[i];
		const double distance = getCoreDistance(ball.m_center, std::numeric_limits<double>::infinity());
		const double protrusion = distance + ball.m_radius - m_margin;
		if (protrusion > most)
			furthest = ball.m_center;
		most = std::max(most, protrusion);
	}
	return most;
}

bool btHybridConvexPart::holds(const btHybridConvexPart& part, double tolerance) const
{
	if (isSame(part))
		return true;
	for (int axis = 0; axis < 3; axis++)
		if (part.m_bounds.min[axis] < m_bounds.min[axis] - tolerance ||
		    part.m_bounds.max[axis] > m_bounds.max[axis] + tolerance)
			return false;
	if (!isSolid())
		return false;
	for (size_t i = 0; i < part.m_balls.size(); i++)
	{
		const double most = m_margin - part.m_balls[i].m_radius + tolerance;
		if (getCoreDistance(part.m_balls[i].m_center, most) > most)
			return false;
	}
	return true;
}

Polytope btHybridConvexPart::getOuterCore() const
{
	return btHybridHullOf(m_around);
}

Polytope btHybridConvexPart::getOuter(const std::vector<btHybridPoint>& tangents, double epsilon) const
{
	std::vector<Point> points;
	const bool hasCore = m_around.size() > 2;
	for (size_t i = 0; i < m_balls.size() && !hasCore; i++)
		addSphere(points, m_balls[i].m_center, m_balls[i].m_radius * circumscribing(c_roundSegments), c_roundSegments);
	const Point middle = 0.5 * (m_bounds.min + m_bounds.max);
	const Point half = 0.5 * (m_bounds.max - m_bounds.min);
	// What is flat cannot be cut into pieces.
	if (btMin(btMin(half.x, half.y), half.z) <= c_flatness * glm::length(half))
		return Polytope();
	Polytope outer = hasCore ? Polytope::box(middle, glm::dmat3(1.0), half) : btHybridHullOf(points);
	std::vector<Point> normals = tangents;
	const std::vector<Point> directions = ballDirections(c_marginSegments);
	if (hasCore)
		normals.insert(normals.end(), directions.begin(), directions.end());
	for (size_t i = 0; i < normals.size() && !outer.isEmpty(); i++)
		outer = outer.clipped({normals[i], getSupport(normals[i])}, epsilon);
	return outer;
}

Polytope btHybridConvexPart::getInner(double inset, double epsilon) const
{
	if (m_revolved && m_revolved->m_profile.size() <= 2)
	{
		std::vector<Point> points;
		for (size_t i = 0; m_margin > inset && i < m_balls.size(); i++)
			addSphere(points, m_balls[i].m_center, m_margin - inset, c_roundSegments);
		return btHybridHullOf(points);
	}
	if (getCore().isEmpty() || inset == m_margin)
		return getCore();
	return inset > m_margin ? movedIn(getCore(), inset - m_margin, epsilon)
	                        : withFlatMargin(getCore(), m_margin - inset);
}
