#pragma once

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletHybrid/btHybridContactSolver.h>

#include <algorithm>

#include "bullet/physics/stage_timer.h"

namespace scatter {

/// A solver of Bullet's kind, bit for bit, which tells the time spent on joints from that on contacts while
/// `timer` is running.
///
/// btSequentialImpulseConstraintSolver solves joint rows, then contact rows, in one function. This one calls
/// it once with only the joint rows in sight and once with only the others.
template <class Solver>
class BulletTimedJoints : public Solver {
 public:
  explicit BulletTimedJoints(BulletStageTimer& timer) : timer_(timer) {}

 protected:
  void convertJoints(btTypedConstraint** constraints, int count, const btContactSolverInfo& info) override {
    if (count == 0) {
      Solver::convertJoints(constraints, count, info);
      return;
    }
    const BulletStageTimer::Scope time(timer_, Stage::kNoncontactConstraints);
    Solver::convertJoints(constraints, count, info);
  }

  /// `solve(count)` solves the rows in sight, and the first `count` of the constraints.
  template <class Solve>
  btScalar solveApart(int constraintCount, const btContactSolverInfo& info, Solve solve) {
    const bool hasJoints = constraintCount > 0 || this->m_tmpSolverNonContactConstraintPool.size() > 0;
    // Random order is drawn for all rows at once, from the sizes of the pools.
    const bool randomOrder = (info.m_solverMode & SOLVER_RANDMIZE_ORDER) != 0;
    if (!hasJoints || randomOrder || !timer_.isRunning()) return solve(constraintCount);

    btScalar jointResidual = 0;
    {
      const BulletStageTimer::Scope time(timer_, Stage::kNoncontactConstraints);
      const Hidden contacts(this->m_tmpSolverContactConstraintPool);
      const Hidden friction(this->m_tmpSolverContactFrictionConstraintPool);
      const Hidden rolling(this->m_tmpSolverContactRollingFrictionConstraintPool);
      jointResidual = solve(constraintCount);
    }
    const Hidden joints(this->m_tmpSolverNonContactConstraintPool);
    return std::max(jointResidual, solve(0));
  }

 private:
  /// While it lives, the pool looks empty; its rows stay where they are.
  class Hidden {
   public:
    explicit Hidden(btConstraintArray& pool) : pool_(pool), size_(pool.size()) {
      pool_.resizeNoInitialize(0);
    }
    Hidden(const Hidden&) = delete;
    Hidden& operator=(const Hidden&) = delete;
    ~Hidden() { pool_.resizeNoInitialize(size_); }

   private:
    btConstraintArray& pool_;
    int size_;
  };

  BulletStageTimer& timer_;
};

/// Bullet's default solver.
class BulletTimedSolver final : public BulletTimedJoints<btSequentialImpulseConstraintSolver> {
 public:
  using BulletTimedJoints::BulletTimedJoints;

 protected:
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int bodyCount,
                                btPersistentManifold** manifolds, int manifoldCount,
                                btTypedConstraint** constraints, int constraintCount,
                                const btContactSolverInfo& info, btIDebugDraw* drawer) override;
};

/// The wide one.
class BulletTimedContactSolver final : public BulletTimedJoints<btHybridContactSolver> {
 public:
  using BulletTimedJoints::BulletTimedJoints;

 protected:
  btScalar solveBulletRows(int iteration, btTypedConstraint** constraints, int constraintCount,
                           const btContactSolverInfo& info) override;
};

}  // namespace scatter
