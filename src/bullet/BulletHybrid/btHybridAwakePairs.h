#ifndef BT_HYBRID_AWAKE_PAIRS_H
#define BT_HYBRID_AWAKE_PAIRS_H

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

class btHybridForesight;

/// The overlapping pairs of a world as its dispatcher sees them, without those that need nothing of it: whose bodies
/// the pair algorithm proves to be apart, in a pile three quarters, and those whose step has been made already. Bullet
/// takes longer to get to them than they take. For dispatchers whose near callback is Bullet's: no other could tell.
/// All else is the pair cache's own.
class btHybridAwakePairs : public btOverlappingPairCache
{
	btOverlappingPairCache* m_pairs;
	btHybridForesight* m_foresight;

	btHybridAwakePairs(const btHybridAwakePairs&);
	btHybridAwakePairs& operator=(const btHybridAwakePairs&);

public:
	/// Both must outlive it.
	btHybridAwakePairs(btOverlappingPairCache* pairs, btHybridForesight* foresight)
	    : m_pairs(pairs), m_foresight(foresight)
	{
	}

	virtual void processAllOverlappingPairs(btOverlapCallback* callback, btDispatcher* dispatcher);
	virtual void processAllOverlappingPairs(btOverlapCallback* callback, btDispatcher* dispatcher,
	                                        const btDispatcherInfo& info);

	virtual btBroadphasePair* getOverlappingPairArrayPtr()
	{
		return m_pairs->getOverlappingPairArrayPtr();
	}
	virtual const btBroadphasePair* getOverlappingPairArrayPtr() const
	{
		return m_pairs->getOverlappingPairArrayPtr();
	}
	virtual btBroadphasePairArray& getOverlappingPairArray()
	{
		return m_pairs->getOverlappingPairArray();
	}
	virtual int getNumOverlappingPairs() const
	{
		return m_pairs->getNumOverlappingPairs();
	}
	virtual btBroadphasePair* findPair(btBroadphaseProxy* proxy0, btBroadphaseProxy* proxy1)
	{
		return m_pairs->findPair(proxy0, proxy1);
	}
	virtual btBroadphasePair* addOverlappingPair(btBroadphaseProxy* proxy0, btBroadphaseProxy* proxy1)
	{
		return m_pairs->addOverlappingPair(proxy0, proxy1);
	}
	virtual void* removeOverlappingPair(btBroadphaseProxy* proxy0, btBroadphaseProxy* proxy1, btDispatcher* dispatcher)
	{
		return m_pairs->removeOverlappingPair(proxy0, proxy1, dispatcher);
	}
	virtual void removeOverlappingPairsContainingProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher)
	{
		m_pairs->removeOverlappingPairsContainingProxy(proxy, dispatcher);
	}
	virtual void cleanOverlappingPair(btBroadphasePair& pair, btDispatcher* dispatcher)
	{
		m_pairs->cleanOverlappingPair(pair, dispatcher);
	}
	virtual void cleanProxyFromPairs(btBroadphaseProxy* proxy, btDispatcher* dispatcher)
	{
		m_pairs->cleanProxyFromPairs(proxy, dispatcher);
	}
	virtual bool needsBroadphaseCollision(btBroadphaseProxy* proxy0, btBroadphaseProxy* proxy1) const
	{
		return m_pairs->needsBroadphaseCollision(proxy0, proxy1);
	}
	virtual btOverlapFilterCallback* getOverlapFilterCallback()
	{
		return m_pairs->getOverlapFilterCallback();
	}
	virtual void setOverlapFilterCallback(btOverlapFilterCallback* callback)
	{
		m_pairs->setOverlapFilterCallback(callback);
	}
	virtual bool hasDeferredRemoval()
	{
		return m_pairs->hasDeferredRemoval();
	}
	virtual void setInternalGhostPairCallback(btOverlappingPairCallback* callback)
	{
		m_pairs->setInternalGhostPairCallback(callback);
	}
	virtual void sortOverlappingPairs(btDispatcher* dispatcher)
	{
		m_pairs->sortOverlappingPairs(dispatcher);
	}
};

#endif  // BT_HYBRID_AWAKE_PAIRS_H
