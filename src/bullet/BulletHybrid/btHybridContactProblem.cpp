#include "btHybridContactProblem.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "btHybridQuad.h"
#include "btHybridReducible.h"

using scatter::solver::ContactBody;
using scatter::solver::ContactPair;
using scatter::solver::ContactSettings;
using scatter::solver::ContactSolver;
using scatter::solver::ProblemPoint;
using scatter::solver::ReducibleContact;

namespace
{
const int kNone = -1;

bool needsBullet(const btManifoldPoint& point, const btContactSolverInfo& info)
{
	const bool hasDirections = (info.m_solverMode & SOLVER_ENABLE_FRICTION_DIRECTION_CACHING) &&
	                           (point.m_contactPointFlags & BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED);
	return point.m_combinedRollingFriction > 0 || (point.m_contactPointFlags & BT_CONTACT_FLAG_FRICTION_ANCHOR) ||
	       hasDirections;
}

// Softness and error reduction of a contact, as btSequentialImpulseConstraintSolver::setupContactConstraint finds
// them.
void findLaw(const btManifoldPoint& point, const btContactSolverInfo& info, btScalar& cfm, btScalar& erp)
{
	cfm = info.m_globalCfm;
	erp = info.m_erp2;
	const int flags = point.m_contactPointFlags;
	if (flags & (BT_CONTACT_FLAG_HAS_CONTACT_CFM | BT_CONTACT_FLAG_HAS_CONTACT_ERP))
	{
		if (flags & BT_CONTACT_FLAG_HAS_CONTACT_CFM)
			cfm = point.m_contactCFM;
		if (flags & BT_CONTACT_FLAG_HAS_CONTACT_ERP)
			erp = point.m_contactERP;
	}
	else if (flags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING)
	{
		const btScalar spring = info.m_timeStep * point.m_combinedContactStiffness1;
		const btScalar resistance = btMax(spring + point.m_combinedContactDamping1, btScalar(SIMD_EPSILON));
		cfm = 1 / resistance;
		erp = spring / resistance;
	}
}

ProblemPoint contactOf(const btManifoldPoint& point, bool swaps, const btContactSolverInfo& info)
{
	btScalar cfm, erp;
	findLaw(point, info, cfm, erp);
	const bool warm = (info.m_solverMode & SOLVER_USE_WARMSTARTING) != 0;
	const btVector3& placeA = point.m_positionWorldOnA;
	const btVector3& placeB = point.m_positionWorldOnB;
	ProblemPoint contact;
	contact.onA = btHybridQuad(swaps ? placeB : placeA, point.getDistance());
	contact.onB = btHybridQuad(swaps ? placeA : placeB, point.m_combinedFriction);
	contact.normal =
	    btHybridQuad(swaps ? -point.m_normalWorldOnB : point.m_normalWorldOnB, point.m_combinedRestitution);
	contact.law = btHybridQuad(
	    btVector3(warm ? point.m_appliedImpulse * info.m_warmstartingFactor : btScalar(0), cfm, erp), 1);
	return contact;
}

ContactSettings settingsOf(const btContactSolverInfo& info, bool clampsFriction)
{
	ContactSettings settings;
	settings.timeStep = float(info.m_timeStep);
	settings.relaxation = float(info.m_sor);
	settings.restitutionThreshold = float(info.m_restitutionVelocityThreshold);
	settings.slop = float(info.m_linearSlop);
	settings.splits = info.m_splitImpulse != 0;
	settings.splitDepth = float(info.m_splitImpulsePenetrationThreshold);
	settings.frictionDirections = (info.m_solverMode & SOLVER_USE_2_FRICTION_DIRECTIONS) ? 2 : 1;
	settings.followsVelocity = (info.m_solverMode & SOLVER_DISABLE_VELOCITY_DEPENDENT_FRICTION_DIRECTION) == 0;
	settings.clampsFriction = clampsFriction;
	return settings;
}
}  // namespace

void btHybridContactProblem::clear()
{
	m_problem.clear();
	m_sources.clear();
	m_taken.clear();
	m_lastPair.clear();
	m_nextPair.clear();
	m_bulletManifolds = 0;
	m_reduced = btHybridContactReductionCount();
}

bool btHybridContactProblem::add(btPersistentManifold* manifold, Side side0, Side side1,
                                 const btContactSolverInfo& info)
{
	// A pair's manifolds may name its bodies in either order.
	const bool swaps = !side0.m_moves || (side1.m_moves && side1.m_id < side0.m_id);
	const int first = int(m_problem.points.size());
	if (!takePoints(manifold, swaps, info))
	{
		m_problem.points.resize(first);
		m_sources.resize(first);
		return false;
	}
	const int count = int(m_problem.points.size()) - first;
	if (count == 0)
		return true;
	const int pair = swaps ? pairOf(side1.m_id, side0.m_id) : pairOf(side0.m_id, side1.m_id);
	m_problem.pairs[pair].count += count;
	m_taken.push_back({pair, first, count});
	return true;
}

bool btHybridContactProblem::takePoints(btPersistentManifold* manifold, bool swaps, const btContactSolverInfo& info)
{
	for (int i = 0; i < manifold->getNumContacts(); ++i)
	{
		btManifoldPoint& point = manifold->getContactPoint(i);
		if (!(point.getDistance() <= manifold->getContactProcessingThreshold()))
			continue;
		if (needsBullet(point, info))
			return false;
		m_problem.points.push_back(contactOf(point, swaps, info));
		m_sources.push_back({&point, swaps, btHybridIsReducible(point)});
	}
	return true;
}

