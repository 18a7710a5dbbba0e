#include "btHybridContactProblem.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "btHybridQuad.h"

using scatter::solver::BodyVelocity;
using scatter::solver::ContactBody;
using scatter::solver::ContactPair;
using scatter::solver::ContactSettings;
using scatter::solver::ContactSolver;
using scatter::solver::Quad;
using scatter::solver::Share;

namespace
{
const int kNone = -1;

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

// Number by number, as they were found: to read a vector that has just been made of numbers makes a processor wait.
void giveTimes(btScalar sign, const Quad& from, btVector3& to)
{
	to.setValue(sign * from.x, sign * from.y, sign * from.z);
}
}  // namespace

void btHybridContactProblem::clear()
{
	m_problem.clear();
	m_bodies.clear();
	m_moving.clear();
	m_fixed.clear();
	m_taken.clear();
	m_lastPair.clear();
	m_known.clear();
	m_reduced = btHybridContactReductionCount();
}

void btHybridContactProblem::add(const btHybridContactPoints::Range& range, Side a, Side b, std::vector<int>& places)
{
	const int place = placeOf(a, places);
	const int pair = pairOf(place, placeOf(b, places));
	m_problem.pairs[pair].count += range.m_count;
	m_taken.push_back({pair, range.m_first, range.m_count});
}

// What does not move may be in many problems, but there is little of it in one.
int btHybridContactProblem::placeOf(Side side, std::vector<int>& places)
{
	if (side.m_moves && places[side.m_id] != kNone)
		return places[side.m_id];
	for (size_t i = 0; !side.m_moves && i < m_fixed.size(); ++i)
		if (m_bodies[m_fixed[i]] == side.m_id)
			return m_fixed[i];
	const int place = int(m_bodies.size());
	m_bodies.push_back(side.m_id);
	(side.m_moves ? m_moving : m_fixed).push_back(place);
	if (side.m_moves)
		places[side.m_id] = place;
	return place;
}

