#include "BulletHybrid/btHybridContactSolver.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "btHybridContactGroups.h"
#include "btHybridManifolds.h"
#include "btHybridSettings.h"

namespace
{
bool isAnisotropic(const btCollisionObject& object)
{
	return object.hasAnisotropicFriction(btCollisionObject::CF_ANISOTROPIC_FRICTION |
	                                     btCollisionObject::CF_ANISOTROPIC_ROLLING_FRICTION);
}

// Contacts in an order that the program wants otherwise than ours.
bool ordersRows(const btContactSolverInfo& info)
{
	return (info.m_solverMode & (SOLVER_RANDMIZE_ORDER | SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS)) != 0;
}

// Manifolds ahead whose memory is fetched, as a pile's do not fit into a cache: time for one to come.
const int c_manifoldsAhead = 6;

bool moves(const btSolverBody& body)
{
	return body.m_originalBody && body.m_originalBody->getInvMass() != 0;
}
}  // namespace

btHybridContactSolver::btHybridContactSolver()
    : m_groups(new btHybridContactGroups()), m_clampsFriction(true), m_reduces(false)
{
}

btHybridContactSolver::~btHybridContactSolver()
{
	delete m_groups;
}

// Before the contacts are.
void btHybridContactSolver::convertJoints(btTypedConstraint** constraints, int numConstraints,
                                          const btContactSolverInfo& info)
{
	m_groups->clear();
	btSequentialImpulseConstraintSolver::convertJoints(constraints, numConstraints, info);
	for (int i = 0; i < numConstraints; ++i)
	{
		setJoined(constraints[i]->getRigidBodyA().getCompanionId());
		setJoined(constraints[i]->getRigidBodyB().getCompanionId());
	}
}

void btHybridContactSolver::setJoined(int body)
{
	if (body >= 0 && body < m_tmpSolverBodyPool.size() && moves(m_tmpSolverBodyPool[body]))
		m_groups->setJoined(body);
}

void btHybridContactSolver::convertContacts(btPersistentManifold** manifolds, int numManifolds,
                                            const btContactSolverInfo& info)
{
	const bool leavesAll = ordersRows(info);
	for (int i = 0; i < numManifolds; ++i)
	{
		if (i + c_manifoldsAhead < numManifolds)
			btHybridContacts::prefetch(manifolds[i + c_manifoldsAhead]);
		convertManifold(manifolds[i], leavesAll, info);
	}
	m_groups->group(m_tmpSolverBodyPool);
	m_groups->beginJoined(m_tmpSolverBodyPool, info, {m_clampsFriction, m_reduces ? &m_reduction : 0});
	// What Bullet's own rows begin with is in its bodies.
	if (!m_groups->joined().empty() && m_groups->m_bulletManifolds > 0)
		m_groups->joined().addVelocities(m_tmpSolverBodyPool);
}

void btHybridContactSolver::convertManifold(btPersistentManifold* manifold, bool leavesAll,
                                            const btContactSolverInfo& info)
{
	btCollisionObject& object0 = *const_cast<btCollisionObject*>(manifold->getBody0());
	btCollisionObject& object1 = *const_cast<btCollisionObject*>(manifold->getBody1());
	const int id0 = getOrInitSolverBody(object0, info.m_timeStep);
	const int id1 = getOrInitSolverBody(object1, info.m_timeStep);
	const btSolverBody& body0 = m_tmpSolverBodyPool[id0];
	const btSolverBody& body1 = m_tmpSolverBodyPool[id1];
	// As in Bullet, bodies that cannot be moved do not respond to each other.
	if (body0.m_invMass.fuzzyZero() && body1.m_invMass.fuzzyZero())
		return;
	const bool isOurs = !leavesAll && !isAnisotropic(object0) && !isAnisotropic(object1);
	if (isOurs && m_groups->add(manifold, {id0, moves(body0)}, {id1, moves(body1)}, info))
		return;
	setJoined(id0);
	setJoined(id1);
	convertContact(manifold, info);
	++m_groups->m_bulletManifolds;
}

bool btHybridContactSolver::hasBulletRows() const
{
	return m_tmpSolverNonContactConstraintPool.size() > 0 || m_groups->m_bulletManifolds > 0;
}

