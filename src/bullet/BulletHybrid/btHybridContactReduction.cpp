#include "BulletHybrid/btHybridContactReduction.h"

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include "btHybridReducedContacts.h"

btHybridContactReduction::btHybridContactReduction(btConstraintSolver* solver)
    : m_own(solver ? 0 : new btSequentialImpulseConstraintSolver()),
      m_solver(solver ? solver : m_own),
      m_reduced(new btHybridReducedContacts())
{
}

btHybridContactReduction::~btHybridContactReduction()
{
	delete m_reduced;
	delete m_own;
}

void btHybridContactReduction::prepareSolve(int numBodies, int numManifolds)
{
	m_solver->prepareSolve(numBodies, numManifolds);
}

btScalar btHybridContactReduction::solveGroup(btCollisionObject** bodies, int numBodies,
                                              btPersistentManifold** manifolds, int numManifolds,
                                              btTypedConstraint** constraints, int numConstraints,
                                              const btContactSolverInfo& info, btIDebugDraw* debugDrawer,
                                              btDispatcher* dispatcher)
{
	m_reduced->find(manifolds, numManifolds, m_info);
	m_reduced->hide();
	const btScalar result = m_solver->solveGroup(bodies, numBodies, manifolds, numManifolds, constraints,
	                                             numConstraints, info, debugDrawer, dispatcher);
	m_reduced->show();
	return result;
}

void btHybridContactReduction::allSolved(const btContactSolverInfo& info, btIDebugDraw* debugDrawer)
{
	m_solver->allSolved(info, debugDrawer);
}

void btHybridContactReduction::reset()
{
	m_solver->reset();
}

btConstraintSolverType btHybridContactReduction::getSolverType() const
{
	return m_solver->getSolverType();
}

btHybridContactReductionCount btHybridContactReduction::getCount() const
{
	return m_reduced->getCount();
}
