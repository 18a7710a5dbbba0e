#ifndef BT_HYBRID_NARROWPHASE_H
#define BT_HYBRID_NARROWPHASE_H

#include "BulletHybrid/btHybridCollision.h"

class btCollisionConfiguration;
class btDispatcher;

/// Registers the pair algorithm with a dispatcher and holds what its pairs share.
class btHybridNarrowphase
{
	btHybridCollisionInfo m_info;
	btHybridCollisionCounts m_counts;

public:
	btHybridNarrowphase(btDispatcher* dispatcher, btCollisionConfiguration* configuration)
	{
		(void)dispatcher;
		(void)configuration;
	}

	const btHybridCollisionInfo& getInfo() const
	{
		return m_info;
	}
	void setInfo(const btHybridCollisionInfo& info)
	{
		m_info = info;
	}

	void beginStep()
	{
		m_counts = btHybridCollisionCounts();
	}

	const btHybridCollisionCounts& getCounts() const
	{
		return m_counts;
	}
	btHybridCollisionMemory getMemory() const
	{
		return btHybridCollisionMemory();
	}
};

#endif  // BT_HYBRID_NARROWPHASE_H
