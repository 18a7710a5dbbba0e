#ifndef BT_HYBRID_NARROWPHASE_H
#define BT_HYBRID_NARROWPHASE_H

#include <memory>
#include <vector>

#include "BulletHybrid/btHybridCollision.h"
#include "btHybridForesight.h"
#include "btHybridGroundEngine.h"
#include "btHybridLookahead.h"
#include "btHybridObjects.h"
#include "btHybridSettings.h"
#include "btHybridWholeGrounds.h"
#include "pairs/pair_step.h"
#include "pairs/pair_table.h"

class btHybridPlanner;

/// What the pair algorithms of a dispatcher share: the pairs, their objects, settings, counts. Counted by its owner and
/// by the pair algorithms, because these live as long as their broadphase pairs.
class btHybridNarrowphase
{
	btHybridCollisionInfo m_info;
	btHybridCollisionCounts m_work;
	int m_users;

	btHybridObjects m_objects;
	scatter::pairs::PairTable m_pairs;
	scatter::pairs::PairTable m_plainPairs;
	scatter::pairs::GroundTable m_grounds;
	btHybridWholeGrounds m_wholeGrounds;
	btHybridForesight m_foresight;
	btHybridLookahead m_lookahead;
	std::vector<std::unique_ptr<scatter::pairs::StepScratch>> m_scratches;
	std::vector<std::unique_ptr<std::vector<btHybridPartBounds>>> m_bounds;
	size_t m_depth;  ///< of pairs' steps inside each other's
	btHybridPlanner* m_planner;

	~btHybridNarrowphase();
	btHybridNarrowphase(const btHybridNarrowphase&);
	btHybridNarrowphase& operator=(const btHybridNarrowphase&);

public:
	/// With pair switching it has a planner.
	explicit btHybridNarrowphase(bool switchesPairs);

	/// Of the levels of pairs; 0 without pair switching.
	btHybridPlanner* getPlanner()
	{
		return m_planner;
	}
	const btHybridPlanner* getPlanner() const
	{
		return m_planner;
	}

	/// Of the levels of a pair that comes up now; 0 if it does so between steps, where a character dispatches pairs of
	/// its own, which nobody plans.
	btHybridPlanner* getPlannerOfNew()
	{
		return m_objects.isDispatching() ? m_planner : 0;
	}

	/// Starts anew with a planner or without one. No pair of a hybrid must be left.
	void setSwitchesPairs(bool switchesPairs);

	void addUser()
	{
		m_users++;
	}
	void removeUser();

	const btHybridCollisionInfo& getInfo() const
	{
		return m_info;
	}
	const scatter::PairSteps& getSteps() const
	{
		return m_info.m_steps;
	}
	void setInfo(const btHybridCollisionInfo& info)
	{
		m_info = btHybridEffective(info);
	}

	void beginStep();

	/// Of the step under way.
	btHybridCollisionCounts& getWork()
	{
		return m_work;
	}
	/// Takes in a step that was made ahead; planIndex: of the pair in the planner, -1 if it does not switch.
	void takeAhead(const scatter::pairs::StepAhead& step, int planIndex);
	/// Takes in what a thread has done with pairs that need no turn of their own.
	void takeDone(const btHybridStepMemory& memory);
	const btHybridCollisionCounts& getCounts() const
	{
		return m_work;
	}
	btHybridCollisionMemory getMemory() const;

	btHybridObjects& getObjects()
	{
		return m_objects;
	}

	/// One for each pair algorithm: of pairs that switch, or of those that do not.
	scatter::pairs::PairTable& getPairs(bool switches)
	{
		return switches ? m_pairs : m_plainPairs;
	}

	size_t countPairs() const
	{
		return size_t(m_pairs.count()) + size_t(m_plainPairs.count());
	}

	btHybridForesight& getForesight()
	{
		return m_foresight;
	}
	const btHybridForesight& getForesight() const
	{
		return m_foresight;
	}

	btHybridLookahead& getLookahead()
	{
		return m_lookahead;
	}

	/// One for each ground algorithm.
	scatter::pairs::GroundTable& getGrounds()
	{
		return m_grounds;
	}

	btHybridWholeGrounds& getWholeGrounds()
	{
		return m_wholeGrounds;
	}

	/// Memory for the engine of a ground algorithm, until the end of the step of its pair.
	std::vector<btHybridPartBounds>& getBounds();

	/// Memory for one step of a pair, until the end of the step. A program's callback may collide two objects inside of
	/// it.
	scatter::pairs::StepScratch& beginPair();
	void endPair()
	{
		m_depth--;
	}

	/// Pairs on credit whose finest shapes can not be proven to overlap by no more than `depth`.
	int countDeepPairs(btScalar depth);
};

#endif  // BT_HYBRID_NARROWPHASE_H
