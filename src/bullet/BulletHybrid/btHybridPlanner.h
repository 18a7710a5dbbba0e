#ifndef BT_HYBRID_PLANNER_H
#define BT_HYBRID_PLANNER_H

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include <string>
#include <vector>

#include "BulletHybrid/btHybridObservation.h"
#include "BulletHybrid/btHybridRequest.h"
#include "BulletHybrid/btHybridSwitching.h"
#include "lod/governor.h"
#include "lod/pair_switch.h"
#include "lod/policy_list.h"
#include "lod/unit_budget.h"

class btHybridLevelBodies;
class btHybridPairAlgorithm;

/// Says what level every pair should have: keeps the table of all pairs that switch, and shows it to the policies and
/// the governor between broadphase and narrowphase.
class btHybridPlanner
{
	struct Pair
	{
		btHybridPairAlgorithm* m_algorithm;
		const btHybridLevelBodies* m_objects[2];
		bool m_requested;     ///< a change of level was asked for and has not happened
		bool m_acknowledged;  ///< and was tried
		unsigned char m_targetBefore;
		int m_step;           ///< the last one in which it was processed
		int m_stepRequested;  ///< in which the request was made
	};

	static const unsigned char c_byProgram = 255;  ///< as scatter::lod::Wish::askedBy

	std::vector<scatter::lod::PlannedPair> m_planned;
	std::vector<Pair> m_pairs;  ///< of the same order
	std::vector<scatter::lod::PairView> m_views;
	std::vector<scatter::lod::BodyView> m_bodies;
	scatter::lod::PolicyList m_policies;
	scatter::lod::CostModel m_costs;
	scatter::lod::Governor m_governor;
	scatter::lod::UnitBudget m_budget;
	scatter::lod::Situation m_situation;

	btHybridPairSwitchingInfo m_info;
	btHybridPairStepInfo m_stepInfo;  ///< of the step under way, and of what happened since the last one
	btHybridPairStepInfo m_lastStepInfo;
	btHybridListener* m_listener;
	int m_step;
	unsigned int m_numCreated;  ///< pairs, ever
	int m_numBelowFinest;       ///< pairs that are, or should be, coarser than their finest level
	bool m_asks;                ///< a body is asked to be coarse
	bool m_plans;               ///< this step was planned
	bool m_advisesAll;          ///< in the next plan every pair is advised, whosever turn it is
	bool m_needsTime;
	double m_fixedUnits;
	double m_units;  ///< of the step under way
	double m_lastUnits;
	double m_budgetUnits;
	double m_auditUnits;  ///< in this step
	std::string m_mistake;
	btAlignedObjectArray<const btCollisionObject*> m_held;  ///< by the user

	void showBodies(const btCollisionObjectArray& objects);
	void showPairs();
	void advise(int pair);
	void applyAsked(int pair);
	bool isHeld(const btCollisionObject* object) const;
	void followRequest(int pair);
	void finishPair(int pair);
	void tell(btHybridPairEventKind kind, int pair, int from, int to, bool onCredit) const;
	const char* whoAsks(int pair, btHybridScope& scope) const;
	bool hasBudget() const;
	void spend(double units);

public:
	btHybridPlanner();

	/// As they act. Before every plan, as the program may change them at any time.
	void setInfo(const btHybridPairSwitchingInfo& info)
	{
		m_info = info;
	}
	const btHybridPairSwitchingInfo& getInfo() const
	{
		return m_info;
	}
	/// 0, or what is wrong with it.
	const char* addPolicy(const char* specification);
	const char* checkPolicy(const char* specification);
	void removePolicies();
	void setFocus(const btVector3& eye, const btVector3& target, btScalar fieldOfView);
	void removeFocus();
	/// needsTime: it is in milliseconds.
	void setBudget(const scatter::lod::UnitBudget& budget, bool needsTime);
	void setListener(btHybridListener* listener)
	{
		m_listener = listener;
	}
	scatter::lod::SwitchRules getRules(int pair) const;

