#ifndef BT_HYBRID_PARALLEL_WORLD_H
#define BT_HYBRID_PARALLEL_WORLD_H

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <LinearMath/btHashMap.h>

class btHybridAlgorithm;
class btHybridPlanner;

/// A pair of convex children of two bodies of a world, ordered as their proxies in the broadphase.
struct btHybridChildKey
{
	const btCollisionObject* m_bodies[2];
	int m_numbers[2];   ///< of their proxies; they tell bodies apart even if those are gone
	int m_children[2];  ///< -1 for a bare shape

	btHybridChildKey()
	{
	}
	btHybridChildKey(const btCollisionObject* body0, const btCollisionObject* body1, int child0, int child1);
	static bool less(const btHybridChildKey& a, const btHybridChildKey& b);
};

/// A child pair and its contacts in a world.
struct btHybridChildManifold
{
	btHybridChildKey m_key;
	btPersistentManifold* m_manifold;
	bool m_swapped;  ///< the manifold has the key's second body first

	btHybridChildManifold()
	{
	}
	btHybridChildManifold(btPersistentManifold* manifold, const btCollisionObject* body0,
	                      const btCollisionObject* body1, int child0, int child1)
	    : m_key(body0, body1, child0, child1), m_manifold(manifold), m_swapped(m_key.m_bodies[0] != body0)
	{
	}

	static bool less(const btHybridChildManifold& a, const btHybridChildManifold& b)
	{
		return btHybridChildKey::less(a.m_key, b.m_key);
	}

	/// Of an array that is sorted; 0 if it is not there.
	static const btHybridChildManifold* find(const btAlignedObjectArray<btHybridChildManifold>& sorted,
	                                         const btHybridChildKey& key);
};

/// A plain Bullet collision world beside a hybrid one: stand-ins of all its objects, with their shapes and where they
/// are, and a broadphase, a dispatcher, a narrowphase and manifolds that are Bullet's own. No hybrid body knows of it.
/// Global contact callbacks must be silent while it is at work; see btHybridSilence.
class btHybridParallelWorld
{
	class Configuration;
	class Dispatcher;
	class Filter;
	class Result;
	class StandIn;

	btCollisionWorld* m_original;
	const btHybridPlanner* m_planner;
	Configuration* m_configuration;
	Dispatcher* m_dispatcher;
	btBroadphaseInterface* m_broadphase;
	Filter* m_filter;
	btCollisionWorld* m_world;
	btHashMap<btHashPtr, StandIn*> m_standIns;
	int m_step;

	btHybridParallelWorld(const btHybridParallelWorld&);
	btHybridParallelWorld& operator=(const btHybridParallelWorld&);

	void remove(StandIn* standIn);
	void cleanPairs();
	const btBroadphasePair* findPair(const btCollisionObject* a, const btCollisionObject* b) const;
	const btHybridAlgorithm* findAlgorithm(const btCollisionObject* a, const btCollisionObject* b) const;
	static void collide(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info);

public:
	/// What the original has done with a pair in its last step.
	enum Fate
	{
		LEFT_ALONE,       ///< not with a hybrid, or the dispatcher does not let them collide
		AT_COARSER,       ///< it is not at its finest level
		HAS_OTHERS,       ///< it has contacts on purpose that no look at its shapes would find
		LOOKED_AT_FINEST  ///< or has no pair, though it might need one
	};

	/// The world must outlive it.
	explicit btHybridParallelWorld(btCollisionWorld* original);
	~btHybridParallelWorld();

	/// Takes in objects, shapes and places. Objects that have left the original are not asked for anything, and may be
	/// gone.
	void follow();

	/// After a narrowphase of the original: Bullet's step of collision detection, for the pairs that it has looked at
	/// at their finest level. Nothing must have changed since follow().
	void step();

	Fate getFate(const btCollisionObject* a, const btCollisionObject* b) const;

	/// Of the original's pairs, for getFate() from now on; 0 in body switching.
	void setPlanner(const btHybridPlanner* planner)
	{
		m_planner = planner;
	}

	/// The manifolds of all child pairs that Bullet's midphase let through, with contacts or without; sorted, and
	/// named by the objects of the original.
	void getManifolds(btAlignedObjectArray<btHybridChildManifold>& manifolds) const;
};

#endif  // BT_HYBRID_PARALLEL_WORLD_H
