#include "btHybridForesight.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <algorithm>
#include <chrono>

#include "btHybridAheadEngine.h"
#include "btHybridAlgorithm.h"
#include "btHybridNarrowphase.h"

namespace
{
/// Pairs that one thread takes at a time. Most are quiet and take 50 ns, so that a block is worth taking; of few pairs,
/// blocks are so small that no thread waits long for the last one. The number of threads must not matter to it.
const int c_largestBlock = 32;
const int c_fewestBlocks = 16;

/// Fewer pairs are done before another thread has woken up, and so is work that takes no longer than this on all
/// threads together: to hand it over, and to ask all pairs, takes longer than it saves. How long it takes seldom
/// changes from step to step. A stack of 20 wheels, with 0.2 ms a step, saves a quarter of its detection on two threads
/// (`scatter run` of wheel_stack-41 in `lean`, collision_detection_ms).
const int c_fewestPairs = 32;
const double c_leastMilliseconds = 0.15;
const int c_pause = 16;

}  // namespace

// Calls work(first, last) for blocks of indices.
template <class Work>
void btHybridForesight::forEachBlock(int count, const Work& work) const
{
	const int size = std::clamp(count / c_fewestBlocks, 1, c_largestBlock);
	const auto block = [&](int i) { work(i * size, std::min(count, (i + 1) * size)); };
	m_threads->run((count + size - 1) / size, block);
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

void btHybridForesight::begin(btHybridNarrowphase& narrowphase, btCollisionDispatcher* dispatcher,
                              const btDispatcherInfo& info)
{
	m_pairs.clear();
	if (!m_threads->areMany() || m_pause-- > 0 || !btHybridAheadRules::isDispatchSure(dispatcher, info, m_promises))
		return;
	m_pause = 0;
	narrowphase.collectOwners(m_pairs);
	if (int(m_pairs.size()) < c_fewestPairs)
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
		             const auto begin = std::chrono::steady_clock::now();
		             for (int i = first; i < last; ++i)
		             {
			             lookAhead(i, first, last);
			             if (m_chosen[i])
				             m_pairs[i]->foresee(m_ahead, *memory);
		             }
		             memory->m_milliseconds +=
		                 std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
		             giveBack(memory);
	             });
}

// Pairs that are left out all the same have not made use of what was found out.
void btHybridForesight::end(btHybridNarrowphase& narrowphase)
{
	for (size_t i = 0; i < m_pairs.size(); ++i)
		if (m_pairs[i] && m_chosen[i])
			m_pairs[i]->endForesight();
	double milliseconds = 0;
	for (const auto& memory : m_memories)
	{
		milliseconds += memory->m_milliseconds;
		narrowphase.takeQuiet(memory->m_quiet);
		memory->reset();
	}
	if (!m_pairs.empty() && milliseconds < c_leastMilliseconds)
		m_pause = c_pause;
	m_pairs.clear();
}

void btHybridForesight::forget(const btHybridAlgorithm* pair)
{
	std::replace(m_pairs.begin(), m_pairs.end(), const_cast<btHybridAlgorithm*>(pair),
	             static_cast<btHybridAlgorithm*>(0));
}
