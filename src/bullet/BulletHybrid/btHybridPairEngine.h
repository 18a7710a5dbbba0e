#ifndef BT_HYBRID_PAIR_ENGINE_H
#define BT_HYBRID_PAIR_ENGINE_H

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <optional>

#include "btHybridFallback.h"
#include "btHybridLevelBodies.h"
#include "btHybridManifolds.h"
#include "btHybridObjects.h"
#include "btHybridPartBody.h"
#include "pairs/pair_engine.h"

/// The two objects of a pair, with the shapes of the level that the pair has looked at last.
struct btHybridPairBodies
{
	btHybridLevelBodies* m_objects[2];
	btHybridPartBody* m_bodies[2];
	int m_level;

	/// No level yet: that is for take() to say.
	btHybridPairBodies(btHybridLevelBodies* object0, btHybridLevelBodies* object1)
	    : m_objects{object0, object1}, m_bodies{0, 0}, m_level(-1)
	{
	}

	void take(int level, btHybridObjects& objects);
};

/// What one call of processCollision was given.
struct btHybridPairCall
{
	const btCollisionObjectWrapper* m_wraps[2];
	const btDispatcherInfo& m_info;
	btManifoldResult* m_result;
};

/// Bullet, as a pair sees it in one step: wrappers in, manifolds out.
class btHybridPairEngine : public btHybridManifolds<scatter::pairs::PairEngine>
{
	/// Shows a manifold result, and what is called with it, the shapes of the pair's level in the place of the finest
	/// ones, for as long as it lives.
	class LevelScope
	{
		btManifoldResult* m_result;
		const btCollisionObjectWrapper* m_before[2];
		btCollisionObjectWrapper m_levels[2];

	public:
		LevelScope(const btHybridPairCall& call, const btHybridPairBodies& bodies);
		~LevelScope();

		const btCollisionObjectWrapper* getWrap(int body) const
		{
			return &m_levels[body];
		}
	};

	btHybridObjects& m_objects;
	btHybridPairBodies& m_bodies;
	const btHybridPairCall& m_call;
	btHybridFallback& m_fallback;
	bool m_ownGjk;
	bool m_switches;
	std::optional<LevelScope> m_scope;  ///< of the bodies that are placed, once their contacts are looked for

	const btCollisionObjectWrapper* getWrap(int body);
	const scatter::PartList::Part& getPart(int body, int part) const;
	const btCollisionShape* getShapeNow(int body) const;
	bool isOdd(int body, int part) const;
	bool looksFromB(const scatter::ChildPair& child) const;
	bool areSpheres(const scatter::ChildPair& child) const;
	btHybridPartBody* getBody(int body, int level);
	btPersistentManifold* manifoldOf(scatter::ChildPair& child);
	void detectByGjk(scatter::PartPair& parts, scatter::ChildPair& child);
	void detectByAlgorithm(scatter::ChildPair& child);

public:
	/// switches: the pair has a level, so that the bodies' shapes are not those of the call. All must outlive it.
	btHybridPairEngine(btCollisionDispatcher* dispatcher, btHybridObjects& objects, btHybridPairBodies& bodies,
	                   const btHybridPairCall& call, btHybridFallback& fallback, bool ownGjk, bool switches)
	    : btHybridManifolds(dispatcher, call.m_wraps[0], call.m_wraps[1]),
	      m_objects(objects),
	      m_bodies(bodies),
	      m_call(call),
	      m_fallback(fallback),
	      m_ownGjk(ownGjk),
	      m_switches(switches)
	{
	}

	/// Where the bodies are, with the shapes that they have been placed with last; no contacts are going to be looked
	/// for.
	bool follow(scatter::pairs::PlacedBodies& bodies);

	virtual bool place(int level, scatter::pairs::PlacedBodies& bodies);
	virtual std::optional<std::array<int, 2>> versionsAt(int level);
	virtual const scatter::PartList& partsOf(int body, int level);
	virtual scatter::Frame frameOf(int body) const;
	virtual float pointDistance() const;
	virtual void fallBack();

	virtual void add(scatter::ChildPair& child, const scatter::PartContact& contact);
	virtual void detect(scatter::PartPair& parts, scatter::ChildPair& child);
	virtual bool letsThrough(const scatter::ChildPair& child) const;
	virtual bool mayBegin(const scatter::ChildPair& child) const;
	virtual bool overlooks(const scatter::ChildPair& child) const;
	virtual void looked(const scatter::ChildPair& child);
};

#endif  // BT_HYBRID_PAIR_ENGINE_H
