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
#include "btHybridPlainSteps.h"
#include "btHybridPlanner.h"

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

/// Pairs ahead whose memory is fetched while one thread goes through all pairs, in the order in which it is needed:
/// time for one to come.
const size_t c_algorithmsAhead = 8;
const size_t c_pairsAhead = 4;
const size_t c_algorithmBytes = sizeof(btHybridPairAlgorithm);

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
void btHybridForesight::lookAhead(const std::vector<int>& places, int index, int first, int last) const
{
	for (int stage = 0; stage < btHybridLookahead::NUM_STAGES; ++stage)
	{
		const int by = int(btHybridLookahead::aheadBy(btHybridLookahead::Stage(stage)));
		const int end = std::min(last, index + by + 1);
		for (int i = index == first ? first : index + by; i < end; ++i)
			if (m_pairs[places[i]])
				m_pairs[places[i]]->fetch(btHybridLookahead::Stage(stage));
	}
}

// Each round fetches what the next one needs of all pairs.
void btHybridForesight::choose(int first, int last, const btHybridNarrowphase& narrowphase)
{
	for (int i = first; i < last; ++i)
		btHybridLookahead::fetch(m_overlaps[i].m_algorithm, c_algorithmBytes);
	for (int i = first; i < last; ++i)
		chooseOne(i, narrowphase);
	for (int i = first; i < last; ++i)
		if (m_pairs[i] && !m_pairs[i]->mayBeForeseen())
			m_pairs[i] = 0;
}

void btHybridForesight::chooseOne(size_t place, const btHybridNarrowphase& narrowphase)
{
	btCollisionAlgorithm* algorithm = m_overlaps[place].m_algorithm;
	m_algorithms[place] = algorithm;
	m_pairs[place] = ownOf(algorithm, narrowphase);
	if (m_pairs[place])
		m_pairs[place]->fetchForeseen();
	else if (m_takesPlain && algorithm && btHybridPlainSteps::isAmong(*algorithm))
		m_foreseen[place] = btHybridForeseen::PLAIN;
}

bool btHybridForesight::follow(size_t place, btCollisionDispatcher* dispatcher) const
{
	if (m_pairs[place])
		return m_pairs[place]->follow(dispatcher);
	return m_foreseen[place].m_kind == btHybridForeseen::PLAIN &&
	       btHybridPlainSteps::mayMake(m_overlaps[place], *dispatcher, m_ahead);
}

// Bodies are shared by pairs, and a shape may turn out to have changed: on one thread.
void btHybridForesight::follow(btCollisionDispatcher* dispatcher)
{
	for (size_t i = 0; i < m_pairs.size(); ++i)
	{
		if (i + c_algorithmsAhead < m_pairs.size())
			btHybridLookahead::fetch(m_pairs[i + c_algorithmsAhead], c_algorithmBytes);
		if (follow(i, dispatcher))
		{
			addPlace(i);
			continue;
		}
		m_pairs[i] = 0;
		m_foreseen[i] = btHybridForeseen::NOTHING;
	}
}

void btHybridForesight::beginPortions()
{
	m_atOnce.clear();
	m_portions.resize(m_planner ? size_t(m_planner->countPortions()) : 0);
	for (std::vector<int>& places : m_portions)
		places.clear();
}

// Pairs that depend on what others take wait for their portion. Where each is it must know before its turn comes.
void btHybridForesight::addPlace(size_t place)
{
	if (!m_pairs[place])
	{
		m_atOnce.push_back(int(place));
		return;
	}
	const int index = m_portions.empty() ? -1 : m_pairs[place]->getPlanIndex();
	const int portion = index >= 0 ? m_planner->portionOf(index) : btHybridPlanner::kNoPortion;
	(portion == btHybridPlanner::kNoPortion ? m_atOnce : m_portions[portion]).push_back(int(place));
	if (portion != btHybridPlanner::kNoPortion)
		m_foreseen[place] = btHybridForeseen::LATER;
	m_pairs[place]->setPlace(int(place));
}

void btHybridForesight::foreseePortionOf(size_t place)
{
	const int portion = m_planner->portionOf(m_pairs[place]->getPlanIndex());
	const std::vector<int>& places = m_portions[portion];
	for (const int each : places)
		m_foreseen[each] = btHybridForeseen::NOTHING;
	m_planner->beginPortion(portion);
	foresee(places);
}

