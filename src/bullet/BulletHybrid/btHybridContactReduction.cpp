#include "BulletHybrid/btHybridContactReduction.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include <algorithm>
#include <vector>

#include "btHybridQuad.h"
#include "btHybridReducible.h"
#include "solver/contact_reduction.h"

using scatter::solver::ContactReduction;
using scatter::solver::ReducibleContact;

namespace
{
const int kNoPair = -1;
const int kNoManifold = -1;

}  // namespace

/// Finds the manifolds of every two bodies, and hides contacts from solvers as long as they work.
class btHybridReducedContacts
{
	/// The manifolds of two bodies.
	struct Pair
	{
		const btCollisionObject* m_other;
		int m_next;  ///< pair of the same first body
		int m_last;  ///< of its manifolds
		int m_contacts;
	};

	struct Hidden
	{
		btManifoldPoint* m_point;
		btScalar m_distance;
	};

	std::vector<int> m_firstPair;  ///< of an object of the world
	std::vector<Pair> m_pairs;
	std::vector<int> m_before;  ///< of a manifold, the one before it of the same bodies
	std::vector<btManifoldPoint*> m_points;
	std::vector<ReducibleContact> m_contacts;
	std::vector<Hidden> m_hidden;
	ContactReduction m_reduction;

	int pairOf(const btPersistentManifold& manifold);
	void group(btPersistentManifold** manifolds, int numManifolds);
	void collect(const Pair& pair, btPersistentManifold** manifolds);
	void hide();

public:
	btHybridContactReductionCount m_count;

	void hide(btPersistentManifold** manifolds, int numManifolds, const btHybridContactReductionInfo& info);
	void show();
};

// In either order of the bodies.
int btHybridReducedContacts::pairOf(const btPersistentManifold& manifold)
{
	const btCollisionObject* first = manifold.getBody0();
	const btCollisionObject* second = manifold.getBody1();
	if (second->getWorldArrayIndex() > first->getWorldArrayIndex())
		std::swap(first, second);
	const int index = first->getWorldArrayIndex();
	if (index < 0)
		return kNoPair;
	if (size_t(index) >= m_firstPair.size())
		m_firstPair.resize(size_t(index) + 1, kNoPair);
	for (int pair = m_firstPair[index]; pair != kNoPair; pair = m_pairs[pair].m_next)
	{
		if (m_pairs[pair].m_other == second)
			return pair;
	}
	m_pairs.push_back({second, m_firstPair[index], kNoManifold, 0});
	m_firstPair[index] = int(m_pairs.size()) - 1;
	return m_firstPair[index];
}

void btHybridReducedContacts::group(btPersistentManifold** manifolds, int numManifolds)
{
	m_pairs.clear();
	m_firstPair.clear();
	m_before.assign(size_t(numManifolds), kNoManifold);
	for (int i = 0; i < numManifolds; ++i)
	{
		const int contacts = manifolds[i]->getNumContacts();
		const int index = contacts > 0 ? pairOf(*manifolds[i]) : kNoPair;
		if (index == kNoPair)
			continue;
		m_before[i] = m_pairs[index].m_last;
		m_pairs[index].m_last = i;
		m_pairs[index].m_contacts += contacts;
	}
}

void btHybridReducedContacts::collect(const Pair& pair, btPersistentManifold** manifolds)
{
	m_points.clear();
	m_contacts.clear();
	for (int i = pair.m_last; i != kNoManifold; i = m_before[i])
	{
		btPersistentManifold& manifold = *manifolds[i];
		const btScalar sign = manifold.getBody1() == pair.m_other ? btScalar(1) : btScalar(-1);
		for (int k = 0; k < manifold.getNumContacts(); ++k)
		{
			btManifoldPoint& point = manifold.getContactPoint(k);
			if (!(point.getDistance() <= manifold.getContactProcessingThreshold()) || !btHybridIsReducible(point))
				continue;
			m_points.push_back(&point);
			m_contacts.push_back({btHybridQuad(point.m_positionWorldOnB, point.getDistance()),
			                      btHybridQuad(sign * point.m_normalWorldOnB, point.m_appliedImpulse), -1});
		}
	}
}

void btHybridReducedContacts::hide()
{
	for (size_t i = 0; i < m_contacts.size(); ++i)
	{
		const int kept = m_contacts[i].kept;
		if (kept == int(i))
			continue;
		btManifoldPoint& point = *m_points[i];
		m_points[kept]->m_appliedImpulse += point.m_appliedImpulse;
		point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
		m_hidden.push_back({&point, point.m_distance1});
		point.m_distance1 = SIMD_INFINITY;
	}
}

void btHybridReducedContacts::hide(btPersistentManifold** manifolds, int numManifolds,
                                   const btHybridContactReductionInfo& info)
{
	m_count = btHybridContactReductionCount();
	m_hidden.clear();
	group(manifolds, numManifolds);
	for (const Pair& pair : m_pairs)
	{
		if (pair.m_contacts < btMax(info.m_leastContacts, 1))
			continue;
		collect(pair, manifolds);
		++m_count.m_pairs;
		m_count.m_contacts += int(m_contacts.size());
		m_count.m_left += m_reduction.reduce(m_contacts, btMax(info.m_mostAlike, 1));
		hide();
	}
}

void btHybridReducedContacts::show()
{
	for (const Hidden& hidden : m_hidden)
		hidden.m_point->m_distance1 = hidden.m_distance;
	m_hidden.clear();
}

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
	m_reduced->hide(manifolds, numManifolds, m_info);
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
	return m_reduced->m_count;
}
