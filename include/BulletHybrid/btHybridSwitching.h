#ifndef BT_HYBRID_SWITCHING_H
#define BT_HYBRID_SWITCHING_H

#include <LinearMath/btScalar.h>

/// What has a level.
enum btHybridSwitchingMode
{
	/// Every pair of bodies. A hybrid's collision shape is always its finest level, for rays, sweeps and drawing; how
	/// it meets a neighbour is the pair's own business.
	BT_HYBRID_PAIR_SWITCHING,

	/// Every body, the same for all its neighbours: its collision shape is the level in use.
	BT_HYBRID_BODY_SWITCHING
};

/// When and how pairs switch.
struct btHybridPairSwitchingInfo
{
	/// Pairs in contact can go coarser: the overlap of the coarser shapes becomes penetration credit, and nothing is
	/// pushed. Off: only levels that are apart.
	bool m_credit;

	/// The coarsest level that a pair in contact takes on credit, unless the budget cannot be kept without. Of four to
	/// ten parts: at a single box contacts lose their direction, and stacks sag.
	int m_creditLevel;

	int m_retryInterval;  ///< steps between tries of a switch to a finer level that was not safe; 1 to 255

	/// How far the bodies of a pair on credit may move against each other before the credit is compared with their
	/// finest shapes again, metres. 0: never.
	btScalar m_auditDistance;

	bool m_safetyConditions;  ///< off only to show what they prevent

	btHybridPairSwitchingInfo()
	    : m_credit(true), m_creditLevel(2), m_retryInterval(10), m_auditDistance(btScalar(0.03)), m_safetyConditions(true)
	{
	}
};

/// Counts of one step.
struct btHybridPairStepInfo
{
	int m_pairs;           ///< that switch
	int m_finestPairs;     ///< of those, at their finest level
	int m_creditedPairs;   ///< of those, with penetration credit
	int m_touchingPairs;   ///< closer than 1 cm
	int m_touchingFinest;  ///< of those, at their finest level
	int m_requests;        ///< standing after the step
	int m_switchesCoarser;
	int m_switchesFiner;
	int m_creditSwitches;  ///< of both, on credit
	int m_retractions;
	int m_reusedPairs;  ///< in contact, kept their contacts for the step, because the budget was about to be exceeded
	int m_blockedTries;
	int m_separationQueries;
	int m_audits;
	int m_unsafeSwitches;  ///< that made a penetration deeper; always 0
	double m_units;        ///< what the step cost
	double m_plannedUnits;
	double m_budgetUnits;  ///< 0 without a budget

	btHybridPairStepInfo()
	    : m_pairs(0), m_finestPairs(0), m_creditedPairs(0), m_touchingPairs(0), m_touchingFinest(0), m_requests(0), m_switchesCoarser(0), m_switchesFiner(0), m_creditSwitches(0), m_retractions(0), m_reusedPairs(0), m_blockedTries(0), m_separationQueries(0), m_audits(0), m_unsafeSwitches(0), m_units(0), m_plannedUnits(0), m_budgetUnits(0)
	{
	}
};

#endif  // BT_HYBRID_SWITCHING_H
