#ifndef BT_HYBRID_CONTACT_PROBLEM_H
#define BT_HYBRID_CONTACT_PROBLEM_H

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/ConstraintSolver/btSolverBody.h>
#include <BulletHybrid/btHybridContactReduction.h>

#include <vector>

#include "solver/contact_problem.h"
#include "solver/contact_reduction.h"
#include "solver/contact_solver.h"

/// Bullet's manifolds and solver bodies as the contacts that a scatter::solver::ContactSolver solves, and back.
class btHybridContactProblem
{
public:
	void clear();

	/// A body of a manifold.
	struct Side
	{
		int m_id;  ///< among the solver's bodies
		bool m_moves;
	};

	/// Takes the contacts of a manifold, one of whose bodies moves. False, and nothing taken, if some contact needs
	/// rows of Bullet's.
	bool add(btPersistentManifold* manifold, Side side0, Side side1, const btContactSolverInfo& info);

	/// After all manifolds: takes the bodies, and begins to solve. `reduction`: what is left out; 0: nothing.
	void begin(const btAlignedObjectArray<btSolverBody>& bodies, const btContactSolverInfo& info,
	           bool clampsFriction, const btHybridContactReductionInfo* reduction);

	/// Writes impulses and friction directions into the manifolds' points.
	void finish(const btContactSolverInfo& info);

	bool empty() const
	{
		return m_problem.pairs.empty();
	}
	const scatter::solver::ContactProblem& problem() const
	{
		return m_problem;
	}
	scatter::solver::ContactSolver& solver()
	{
		return m_solver;
	}
	const scatter::solver::ContactSolver& solver() const
	{
		return m_solver;
	}

	int m_bulletManifolds;
	btHybridContactReductionCount m_reduced;

private:
	/// Where a point comes from.
	struct Source
	{
		btManifoldPoint* m_point;
		bool m_isSwapped;  ///< body 0 of the manifold is the contact's b
		bool m_isReducible;
	};

	/// Where the contacts of a manifold are.
	struct Taken
	{
		int m_pair;
		int m_first;
		int m_count;
	};

	int pairOf(int a, int b);
	bool takePoints(btPersistentManifold* manifold, bool swaps, const btContactSolverInfo& info);
	void takeBody(const btSolverBody& body);
	void order();
	void reduce(scatter::solver::ContactPair& pair, int mostAlike);
	void leaveOut(int index, int kept);

	scatter::solver::ContactProblem m_problem;
	scatter::solver::ContactSolver m_solver;
	scatter::solver::ContactReduction m_reduction;
	std::vector<scatter::solver::ReducibleContact> m_reducible;
	std::vector<int> m_reducibleIndex;  ///< of the problem's points
	std::vector<Source> m_sources;      ///< of the problem's points
	std::vector<Taken> m_taken;
	std::vector<int> m_lastPair;  ///< of a body that is a pair's a, the pair that was found last
	std::vector<int> m_nextPair;  ///< of a pair, another one with the same a
};

#endif  // BT_HYBRID_CONTACT_PROBLEM_H
