#include "btHybridHeldContacts.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <algorithm>
#include <utility>

namespace
{
// What two directions that are opposed count, as a distance in metres, when contacts are told apart.
const btScalar c_turned = 2;

// Least cosine between the directions of two contacts of which one can stand for the other.
const btScalar c_alike = btScalar(0.9);

// How different two contacts are: in place, and in direction.
btScalar difference(const btManifoldPoint& a, const btManifoldPoint& b)
{
	return (a.m_positionWorldOnB - b.m_positionWorldOnB).length2() + c_turned * c_turned / 4 * (a.m_normalWorldOnB - b.m_normalWorldOnB).length2();
}

// As a manifold result does it; the end is told by the manifold.
void append(const btManifoldPoint& point, btPersistentManifold* manifold)
{
	manifold->addManifoldPoint(point);
	if (gContactStartedCallback && manifold->getNumContacts() == 1)
		gContactStartedCallback(manifold);
}

// Children are in ascending order.
scatter::ChildPair* find(std::vector<scatter::ChildPair>& children, int a, int b)
{
	const auto isBefore = [](const scatter::ChildPair& child, const std::pair<int, int>& wanted)
	{ return child.a != wanted.first ? child.a < wanted.first : child.b < wanted.second; };
	const auto found = std::lower_bound(children.begin(), children.end(), std::make_pair(a, b), isBefore);
	return found != children.end() && found->a == a && found->b == b ? &*found : 0;
}
}  // namespace

struct btHybridHeldContacts::Candidate
{
	btManifoldPoint* m_point;
	const btPersistentManifold* m_manifold;
	btScalar m_difference;  ///< from those that were chosen
};

void btHybridHeldContacts::collect(const std::vector<scatter::ChildPair>& children, std::vector<Candidate>& candidates)
{
	candidates.clear();
	for (size_t i = 0; i < children.size(); i++)
	{
		btPersistentManifold* manifold = static_cast<btPersistentManifold*>(children[i].contact);
		for (int k = 0; manifold && k < manifold->getNumContacts(); k++)
		{
			const Candidate candidate = {&manifold->getContactPoint(k), manifold, BT_LARGE_FLOAT};
			candidates.push_back(candidate);
		}
	}
}

// Contacts that were held and are not found anew are still good: Bullet, too, finds a few at a time and keeps them.
void btHybridHeldContacts::collectOld(std::vector<Candidate>& candidates, std::vector<const btManifoldPoint*>& replaced)
{
	const size_t found = candidates.size();
	replaced.clear();
	for (int i = 0; i < m_count; i++)
	{
		for (int k = 0; k < m_manifolds[i]->getNumContacts(); k++)
		{
			btManifoldPoint* point = &m_manifolds[i]->getContactPoint(k);
			const auto isLike = [point](const Candidate& candidate)
			{ return difference(*candidate.m_point, *point) < gContactBreakingThreshold * gContactBreakingThreshold; };
			if (std::any_of(candidates.begin(), candidates.begin() + std::ptrdiff_t(found), isLike))
			{
				replaced.push_back(point);
				continue;
			}
			const Candidate candidate = {point, m_manifolds[i], BT_LARGE_FLOAT};
			candidates.push_back(candidate);
		}
	}
}

btManifoldPoint* btHybridHeldContacts::nearest(const btManifoldPoint& point)
{
	btManifoldPoint* best = 0;
	btScalar least = BT_LARGE_FLOAT;
	for (int i = 0; i < m_count; i++)
	{
		for (int k = 0; k < m_manifolds[i]->getNumContacts(); k++)
		{
			btManifoldPoint& other = m_manifolds[i]->getContactPoint(k);
			const btScalar far = difference(point, other);
			if (far >= least)
				continue;
			least = far;
			best = &other;
		}
	}
	return best;
}

// What a contact bore that is not there any more, the one that is most like it bears on.
void btHybridHeldContacts::inherit(const btManifoldPoint& from)
{
	btManifoldPoint* to = from.m_appliedImpulse > 0 ? nearest(from) : 0;
	if (!to || to->m_normalWorldOnB.dot(from.m_normalWorldOnB) < c_alike)
		return;
	to->m_appliedImpulse += from.m_appliedImpulse;
	to->m_appliedImpulseLateral1 += from.m_appliedImpulseLateral1;
	to->m_appliedImpulseLateral2 += from.m_appliedImpulseLateral2;
}

