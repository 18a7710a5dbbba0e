#include "btHybridForesight.h"

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <algorithm>
#include <chrono>
#include <typeinfo>

#include "btHybridAheadEngine.h"
#include "btHybridGroundAlgorithm.h"
#include "btHybridNarrowphase.h"
#include "btHybridPairAlgorithm.h"

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
const size_t c_fewestPairs = 32;
const double c_leastMilliseconds = 0.15;
const int c_pause = 16;

/// Pairs ahead whose memory is fetched while pairs are passed by, in the order in which it is needed: time for one to
/// come.
const size_t c_algorithmsAhead = 8;
const size_t c_pairsAhead = 4;

btHybridAlgorithm* ownOf(btCollisionAlgorithm* algorithm, const btHybridNarrowphase& narrowphase)
{
	if (!algorithm ||
	    (typeid(*algorithm) != typeid(btHybridPairAlgorithm) && typeid(*algorithm) != typeid(btHybridGroundAlgorithm)))
		return 0;
	btHybridAlgorithm* own = static_cast<btHybridAlgorithm*>(algorithm);
	return own->isOf(narrowphase) ? own : 0;
}
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
			if (m_pairs[i])
				m_pairs[i]->fetch(btHybridLookahead::Stage(stage));
	}
}

// Bodies are shared by pairs, and a shape may turn out to have changed: they follow on one thread.
void btHybridForesight::choose(const btHybridNarrowphase& narrowphase, btCollisionDispatcher* dispatcher,
                               btOverlappingPairCache& overlaps)
{
	const btBroadphasePair* pairs = overlaps.getOverlappingPairArrayPtr();
	forEachBlock(int(m_pairs.size()),
	             [this, pairs, &narrowphase](int first, int last)
	             {
		             for (int i = first; i < last; ++i)
		             {
			             btHybridAlgorithm* pair = ownOf(pairs[i].m_algorithm, narrowphase);
			             m_pairs[i] = pair && pair->mayBeForeseen() ? pair : 0;
		             }
	             });
	for (btHybridAlgorithm*& pair : m_pairs)
		if (pair && !pair->follow(dispatcher))
			pair = 0;
}

void btHybridForesight::foresee(int first, int last)
{
	btHybridStepMemory* memory = borrow();
	const auto begin = std::chrono::steady_clock::now();
	for (int i = first; i < last; ++i)
	{
		lookAhead(i, first, last);
		if (!m_pairs[i])
			continue;
		m_foreseen[i] = m_pairs[i]->foresee(m_ahead, *memory);
		m_pairs[i]->setPlace(i);
	}
	memory->m_milliseconds +=
	    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
	giveBack(memory);
}

void btHybridForesight::begin(btHybridNarrowphase& narrowphase, btCollisionDispatcher* dispatcher,
                              btOverlappingPairCache& overlaps, const btDispatcherInfo& info)
{
	m_pairs.clear();
	const size_t own = narrowphase.countPairs() + size_t(narrowphase.getGrounds().count());
	if (!m_threads->areMany() || m_pause-- > 0 || own < c_fewestPairs ||
	    !btHybridAheadRules::isDispatchSure(dispatcher, info, m_promises))
		return;
	m_pause = 0;
	m_ahead.m_info = &info;
	m_ahead.m_mayStep = btHybridAheadRules::mayStep();
	m_ahead.m_mayAdd = btHybridAheadRules::mayAdd(m_promises);
	const int count = overlaps.getNumOverlappingPairs();
	m_pairs.resize(count);
	m_foreseen.assign(count, btHybridForeseen::NOTHING);
	choose(narrowphase, dispatcher, overlaps);
	forEachBlock(count, [this](int first, int last) { foresee(first, last); });
}

// Pairs that are left out all the same have not made use of what was found out.
void btHybridForesight::end(btHybridNarrowphase& narrowphase)
{
	for (size_t i = 0; i < m_pairs.size(); ++i)
		if (m_foreseen[i].m_kind != btHybridForeseen::NOTHING)
			m_pairs[i]->endForesight(m_foreseen[i]);
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

// Whether takeForeseen() is going to be called.
bool btHybridForesight::isTaken(size_t place) const
{
	if (place >= m_pairs.size())
		return false;
	const btHybridForeseen::Kind kind = m_foreseen[place].m_kind;
	return kind == btHybridForeseen::QUIET || kind == btHybridForeseen::MADE;
}

void btHybridForesight::fetchAfter(size_t place) const
{
#if defined(__GNUC__)
	const size_t far = place + c_algorithmsAhead;
	const size_t near = place + c_pairsAhead;
	if (isTaken(far))
		__builtin_prefetch(m_pairs[far]);
	if (isTaken(far) && m_foreseen[far].m_made)
		btHybridLookahead::fetch(m_foreseen[far].m_made, sizeof(scatter::pairs::StepAhead));
	if (isTaken(near))
		m_pairs[near]->fetchForeseen();
#else
	(void)place;
#endif
}

void btHybridForesight::forget(btHybridAlgorithm* pair)
{
	const size_t place = pair->getPlace();
	if (place >= m_pairs.size() || m_pairs[place] != pair)
		return;
	const btHybridForeseen foreseen = m_foreseen[place];
	m_foreseen[place] = btHybridForeseen::NOTHING;
	m_pairs[place] = 0;
	if (foreseen.m_kind != btHybridForeseen::NOTHING)
		pair->endForesight(foreseen);
}
