#ifndef BT_HYBRID_AHEAD_ENGINE_H
#define BT_HYBRID_AHEAD_ENGINE_H

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>

#include <utility>
#include <vector>

#include "btHybridStepMemory.h"

class btCollisionDispatcher;
class btDispatcher;

/// Bullet, as a pair sees it whose step is made ahead, on any thread: the dispatcher is told later of manifolds that
/// are new and of those that are released. `Engine` is what the pair sees otherwise.
template <class Engine>
class btHybridAheadEngine : public Engine
{
	btHybridStepMemory& m_memory;
	std::vector<scatter::pairs::ManifoldNote>& m_notes;

public:
	/// The rest is for the engine. All must outlive it.
	template <class... Rest>
	btHybridAheadEngine(btHybridStepMemory& memory, std::vector<scatter::pairs::ManifoldNote>& notes, Rest&&... rest)
	    : Engine(std::forward<Rest>(rest)...), m_memory(memory), m_notes(notes)
	{
	}

	virtual void* newManifold()
	{
		const btCollisionObject* objects[2] = {this->m_wraps[0]->getCollisionObject(),
		                                       this->m_wraps[1]->getCollisionObject()};
		const scatter::pairs::ManifoldNote note = {m_memory.standIn(objects[0], objects[1], this->threshold()), true};
		m_notes.push_back(note);
		return note.manifold;
	}
	virtual void release(void* manifold)
	{
		const scatter::pairs::ManifoldNote note = {manifold, false};
		m_notes.push_back(note);
	}
};

/// Tells the dispatcher of the manifolds of a step that was made ahead.
class btHybridAdoption
{
	struct Adopted
	{
		const void* m_standIn;
		btPersistentManifold* m_manifold;
	};
	std::vector<Adopted> m_adopted;

public:
	/// Of two objects, in the order of their manifolds.
	btHybridAdoption(btDispatcher* dispatcher, const btCollisionObject* a, const btCollisionObject* b,
	                 const std::vector<scatter::pairs::ManifoldNote>& notes);

	bool empty() const
	{
		return m_adopted.empty();
	}

	/// The manifold for which another stood in, or this itself.
	btPersistentManifold* find(void* manifold) const;
};

/// Tells the dispatcher of the manifolds of a pair's step that was made ahead, and gives the pair those for which
/// others stood in.
template <class Pair>
void btHybridAdopt(Pair& pair, const std::vector<scatter::pairs::ManifoldNote>& notes, btDispatcher* dispatcher,
                   const btCollisionObject* a, const btCollisionObject* b)
{
	const btHybridAdoption adoption(dispatcher, a, b, notes);
	if (!adoption.empty())
		pair.forEachContact([&adoption](void*& manifold) { manifold = adoption.find(manifold); });
}

/// When steps may be made ahead.
struct btHybridAheadRules
{
	/// Whether every pair's turn is going to come; `promises` of btHybridPromises.
	static bool isDispatchSure(const btCollisionDispatcher* dispatcher, const btDispatcherInfo& info, int promises);

	/// Whether nothing that a program has set would be called on the wrong thread, or at the wrong time, by steps that
	/// are made ahead. With mayAdd(), of all objects; else of those that let no callback hear of new contacts.
	static bool mayStep();
	static bool mayAdd(int promises);
	static bool mayStep(const btHybridAhead& ahead, const btCollisionObject* a, const btCollisionObject* b);
};

#endif  // BT_HYBRID_AHEAD_ENGINE_H
