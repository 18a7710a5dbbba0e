#include "btHybridContactGroups.h"

#include <algorithm>

using scatter::solver::IslandGroups;
using scatter::solver::PairBatch;
using scatter::solver::Share;

namespace
{
// Contacts of a group, unless one island alone has more: fewer do not fill four lanes, more leave threads without work.
// Of groups of about 200, 400, 800 and all contacts, those of 200 and 400 take two threads least time and one thread a
// tenth more than all in one
// (`scatter run` of ships_mesh-12 in `lean`, contact_constraints_ms).
const int c_shareOfGroup = 256;

// With fewer contacts, which take some 30 microseconds, all are solved before another thread has woken up.
const size_t c_fewestContacts = 256;

// A group with so many times the contacts of all others is solved first, and threads share its rows and impulses, which
// take two fifths of its time (perf of `scatter run fleet --world lean`): two threads save a fifth, and lose what one
// of them would have solved meanwhile.
const int c_loneliness = 4;

// With fewer contacts, to wake threads twice takes as long as they save. Where every other step shared, it took longer
// than those beside it up to 1700 contacts, and from 3000 on a fifth less (`scatter run` of fleet and implosion-21 in
// `lean` on two threads, contact_constraints_ms).
const size_t c_fewestOfPile = 2048;
}  // namespace

btHybridContactGroups::btHybridContactGroups() : m_threads(new btHybridThreads), m_bulletManifolds(0)
{
	m_problems.push_back(std::make_unique<btHybridContactProblem>());
	clear();
}

void btHybridContactGroups::clear()
{
	// Their number hardly changes from step to step.
	if (hasManyContacts() && !hasPile())
		m_threads->expectWork();
	m_points.clear();
	m_members.clear();
	m_links.clear();
	m_joined.clear();
	m_bulletManifolds = 0;
	for (const auto& problem : m_problems)
		problem->clear();
}

bool btHybridContactGroups::hasManyContacts() const
{
	return m_points.sources().size() >= c_fewestContacts;
}

bool btHybridContactGroups::hasPile() const
{
	return m_points.sources().size() >= c_fewestOfPile;
}

bool btHybridContactGroups::add(btPersistentManifold* manifold, Side side0, Side side1, const btContactSolverInfo& info)
{
	// A pair's manifolds may name its bodies in either order.
	const bool swaps = !side0.m_moves || (side1.m_moves && side1.m_id < side0.m_id);
	Member member = {{0, 0}, swaps ? side1 : side0, swaps ? side0 : side1};
	const bool isOurs = m_points.add(manifold, swaps, info, member.m_range);
	if (isOurs && member.m_range.m_count > 0)
		add(member);
	return isOurs;
}

// Manifolds that follow each other have points that do. In a large island few of a pair do: Bullet has mixed them.
void btHybridContactGroups::add(const Member& member)
{
	const int count = member.m_range.m_count;
	if (!m_members.empty() && m_members.back().m_a.m_id == member.m_a.m_id &&
	    m_members.back().m_b.m_id == member.m_b.m_id)
	{
		m_members.back().m_range.m_count += count;
		m_links.back().count += count;
		return;
	}
	m_members.push_back(member);
	m_links.push_back({member.m_a.m_id, member.m_b.m_moves ? member.m_b.m_id : IslandGroups::kNone, count});
}

void btHybridContactGroups::group(const btAlignedObjectArray<btSolverBody>& bodies)
{
	// To take so many has taken longer than threads look for work.
	if (hasPile())
		m_threads->expectWork();
	m_groups.group(bodies.size(), m_links, m_joined, c_shareOfGroup);
	m_places.assign(bodies.size(), IslandGroups::kNone);
	while (int(m_problems.size()) < m_groups.count())
		m_problems.push_back(std::make_unique<btHybridContactProblem>());
}

void btHybridContactGroups::take(int group)
{
	for (int i : m_groups.linksOf(group))
		m_problems[group]->add(m_members[i].m_range, m_members[i].m_a, m_members[i].m_b, m_places);
}

void btHybridContactGroups::beginJoined(const btAlignedObjectArray<btSolverBody>& bodies,
                                        const btContactSolverInfo& info, const Settings& settings)
{
	take(0);
	if (!joined().empty())
		joined().begin(m_points, bodies, info, settings.m_clampsFriction, settings.m_reduction, pileThreads());
}

void btHybridContactGroups::finishJoined(btAlignedObjectArray<btSolverBody>& bodies, const btContactSolverInfo& info)
{
	joined().finish(bodies, info, pileThreads());
}

// Threads that share the rows and impulses of a group, if it may be one that is worth it.
Share btHybridContactGroups::pileThreads() const
{
	if (!hasPile())
		return scatter::solver::shareWithNobody;
	return [this](int count, const std::function<void(int)>& work) { m_threads->run(count, work); };
}

void btHybridContactGroups::solveOne(int group, btAlignedObjectArray<btSolverBody>& bodies,
                                     const btContactSolverInfo& info, const Settings& settings, const Share& share)
{
	btHybridContactProblem& problem = *m_problems[group];
	take(group);
	problem.begin(m_points, bodies, info, settings.m_clampsFriction, settings.m_reduction, share);
	problem.solve(info);
	problem.finish(bodies, info, share);
}

int btHybridContactGroups::countContacts(int group) const
{
	int count = 0;
	for (int i : m_groups.linksOf(group))
		count += m_links[i].count;
	return count;
}

// Others need not wait for a large one that has begun last.
void btHybridContactGroups::sortGroups()
{
	m_order.clear();
	for (int group = 1; group < m_groups.count(); ++group)
		m_order.push_back(std::make_pair(-countContacts(group), group));
	std::sort(m_order.begin(), m_order.end());
}

// Threads that have solved all others would wait for it longer than they take to help with it.
bool btHybridContactGroups::isLargestAlone() const
{
	int others = 0;
	for (size_t i = 1; i < m_order.size(); ++i)
		others -= m_order[i].first;
	return !m_order.empty() && c_loneliness * others < -m_order[0].first;
}

void btHybridContactGroups::solve(btAlignedObjectArray<btSolverBody>& bodies, const btContactSolverInfo& info,
                                  const Settings& settings)
{
	sortGroups();
	const int first = hasPile() && isLargestAlone() ? 1 : 0;
	if (first)
		solveOne(m_order[0].second, bodies, info, settings, pileThreads());
	const auto solve = [&](int i)
	{ solveOne(m_order[i + first].second, bodies, info, settings, scatter::solver::shareWithNobody); };
	const int count = int(m_order.size()) - first;
	if (hasManyContacts())
		m_threads->run(count, solve);
	else
		scatter::solver::shareWithNobody(count, solve);
}

void btHybridContactGroups::addTo(btHybridContactSolverInfo& info) const
{
	info.m_bulletManifolds = m_bulletManifolds;
	info.m_points = int(m_points.sources().size());
	for (const auto& problem : m_problems)
	{
		if (problem->empty())
			continue;
		info.m_groups++;
		info.m_pairs += int(problem->problem().pairs.size());
		info.m_colours = std::max(info.m_colours, problem->solver().colouring().colours());
		for (const PairBatch& batch : problem->solver().colouring().batches())
			info.m_rows += batch.rows;
		info.m_reduced.m_pairs += problem->m_reduced.m_pairs;
		info.m_reduced.m_contacts += problem->m_reduced.m_contacts;
		info.m_reduced.m_left += problem->m_reduced.m_left;
	}
}