btScalar btHybridContactSolver::solveBulletPushes()
{
	btScalar most = 0;
	for (int i = 0; i < m_tmpSolverContactConstraintPool.size(); ++i)
	{
		const btSolverConstraint& row = m_tmpSolverContactConstraintPool[m_orderTmpConstraintPool[i]];
		const btScalar residual = resolveSplitPenetrationImpulse(m_tmpSolverBodyPool[row.m_solverBodyIdA],
		                                                         m_tmpSolverBodyPool[row.m_solverBodyIdB], row);
		most = btMax(most, residual * residual);
	}
	return most;
}

void btHybridContactSolver::solveGroupCacheFriendlySplitImpulseIterations(btCollisionObject**, int,
                                                                          btPersistentManifold**, int,
                                                                          btTypedConstraint**, int,
                                                                          const btContactSolverInfo& info,
                                                                          btIDebugDraw*)
{
	if (!info.m_splitImpulse)
		return;
	btHybridContactProblem& joined = m_groups->joined();
	for (int i = 0; i < info.m_numIterations; ++i)
	{
		btScalar residual = 0;
		if (m_groups->m_bulletManifolds > 0)
		{
			if (!joined.empty())
				joined.givePushes(m_tmpSolverBodyPool);
			residual = solveBulletPushes();
			if (!joined.empty())
				joined.takePushes(m_tmpSolverBodyPool);
		}
		if (!joined.empty() && joined.solver().pushes())
			residual = btMax(residual, btScalar(joined.solver().solvePushes()));
		if (residual <= info.m_leastSquaresResidualThreshold)
			break;
	}
}

btScalar btHybridContactSolver::solveBulletRows(int iteration, btTypedConstraint** constraints, int numConstraints,
                                                const btContactSolverInfo& info)
{
	return btSequentialImpulseConstraintSolver::solveSingleIteration(iteration, 0, 0, 0, 0, constraints, numConstraints,
	                                                                 info, 0);
}

btScalar btHybridContactSolver::solveSingleIteration(int iteration, btCollisionObject**, int, btPersistentManifold**,
                                                     int, btTypedConstraint** constraints, int numConstraints,
                                                     const btContactSolverInfo& info, btIDebugDraw*)
{
	btHybridContactProblem& joined = m_groups->joined();
	if (!joined.empty())
		joined.giveVelocities(m_tmpSolverBodyPool);
	btScalar residual = solveBulletRows(iteration, constraints, numConstraints, info);
	if (joined.empty())
		return residual;
	joined.takeVelocities(m_tmpSolverBodyPool);
	if (iteration < info.m_numIterations)
		residual = btMax(residual, btScalar(joined.solver().solveVelocities()));
	return residual;
}

btScalar btHybridContactSolver::solveGroupCacheFriendlyIterations(btCollisionObject** bodies, int numBodies,
                                                                  btPersistentManifold** manifolds, int numManifolds,
                                                                  btTypedConstraint** constraints, int numConstraints,
                                                                  const btContactSolverInfo& info, btIDebugDraw* drawer)
{
	m_groups->solve(m_tmpSolverBodyPool, info, {m_clampsFriction, m_reduces ? &m_reduction : 0});
	if (numConstraints == 0 && !hasBulletRows())
		return 0;
	return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyIterations(
	    bodies, numBodies, manifolds, numManifolds, constraints, numConstraints, info, drawer);
}

btScalar btHybridContactSolver::solveGroupCacheFriendlyFinish(btCollisionObject** bodies, int numBodies,
                                                              const btContactSolverInfo& info)
{
	if (!m_groups->joined().empty())
		m_groups->finishJoined(m_tmpSolverBodyPool, info);
	return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyFinish(bodies, numBodies, info);
}

btHybridContactSolverInfo btHybridContactSolver::getContactSolverInfo() const
{
	btHybridContactSolverInfo info;
	m_groups->addTo(info);
	return info;
}

void btHybridContactSolver::setContactReduction(const btHybridContactReductionInfo& info)
{
	m_reduces = true;
	m_reduction = info;
}

const char* btHybridContactSolver::setNumThreads(int threads)
{
	const char* mistake = btHybridCheckThreads(threads);
	if (!mistake)
		m_groups->m_threads->setNumThreads(threads);
	return mistake;
}

int btHybridContactSolver::getNumThreads() const
{
	return m_groups->m_threads->getNumThreads();
}

void btHybridContactSolver::setTaskScheduler(btITaskScheduler* scheduler)
{
	m_groups->m_threads->setScheduler(scheduler);
}
