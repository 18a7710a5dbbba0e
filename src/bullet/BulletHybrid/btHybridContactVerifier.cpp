#include "btHybridContactVerifier.h"

#include <functional>

#include "BulletHybrid/btHybridRigidBody.h"
#include "btHybridBruteForce.h"
#include "btHybridPlanner.h"

namespace
{
// Names a child pair in contact. The order of bodies in memory sorts them, and nothing else.
struct ContactKey
{
	const btCollisionObject* m_bodies[2];
	int m_children[2];
	bool m_isNew;  // the point was not there before this step

	ContactKey()
	{
	}
	ContactKey(const btCollisionObject* body0, const btCollisionObject* body1, int child0, int child1, bool isNew = false)
	    : m_isNew(isNew)
	{
		const bool swap = std::less<>()(body1, body0);
		m_bodies[swap] = body0;
		m_bodies[!swap] = body1;
		m_children[swap] = child0;
		m_children[!swap] = child1;
	}

	static bool less(const ContactKey& a, const ContactKey& b)
	{
		for (int i = 0; i < 2; i++)
			if (a.m_bodies[i] != b.m_bodies[i])
				return std::less<>()(a.m_bodies[i], b.m_bodies[i]);
		return a.m_children[0] != b.m_children[0] ? a.m_children[0] < b.m_children[0] : a.m_children[1] < b.m_children[1];
	}
};

// The child pairs that have contact points in the world, sorted.
class ContactIndex
{
	btAlignedObjectArray<ContactKey> m_keys;

public:
	explicit ContactIndex(btDispatcher* dispatcher)
	{
		for (int i = 0; i < dispatcher->getNumManifolds(); i++)
			add(*dispatcher->getManifoldByIndexInternal(i));
		if (m_keys.size() > 1)
			m_keys.quickSort(ContactKey::less);
	}

	int size() const
	{
		return m_keys.size();
	}
	const ContactKey& operator[](int i) const
	{
		return m_keys[i];
	}

	// The first that is not less than the key.
	int lowerBound(const ContactKey& key) const
	{
		int first = 0;
		int last = m_keys.size();
		while (first < last)
		{
			const int middle = first + (last - first) / 2;
			if (ContactKey::less(m_keys[middle], key))
				first = middle + 1;
			else
				last = middle;
		}
		return first;
	}

	bool contains(const ContactKey& key) const
	{
		const int i = lowerBound(key);
		return i < m_keys.size() && !ContactKey::less(key, m_keys[i]);
	}

	bool isOfBodies(int i, const ContactKey& key) const
	{
		return i < m_keys.size() && m_keys[i].m_bodies[0] == key.m_bodies[0] && m_keys[i].m_bodies[1] == key.m_bodies[1];
	}

private:
	// A step adds one to the age of every point that it finds; a contact-added callback may have done so too.
	static bool isNew(const btManifoldPoint& point)
	{
		return point.getLifeTime() <= 1;
	}

	void add(const btPersistentManifold& manifold)
	{
		for (int i = 0; i < manifold.getNumContacts(); i++)
		{
			const btManifoldPoint& point = manifold.getContactPoint(i);
			m_keys.push_back(ContactKey(manifold.getBody0(), manifold.getBody1(), point.m_index0, point.m_index1, isNew(point)));
		}
	}
};

// One verification of a world.
class Verification
{
	btDispatcher* m_dispatcher;
	btHybridContactReport& m_report;
	ContactIndex m_contacts;
	btHybridBruteForce m_bruteForce;
	btHybridConvexSide m_a;
	btHybridConvexSide m_b;

public:
	Verification(btDispatcher* dispatcher, btHybridContactReport& report)
	    : m_dispatcher(dispatcher), m_report(report), m_contacts(dispatcher), m_bruteForce(dispatcher)
	{
	}