void btHybridHeldContacts::add(const btManifoldPoint& point, const btPersistentManifold* like, btDispatcher* dispatcher)
{
	if (m_count == 0 || m_manifolds[m_count - 1]->getNumContacts() == MANIFOLD_CACHE_SIZE)
		m_manifolds[m_count++] = dispatcher->getNewManifold(like->getBody0(), like->getBody1());
	append(point, m_manifolds[m_count - 1]);
}

void btHybridHeldContacts::gather(const std::vector<scatter::ChildPair>& children, btDispatcher* dispatcher)
{
	static thread_local std::vector<Candidate> candidates;
	static thread_local std::vector<const btManifoldPoint*> replaced;
	collect(children, candidates);
	btHybridHeldContacts before = *this;
	before.collectOld(candidates, replaced);
	m_count = 0;
	const int most = c_mostManifolds * MANIFOLD_CACHE_SIZE;
	for (int chosen = 0; chosen < most && !candidates.empty(); chosen++)
	{
		const auto isLess = [chosen](const Candidate& a, const Candidate& b)
		{ return chosen == 0 ? a.m_point->getDistance() > b.m_point->getDistance() : a.m_difference < b.m_difference; };
		const auto best = std::max_element(candidates.begin(), candidates.end(), isLess);
		const btManifoldPoint point = *best->m_point;
		// A program's data goes with the point, and is given back once.
		best->m_point->m_userPersistentData = 0;
		add(point, best->m_manifold, dispatcher);
		candidates.erase(best);
		for (size_t i = 0; i < candidates.size(); i++)
			candidates[i].m_difference = btMin(candidates[i].m_difference, difference(*candidates[i].m_point, point));
	}
	for (size_t i = 0; i < candidates.size(); i++)
		inherit(*candidates[i].m_point);
	for (size_t i = 0; i < replaced.size(); i++)
		inherit(*replaced[i]);
	before.release(dispatcher);
}

void btHybridHeldContacts::refresh(const btTransform& transform0, const btTransform& transform1)
{
	for (int i = 0; i < m_count; i++)
		m_manifolds[i]->refreshContactPoints(transform0, transform1);
}

void btHybridHeldContacts::giveBack(std::vector<scatter::ChildPair>& children, btDispatcher* dispatcher)
{
	for (int i = 0; i < m_count; i++)
	{
		for (int k = 0; k < m_manifolds[i]->getNumContacts(); k++)
		{
			btManifoldPoint& point = m_manifolds[i]->getContactPoint(k);
			scatter::ChildPair* child = find(children, btMax(point.m_index0, 0), btMax(point.m_index1, 0));
			if (!child)
				continue;
			if (!child->contact)
				child->contact = dispatcher->getNewManifold(m_manifolds[i]->getBody0(), m_manifolds[i]->getBody1());
			btPersistentManifold* manifold = static_cast<btPersistentManifold*>(child->contact);
			if (manifold->getNumContacts() == MANIFOLD_CACHE_SIZE)
				continue;
			append(point, manifold);
			point.m_userPersistentData = 0;
			child->touching = true;
		}
	}
	release(dispatcher);
}

void btHybridHeldContacts::release(btDispatcher* dispatcher)
{
	for (int i = 0; i < m_count; i++)
		dispatcher->releaseManifold(m_manifolds[i]);
	m_count = 0;
}

int btHybridHeldContacts::getNumContacts() const
{
	int contacts = 0;
	for (int i = 0; i < m_count; i++)
		contacts += m_manifolds[i]->getNumContacts();
	return contacts;
}

btScalar btHybridHeldContacts::getLeastDistance() const
{
	btScalar least = BT_LARGE_FLOAT;
	for (int i = 0; i < m_count; i++)
		for (int k = 0; k < m_manifolds[i]->getNumContacts(); k++)
			least = btMin(least, m_manifolds[i]->getContactPoint(k).getDistance());
	return least;
}
