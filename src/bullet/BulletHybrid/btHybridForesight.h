#ifndef BT_HYBRID_FORESIGHT_H
#define BT_HYBRID_FORESIGHT_H

#include <memory>
#include <mutex>
#include <vector>

#include "btHybridStepMemory.h"
#include "parallel/thread_pool.h"

class btCollisionDispatcher;
struct btDispatcherInfo;
class btHybridNarrowphase;
class btHybridAlgorithm;
class btITaskScheduler;

/// Makes on several threads, before the pairs of a step are dispatched, the steps of those that need nothing of Bullet
/// but manifolds; of others, it finds out the neighbours and distances of their parts. What Bullet is asked or told
/// stays on the caller's thread, in today's order, and results are the same bits for any number of threads.
class btHybridForesight
{
	int m_numThreads;
	std::unique_ptr<scatter::parallel::ThreadPool> m_threads;
	btITaskScheduler* m_scheduler;
	std::vector<btHybridAlgorithm*> m_pairs;  ///< of the step
	std::vector<char> m_chosen;
	btHybridAhead m_ahead;
	int m_promises;  ///< of the program, see btHybridPromises
	std::mutex m_mutex;
	std::vector<std::unique_ptr<btHybridStepMemory>> m_memories;
	std::vector<btHybridStepMemory*> m_free;
	int m_pause;  ///< steps in which nothing is to be foreseen

	btHybridForesight(const btHybridForesight&);
	btHybridForesight& operator=(const btHybridForesight&);

	template <class Work>
	void forEachBlock(int count, const Work& work);
	void lookAhead(int index, int first, int last) const;
	btHybridStepMemory* borrow();
	void giveBack(btHybridStepMemory* memory);

public:
	btHybridForesight()
	    : m_numThreads(1), m_scheduler(0), m_promises(0), m_pause(0)
	{
	}

	/// 1: none of its own; nor are there any on a machine of one core.
	void setNumThreads(int threads);
	int getNumThreads() const
	{
		return m_numThreads;
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

	void setPromises(int promises)
	{
		m_promises = promises;
	}
	int getPromises() const
	{
		return m_promises;
	}

	/// Around the dispatch of a step's pairs.
	void begin(btHybridNarrowphase& narrowphase, btCollisionDispatcher* dispatcher, const btDispatcherInfo& info);
	void end();

	/// Of a pair that is gone.
	void forget(const btHybridAlgorithm* pair);
};

#endif  // BT_HYBRID_FORESIGHT_H
