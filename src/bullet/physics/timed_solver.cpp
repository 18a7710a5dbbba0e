#include "bullet/physics/timed_solver.h"

namespace scatter {

btScalar BulletTimedSolver::solveSingleIteration(int iteration, btCollisionObject** bodies, int bodyCount,
                                                 btPersistentManifold** manifolds, int manifoldCount,
                                                 btTypedConstraint** constraints, int constraintCount,
                                                 const btContactSolverInfo& info, btIDebugDraw* drawer) {
  return solveApart(constraintCount, info, [&](int count) {
    return btSequentialImpulseConstraintSolver::solveSingleIteration(
        iteration, bodies, bodyCount, manifolds, manifoldCount, constraints, count, info, drawer);
  });
}

btScalar BulletTimedContactSolver::solveBulletRows(int iteration, btTypedConstraint** constraints,
                                                   int constraintCount, const btContactSolverInfo& info) {
  return solveApart(constraintCount, info, [&](int count) {
    return btHybridContactSolver::solveBulletRows(iteration, constraints, count, info);
  });
}

}  // namespace scatter
