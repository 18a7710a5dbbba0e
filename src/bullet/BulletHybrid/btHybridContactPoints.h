#ifndef BT_HYBRID_CONTACT_POINTS_H
#define BT_HYBRID_CONTACT_POINTS_H

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>

#include <span>
#include <vector>

#include "solver/contact_problem.h"

/// Bullet's contact points as a scatter::solver::ContactSolver has them, and where they come from.
class btHybridContactPoints
{
public:
	struct Source
	{
		btManifoldPoint* m_point;
		bool m_isSwapped;  ///< body 0 of the manifold is the contact's b
		bool m_isReducible;
	};

	/// The contacts of a manifold, side by side.
	struct Range
	{
		int m_first;
		int m_count;
	};

	void clear();

	/// Takes the near contacts of a manifold. False, and nothing taken, if one of them needs rows of Bullet's.
	bool add(btPersistentManifold* manifold, bool swaps, const btContactSolverInfo& info, Range& range);

	std::span<scatter::solver::ProblemPoint> points()
	{
		return m_points;
	}
	const std::vector<Source>& sources() const
	{
		return m_sources;
	}

private:
	std::vector<scatter::solver::ProblemPoint> m_points;
	std::vector<Source> m_sources;  ///< of the points
};

#endif  // BT_HYBRID_CONTACT_POINTS_H
