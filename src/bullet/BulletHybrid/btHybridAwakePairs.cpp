#include "btHybridAwakePairs.h"

#include "btHybridForesight.h"

namespace
{
/// Hands on the pairs that need something of Bullet.
class AwakeOverlaps : public btOverlapCallback
{
	btOverlapCallback* m_callback;
	const btOverlappingPairCache* m_pairs;
	btHybridForesight* m_foresight;

public:
	AwakeOverlaps(btOverlapCallback* callback, const btOverlappingPairCache* pairs, btHybridForesight* foresight)
	    : m_callback(callback), m_pairs(pairs), m_foresight(foresight)
	{
	}
	// A pair that has begun or ended in this step may have moved the array: the foresight sees by the algorithm.
	virtual bool processOverlap(btBroadphasePair& pair)
	{
		const size_t place = &pair - m_pairs->getOverlappingPairArrayPtr();
		m_foresight->fetchAfter(place);
		return !m_foresight->passBy(place, pair.m_algorithm) && m_callback->processOverlap(pair);
	}
};
}  // namespace

void btHybridAwakePairs::processAllOverlappingPairs(btOverlapCallback* callback, btDispatcher* dispatcher)
{
	AwakeOverlaps awake(callback, m_pairs, m_foresight);
	m_pairs->processAllOverlappingPairs(&awake, dispatcher);
}

void btHybridAwakePairs::processAllOverlappingPairs(btOverlapCallback* callback, btDispatcher* dispatcher,
                                                    const btDispatcherInfo& info)
{
	AwakeOverlaps awake(callback, m_pairs, m_foresight);
	m_pairs->processAllOverlappingPairs(&awake, dispatcher, info);
}
