#ifndef BT_HYBRID_SWITCHING_H
#define BT_HYBRID_SWITCHING_H

#include <LinearMath/btScalar.h>
#include <scatter/lod/budget_state.h>
#include <scatter/lod/pair_step_counts.h>

/// What has a level.
enum btHybridSwitchingMode
{
	/// Every pair of bodies. A hybrid's collision shape is always its finest level, for rays, sweeps and drawing; how
	/// it meets a neighbour is the pair's own business.
	BT_HYBRID_PAIR_SWITCHING,

	/// Every body, the same for all its neighbours: its collision shape is the level in use.
	BT_HYBRID_BODY_SWITCHING
};

/// Counts of one step. In pair switching those of the program's requests for bodies; btHybridPairStepInfo has the rest.
struct btHybridStepInfo
{
	int m_standingRequests;  ///< after the step
	int m_switchesCoarser;
	int m_switchesFiner;
	int m_retractions;
	int m_blockedTries;
	int m_separationQueries;

	btHybridStepInfo()
	    : m_standingRequests(0),
	      m_switchesCoarser(0),
	      m_switchesFiner(0),
	      m_retractions(0),
	      m_blockedTries(0),
	      m_separationQueries(0)
	{
	}
};

/// When and how bodies switch, in body switching. Read in every step, so that values may be changed at any time. Each
/// has a meaning whatever it is set to.
struct btHybridSwitchingInfo
{
	/// The world asks for level 1 when another moving body is near, and for the finest level when none is.
	/// Static bodies count for safety, but do not ask for anything: a floor is always near.
	bool m_proximity;

	/// A request comes at least this many steps before the level-1 bounds of two bodies can touch at their present
	/// velocities; 1 or less comes too late to be sure of that, and 0 once they overlap (report, section 5.1.2.1).
	/// Below 0 and what is not a number act as 0, above 1000 acts as 1000.
	btScalar m_proximitySteps;

	int m_retryInterval;  ///< steps between tries of a blocked request; below 1 it acts as 1, above a million as that
	int m_quietSteps;     ///< steps without a neighbour before the finest level is asked for; below 1 it acts as 1

	/// Distance that must separate shapes for a switch to be safe, metres. What is negative or not a number acts as 0,
	/// above 1000 it acts as 1000. In both kinds of switching the bounds of hybrids are wider by at least this much.
	btScalar m_safetyGap;

	bool m_safetyConditions;  ///< off only to show what they prevent

	btHybridSwitchingInfo()
	    : m_proximity(true),
	      m_proximitySteps(3),
	      m_retryInterval(10),
	      m_quietSteps(30),
	      m_safetyGap(btScalar(0.01)),
	      m_safetyConditions(true)
	{
	}
};

/// When and how pairs switch. Read in every step, so that values may be changed at any time. Each has a meaning
/// whatever it is set to.
struct btHybridPairSwitchingInfo
{
	/// Pairs in contact can go coarser: the overlap of the coarser shapes becomes penetration credit, and nothing is
	/// pushed. Off: only levels that are apart. So it is of bodies whose contacts are springs
	/// (btCollisionObject::setContactStiffnessAndDamping), which cannot be told to leave an overlap as it is.
	bool m_credit;

	/// The coarsest level that a pair in contact takes on credit, unless the budget cannot be kept without. Of four to
	/// ten parts: at a single box contacts lose their direction, and stacks sag. Below 1 it acts as 1; for a pair that
	/// has no more levels than this, it is the one before its finest.
	int m_creditLevel;

	/// Steps between tries of a switch to a finer level that was not safe. Below 1 it acts as 1, above 255 as 255.
	int m_retryInterval;

	/// How far the bodies of a pair on credit may move against each other before the credit is compared with their
	/// finest shapes again, metres. 0, what is negative, and what is not a number: never. Above 1000 it acts as 1000.
	/// Small bodies may move less: one and a half times the distance at which Bullet ends their contacts.
	btScalar m_auditDistance;

	/// While a budget gives something up, bodies that lie still (a sixteenth of their sleeping thresholds), touch
	/// nothing below its finest level and are of no importance to policies fall asleep in a quarter of the usual time.
	/// Off: as in any Bullet world.
	bool m_earlyRest;

	/// Bodies that have fallen asleep in contact without detail that a budget took wake, with those that touch them,
	/// once the budget has room for all of it, so that gaps do not stay. Off: they sleep until something else wakes
	/// them.
	bool m_wakesForDetail;

	bool m_safetyConditions;  ///< off only to show what they prevent

	btHybridPairSwitchingInfo()
	    : m_credit(true),
	      m_creditLevel(2),
	      m_retryInterval(10),
	      m_auditDistance(btScalar(0.03)),
	      m_earlyRest(true),
	      m_wakesForDetail(true),
	      m_safetyConditions(true)
	{
	}
};

/// What has become of a budget.
typedef scatter::BudgetState btHybridBudgetState;

/// Counts of one step.
typedef scatter::PairStepCounts btHybridPairStepInfo;

/// What a step may cost.
typedef scatter::BudgetUnits btHybridBudgetUnits;

#endif  // BT_HYBRID_SWITCHING_H
