#ifndef BT_HYBRID_FORESIGHT_H
#define BT_HYBRID_FORESIGHT_H

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include <memory>
#include <mutex>
#include <vector>

#include "btHybridAlgorithm.h"
#include "btHybridStepMemory.h"
#include "btHybridThreads.h"

class btCollisionDispatcher;
struct btDispatcherInfo;
class btHybridNarrowphase;
class btHybridPlanner;
class btOverlappingPairCache;
struct btBroadphasePair;

/// Makes on several threads, before the pairs of a step are dispatched, the steps of those that need nothing of Bullet
/// but manifolds, and those that are Bullet's own on any thread; of others, it finds out the neighbours and distances
/// of their parts. What Bullet is asked or told stays on the caller's thread, in today's order, and results are the
/// same bits for any number of threads.
class btHybridForesight
{
	std::shared_ptr<btHybridThreads> m_threads;
	const btBroadphasePair* m_overlaps;                     ///< of the step
	std::vector<const btCollisionAlgorithm*> m_algorithms;  ///< of those, in Bullet's order
	std::vector<btHybridAlgorithm*> m_pairs;                ///< that are ours; 0 where nothing is ours to be foreseen
	std::vector<btHybridForeseen>
	    m_foreseen;              ///< of each, side by side: most need no look at the pair when their turn comes
	btHybridPlanner* m_planner;  ///< of the step
	std::vector<int> m_atOnce;   ///< places of pairs that are foreseen before the first has its turn
	std::vector<std::vector<int>> m_portions;  ///< places of those of each portion
	btHybridAhead m_ahead;
	int m_promises;  ///< of the program, see btHybridPromises
	std::mutex m_mutex;
	std::vector<std::unique_ptr<btHybridStepMemory>> m_memories;
	std::vector<btHybridStepMemory*> m_free;
	int m_pause;         ///< steps in which nothing is to be foreseen
	bool m_takesPlain;   ///< pairs that are not ours may be done before their turn
	bool m_isExpecting;  ///< the next step is likely to share its pairs, as the last one did

	btHybridForesight(const btHybridForesight&);
	btHybridForesight& operator=(const btHybridForesight&);

	template <class Work>
	void forEachBlock(int count, const Work& work) const;
	void choose(int first, int last, const btHybridNarrowphase& narrowphase);
	void chooseOne(size_t place, const btHybridNarrowphase& narrowphase);
	bool follow(size_t place, btCollisionDispatcher* dispatcher) const;
	void follow(btCollisionDispatcher* dispatcher);
	void beginPortions();
	void addPlace(size_t place);
	void foresee(const std::vector<int>& places);
	void foresee(const std::vector<int>& places, int first, int last);
	void foresee(size_t place, btHybridStepMemory& memory);
	void foreseePortionOf(size_t place);
	void lookAhead(const std::vector<int>& places, int index, int first, int last) const;
	bool isTaken(size_t place) const;
	btHybridStepMemory* borrow();
	void giveBack(btHybridStepMemory* memory);

public:
	btHybridForesight()
	    : m_threads(new btHybridThreads),
	      m_overlaps(0),
	      m_planner(0),
	      m_promises(0),
	      m_pause(0),
	      m_takesPlain(false),
	      m_isExpecting(false)
	{
	}

	/// Which a solver may use as well.
	const std::shared_ptr<btHybridThreads>& getThreads() const
	{
		return m_threads;
	}

	void setPromises(int promises)
	{
		m_promises = promises;
	}
	int getPromises() const
	{
		return m_promises;
	}

	/// Early in a step, before anything that takes a while. Threads are woken only for what is likely to come: woken
	/// in every step, two made one of a scene without detailed bodies 1.09 times as long (`bench/in_turn --scene
	/// quiet-12.toml --worlds finest,finest@2threads`, a file of `scatter families`).
	void expect() const
	{
		if (m_isExpecting)
			m_threads->expectWork();
	}

	/// Around the dispatch of a step's pairs, which `overlaps` has.
	void begin(btHybridNarrowphase& narrowphase, btCollisionDispatcher* dispatcher, btOverlappingPairCache& overlaps,
	           const btDispatcherInfo& info);
	void end(btHybridNarrowphase& narrowphase);

	/// Whether something has been found out about the pairs of the step under way.
	bool isAtWork() const
	{
		return !m_pairs.empty();
	}

	/// The turn of a pair has come, which was at `place` among the step's. Whether its step has been made already, or
	/// its bodies are known to stay apart: it is done then. `algorithm` may be anyone's.
	bool passBy(size_t place, const btCollisionAlgorithm* algorithm)
	{
		if (place >= m_algorithms.size() || m_algorithms[place] != algorithm)
			return false;
		if (m_foreseen[place].m_kind == btHybridForeseen::LATER)
			foreseePortionOf(place);
		if (m_foreseen[place].m_kind < btHybridForeseen::QUIET)
			return false;
		const btHybridForeseen foreseen = m_foreseen[place];
		m_foreseen[place] = btHybridForeseen::NOTHING;
		if (foreseen.m_kind != btHybridForeseen::DONE)
			m_pairs[place]->takeForeseen(foreseen);
		return true;
	}

	/// Fetches memory that passBy() is going to need for the pairs after `place`.
	void fetchAfter(size_t place) const;

	/// Of a pair that goes.
	void forget(btHybridAlgorithm* pair);
};

#endif  // BT_HYBRID_FORESIGHT_H
