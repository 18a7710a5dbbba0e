#ifndef BT_HYBRID_CONTACT_PROBLEM_H
#define BT_HYBRID_CONTACT_PROBLEM_H

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/ConstraintSolver/btSolverBody.h>
#include <BulletHybrid/btHybridContactReduction.h>
#include <LinearMath/btAlignedObjectArray.h>

#include <array>
#include <span>
#include <vector>

#include "btHybridContactPoints.h"
#include "btHybridPairReduction.h"
#include "solver/contact_problem.h"
#include "solver/contact_solver.h"

/// Contacts of Bullet's manifolds, with the solver bodies that they are between, as a scatter::solver::ContactSolver
/// solves them, and back. Problems whose moving bodies are others may be at work on several threads at once.
class btHybridContactProblem
{
public:
	btHybridContactProblem() : m_points(0)
	{
	}

	void clear();

	/// A body of a manifold.
	struct Side
	{
		int m_id;  ///< among the solver's bodies
		bool m_moves;
	};

	/// Takes contacts of two bodies, of which a moves. `places`: of each solver body, room for its number here.
	void add(const btHybridContactPoints::Range& range, Side a, Side b, std::vector<int>& places);

	/// After all contacts, of these points: takes the bodies, and begins to solve. `reduction`: what is left out; 0:
	/// nothing. `share`: threads that help; they make no difference to the bits.
	void begin(btHybridContactPoints& points, const btAlignedObjectArray<btSolverBody>& bodies,
	           const btContactSolverInfo& info, bool clampsFriction, const btHybridContactReductionInfo* reduction,
	           const scatter::solver::Share& share);

	/// All iterations, where nothing but these contacts moves the bodies.
	void solve(const btContactSolverInfo& info);

	/// Gives the bodies all that they have been moved by, and writes impulses and friction directions into the
	/// manifolds' points.
	void finish(btAlignedObjectArray<btSolverBody>& bodies, const btContactSolverInfo& info,
	            const scatter::solver::Share& share);

	/// What has been added to the velocities of the solver bodies; give() to them, take() from them, with what others
	/// have added.
	void giveVelocities(btAlignedObjectArray<btSolverBody>& bodies);
	void takeVelocities(const btAlignedObjectArray<btSolverBody>& bodies);
	void givePushes(btAlignedObjectArray<btSolverBody>& bodies);
	void takePushes(const btAlignedObjectArray<btSolverBody>& bodies);

	/// The same, after begin(), of what others begin with.
	void addVelocities(const btAlignedObjectArray<btSolverBody>& bodies);

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

	btHybridContactReductionCount m_reduced;

private:
	/// Of a pair that was found: what tells it from others with the same a, of which one comes next.
	struct Known
	{
		int m_b;
		int m_next;
	};

	/// Where the contacts of a manifold are.
	struct Taken
	{
		int m_pair;
		int m_first;
		int m_count;
	};

	void give(std::span<const scatter::solver::BodyVelocity> velocities, btAlignedObjectArray<btSolverBody>& bodies,
	          btVector3 btSolverBody::*linear, btVector3 btSolverBody::*angular) const;
	void take(std::span<scatter::solver::BodyVelocity> velocities, const btAlignedObjectArray<btSolverBody>& bodies,
	          btVector3 btSolverBody::*linear, btVector3 btSolverBody::*angular) const;
	int placeOf(Side side, std::vector<int>& places);
	int pairOf(int a, int b);
	void takeBody(const btSolverBody& body);
	void order();
	void reduce(const btHybridContactReductionInfo& reduction, const scatter::solver::Share& share);
	void fetchPoints(size_t batch) const;
	void giveImpulse(int index, const scatter::solver::ContactSolver::Impulse& impulse,
	                 const btContactSolverInfo& info) const;

	std::vector<int> m_bodies;  ///< the solver body of each of the problem's
	std::vector<int> m_moving;  ///< of those, the problem's that move
	std::vector<int> m_fixed;   ///< and those that do not
	btHybridContactPoints* m_points;
	scatter::solver::ContactProblem m_problem;
	scatter::solver::ContactSolver m_solver;
	std::array<btHybridPairReduction, 8> m_reductions;  ///< each of every eighth pair, for up to so many threads
	std::vector<Taken> m_taken;
	std::vector<int> m_lastPair;  ///< of a body that is a pair's a, the pair that was found last
	std::vector<Known> m_known;   ///< of the pairs
};

#endif  // BT_HYBRID_CONTACT_PROBLEM_H
