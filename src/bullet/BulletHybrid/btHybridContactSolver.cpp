#include "BulletHybrid/btHybridContactSolver.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "btHybridContactProblem.h"
#include "btHybridManifolds.h"
#include "btHybridQuad.h"

using scatter::solver::BodyVelocity;
using scatter::solver::PairBatch;

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
    : m_problem(new btHybridContactProblem()), m_clampsFriction(true), m_reduces(false)
{
	m_problem->clear();
}

btHybridContactSolver::~btHybridContactSolver()
{
	delete m_problem;
}

void btHybridContactSolver::convertContacts(btPersistentManifold** manifolds, int numManifolds,
                                            const btContactSolverInfo& info)
{
	m_problem->clear();
	const bool leavesAll = ordersRows(info);
	for (int i = 0; i < numManifolds; ++i)
	{
		if (i + c_manifoldsAhead < numManifolds)
			btHybridContacts::prefetch(manifolds[i + c_manifoldsAhead]);
		btPersistentManifold* manifold = manifolds[i];
		btCollisionObject& object0 = *const_cast<btCollisionObject*>(manifold->getBody0());
		btCollisionObject& object1 = *const_cast<btCollisionObject*>(manifold->getBody1());
		const int id0 = getOrInitSolverBody(object0, info.m_timeStep);
		const int id1 = getOrInitSolverBody(object1, info.m_timeStep);
		const btSolverBody& body0 = m_tmpSolverBodyPool[id0];
		const btSolverBody& body1 = m_tmpSolverBodyPool[id1];
		// As in Bullet, bodies that cannot be moved do not respond to each other.
		if (body0.m_invMass.fuzzyZero() && body1.m_invMass.fuzzyZero())
			continue;
		const bool isOurs = !leavesAll && !isAnisotropic(object0) && !isAnisotropic(object1);
		if (isOurs && m_problem->add(manifold, {id0, moves(body0)}, {id1, moves(body1)}, info))
			continue;
		convertContact(manifold, info);
		++m_problem->m_bulletManifolds;
	}
	if (m_problem->empty())
		return;
	m_problem->begin(m_tmpSolverBodyPool, info, m_clampsFriction, m_reduces ? &m_reduction : 0);
	addWarmStart();
}

// What Bullet's own rows begin with is in its bodies.
void btHybridContactSolver::addWarmStart()
{
	for (int i = 0; m_problem->m_bulletManifolds > 0 && i < m_tmpSolverBodyPool.size(); ++i)
	{
		BodyVelocity& velocity = m_problem->solver().velocities()[i];
		velocity.linear =
		    btHybridQuad(btHybridVectorOf(velocity.linear) + m_tmpSolverBodyPool[i].m_deltaLinearVelocity);
		velocity.angular =
		    btHybridQuad(btHybridVectorOf(velocity.angular) + m_tmpSolverBodyPool[i].m_deltaAngularVelocity);
	}
}

bool btHybridContactSolver::hasBulletRows() const
{
	return m_tmpSolverNonContactConstraintPool.size() > 0 || m_problem->m_bulletManifolds > 0;
}

// Joints without rows may add bodies to Bullet's later on. Without contacts of ours there are none.
int btHybridContactSolver::countBodies() const
{
	return int(m_problem->problem().bodies.size());
}

void btHybridContactSolver::giveVelocities()
{
	for (int i = 0; i < countBodies(); ++i)
	{
		const BodyVelocity& velocity = m_problem->solver().velocities()[i];
		m_tmpSolverBodyPool[i].m_deltaLinearVelocity = btHybridVectorOf(velocity.linear);
		m_tmpSolverBodyPool[i].m_deltaAngularVelocity = btHybridVectorOf(velocity.angular);
	}
}

void btHybridContactSolver::takeVelocities()
{
	for (int i = 0; i < countBodies(); ++i)
	{
		BodyVelocity& velocity = m_problem->solver().velocities()[i];
		velocity.linear = btHybridQuad(m_tmpSolverBodyPool[i].m_deltaLinearVelocity);
		velocity.angular = btHybridQuad(m_tmpSolverBodyPool[i].m_deltaAngularVelocity);
	}
}

void btHybridContactSolver::givePushes()
{
	for (int i = 0; i < countBodies(); ++i)
	{
		const BodyVelocity& push = m_problem->solver().pushVelocities()[i];
		m_tmpSolverBodyPool[i].m_pushVelocity = btHybridVectorOf(push.linear);
		m_tmpSolverBodyPool[i].m_turnVelocity = btHybridVectorOf(push.angular);
	}
}

void btHybridContactSolver::takePushes()
{
	for (int i = 0; i < countBodies(); ++i)
	{
		BodyVelocity& push = m_problem->solver().pushVelocities()[i];
		push.linear = btHybridQuad(m_tmpSolverBodyPool[i].m_pushVelocity);
		push.angular = btHybridQuad(m_tmpSolverBodyPool[i].m_turnVelocity);
	}
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
	for (int i = 0; i < info.m_numIterations; ++i)
	{
		btScalar residual = 0;
		if (m_problem->m_bulletManifolds > 0)
		{
			givePushes();
			residual = solveBulletPushes();
			takePushes();
		}
		if (!m_problem->empty() && m_problem->solver().pushes())
			residual = btMax(residual, btScalar(m_problem->solver().solvePushes()));
		if (residual <= info.m_leastSquaresResidualThreshold)
			break;
	}
}

btScalar btHybridContactSolver::solveBulletRows(int iteration, btTypedConstraint** constraints, int numConstraints,
                                                const btContactSolverInfo& info)
{
	return btSequentialImpulseConstraintSolver::solveSingleIteration(iteration, 0, 0, 0, 0, constraints,
	                                                                 numConstraints, info, 0);
}

btScalar btHybridContactSolver::solveSingleIteration(int iteration, btCollisionObject**, int,
                                                     btPersistentManifold**, int, btTypedConstraint** constraints,
                                                     int numConstraints, const btContactSolverInfo& info,
                                                     btIDebugDraw*)
{
	btScalar residual = 0;
	if (numConstraints > 0 || hasBulletRows())
	{
		giveVelocities();
		residual = solveBulletRows(iteration, constraints, numConstraints, info);
		takeVelocities();
	}
	if (!m_problem->empty() && iteration < info.m_numIterations)
		residual = btMax(residual, btScalar(m_problem->solver().solveVelocities()));
	return residual;
}

btScalar btHybridContactSolver::solveGroupCacheFriendlyFinish(btCollisionObject** bodies, int numBodies,
                                                              const btContactSolverInfo& info)
{
	if (m_problem->empty())
		return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyFinish(bodies, numBodies, info);
	m_problem->finish(info);
	giveVelocities();
	if (info.m_splitImpulse)
		givePushes();
	return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyFinish(bodies, numBodies, info);
}

btHybridContactSolverInfo btHybridContactSolver::getContactSolverInfo() const
{
	btHybridContactSolverInfo info;
	info.m_pairs = int(m_problem->problem().pairs.size());
	info.m_points = int(m_problem->problem().points.size());
	info.m_bulletManifolds = m_problem->m_bulletManifolds;
	if (m_problem->empty())
		return info;
	info.m_colours = m_problem->solver().colouring().colours();
	for (const PairBatch& batch : m_problem->solver().colouring().batches())
		info.m_rows += batch.rows;
	info.m_reduced = m_problem->m_reduced;
	return info;
}

void btHybridContactSolver::setContactReduction(const btHybridContactReductionInfo& info)
{
	m_reduces = true;
	m_reduction = info;
}
