#ifndef BT_HYBRID_PLAIN_STEPS_H
#define BT_HYBRID_PLAIN_STEPS_H

class btCollisionAlgorithm;
class btCollisionDispatcher;
struct btBroadphasePair;
struct btDispatcherInfo;
struct btHybridAhead;

/// Steps of pairs without lists of convex parts, of which Bullet's own algorithms reach for nothing but the pair's two
/// objects and its manifold: any thread may make them, for the same bits. Those of two boxes are such, which walls,
/// stacks and debris are made of. Others ask detectors that count in global variables, or make manifolds as they go.
struct btHybridPlainSteps
{
	static bool isAmong(const btCollisionAlgorithm& algorithm);

	/// Whether a step is going to come, and nothing that a program has set hears of it. On the caller's thread: a
	/// program's own dispatcher or objects may be asked.
	static bool mayMake(const btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btHybridAhead& ahead);

	/// As btCollisionDispatcher::defaultNearCallback does. Any number of pairs at once.
	static void make(const btBroadphasePair& pair, const btDispatcherInfo& info);
};

#endif  // BT_HYBRID_PLAIN_STEPS_H