void btHybridForesight::foresee(const std::vector<int>& places)
{
	forEachBlock(int(places.size()), [&](int first, int last) { foresee(places, first, last); });
}

void btHybridForesight::foresee(const std::vector<int>& places, int first, int last)
{
	btHybridStepMemory* memory = borrow();
	const auto begin = std::chrono::steady_clock::now();
	for (int i = first; i < last; ++i)
	{
		lookAhead(places, i, first, last);
		foresee(places[i], *memory);
	}
	memory->m_milliseconds +=
	    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
	giveBack(memory);
}

void btHybridForesight::foresee(size_t place, btHybridStepMemory& memory)
{
	if (m_pairs[place])
	{
		m_foreseen[place] = m_pairs[place]->foresee(m_ahead, memory);
	}
	else if (m_foreseen[place].m_kind == btHybridForeseen::PLAIN)
	{
		btHybridPlainSteps::make(m_overlaps[place], *m_ahead.m_info);
		m_foreseen[place] = btHybridForeseen::DONE;
	}
}

void btHybridForesight::begin(btHybridNarrowphase& narrowphase, btCollisionDispatcher* dispatcher,
                              btOverlappingPairCache& overlaps, const btDispatcherInfo& info)
{
	m_algorithms.clear();
	m_pairs.clear();
	m_isExpecting = false;
	const int count = overlaps.getNumOverlappingPairs();
	if (!m_threads->areMany() || count < c_fewestPairs ||
	    !btHybridAheadRules::isDispatchSure(dispatcher, info, m_promises))
		return;
	if (m_pause > 0)
	{
		--m_pause;
		m_isExpecting = m_pause == 0;
		return;
	}
	m_ahead.m_info = &info;
	m_ahead.m_mayStep = btHybridAheadRules::mayStep();
	m_ahead.m_mayAdd = btHybridAheadRules::mayAdd(m_promises);
	m_takesPlain = m_ahead.m_mayStep && btHybridAheadRules::isDispatchSure(dispatcher, info, 0);
	m_algorithms.resize(count);
	m_pairs.resize(count);
	m_foreseen.assign(count, btHybridForeseen::NOTHING);
	m_overlaps = overlaps.getOverlappingPairArrayPtr();
	forEachBlock(count, [&](int first, int last) { choose(first, last, narrowphase); });
	m_planner = narrowphase.getPlanner();
	beginPortions();
	follow(dispatcher);
	foresee(m_atOnce);
}

// Pairs that are left out all the same have not made use of what was found out.
void btHybridForesight::end(btHybridNarrowphase& narrowphase)
{
	for (size_t i = 0; i < m_pairs.size(); ++i)
		if (m_pairs[i] && m_foreseen[i].m_kind != btHybridForeseen::NOTHING)
			m_pairs[i]->endForesight(m_foreseen[i]);
	double milliseconds = 0;
	for (const auto& memory : m_memories)
	{
		milliseconds += memory->m_milliseconds;
		narrowphase.takeDone(*memory);
		memory->reset();
	}
	if (!m_pairs.empty())
	{
		m_isExpecting = milliseconds >= c_leastMilliseconds;
		m_pause = m_isExpecting ? 0 : c_pause;
	}
	m_algorithms.clear();
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
	const size_t far = place + c_algorithmsAhead;
	const size_t near = place + c_pairsAhead;
	if (isTaken(far))
		btHybridLookahead::fetch(m_pairs[far], c_algorithmBytes);
	if (isTaken(far) && m_foreseen[far].m_made)
		btHybridLookahead::fetch(m_foreseen[far].m_made, sizeof(scatter::pairs::StepAhead));
	if (isTaken(near))
		m_pairs[near]->fetchForeseen();
}

void btHybridForesight::forget(btHybridAlgorithm* pair)
{
	const size_t place = pair->getPlace();
	if (place >= m_pairs.size() || m_pairs[place] != pair)
		return;
	const btHybridForeseen foreseen = m_foreseen[place];
	m_foreseen[place] = btHybridForeseen::NOTHING;
	m_algorithms[place] = 0;
	m_pairs[place] = 0;
	if (foreseen.m_kind != btHybridForeseen::NOTHING)
		pair->endForesight(foreseen);
}
