#pragma once

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

namespace scatter {

class BulletStageTimer;

/// Bullet's default solver, bit for bit, which tells the time spent on joints from that on contacts while
/// `timer` is running.
///
/// The base class solves joint rows, then contact rows, in one function. This one calls it once with only
/// the joint rows in sight and once with only the others.
class BulletTimedSolver final : public btSequentialImpulseConstraintSolver {
 public:
  explicit BulletTimedSolver(BulletStageTimer& timer) : timer_(timer) {}

 protected:
  void convertJoints(btTypedConstraint** constraints, int count, const btContactSolverInfo& info) override;
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int bodyCount,
                                btPersistentManifold** manifolds, int manifoldCount,
                                btTypedConstraint** constraints, int constraintCount,
                                const btContactSolverInfo& info, btIDebugDraw* drawer) override;

 private:
  BulletStageTimer& timer_;
};

}  // namespace scatter