	int addPair(btHybridPairAlgorithm* algorithm, const btHybridLevelBodies* object0, const btHybridLevelBodies* object1);
	void removePair(int pair);
	int getNumPairs() const
	{
		return int(m_pairs.size());
	}
	const scatter::lod::PlannedPair& getPair(int pair) const
	{
		return m_planned[pair];
	}
	static size_t getPairBytes()
	{
		return sizeof(Pair) + sizeof(scatter::lod::PlannedPair) + sizeof(scatter::lod::PairView);
	}

	/// And looked for its contacts in the last step. Also of pairs that are none of the planner's.
	bool isAtFinest(const btCollisionAlgorithm* algorithm) const;

	/// Between broadphase and narrowphase.
	void plan(const btCollisionObjectArray& objects, int numMoving, int numOverlappingPairs);

	/// The level that a pair should have, in the narrowphase.
	int getTarget(int pair);

	/// Whether a pair has the level that it should have, and no contacts.
	bool isSettled(int pair) const
	{
		const scatter::lod::PlannedPair& planned = m_planned[pair];
		return planned.target == planned.view.level && !planned.view.touching;
	}

	/// A pair that is settled was left without a look.
	void countQuiet(int pair)
	{
		m_governor.spend(m_planned[pair], 0, 0);
		m_stepInfo.m_pairs++;
		m_stepInfo.m_finestPairs += m_planned[pair].view.level == m_planned[pair].view.finest ? 1 : 0;
		m_stepInfo.m_creditedPairs += m_planned[pair].view.credited ? 1 : 0;
	}

	/// What has become of it.
	void acknowledge(int pair);
	void take(int pair, const scatter::lod::SwitchChoice& choice);
	void countQuery();

	/// Whether the budget is about to be exceeded, so that what is not urgent should wait for a step.
	bool isShort() const
	{
		return m_plans && m_governor.isShort();
	}

	/// Whether a pair in contact should keep its contacts for this step, as the budget is about to be exceeded.
	bool mayReuse(int pair) const;
	bool mayAudit() const;
	void countAudit();
	void takeAudit(const scatter::lod::PairWorkload& work);

	/// average: of the pair's cost, if that comes in bursts.
	void takeWork(int pair, const scatter::lod::PairWorkload& work, bool touching, bool credited, float* average);

	void countUnsafe()
	{
		m_stepInfo.m_unsafeSwitches++;
	}

	/// After the narrowphase.
	void finish();

	/// After the step. milliseconds: of processor time.
	void takeTime(double milliseconds);
	bool needsTime() const
	{
		return m_needsTime;
	}

	const btHybridPairStepInfo& getStepInfo() const
	{
		return m_lastStepInfo;
	}

	/// Whether a body is asked to be coarser than its finest level.
	void setAsks(bool asks)
	{
		m_asks = asks;
	}

	/// Objects whose pairs are to be finest, whatever else is asked for.
	void setHeld(const btAlignedObjectArray<const btCollisionObject*>& held);

	/// A pair of a body that is finer than the body is asked to be; -1 if there is none.
	int findFinerPair(const btCollisionObject* body) const;

	/// Whether all pairs of a body have the level that it is asked to have.
	bool complies(const btCollisionObject* body) const
	{
		return findFinerPair(body) < 0;
	}

	/// Of the pair that is this algorithm's; all zero if it is none of the planner's.
	btHybridPairView viewPair(const btCollisionAlgorithm* algorithm) const;

	/// Pairs on credit whose finest shapes can not be proven to overlap by no more than `depth`.
	int countDeepPairs(btScalar depth) const;

	/// Adds to the request of a body what holds it up.
	void viewObstacle(const btCollisionObject* body, btHybridRequestView& request) const;
};

#endif  // BT_HYBRID_PLANNER_H
