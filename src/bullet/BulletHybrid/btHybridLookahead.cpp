#include "btHybridLookahead.h"

#include <algorithm>

#include "btHybridManifolds.h"

namespace
{
const size_t c_line = 64;

// Pairs ahead at which each stage is fetched. Twice or half as many change implosions of 400 ships by less than runs differ.
const size_t c_ahead[btHybridLookahead::NUM_STAGES] = {12, 7, 3};

// Of a pair: more would push out what is needed first.
const size_t c_mostChildBytes = 24 * c_line;
const size_t c_mostContacts = 6;

void fetch(const void* from, size_t bytes)
{
#if defined(__GNUC__)
	for (size_t i = 0; i < bytes; i += c_line)
		__builtin_prefetch(static_cast<const char*>(from) + i, 1);
#else
	(void)from;
	(void)bytes;
#endif
}

bool isLikelyQuiet(const scatter::pairs::Pair& pair)
{
	return pair.quietUntil > scatter::pairs::Pair::kAwake;
}

void fetchChildren(const scatter::pairs::Pair& pair)
{
	const auto children = pair.parts.children();
	const auto wakeful = pair.parts.lastWakeful();
	fetch(children.data(), std::min(children.size_bytes(), c_mostChildBytes));
	fetch(wakeful.data(), std::min(wakeful.size_bytes(), c_line));
}

void fetchContacts(const scatter::pairs::Pair& pair)
{
	const auto children = pair.parts.children();
	const size_t end = std::min(children.size(), c_mostChildBytes / sizeof(children[0]));
	size_t fetched = 0;
	for (size_t i = 0; i < end && fetched < c_mostContacts; i++)
		if (children[i].touching)
		{
			btHybridContacts::prefetch(children[i].contact);
			fetched++;
		}
}
}  // namespace

size_t btHybridLookahead::aheadBy(Stage stage)
{
	return c_ahead[stage];
}

void btHybridLookahead::fetch(const scatter::pairs::Pair& pair, Stage stage)
{
	if (stage == PAIR)
		return ::fetch(&pair, sizeof(pair));
	if (isLikelyQuiet(pair))
		return;
	if (pair.ahead && stage == CHILDREN)
		::fetch(pair.ahead, sizeof(*pair.ahead));
	if (pair.ahead)
		return;
	if (stage == CHILDREN)
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

void btHybridLookahead::visit(const void* algorithm, int index, const scatter::pairs::PairTable& pairs, size_t all, const void* planned)
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
		::fetch(next.m_algorithm, 2 * c_line);
		if (next.m_planned)
			::fetch(next.m_planned, 2 * c_line);
	}
	for (int stage = PAIR; stage < NUM_STAGES; stage++)
		if (const scatter::pairs::Pair* pair = ahead(c_ahead[stage]))
			fetch(*pair, Stage(stage));
}