// A body has few neighbours that it is the first of.
int btHybridContactProblem::pairOf(int a, int b)
{
	if (size_t(a) >= m_lastPair.size())
		m_lastPair.resize(a + 1, kNone);
	for (int pair = m_lastPair[a]; pair != kNone; pair = m_known[pair].m_next)
	{
		if (m_known[pair].m_b == b)
			return pair;
	}
	const int pair = int(m_problem.pairs.size());
	m_problem.pairs.push_back({a, b, 0, 0});
	m_known.push_back({b, m_lastPair[a]});
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

// To reduce a pair of 270 contacts takes six microseconds, a quarter of the step of a stack of wheels (perf of
// `scatter run` of wheel_stack-12 in `lean`).
void btHybridContactProblem::reduce(const btHybridContactReductionInfo& reduction, const Share& share)
{
	const int least = btMax(reduction.m_leastContacts, 1);
	const int mostAlike = btMax(reduction.m_mostAlike, 1);
	const auto reduceSome = [&](int first)
	{
		for (size_t i = first; i < m_problem.pairs.size(); i += m_reductions.size())
			if (m_problem.pairs[i].count >= least)
				m_reductions[first].reduce(m_problem.pairs[i], m_problem, *m_points, mostAlike);
	};
	share(int(m_reductions.size()), reduceSome);
	for (btHybridPairReduction& each : m_reductions)
		each.takeCount(m_reduced);
}

void btHybridContactProblem::begin(btHybridContactPoints& points, const btAlignedObjectArray<btSolverBody>& bodies,
                                   const btContactSolverInfo& info, bool clampsFriction,
                                   const btHybridContactReductionInfo* reduction, const Share& share)
{
	m_points = &points;
	m_problem.points = points.points();
	for (int body : m_bodies)
		takeBody(bodies[body]);
	order();
	if (reduction)
		reduce(*reduction, share);
	m_solver.begin(m_problem, settingsOf(info, clampsFriction), share);
}

// As Bullet's solver does it, islands of at least 128 contacts at a time: these stop when nothing in them changes any
// more.
void btHybridContactProblem::solve(const btContactSolverInfo& info)
{
	const btScalar enough = info.m_leastSquaresResidualThreshold;
	const int pushes = info.m_splitImpulse && m_solver.pushes() ? info.m_numIterations : 0;
	for (int i = 0; i < pushes && m_solver.solvePushes() > enough; ++i)
	{
	}
	for (int i = 0; i < info.m_numIterations && m_solver.solveVelocities() > enough; ++i)
	{
	}
}

void btHybridContactProblem::give(std::span<const BodyVelocity> velocities, btAlignedObjectArray<btSolverBody>& bodies,
                                  btVector3 btSolverBody::*linear, btVector3 btSolverBody::*angular) const
{
	for (int i : m_moving)
	{
		bodies[m_bodies[i]].*linear = btHybridVectorOf(velocities[i].linear);
		bodies[m_bodies[i]].*angular = btHybridVectorOf(velocities[i].angular);
	}
}

void btHybridContactProblem::take(std::span<BodyVelocity> velocities, const btAlignedObjectArray<btSolverBody>& bodies,
                                  btVector3 btSolverBody::*linear, btVector3 btSolverBody::*angular) const
{
	for (int i : m_moving)
	{
		velocities[i].linear = btHybridQuad(bodies[m_bodies[i]].*linear);
		velocities[i].angular = btHybridQuad(bodies[m_bodies[i]].*angular);
	}
}

void btHybridContactProblem::giveVelocities(btAlignedObjectArray<btSolverBody>& bodies)
{
	give(m_solver.velocities(), bodies, &btSolverBody::m_deltaLinearVelocity, &btSolverBody::m_deltaAngularVelocity);
}

void btHybridContactProblem::takeVelocities(const btAlignedObjectArray<btSolverBody>& bodies)
{
	take(m_solver.velocities(), bodies, &btSolverBody::m_deltaLinearVelocity, &btSolverBody::m_deltaAngularVelocity);
}

void btHybridContactProblem::givePushes(btAlignedObjectArray<btSolverBody>& bodies)
{
	give(m_solver.pushVelocities(), bodies, &btSolverBody::m_pushVelocity, &btSolverBody::m_turnVelocity);
}

void btHybridContactProblem::takePushes(const btAlignedObjectArray<btSolverBody>& bodies)
{
	take(m_solver.pushVelocities(), bodies, &btSolverBody::m_pushVelocity, &btSolverBody::m_turnVelocity);
}

void btHybridContactProblem::addVelocities(const btAlignedObjectArray<btSolverBody>& bodies)
{
	for (int i : m_moving)
	{
		const btSolverBody& body = bodies[m_bodies[i]];
		BodyVelocity& velocity = m_solver.velocities()[i];
		velocity.linear = btHybridQuad(btHybridVectorOf(velocity.linear) + body.m_deltaLinearVelocity);
		velocity.angular = btHybridQuad(btHybridVectorOf(velocity.angular) + body.m_deltaAngularVelocity);
	}
}

// Many points of a pile have left the cache since their rows were made.
void btHybridContactProblem::fetchPoints(size_t batch) const
{
#if defined(__GNUC__)
	if (batch >= m_solver.countBatches())
		return;
	m_solver.forEachPoint(m_problem, batch,
	                      [this](int index, const ContactSolver::Place&)
	                      {
		                      const btManifoldPoint* point = m_points->sources()[index].m_point;
		                      __builtin_prefetch(&point->m_appliedImpulse, 1);
		                      __builtin_prefetch(&point->m_lateralFrictionDir2, 1);
	                      });
#else
	(void)batch;
#endif
}

void btHybridContactProblem::giveImpulse(int index, const ContactSolver::Impulse& impulse,
                                         const btContactSolverInfo& info) const
{
	const bool two = (info.m_solverMode & SOLVER_USE_2_FRICTION_DIRECTIONS) != 0;
	const btHybridContactPoints::Source& source = m_points->sources()[index];
	btManifoldPoint& point = *source.m_point;
	const btScalar sign = source.m_isSwapped ? btScalar(-1) : btScalar(1);
	giveTimes(sign, impulse.directions[0], point.m_lateralFrictionDir1);
	if (two)
		giveTimes(sign, impulse.directions[1], point.m_lateralFrictionDir2);
	if (!(info.m_solverMode & SOLVER_USE_WARMSTARTING))
		return;
	point.m_appliedImpulse = impulse.normal;
	point.m_appliedImpulseLateral1 = impulse.friction[0];
	if (two)
		point.m_appliedImpulseLateral2 = impulse.friction[1];
}

void btHybridContactProblem::finish(btAlignedObjectArray<btSolverBody>& bodies, const btContactSolverInfo& info,
                                    const Share& share)
{
	giveVelocities(bodies);
	if (info.m_splitImpulse)
		givePushes(bodies);
	scatter::solver::shareBatches(m_solver.countBatches(), share,
	                              [&](size_t batch)
	                              {
		                              fetchPoints(batch + 1);
		                              m_solver.forEachPoint(m_problem, batch,
		                                                    [&](int index, const ContactSolver::Place& place)
		                                                    { giveImpulse(index, m_solver.impulseAt(place), info); });
	                              });
}
