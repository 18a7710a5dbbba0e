#ifndef BT_HYBRID_THREADS_H
#define BT_HYBRID_THREADS_H

#include <LinearMath/btThreads.h>

#include <memory>

#include "parallel/thread_pool.h"

/// Threads that share a piece of work: of their own, or a program's.
class btHybridThreads
{
	int m_numThreads;
	std::unique_ptr<scatter::parallel::ThreadPool> m_pool;
	btITaskScheduler* m_scheduler;

	btHybridThreads(const btHybridThreads&);
	btHybridThreads& operator=(const btHybridThreads&);

	template <class Work>
	struct Body : public btIParallelForBody
	{
		const Work& m_work;

		explicit Body(const Work& work) : m_work(work)
		{
		}
		virtual void forLoop(int begin, int end) const
		{
			for (int i = begin; i < end; ++i)
				m_work(i);
		}
	};

public:
	btHybridThreads() : m_numThreads(1), m_scheduler(0)
	{
	}

	/// 1: none of its own; nor are there any on a machine of one core, where threads only take turns, with all that it
	/// costs to hand work over.
	void setNumThreads(int threads)
	{
		m_numThreads = threads;
		m_pool.reset(threads > 1 && scatter::parallel::countCores() > 1 ? new scatter::parallel::ThreadPool(threads)
		                                                                : 0);
	}
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

	/// Whether there are others than the caller's.
	bool areMany() const
	{
		return m_pool || m_scheduler;
	}

	/// Work comes soon: so that threads of ours are awake by then.
	void expectWork()
	{
		if (m_pool && !m_scheduler)
			m_pool->expectWork();
	}

	/// Calls work(i) once for every i from 0 to count - 1, on any thread and in any order, and returns when all have
	/// returned.
	template <class Work>
	void run(int count, const Work& work)
	{
		if (m_scheduler)
			m_scheduler->parallelFor(0, count, 1, Body<Work>(work));
		else if (m_pool)
			m_pool->run(count, work);
		else
			for (int i = 0; i < count; ++i)
				work(i);
	}
};

#endif  // BT_HYBRID_THREADS_H
