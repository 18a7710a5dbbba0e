#include "bullet/physics/timed_solver.h"

#include <algorithm>

#include "bullet/physics/stage_timer.h"

namespace scatter {

namespace {

/// While it lives, the pool looks empty; its rows stay where they are.
class Hidden {
 public:
  explicit Hidden(btConstraintArray& pool) : pool_(pool), size_(pool.size()) { pool_.resizeNoInitialize(0); }
  Hidden(const Hidden&) = delete;
  Hidden& operator=(const Hidden&) = delete;
  ~Hidden() { pool_.resizeNoInitialize(size_); }

 private:
  btConstraintArray& pool_;
  int size_;
};

}  // namespace

void BulletTimedSolver::convertJoints(btTypedConstraint** constraints, int count,
                                      const btContactSolverInfo& info) {
  if (count == 0) {
    btSequentialImpulseConstraintSolver::convertJoints(constraints, count, info);
    return;
  }
  const BulletStageTimer::Scope time(timer_, Stage::kNoncontactConstraints);
  btSequentialImpulseConstraintSolver::convertJoints(constraints, count, info);
}

btScalar BulletTimedSolver::solveSingleIteration(int iteration, btCollisionObject** bodies, int bodyCount,
                                                 btPersistentManifold** manifolds, int manifoldCount,
                                                 btTypedConstraint** constraints, int constraintCount,
                                                 const btContactSolverInfo& info, btIDebugDraw* drawer) {
  const auto solve = [&](int joints) {
    return btSequentialImpulseConstraintSolver::solveSingleIteration(
        iteration, bodies, bodyCount, manifolds, manifoldCount, constraints, joints, info, drawer);
  };
  const bool hasJoints = constraintCount > 0 || m_tmpSolverNonContactConstraintPool.size() > 0;
  // Random order is drawn for all rows at once, from the sizes of the pools.
  const bool randomOrder = (info.m_solverMode & SOLVER_RANDMIZE_ORDER) != 0;
  if (!hasJoints || randomOrder || !timer_.isRunning()) return solve(constraintCount);

  btScalar jointResidual = 0;
  {
    const BulletStageTimer::Scope time(timer_, Stage::kNoncontactConstraints);
    const Hidden contacts(m_tmpSolverContactConstraintPool);
    const Hidden friction(m_tmpSolverContactFrictionConstraintPool);
    const Hidden rolling(m_tmpSolverContactRollingFrictionConstraintPool);
    jointResidual = solve(constraintCount);
  }
  const Hidden joints(m_tmpSolverNonContactConstraintPool);
  return std::max(jointResidual, solve(0));
}

}  // namespace scatter
