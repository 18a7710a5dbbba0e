#include "btHybridForesight.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <LinearMath/btThreads.h>

#include <algorithm>

#include "btHybridAheadEngine.h"
#include "btHybridAlgorithm.h"
#include "btHybridNarrowphase.h"

namespace
{
/// Pairs that one thread takes at a time. Most are quiet and take 50 ns, so that a block is worth taking; the
/// number of threads must not matter to it.
const int c_block = 32;

/// Fewer pairs are done before another thread has woken up; and where fewer have to be looked at, which takes some
/// microseconds each, to ask all of them takes longer than it saves. That seldom changes from step to step. Of 48 and
/// 128, this is the number with which `engine_bullet --lean --threads 2` (bench/engines) loses least on a wall and on
/// wheels on a plane, and nothing elsewhere.
const int c_fewest = 128;
const int c_pause = 16;

template <class Work>
struct BlockBody : public btIParallelForBody
{
	const Work& m_work;

	explicit BlockBody(const Work& work)
	    : m_work(work)
	{
	}
	virtual void forLoop(int begin, int end) const
	{
		for (int i = begin; i < end; ++i)
			m_work(i);
	}
};
}  // namespace

// On one core threads only take turns, with all that it costs to hand work over.
void btHybridForesight::setNumThreads(int threads)
{
	m_numThreads = threads;
	m_threads.reset(threads > 1 && scatter::parallel::countCores() > 1 ? new scatter::parallel::ThreadPool(threads) : 0);
}

// Calls work(first, last) for blocks of indices.
template <class Work>
void btHybridForesight::forEachBlock(int count, const Work& work)
{
	const auto block = [&](int i)
	{ work(i * c_block, std::min(count, (i + 1) * c_block)); };
	const int blocks = (count + c_block - 1) / c_block;
	if (m_scheduler)
		m_scheduler->parallelFor(0, blocks, 1, BlockBody<decltype(block)>(block));
	else
		m_threads->run(blocks, block);
}

btHybridStepMemory* btHybridForesight::borrow()
{
	const std::scoped_lock lock(m_mutex);
	if (m_free.empty())
	{
		m_memories.push_back(std::make_unique<btHybridStepMemory>());
		m_free.push_back(m_memories.back().get());
	}
	btHybridStepMemory* memory = m_free.back();
	m_free.pop_back();
	return memory;
}

void btHybridForesight::giveBack(btHybridStepMemory* memory)
{
	const std::scoped_lock lock(m_mutex);
	m_free.push_back(memory);
}

// The first pairs of a block are fetched at once, so that each stage is.
void btHybridForesight::lookAhead(int index, int first, int last) const
{
	for (int stage = 0; stage < btHybridLookahead::NUM_STAGES; ++stage)
	{
		const int by = int(btHybridLookahead::aheadBy(btHybridLookahead::Stage(stage)));
		const int end = std::min(last, index + by + 1);
		for (int i = index == first ? first : index + by; i < end; ++i)
			if (m_chosen[i])
				m_pairs[i]->fetch(btHybridLookahead::Stage(stage));
	}
}

void btHybridForesight::begin(btHybridNarrowphase& narrowphase, btCollisionDispatcher* dispatcher, const btDispatcherInfo& info)
{
	m_pairs.clear();
	if ((!m_threads && !m_scheduler) || m_pause-- > 0 || !btHybridAheadRules::isDispatchSure(dispatcher, info, m_promises))
		return;
	m_pause = 0;
	narrowphase.collectOwners(m_pairs);
	if (int(m_pairs.size()) < c_fewest)
	{
		m_pairs.clear();
		return;
	}
	m_ahead.m_info = &info;
	m_ahead.m_mayStep = btHybridAheadRules::mayStep();
	m_ahead.m_mayAdd = btHybridAheadRules::mayAdd(m_promises);
	m_chosen.assign(m_pairs.size(), 0);
	const int count = int(m_pairs.size());
	forEachBlock(count,
	             [this](int first, int last)
	             {
		             for (int i = first; i < last; ++i)
			             m_chosen[i] = m_pairs[i]->mayBeForeseen();
	             });
	// Bodies are shared by pairs, and a shape may turn out to have changed.
	for (int i = 0; i < count; ++i)
		m_chosen[i] = m_chosen[i] && m_pairs[i]->follow(dispatcher);
	forEachBlock(count,
	             [this](int first, int last)
	             {
		             btHybridStepMemory* memory = borrow();
		             for (int i = first; i < last; ++i)
		             {
			             lookAhead(i, first, last);
			             if (m_chosen[i])
				             m_pairs[i]->foresee(m_ahead, *memory);
		             }
		             giveBack(memory);
	             });
}

// Pairs that are left out all the same have not made use of what was found out.
void btHybridForesight::end()
{
	for (size_t i = 0; i < m_pairs.size(); ++i)
		if (m_pairs[i] && m_chosen[i])
			m_pairs[i]->endForesight();
	int awake = 0;
	for (const auto& memory : m_memories)
	{
		awake += memory->m_looked;
		memory->reset();
	}
	if (!m_pairs.empty() && awake < c_fewest)
		m_pause = c_pause;
	m_pairs.clear();
}

void btHybridForesight::forget(const btHybridAlgorithm* pair)
{
	std::replace(m_pairs.begin(), m_pairs.end(), const_cast<btHybridAlgorithm*>(pair),
	             static_cast<btHybridAlgorithm*>(0));
}
