#include "btHybridReducedContacts.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "btHybridQuad.h"
#include "btHybridReducible.h"

namespace
{
const int kNoPair = -1;
const int kNoManifold = -1;

unsigned drawLot(int first, int second)
{
	const uint64_t golden = 0x9E3779B97F4A7C15u;
	return unsigned(((uint64_t(first) << 32 | uint64_t(second)) * golden) >> 32);
}

// One that stayed a step before counts as one that bore something, so that the choice does not flicker where many
// bear next to nothing. Bullet's solvers of rigid bodies do not use where that is noted, and it goes where the point
// goes.
btScalar btHybridLoyaltyOf(const btManifoldPoint& point)
{
	return point.m_appliedImpulse + point.m_prevRHS;
}
}  // namespace

// In either order of the bodies.
int btHybridReducedContacts::pairOf(const btCollisionObject* first, const btCollisionObject* second)
{
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
	m_pairs.push_back({second, drawLot(index, second->getWorldArrayIndex()), m_firstPair[index], kNoManifold, 0});
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
		const int index = contacts > 0 ? pairOf(manifolds[i]->getBody0(), manifolds[i]->getBody1()) : kNoPair;
		if (index == kNoPair)
			continue;
		m_before[i] = m_pairs[index].m_last;
		m_pairs[index].m_last = i;
		m_pairs[index].m_contacts += contacts;
	}
}

void btHybridReducedContacts::order(int leastContacts)
{
	m_order.clear();
	for (size_t i = 0; i < m_pairs.size(); ++i)
		if (m_pairs[i].m_contacts >= leastContacts)
			m_order.push_back(int(i));
	std::sort(m_order.begin(), m_order.end(),
	          [this](int a, int b) { return std::tie(m_pairs[a].m_lot, a) < std::tie(m_pairs[b].m_lot, b); });
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
			if (!btHybridIsNear(manifold, point) || !btHybridIsReducible(point))
				continue;
			m_points.push_back(&point);
			m_contacts.push_back({btHybridQuad(point.m_positionWorldOnB, point.getDistance()),
			                      btHybridQuad(sign * point.m_normalWorldOnB, btHybridLoyaltyOf(point)), -1});
		}
	}
}

void btHybridReducedContacts::remember()
{
	for (size_t i = 0; i < m_contacts.size(); ++i)
	{
		const int kept = m_contacts[i].kept;
		m_points[i]->m_prevRHS = btScalar(kept == int(i) ? 1 : 0);
		if (kept != int(i))
			m_hidden.push_back({m_points[i], m_points[kept], 0});
	}
}

void btHybridReducedContacts::find(btPersistentManifold** manifolds, int numManifolds,
                                   const btHybridContactReductionInfo& info)
{
	forget();
	group(manifolds, numManifolds);
	order(btMax(info.m_leastContacts, 1));
	for (int pair : m_order)
	{
		collect(m_pairs[pair], manifolds);
		++m_count.m_pairs;
		m_count.m_contacts += int(m_contacts.size());
		m_count.m_left += m_reduction.reduce(m_contacts, btMax(info.m_mostAlike, 1));
		remember();
	}
}

void btHybridReducedContacts::forget()
{
	m_count = btHybridContactReductionCount();
	m_hidden.clear();
}

void btHybridReducedContacts::keepFirst(int most)
{
	if (m_hidden.size() > size_t(btMax(most, 0)))
		m_hidden.resize(size_t(btMax(most, 0)));
}

// What a contact bore is borne by the one that stands for it.
void btHybridReducedContacts::hide()
{
	for (Hidden& hidden : m_hidden)
	{
		btManifoldPoint& point = *hidden.m_point;
		hidden.m_kept->m_appliedImpulse += point.m_appliedImpulse;
		point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
		hidden.m_distance = point.m_distance1;
		point.m_distance1 = SIMD_INFINITY;
	}
}

void btHybridReducedContacts::show()
{
	for (const Hidden& hidden : m_hidden)
		hidden.m_point->m_distance1 = hidden.m_distance;
	m_hidden.clear();
}