	void verifyPair(const btBroadphasePair& pair)
	{
		const btCollisionObject* a = static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
		const btCollisionObject* b = static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject);
		if (!btHybridRigidBody::upcast(a) && !btHybridRigidBody::upcast(b))
			return;
		if (!m_dispatcher->needsCollision(a, b) || !m_a.collect(a) || !m_b.collect(b))
			return;
		for (int i = 0; i < m_a.m_children.size(); i++)
			for (int j = 0; j < m_b.m_children.size(); j++)
				verifyChildPair(m_a.m_children[i], m_b.m_children[j]);
		countExtras();
	}

private:
	ContactKey keyOf(int childA, int childB) const
	{
		return ContactKey(m_a.m_object, m_b.m_object, childA, childB);
	}

	void verifyChildPair(const btHybridConvexChild& childA, const btHybridConvexChild& childB)
	{
		if (!btHybridMidphaseKeeps(m_a, childA, m_b, childB, true, -(childA.m_rounding + childB.m_rounding)))
			return;
		m_report.m_childPairs++;
		btHybridMissedContact contact;
		if (!m_bruteForce.findContact(m_a, childA, m_b, childB, false, contact.m_distance))
			return;
		const bool isThere = m_contacts.contains(keyOf(childA.m_index, childB.m_index));
		if (!isThere && isDoubtful(childA, childB))
		{
			m_report.m_doubtful++;
			return;
		}
		m_report.m_expected++;
		if (isThere)
			return;
		contact.m_bodyA = m_a.m_object;
		contact.m_bodyB = m_b.m_object;
		contact.m_childA = childA.m_index;
		contact.m_childB = childB.m_index;
		m_report.m_missed++;
		m_report.m_lastMissed.push_back(contact);
	}

	// Bullet's GJK finds contacts between parts of millimetres, or nearly flat ones, that are further apart
	// than its threshold, or finds them in one order of the two only. Nobody misses those.
	bool isDoubtful(const btHybridConvexChild& childA, const btHybridConvexChild& childB)
	{
		btScalar distance;
		if (btHybridAreBoxes(childA, childB))
			return false;
		return btHybridIsProvenApart(childA, childB, m_bruteForce.getThreshold()) || !m_bruteForce.findContact(m_a, childA, m_b, childB, true, distance);
	}

	void countExtras()
	{
		const ContactKey bodies = keyOf(-1, -1);
		const bool swapped = bodies.m_bodies[0] != m_a.m_object;
		for (int i = m_contacts.lowerBound(bodies); m_contacts.isOfBodies(i, bodies);)
		{
			const ContactKey& key = m_contacts[i];
			bool isNew = true;
			// One child pair has up to four points.
			for (; i < m_contacts.size() && !ContactKey::less(key, m_contacts[i]); i++)
				isNew &= m_contacts[i].m_isNew;
			m_report.m_extra += isExtra(key.m_children[swapped], key.m_children[!swapped], isNew);
		}
	}

	bool isExtra(int childA, int childB, bool isNew) const
	{
		// Without a child it is not of the narrowphase: Bullet's continuous detection predicts such contacts.
		if ((m_a.m_compound && childA < 0) || (m_b.m_compound && childB < 0))
			return false;
		const btHybridConvexChild* a = findChild(m_a, childA);
		const btHybridConvexChild* b = findChild(m_b, childB);
		return !a || !b || !btHybridMidphaseKeeps(m_a, *a, m_b, *b, isNew, a->m_rounding + b->m_rounding);
	}

	static const btHybridConvexChild* findChild(const btHybridConvexSide& side, int index)
	{
		const int position = side.m_compound ? index : index + 1;
		return position >= 0 && position < side.m_children.size() ? &side.m_children[position] : 0;
	}
};
}  // namespace

void btHybridContactVerifier::verify(btBroadphasePairArray& pairs, btDispatcher* dispatcher, const btHybridPlanner* planner)
{
	Verification verification(dispatcher, m_report);
	m_report.m_lastMissed.resize(0);
	for (int i = 0; i < pairs.size(); i++)
		if (!planner || !pairs[i].m_algorithm || planner->isAtFinest(pairs[i].m_algorithm))
			verification.verifyPair(pairs[i]);
	m_report.m_steps++;
}
