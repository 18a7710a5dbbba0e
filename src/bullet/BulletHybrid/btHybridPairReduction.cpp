#include "btHybridPairReduction.h"

using scatter::solver::ContactPair;
using scatter::solver::ContactProblem;
using scatter::solver::ProblemPoint;
using scatter::solver::ReducibleContact;
using scatter::solver::withW;

// Those that must stay come first; returns how many they are.
int btHybridPairReduction::collect(const ContactPair& pair, ContactProblem& problem,
                                   const btHybridContactPoints& points)
{
	m_reducible.clear();
	m_indices.clear();
	int left = 0;
	for (int i = pair.first; i < pair.first + pair.count; ++i)
	{
		const int index = problem.order[i];
		if (!points.sources()[index].m_isReducible)
		{
			problem.order[pair.first + left++] = index;
			continue;
		}
		const ProblemPoint& point = problem.points[index];
		ReducibleContact& contact = m_reducible.emplace_back();
		store(withW(point.onB, point.onA.w), contact.place);
		store(withW(point.normal, point.law.x), contact.normal);
		m_indices.push_back(index);
	}
	return left;
}

void btHybridPairReduction::leaveOut(int index, int kept, ContactProblem& problem,
                                     const btHybridContactPoints& points) const
{
	const float impulse = problem.points[index].law.x;
	if (impulse == 0)
		return;
	problem.points[kept].law.x += impulse;
	btManifoldPoint& point = *points.sources()[index].m_point;
	point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
}

void btHybridPairReduction::reduce(ContactPair& pair, ContactProblem& problem, const btHybridContactPoints& points,
                                   int mostAlike)
{
	int left = collect(pair, problem, points);
	++m_count.m_pairs;
	m_count.m_contacts += int(m_reducible.size());
	m_count.m_left += m_reduction.reduce(m_reducible, mostAlike);
	for (size_t i = 0; i < m_reducible.size(); ++i)
	{
		const int kept = m_reducible[i].kept;
		if (kept == int(i))
			problem.order[pair.first + left++] = m_indices[i];
		else
			leaveOut(m_indices[i], m_indices[kept], problem, points);
	}
	pair.count = left;
}

void btHybridPairReduction::takeCount(btHybridContactReductionCount& sum)
{
	sum.m_pairs += m_count.m_pairs;
	sum.m_contacts += m_count.m_contacts;
	sum.m_left += m_count.m_left;
	m_count = btHybridContactReductionCount();
}
