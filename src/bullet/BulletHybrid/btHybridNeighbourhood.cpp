#include "btHybridNeighbourhood.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <LinearMath/btAabbUtil2.h>

void btHybridNeighbourhood::indexHybrids(int numObjects, const btAlignedObjectArray<btHybridRigidBody*>& hybrids)
{
	m_hybridOfObject.resizeNoInitialize(numObjects);
	for (int i = 0; i < m_hybridOfObject.size(); i++)
		m_hybridOfObject[i] = -1;
	for (int i = 0; i < hybrids.size(); i++)
		m_hybridOfObject[hybrids[i]->getWorldArrayIndex()] = i;
}

int btHybridNeighbourhood::hybridOf(const btBroadphaseProxy* proxy) const
{
	return m_hybridOfObject[static_cast<const btCollisionObject*>(proxy->m_clientObject)->getWorldArrayIndex()];
}

// The speed of a body's fastest point.
static btScalar fastestPoint(const btRigidBody* body)
{
	return body->getLinearVelocity().length() +
	       body->getAngularVelocity().length() * body->getCollisionShape()->getAngularMotionDisc();
}

void btHybridNeighbourhood::measureSpeeds(const btAlignedObjectArray<btRigidBody*>& nonStaticBodies)
{
	m_speedOfObject.resizeNoInitialize(m_hybridOfObject.size());
	for (int i = 0; i < m_speedOfObject.size(); i++)
		m_speedOfObject[i] = 0;
	m_topSpeed = 0;
	for (int i = 0; i < nonStaticBodies.size(); i++)
	{
		const btScalar speed = fastestPoint(nonStaticBodies[i]);
		m_speedOfObject[nonStaticBodies[i]->getWorldArrayIndex()] = speed;
		m_topSpeed = btMax(m_topSpeed, speed);
	}
}

void btHybridNeighbourhood::collectPairs(btBroadphasePairArray& pairs, int numHybrids)
{
	m_firstPair.resizeNoInitialize(numHybrids + 1);
	for (int i = 0; i < m_firstPair.size(); i++)
		m_firstPair[i] = 0;
	for (int i = 0; i < pairs.size(); i++)
	{
		const int owners[2] = {hybridOf(pairs[i].m_pProxy0), hybridOf(pairs[i].m_pProxy1)};
		for (int k = 0; k < 2; k++)
			if (owners[k] >= 0)
				m_firstPair[owners[k]]++;
	}
	for (int i = 1; i < m_firstPair.size(); i++)
		m_firstPair[i] += m_firstPair[i - 1];
	// Filling from the back turns each count into the start of its run.
	m_pairs.resizeNoInitialize(m_firstPair[numHybrids]);
	for (int i = pairs.size() - 1; i >= 0; i--)
	{
		const int owners[2] = {hybridOf(pairs[i].m_pProxy0), hybridOf(pairs[i].m_pProxy1)};
		for (int k = 0; k < 2; k++)
			if (owners[k] >= 0)
				m_pairs[--m_firstPair[owners[k]]] = &pairs[i];
	}
}

namespace
{
// Looks for a moving body that could reach a hybrid's bounds within the proximity steps. The margin is the
// pair's, so that m > v_max * dt holds for it (report, section 6.3.1) and one fast body widens no other pair.
struct NeighbourSearch : public btBroadphaseAabbCallback
{
	const btBroadphaseProxy* m_self;
	const btAlignedObjectArray<btScalar>& m_speeds;
	btScalar m_seconds;
	btScalar m_ownSpeed;
	bool m_found;

	NeighbourSearch(const btBroadphaseProxy* self, const btAlignedObjectArray<btScalar>& speeds, btScalar seconds,
	                btScalar ownSpeed)
	    : m_self(self), m_speeds(speeds), m_seconds(seconds), m_ownSpeed(ownSpeed), m_found(false)
	{
	}

	virtual bool process(const btBroadphaseProxy* other)
	{
		if (m_found || other == m_self || !mayCollide(other))
			return true;
		const btCollisionObject* object = static_cast<const btCollisionObject*>(other->m_clientObject);
		if (object->isStaticObject())
			return true;
		const btScalar margin = m_seconds * (m_ownSpeed + m_speeds[object->getWorldArrayIndex()]);
		const btVector3 wide(margin, margin, margin);
		m_found = TestAabbAgainstAabb2(m_self->m_aabbMin - wide, m_self->m_aabbMax + wide, other->m_aabbMin,
		                               other->m_aabbMax);
		return true;
	}

	bool mayCollide(const btBroadphaseProxy* other) const
	{
		return (m_self->m_collisionFilterGroup & other->m_collisionFilterMask) &&
		       (other->m_collisionFilterGroup & m_self->m_collisionFilterMask);
	}
};
}  // namespace

bool btHybridNeighbourhood::hasMovingNeighbour(const btHybridRigidBody* body, int hybrid, btScalar seconds,
                                               btBroadphaseInterface* broadphase) const
{
	const btBroadphaseProxy* proxy = body->getBroadphaseProxy();
	NeighbourSearch search(proxy, m_speedOfObject, seconds, m_speedOfObject[body->getWorldArrayIndex()]);
	for (int i = 0; i < getNumPairs(hybrid) && !search.m_found; i++)
	{
		const btBroadphasePair* pair = getPair(hybrid, i);
		search.process(pair->m_pProxy0 == proxy ? pair->m_pProxy1 : pair->m_pProxy0);
	}
	if (search.m_found)
		return true;
	// Only a body without overlapping pairs, of which an overload has few, pays for a look around.
	const btScalar margin = seconds * (search.m_ownSpeed + m_topSpeed);
	const btVector3 wide(margin, margin, margin);
	broadphase->aabbTest(proxy->m_aabbMin - wide, proxy->m_aabbMax + wide, search);
	return search.m_found;
}
