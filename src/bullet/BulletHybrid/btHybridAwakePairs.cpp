#include "btHybridAwakePairs.h"

#include <typeinfo>

#include "btHybridPairAlgorithm.h"

namespace
{
// Pairs ahead whose memory is fetched, in the order in which it is needed: time for one to come.
const ptrdiff_t c_algorithmsAhead = 8;
const ptrdiff_t c_pairsAhead = 4;

/// Hands on the pairs that need something of Bullet.
class AwakeOverlaps : public btOverlapCallback
{
	btOverlapCallback* m_callback;
	const btOverlappingPairCache* m_pairs;

	static btHybridPairAlgorithm* algorithmOf(const btBroadphasePair& pair)
	{
		const bool isOurs = pair.m_algorithm && typeid(*pair.m_algorithm) == typeid(btHybridPairAlgorithm);
		return isOurs ? static_cast<btHybridPairAlgorithm*>(pair.m_algorithm) : 0;
	}

	// A pair that has begun in this step may have moved the array, and pairs may come in another order.
	void fetchAhead(const btBroadphasePair& pair) const
	{
#if defined(__GNUC__)
		const btBroadphasePair* first = m_pairs->getOverlappingPairArrayPtr();
		const ptrdiff_t left = first + m_pairs->getNumOverlappingPairs() - &pair;
		if (&pair < first || left <= c_algorithmsAhead)
			return;
		__builtin_prefetch((&pair)[c_algorithmsAhead].m_algorithm);
		if (btHybridPairAlgorithm* next = algorithmOf((&pair)[c_pairsAhead]))
			next->fetchNext();
#else
		(void)pair;
#endif
	}

public:
	AwakeOverlaps(btOverlapCallback* callback, const btOverlappingPairCache* pairs)
	    : m_callback(callback), m_pairs(pairs)
	{
	}
	virtual bool processOverlap(btBroadphasePair& pair)
	{
		fetchAhead(pair);
		btHybridPairAlgorithm* algorithm = algorithmOf(pair);
		return !(algorithm && algorithm->passBy()) && m_callback->processOverlap(pair);
	}
};
}  // namespace

void btHybridAwakePairs::processAllOverlappingPairs(btOverlapCallback* callback, btDispatcher* dispatcher)
{
	AwakeOverlaps awake(callback, m_pairs);
	m_pairs->processAllOverlappingPairs(&awake, dispatcher);
}

void btHybridAwakePairs::processAllOverlappingPairs(btOverlapCallback* callback, btDispatcher* dispatcher,
                                                    const btDispatcherInfo& info)
{
	AwakeOverlaps awake(callback, m_pairs);
	m_pairs->processAllOverlappingPairs(&awake, dispatcher, info);
}
