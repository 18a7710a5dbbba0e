#ifndef BT_HYBRID_PAIR_REDUCTION_H
#define BT_HYBRID_PAIR_REDUCTION_H

#include <BulletHybrid/btHybridContactReduction.h>

#include <vector>

#include "btHybridContactPoints.h"
#include "solver/contact_problem.h"
#include "solver/contact_reduction.h"

/// Leaves contacts out of pairs of a problem: those that others stand for, which begin with their impulses too; what
/// was left out bears nothing. In memory of one thread.
class btHybridPairReduction
{
	btHybridContactReductionCount m_count;
	scatter::solver::ContactReduction m_reduction;
	std::vector<scatter::solver::ReducibleContact> m_reducible;
	std::vector<int> m_indices;  ///< of those, among the points

	int collect(const scatter::solver::ContactPair& pair, scatter::solver::ContactProblem& problem,
	            const btHybridContactPoints& points);
	void leaveOut(int index, int kept, scatter::solver::ContactProblem& problem,
	              const btHybridContactPoints& points) const;

public:
	/// Changes the count of a pair, and which of the problem's points are its; those of other pairs may be reduced at
	/// the same time. `mostAlike`: of each cluster, so many stay.
	void reduce(scatter::solver::ContactPair& pair, scatter::solver::ContactProblem& problem,
	            const btHybridContactPoints& points, int mostAlike);

	/// Adds what has been reduced, and forgets it.
	void takeCount(btHybridContactReductionCount& sum);
};

#endif  // BT_HYBRID_PAIR_REDUCTION_H
