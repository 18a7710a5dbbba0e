#include "btHybridLookahead.h"

#include <algorithm>

#include "btHybridManifolds.h"

namespace
{
const size_t c_line = 64;

// Pairs ahead at which each stage is fetched. Twice or half as many change implosions of 400 ships by less than runs
// differ.
const size_t c_ahead[btHybridLookahead::NUM_STAGES] = {14, 10, 6, 3};

// Of a pair: more would push out what is needed first.
const size_t c_mostWakefulBytes = 8 * c_line;
const size_t c_mostAwakeChildren = 16;
const size_t c_mostContacts = 6;

bool isLikelyQuiet(const scatter::pairs::Pair& pair)
{
	return pair.quietUntil > scatter::pairs::Pair::kAwake;
}

void fetchWakeful(const scatter::pairs::Pair& pair)
{
	const auto wakeful = pair.parts.lastWakeful();
	btHybridLookahead::fetch(wakeful.data(), std::min(wakeful.size_bytes(), c_mostWakefulBytes));
}

// Calls use(child) for the first of those that are likely to be looked at.
template <class Use>
void forEachAwake(const scatter::pairs::Pair& pair, size_t most, const Use& use)
{
	const auto children = pair.parts.children();
	size_t used = 0;
	for (const scatter::WakefulChild& one : pair.parts.lastWakeful())
	{
		if (pair.parts.isAsleep(one) || size_t(one.index) >= children.size())
			continue;
		if (used++ == most)
			return;
		use(children[one.index]);
	}
}

void fetchChildren(const scatter::pairs::Pair& pair)
{
	forEachAwake(pair, c_mostAwakeChildren,
	             [](const scatter::ChildPair& child) { btHybridLookahead::fetch(&child, sizeof(child)); });
}

void fetchContacts(const scatter::pairs::Pair& pair)
{
	forEachAwake(pair, c_mostContacts,
	             [](const scatter::ChildPair& child)
	             {
		             if (child.touching)
			             btHybridContacts::prefetch(child.contact);
	             });
}
}  // namespace

void btHybridLookahead::fetch(const void* from, size_t bytes)
{
#if defined(__GNUC__)
	for (size_t i = 0; i < bytes; i += c_line)
		__builtin_prefetch(static_cast<const char*>(from) + i, 1);
#else
	(void)from;
	(void)bytes;
#endif
}

size_t btHybridLookahead::aheadBy(Stage stage)
{
	return c_ahead[stage];
}

void btHybridLookahead::fetch(const scatter::pairs::Pair& pair, Stage stage)
{
	if (stage == PAIR)
		return fetch(&pair, sizeof(pair));
	if (isLikelyQuiet(pair))
		return;
	if (stage == WAKEFUL)
		fetchWakeful(pair);
	else if (stage == CHILDREN)
		fetchChildren(pair);
	else
		fetchContacts(pair);
}

void btHybridLookahead::begin()
{
	m_last.swap(m_now);
	m_now.clear();
	m_place = 0;
}

// A program that only asks queries, each of which makes a pair of its own, never comes round.
bool btHybridLookahead::hasComeRound(const void* algorithm, size_t pairs) const
{
	return !m_now.empty() && (m_now.front().m_algorithm == algorithm || m_now.size() > 2 * pairs);
}

// A pair that is new, or was left out, moves the others by one.
void btHybridLookahead::findPlace(const void* algorithm)
{
	const size_t c_window = 8;
	const size_t end = std::min(m_place + c_window, m_last.size());
	for (size_t i = m_place; i < end; i++)
		if (m_last[i].m_algorithm == algorithm)
		{
			m_place = i + 1;
			return;
		}
}

void btHybridLookahead::visit(const void* algorithm, int index, const scatter::pairs::PairTable& pairs, size_t all,
                              const void* planned)
{
	if (hasComeRound(algorithm, all))
		begin();
	const Visit visit = {algorithm, index, planned};
	m_now.push_back(visit);
	findPlace(algorithm);
	const auto ahead = [&](size_t by) -> const scatter::pairs::Pair*
	{
		const size_t place = m_place + by;
		const bool isThere = place < m_last.size() && m_last[place].m_index < pairs.count();
		return isThere ? &pairs[m_last[place].m_index] : 0;
	};
	if (ahead(c_ahead[PAIR]))
	{
		const Visit& next = m_last[m_place + c_ahead[PAIR]];
		fetch(next.m_algorithm, 2 * c_line);
		if (next.m_planned)
			fetch(next.m_planned, 2 * c_line);
	}
	for (int stage = PAIR; stage < NUM_STAGES; stage++)
		if (const scatter::pairs::Pair* pair = ahead(c_ahead[stage]))
			fetch(*pair, Stage(stage));
}
