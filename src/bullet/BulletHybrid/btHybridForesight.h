#ifndef BT_HYBRID_FORESIGHT_H
#define BT_HYBRID_FORESIGHT_H

#include <memory>
#include <mutex>
#include <vector>

#include "pairs/foresee.h"
#include "parallel/thread_pool.h"

class btDispatcher;
class btHybridNarrowphase;
class btHybridAlgorithm;
class btITaskScheduler;

/// Finds out on several threads, before the pairs of a step are dispatched, what of them needs nothing of Bullet:
/// which stay quiet, and of the others the neighbours and distances of their parts. All that Bullet is asked or
/// told stays on the caller's thread, in today's order, and results are the same bits for any number of threads.
class btHybridForesight
{
	std::unique_ptr<scatter::parallel::ThreadPool> m_threads;
	btITaskScheduler* m_scheduler;
	std::vector<btHybridAlgorithm*> m_pairs;  ///< of the step
	std::vector<char> m_chosen;
	scatter::pairs::BoundsLocks m_locks;
	std::mutex m_mutex;
	std::vector<std::unique_ptr<scatter::pairs::ForesightScratch>> m_scratches;
	std::vector<scatter::pairs::ForesightScratch*> m_free;
	int m_pause;  ///< steps in which nothing is to be foreseen

	btHybridForesight(const btHybridForesight&);
	btHybridForesight& operator=(const btHybridForesight&);

	template <class Work>
	void forEachBlock(int count, const Work& work);
	scatter::pairs::ForesightScratch* borrow();
	void giveBack(scatter::pairs::ForesightScratch* scratch);

public:
	btHybridForesight()
	    : m_scheduler(0), m_pause(0)
	{
	}

	/// 1: none of its own.
	void setNumThreads(int threads);
	int getNumThreads() const
	{
		return m_threads ? m_threads->threads() : 1;
	}

	/// Threads of a program's own, in the place of ours; 0: none.
	void setScheduler(btITaskScheduler* scheduler)
	{
		m_scheduler = scheduler;
	}
	btITaskScheduler* getScheduler() const
	{
		return m_scheduler;
	}

	/// Around the dispatch of a step's pairs.
	void begin(btHybridNarrowphase& narrowphase, btDispatcher* dispatcher);
	void end();

	/// Of a pair that is gone.
	void forget(const btHybridAlgorithm* pair);
};

#endif  // BT_HYBRID_FORESIGHT_H
