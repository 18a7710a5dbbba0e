#ifndef BT_HYBRID_SILENCE_H
#define BT_HYBRID_SILENCE_H

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

/// While it lives Bullet's global contact callbacks, which are the user's, are away, and contacts are combined as
/// Bullet does by itself. Not those that choose child pairs: they decide what collides.
class btHybridSilence
{
	ContactAddedCallback m_added;
	ContactProcessedCallback m_processed;
	ContactDestroyedCallback m_destroyed;
	ContactStartedCallback m_started;
	ContactEndedCallback m_ended;
	CalculateCombinedCallback m_combiners[6];

	btHybridSilence(const btHybridSilence&);
	btHybridSilence& operator=(const btHybridSilence&);

public:
	btHybridSilence();
	~btHybridSilence();
};

#endif  // BT_HYBRID_SILENCE_H
