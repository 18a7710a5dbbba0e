#include "BulletHybrid/btHybridFidelity.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "BulletHybrid/btHybridDynamicsWorld.h"
#include "BulletHybrid/btHybridRigidBody.h"
#include "btHybridShapeQuery.h"

namespace
{
typedef std::pair<const btCollisionObject*, const btCollisionObject*> ObjectPair;

// Whichever comes first in memory is first; nothing but looking up depends on it.
ObjectPair ordered(const btCollisionObject* a, const btCollisionObject* b)
{
	return std::less<>()(b, a) ? ObjectPair(b, a) : ObjectPair(a, b);
}

// The pairs with a contact point that is closer than a distance.
class TouchingPairs
{
	std::vector<ObjectPair> m_pairs;

public:
	TouchingPairs(const btDispatcher* dispatcher, btScalar distance)
	{
		for (int i = 0; i < dispatcher->getNumManifolds(); i++)
		{
			// Bullet's getter is not const.
			const btPersistentManifold* const manifold =
			    const_cast<btDispatcher*>(dispatcher)->getManifoldByIndexInternal(i);
			if (touches(*manifold, distance))
				m_pairs.push_back(ordered(manifold->getBody0(), manifold->getBody1()));
		}
		std::sort(m_pairs.begin(), m_pairs.end(), isLess);
	}

	bool contains(const btCollisionObject* a, const btCollisionObject* b) const
	{
		return std::binary_search(m_pairs.begin(), m_pairs.end(), ordered(a, b), isLess);
	}

private:
	static bool touches(const btPersistentManifold& manifold, btScalar distance)
	{
		for (int i = 0; i < manifold.getNumContacts(); i++)
			if (manifold.getContactPoint(i).getDistance() < distance)
				return true;
		return false;
	}

	static bool isLess(const ObjectPair& a, const ObjectPair& b)
	{
		return a.first != b.first ? std::less<>()(a.first, b.first) : std::less<>()(a.second, b.second);
	}
};

bool mayTouch(const btCollisionObject* a, const btCollisionObject* b)
{
	if (!a->hasContactResponse() || !b->hasContactResponse() ||
	    (a->isStaticOrKinematicObject() && b->isStaticOrKinematicObject()))
		return false;
	return a->checkCollideWith(b) && b->checkCollideWith(a);
}

btHybridPlacedShape finestOf(const btCollisionObject* object)
{
	const btHybridRigidBody* hybrid = btHybridRigidBody::upcast(object);
	return {hybrid ? hybrid->getLevels().getLevelShape(hybrid->getFinestLevel()) : object->getCollisionShape(),
	        object->getWorldTransform()};
}

// How many levels a body is below its finest one.
int levelsBelow(const btCollisionObject* object)
{
	const btHybridRigidBody* hybrid = btHybridRigidBody::upcast(object);
	return hybrid ? hybrid->getFinestLevel() - hybrid->getLevel() : 0;
}

// One measurement of a world.
class Measurement
{
	const btHybridFidelity& m_fidelity;
	const btHybridDynamicsWorld* m_hybridWorld;  // 0: every pair meets with the bodies' shapes
	TouchingPairs m_touching;
	btHybridShapeQuery m_query;
	btHybridFidelitySample& m_sample;

public:
	Measurement(const btHybridFidelity& fidelity, const btCollisionWorld* world, btHybridFidelitySample& sample)
	    : m_fidelity(fidelity),
	      m_hybridWorld(dynamic_cast<const btHybridDynamicsWorld*>(world)),
	      m_touching(world->getDispatcher(), fidelity.m_touchingDistance),
	      m_sample(sample)
	{
	}

	void measurePair(const btBroadphasePair& pair)
	{
		const btCollisionObject* const a = static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
		const btCollisionObject* const b = static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject);
		const int levels = btMax(m_fidelity.getNumLevels(a), m_fidelity.getNumLevels(b));
		if (levels < 2 || !mayTouch(a, b))
			return;
		const btHybridPlacedShape finestA = finestOf(a);
		const btHybridPlacedShape finestB = finestOf(b);
		m_sample.m_visibleOverlapPairs += m_query.overlapDeeper(finestA, finestB, m_fidelity.m_visibleDepth);
		if (!m_touching.contains(a, b))
			return;
		const int below = pairLevelsBelow(a, b, levels);
		countTouching(below);
		if (below > 0)
			m_sample.m_contactGaps.push_back(m_query.getDistance(finestA, finestB));
	}

private:
	// With pair switching bodies are always at their finest level, with body switching pairs have none of their own.
	int pairLevelsBelow(const btCollisionObject* a, const btCollisionObject* b, int levels) const
	{
		const int ofBodies = btMax(levelsBelow(a), levelsBelow(b));
		const int level = m_hybridWorld ? m_hybridWorld->getPairLevel(a, b) : 0;
		return level > 0 ? btMax(ofBodies, levels - level) : ofBodies;
	}

	void countTouching(int below)
	{
		m_sample.m_touchingPairs++;
		while (m_sample.m_touchingByLevel.size() <= below)
			m_sample.m_touchingByLevel.push_back(0);
		m_sample.m_touchingByLevel[below]++;
	}
};
}  // namespace

btHybridFidelity::btHybridFidelity(const btCollisionWorld* world)
    : m_world(world), m_touchingDistance(btScalar(0.01)), m_visibleDepth(btScalar(0.05))
{
}

int btHybridFidelity::getNumLevels(const btCollisionObject* object) const
{
	const btHybridRigidBody* hybrid = btHybridRigidBody::upcast(object);
	return hybrid ? hybrid->getFinestLevel() : 1;
}

btHybridFidelitySample btHybridFidelity::measure() const
{
	btHybridFidelitySample sample;
	if (!m_world)
		return sample;
	Measurement measurement(*this, m_world, sample);
	const btOverlappingPairCache* const cache = m_world->getBroadphase()->getOverlappingPairCache();
	const btBroadphasePair* const pairs = cache->getOverlappingPairArrayPtr();
	for (int i = 0; i < cache->getNumOverlappingPairs(); i++)
		measurement.measurePair(pairs[i]);
	return sample;
}