// A body has few neighbours that it is the first of, and the manifolds of a pair mostly follow each other.
int btHybridContactProblem::pairOf(int a, int b)
{
	if (size_t(a) >= m_lastPair.size())
		m_lastPair.resize(a + 1, kNone);
	for (int pair = m_lastPair[a]; pair != kNone; pair = m_nextPair[pair])
	{
		if (m_problem.pairs[pair].b == b)
			return pair;
	}
	const int pair = int(m_problem.pairs.size());
	m_problem.pairs.push_back({a, b, 0, 0});
	m_nextPair.push_back(m_lastPair[a]);
	m_lastPair[a] = pair;
	return pair;
}

void btHybridContactProblem::takeBody(const btSolverBody& body)
{
	ContactBody result;
	result.center = btHybridQuad(body.getWorldTransform().getOrigin());
	const btRigidBody* original = body.m_originalBody;
	if (original)
	{
		result.center.w = float(original->getInvMass());
		result.velocity = btHybridQuad(body.m_linearVelocity);
		result.spin = btHybridQuad(body.m_angularVelocity);
		result.force = btHybridQuad(body.m_externalForceImpulse);
		result.torque = btHybridQuad(body.m_externalTorqueImpulse);
		for (int i = 0; i < 3; ++i)
			result.inertia[i] = btHybridQuad(original->getInvInertiaTensorWorld()[i]);
		result.linear = btHybridQuad(body.m_invMass * body.m_linearFactor);
		result.angular = btHybridQuad(body.m_angularFactor);
		result.moves = original->getInvMass() != 0;
	}
	m_problem.bodies.push_back(result);
}

void btHybridContactProblem::order()
{
	int first = 0;
	for (ContactPair& pair : m_problem.pairs)
	{
		pair.first = first;
		first += pair.count;
		pair.count = 0;
	}
	m_problem.order.resize(first);
	for (const Taken& taken : m_taken)
	{
		ContactPair& pair = m_problem.pairs[taken.m_pair];
		for (int i = 0; i < taken.m_count; ++i)
			m_problem.order[pair.first + pair.count++] = taken.m_first + i;
	}
}

// What stands for what was left out begins with its impulse too; what was left out bears nothing.
void btHybridContactProblem::leaveOut(int index, int kept)
{
	const float impulse = m_problem.points[index].law.x;
	if (impulse == 0)
		return;
	m_problem.points[kept].law.x += impulse;
	btManifoldPoint& point = *m_sources[index].m_point;
	point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
}

void btHybridContactProblem::reduce(ContactPair& pair, int mostAlike)
{
	m_reducible.clear();
	m_reducibleIndex.clear();
	int left = 0;
	for (int i = pair.first; i < pair.first + pair.count; ++i)
	{
		const int index = m_problem.order[i];
		if (!m_sources[index].m_isReducible)
		{
			m_problem.order[pair.first + left++] = index;
			continue;
		}
		const ProblemPoint& point = m_problem.points[index];
		ReducibleContact contact;
		contact.place = point.onB;
		contact.place.w = point.onA.w;
		contact.normal = point.normal;
		contact.normal.w = point.law.x;
		m_reducible.push_back(contact);
		m_reducibleIndex.push_back(index);
	}
	++m_reduced.m_pairs;
	m_reduced.m_contacts += int(m_reducible.size());
	m_reduced.m_left += m_reduction.reduce(m_reducible, mostAlike);
	for (size_t i = 0; i < m_reducible.size(); ++i)
	{
		const int kept = m_reducible[i].kept;
		if (kept == int(i))
			m_problem.order[pair.first + left++] = m_reducibleIndex[i];
		else
			leaveOut(m_reducibleIndex[i], m_reducibleIndex[kept]);
	}
	pair.count = left;
}

void btHybridContactProblem::begin(const btAlignedObjectArray<btSolverBody>& bodies,
                                   const btContactSolverInfo& info, bool clampsFriction,
                                   const btHybridContactReductionInfo* reduction)
{
	for (int i = 0; i < bodies.size(); ++i)
		takeBody(bodies[i]);
	order();
	for (ContactPair& pair : m_problem.pairs)
	{
		if (reduction && pair.count >= btMax(reduction->m_leastContacts, 1))
			reduce(pair, btMax(reduction->m_mostAlike, 1));
	}
	m_solver.begin(m_problem, settingsOf(info, clampsFriction));
}

void btHybridContactProblem::finish(const btContactSolverInfo& info)
{
	const bool warm = (info.m_solverMode & SOLVER_USE_WARMSTARTING) != 0;
	const bool two = (info.m_solverMode & SOLVER_USE_2_FRICTION_DIRECTIONS) != 0;
	m_solver.forEachImpulse(m_problem,
	                        [&](int index, const ContactSolver::Impulse& impulse)
	                        {
		                        btManifoldPoint& point = *m_sources[index].m_point;
		                        const btScalar sign = m_sources[index].m_isSwapped ? btScalar(-1) : btScalar(1);
		                        point.m_lateralFrictionDir1 = sign * btHybridVectorOf(impulse.directions[0]);
		                        if (two)
			                        point.m_lateralFrictionDir2 = sign * btHybridVectorOf(impulse.directions[1]);
		                        if (!warm)
			                        return;
		                        point.m_appliedImpulse = impulse.normal;
		                        point.m_appliedImpulseLateral1 = impulse.friction[0];
		                        if (two)
			                        point.m_appliedImpulseLateral2 = impulse.friction[1];
	                        });
}
