#include "BulletHybrid/btHybridLevelSet.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <cstdio>
#include <cstring>

#include "btHybridConversions.h"
#include "btHybridConvexPart.h"
#include "btHybridFinite.h"
#include "btHybridNesting.h"
#include "btHybridShapeRadius.h"
#include "collision/ball_bounds.h"
#include "collision/simd.h"

namespace
{
// Pairs count their levels and child pairs their parts in few bits.
const int c_mostLevels = 250;
const int c_mostChildren = 65535;

// Balls whose hull a level's bounds are found from in every step. As many take 40 ns, of the half microsecond that
// Bullet's broadphase takes for a body in a pile (`scatter run` of implosion-12 in `lean`, update_aabbs_ms).
const int c_mostBalls = 64;

// How far, as a share of the coarser level's largest side, a level may stick out and still count as nested.
const double c_nestingTolerance = 1e-4;

const char* findMistakeInHull(const btConvexHullShape* hull)
{
	if (hull->getNumPoints() == 0)
		return "is a hull without points; add them first";
	if (hull->getNumPoints() > c_mostChildren)
		return "is a hull of more than 65535 points; leave out those inside it";
	for (int i = 0; i < hull->getNumPoints(); i++)
		if (!btHybridIsFinite(hull->getScaledPoint(i)))
			return "is a hull with a point that is not finite";
	return 0;
}

const char* findMistakeInPart(const btCollisionShape* shape)
{
	if (shape->isCompound())
		return "is a compound within a compound; add its children to the outer one";
	if (!shape->isConvex())
		return "is not convex; a level is a convex shape or a compound of convex shapes";
	if (!std::isfinite(shape->getMargin()) || shape->getMargin() < 0)
		return "has a collision margin that is negative or not finite";
	if (shape->getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE)
		if (const char* mistake = findMistakeInHull(static_cast<const btConvexHullShape*>(shape)))
			return mistake;
	btVector3 aabbMin, aabbMax;
	shape->getAabb(btTransform::getIdentity(), aabbMin, aabbMax);
	return btHybridIsFinite(aabbMin) && btHybridIsFinite(aabbMax) ? 0 : "has bounds that are not finite";
}

// child: the one that is at fault; -1 if the whole is.
const char* findMistake(const btCollisionShape* shape, int& child)
{
	child = -1;
	if (!shape->isCompound())
		return findMistakeInPart(shape);
	const btCompoundShape* compound = static_cast<const btCompoundShape*>(shape);
	if (compound->getNumChildShapes() == 0)
		return "is a compound without children; add them first";
	if (compound->getNumChildShapes() > c_mostChildren)
		return "has more than 65535 children; merge some";
	for (child = 0; child < compound->getNumChildShapes(); child++)
	{
		if (!btHybridIsFinite(compound->getChildTransform(child)))
			return "has a place that is not finite";
		if (const char* mistake = findMistakeInPart(compound->getChildShape(child)))
			return mistake;
	}
	child = -1;
	return 0;
}

// Of which a level is the hull; none if they are too many, as those of round shapes are, or if Bullet's bounds are as
// close.
std::vector<btHybridBall> ballsOf(const btCollisionShape* shape)
{
	if (shape->getShapeType() == BOX_SHAPE_PROXYTYPE)
		return std::vector<btHybridBall>();
	const btCompoundShape* compound = shape->isCompound() ? static_cast<const btCompoundShape*>(shape) : 0;
	const int parts = compound ? compound->getNumChildShapes() : 1;
	std::vector<btHybridBall> balls;
	for (int i = 0; i < parts; i++)
	{
		const btCollisionShape* part = compound ? compound->getChildShape(i) : shape;
		const btTransform place = compound ? compound->getChildTransform(i) : btTransform::getIdentity();
		const std::vector<btHybridBall> own =
		    btHybridConvexPart(static_cast<const btConvexShape*>(part), place).getBalls();
		if (int(balls.size() + own.size()) > c_mostBalls)
			return std::vector<btHybridBall>();
		balls.insert(balls.end(), own.begin(), own.end());
	}
	return balls;
}

double largestSide(const btCollisionShape* shape)
{
	btVector3 aabbMin, aabbMax;
	shape->getAabb(btTransform::getIdentity(), aabbMin, aabbMax);
	const btVector3 sides = aabbMax - aabbMin;
	return double(sides[sides.maxAxis()]);
}
}  // namespace

const char* btHybridLevelSet::refuse(const char* mistake)
{
	m_mistake.resize(int(std::strlen(mistake)) + 1);
	std::strcpy(&m_mistake[0], mistake);
	return &m_mistake[0];
}

const char* btHybridLevelSet::addLevel(btCollisionShape* shape, btHybridNesting nesting)
{
	char text[400];
	const int level = m_levels.size() + 1;
	if (!shape)
		return refuse("a level needs a shape; 0 was given");
	if (level > c_mostLevels)
		return refuse("a level set has at most 250 levels; a few are enough");
	int child;
	if (const char* mistake = findMistake(shape, child))
	{
		char place[40] = "";
		if (child >= 0)
			std::snprintf(place, sizeof(place), ", child %d,", child);
		std::snprintf(text, sizeof(text), "level %d%s %s", level, place, mistake);
		return refuse(text);
	}
	if (level > 1 && nesting == BT_HYBRID_PROVE_NESTING)
	{
		const btCollisionShape* before = m_levels[level - 2];
		const btHybridProtrusion worst =
		    btHybridFindProtrusion(shape, before, c_nestingTolerance * largestSide(before));
		if (worst.m_child >= 0)
		{
			std::snprintf(
			    text, sizeof(text),
			    "level %d, child %d, sticks out of level %d by %.3g m at (%.4g, %.4g, %.4g), collision margins "
			    "included: those of hulls and cones lie outside them; enlarge level %d there, or make the child or "
			    "its margin smaller",
			    level, worst.m_child, level - 1, double(worst.m_distance), double(worst.m_point.x()),
			    double(worst.m_point.y()), double(worst.m_point.z()), level - 1);
			return refuse(text);
		}
	}
	m_levels.push_back(shape);
	if (level == 1)
	{
		findBalls();
		m_coarsestRadius = btHybridRadiusOf(shape);
	}
	return 0;
}

void btHybridLevelSet::findBalls()
{
	const std::vector<btHybridBall> balls = ballsOf(m_levels[0]);
	const int padded = scatter::simd::padded(int(balls.size()));
	m_balls.resize(4 * padded);
	for (int i = 0; i < padded; i++)
	{
		const btHybridBall& ball = balls[btMin(i, int(balls.size()) - 1)];
		for (int axis = 0; axis < 3; axis++)
			m_balls[axis * padded + i] = float(ball.m_center[axis]);
		m_balls[3 * padded + i] = float(ball.m_radius);
	}
}

void btHybridLevelSet::getCoarsestAabb(const btTransform& transform, btVector3& aabbMin, btVector3& aabbMax) const
{
	aabbMin = aabbMax = transform.getOrigin();
	if (m_levels.size() == 0)
		return;
	if (m_balls.size() == 0)
		return m_levels[0]->getAabb(transform, aabbMin, aabbMax);
	const int padded = m_balls.size() / 4;
	const float* x = &m_balls[0];
	const float* y = x + padded;
	const float* z = y + padded;
	scatter::Vec3 low, high;
	scatter::boundBalls({x, y, z, padded}, z + padded, btHybridFrameOf(transform), low, high);
	aabbMin.setValue(low.x, low.y, low.z);
	aabbMax.setValue(high.x, high.y, high.z);
}
