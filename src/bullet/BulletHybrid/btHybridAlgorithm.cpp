#include "btHybridAlgorithm.h"

#include "btHybridNarrowphase.h"
#include "btHybridPlanner.h"

btHybridPlanner* btHybridAlgorithm::getPlanner() const
{
	return getPlanIndex() >= 0 ? m_narrowphase->getPlanner() : 0;
}

static void countQuiet(scatter::PairWork& work)
{
	work.pairs++;
	work.pairsSkipped++;
}

// Where nothing plans all pairs cost the same, so that their order is of no matter.
btHybridForeseen btHybridAlgorithm::foreseeQuiet(btHybridStepMemory& memory) const
{
	const btHybridPlanner* planner = getPlanner();
	if (planner && planner->plans())
		return btHybridForeseen::QUIET;
	countQuiet(memory.m_work);
	if (planner)
		planner->takeQuiet(getPlanIndex(), memory.m_unplanned);
	return btHybridForeseen::DONE;
}

void btHybridAlgorithm::takeQuiet() const
{
	countQuiet(m_narrowphase->getWork());
	if (btHybridPlanner* planner = getPlanner())
		planner->takeQuiet(getPlanIndex());
}

// The dispatcher is told on one thread, and so is who plans, and hears of levels.
btHybridForeseen btHybridAlgorithm::foreseeMade(const scatter::pairs::StepAhead& made, btHybridStepMemory& memory) const
{
	btHybridPlanner* planner = getPlanner();
	const bool isPlain = !planner || (!planner->plans() && scatter::pairs::isPlain(made.outcome));
	if (!made.notes.empty() || !isPlain)
		return btHybridForeseen(btHybridForeseen::MADE, &made);
	memory.m_work += made.work;
	if (planner)
		planner->takeUnplanned(getPlanIndex(), made.outcome, memory.m_unplanned);
	memory.m_foresight.giveBackStep();
	return btHybridForeseen::DONE;
}
