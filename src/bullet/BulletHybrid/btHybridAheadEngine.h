#ifndef BT_HYBRID_AHEAD_ENGINE_H
#define BT_HYBRID_AHEAD_ENGINE_H

#include "btHybridPairEngine.h"
#include "btHybridStepMemory.h"

/// Bullet, as a pair sees it whose step is made ahead, on any thread: the dispatcher is told later of manifolds that are new and
/// of those that are released.
class btHybridAheadEngine : public btHybridPairEngine
{
	btHybridStepMemory& m_memory;
	std::vector<scatter::pairs::ManifoldNote>& m_notes;

public:
	/// As of btHybridPairEngine; what is added must outlive it, too.
	btHybridAheadEngine(btCollisionDispatcher* dispatcher, btHybridObjects& objects, btHybridPairBodies& bodies, const btHybridPairCall& call, btHybridFallback& fallback, bool ownGjk, bool switches, btHybridStepMemory& memory, std::vector<scatter::pairs::ManifoldNote>& notes)
	    : btHybridPairEngine(dispatcher, objects, bodies, call, fallback, ownGjk, switches), m_memory(memory), m_notes(notes)
	{
	}

	virtual void* newManifold();
	virtual void release(void* manifold);

	/// Whether every pair's turn is going to come; `promises` of btHybridPromises.
	static bool isDispatchSure(const btCollisionDispatcher* dispatcher, const btDispatcherInfo& info, int promises);

	/// Whether nothing that a program has set would be called on the wrong thread, or at the wrong time, by steps that are made ahead. With
	/// mayAdd(), of all objects; else of those that let no callback hear of new contacts.
	static bool mayStep();
	static bool mayAdd(int promises);
	static bool hearsOfNew(const btCollisionObject* object);

	/// Tells the dispatcher, and gives the child pairs the manifolds for which others stood in.
	static void tell(btDispatcher* dispatcher, const btCollisionObject* a, const btCollisionObject* b, scatter::pairs::Pair& pair);
};

#endif  // BT_HYBRID_AHEAD_ENGINE_H
