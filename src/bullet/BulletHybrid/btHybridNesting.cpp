#include "btHybridNesting.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "btHybridConvexPart.h"
#include "levels/cover.h"

using scatter::levels::Cover;
using scatter::levels::HalfSpace;
using scatter::levels::Polytope;
using scatter::levels::Uncovered;

namespace
{
// Rounding of the clipping, as a share of the largest coordinate.
const double c_epsilon = 1e-10;

std::vector<btHybridConvexPart> partsOf(const btCollisionShape* shape)
{
	std::vector<btHybridConvexPart> parts;
	if (!shape->isCompound())
	{
		parts.push_back(btHybridConvexPart(static_cast<const btConvexShape*>(shape), btTransform::getIdentity()));
		return parts;
	}
	const btCompoundShape* compound = static_cast<const btCompoundShape*>(shape);
	for (int i = 0; i < compound->getNumChildShapes(); i++)
		parts.push_back(btHybridConvexPart(static_cast<const btConvexShape*>(compound->getChildShape(i)),
		                                   compound->getChildTransform(i)));
	return parts;
}

double largestCoordinate(const std::vector<btHybridConvexPart>& parts)
{
	double largest = 0;
	for (size_t i = 0; i < parts.size(); i++)
		for (int axis = 0; axis < 3; axis++)
			largest = btMax(largest, btMax(-parts[i].getBounds().min[axis], parts[i].getBounds().max[axis]));
	return largest;
}

/// A coarser level, asked part by part whether it holds a finer one. Every rule is sufficient: what it accepts is
/// nested. Rules that need more work come later.
class NestingCheck
{
	std::vector<btHybridConvexPart> m_coarser;
	double m_tolerance;
	double m_epsilon;
	std::vector<std::pair<double, std::vector<Cover>>> m_covers;  ///< by inset, for all parts that share it

public:
	NestingCheck(const btCollisionShape* coarser, double tolerance)
	    : m_coarser(partsOf(coarser)), m_tolerance(tolerance), m_epsilon(c_epsilon * largestCoordinate(m_coarser))
	{
	}

	std::optional<Uncovered> findGap(const btHybridConvexPart& part)
	{
		const std::optional<Uncovered> gap = findUnproven(part);
		if (!gap)
			return gap;
		// Polytopes around round parts reach further than these; of a single coarser part it is known exactly.
		const Uncovered miss = nearestMiss(part);
		return miss.distance < gap->distance ? miss : gap;
	}

private:
	std::optional<Uncovered> findUnproven(const btHybridConvexPart& part)
	{
		for (size_t i = 0; i < m_coarser.size(); i++)
			if (m_coarser[i].holds(part, m_tolerance))
				return std::nullopt;
		// One part alone is no union.
		if (m_coarser.size() == 1)
			return nearestMiss(part);
		// A core grown by a margin lies in a union if the core lies in what is left when each part is shrunk by it.
		const double radius = part.getRadius();
		const Polytope core = radius >= 0 ? part.getOuterCore() : Polytope();
		const bool hasCore = !core.isEmpty() && !getCovers(radius).empty();
		if (hasCore && scatter::levels::isCovered(core, getCovers(radius), m_tolerance, m_epsilon))
			return std::nullopt;
		if (hasCore && (radius <= 0 || meetsHullsOnly(part)))
			return scatter::levels::findUncovered(core, getCovers(radius), m_tolerance, m_epsilon);
		// It also does if a polytope around both does, which holds for boxes that touch each other, too.
		const Polytope outer = part.getOuter(tangentsOf(part), m_epsilon);
		if (outer.isEmpty() || getCovers(0).empty())
			return nearestMiss(part);
		return scatter::levels::findUncovered(outer, getCovers(0), m_tolerance, m_epsilon);
	}

	const std::vector<Cover>& getCovers(double inset)
	{
		for (size_t i = 0; i < m_covers.size(); i++)
			if (m_covers[i].first == inset)
				return m_covers[i].second;
		std::vector<Cover> covers;
		for (size_t i = 0; i < m_coarser.size(); i++)
		{
			Polytope inner = m_coarser[i].getInner(inset, m_epsilon);
			if (!inner.isEmpty())
				covers.push_back(Cover(std::move(inner)));
		}
		m_covers.push_back(std::make_pair(inset, std::move(covers)));
		return m_covers.back().second;
	}

	/// Between hulls of one margin these cancel, and the first rule says all that there is to say.
	bool meetsHullsOnly(const btHybridConvexPart& part) const
	{
		for (size_t i = 0; i < m_coarser.size(); i++)
		{
			const bool cancels = m_coarser[i].isHull() && m_coarser[i].getRadius() == part.getRadius();
			if (!cancels && m_coarser[i].getBounds().overlaps(part.getBounds(), m_tolerance))
				return false;
		}
		return true;
	}

	/// Directions in which a polytope around the part must touch it to be judged exactly.
	std::vector<btHybridPoint> tangentsOf(const btHybridConvexPart& part)
	{
		std::vector<btHybridPoint> normals;
		const Polytope core = part.getOuterCore();
		for (size_t i = 0; i < core.faces().size(); i++)
			normals.push_back(core.faces()[i].plane.normal);
		const std::vector<Cover>& covers = getCovers(0);
		for (size_t i = 0; i < covers.size(); i++)
			for (size_t k = 0;
			     covers[i].bounds().overlaps(part.getBounds(), m_tolerance) && k < covers[i].planes().size(); k++)
				normals.push_back(covers[i].planes()[k].normal);
		return normals;
	}

	/// What a part sticks out of the coarser part that is nearest to holding it.
	Uncovered nearestMiss(const btHybridConvexPart& part) const
	{
		Uncovered miss;
		miss.point = part.getBalls()[0].m_center;
		miss.distance = glm::length(part.getBounds().max - part.getBounds().min);
		for (size_t i = 0; i < m_coarser.size(); i++)
		{
			btHybridPoint furthest(0.0);
			const double protrusion =
			    m_coarser[i].isSolid() ? m_coarser[i].getProtrusion(part, furthest) : miss.distance;
			if (protrusion >= miss.distance)
				continue;
			miss.distance = protrusion;
			miss.point = furthest;
		}
		return miss;
	}
};
}  // namespace

btHybridProtrusion btHybridFindProtrusion(const btCollisionShape* finer, const btCollisionShape* coarser,
                                          double tolerance)
{
	btHybridProtrusion worst;
	NestingCheck check(coarser, tolerance);
	const std::vector<btHybridConvexPart> parts = partsOf(finer);
	for (size_t i = 0; i < parts.size(); i++)
	{
		const std::optional<Uncovered> gap = check.findGap(parts[i]);
		if (!gap || (worst.m_child >= 0 && gap->distance <= double(worst.m_distance)))
			continue;
		worst.m_child = int(i);
		worst.m_distance = btScalar(gap->distance);
		worst.m_point.setValue(btScalar(gap->point.x), btScalar(gap->point.y), btScalar(gap->point.z));
	}
	return worst;
}
