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
#include "pairs/pair_plan.h"

class btHybridLevelBodies;

/// Says what level every pair should have: keeps the table of all pairs that switch, and shows it to the policies and
/// the governor between broadphase and narrowphase.
class btHybridPlanner
{
	struct Pair
	{
		btHybridLevelBodies* m_objects[2];
		int* m_place;         ///< where its owner keeps its index
		int m_coarsest;       ///< level that it can have
		bool m_isGround;      ///< the second object has no levels, and is no list of parts
		bool m_requested;     ///< a change of level was asked for and has not happened
		bool m_acknowledged;  ///< and was tried
		unsigned char m_targetBefore;
		int m_step;            ///< the last one in which it was processed
		int m_stepRequested;   ///< in which the request was made
		float m_averageUnits;  ///< what it costs a step while on credit: that comes in bursts
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

	void add(btHybridLevelBodies* object0, btHybridLevelBodies* object1, double numChildPairs, int* place);
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
	void countQueries(int queries);
	int getTarget(int pair);
	scatter::lod::SwitchRules getRules(int pair) const;
	int keepsFrom(int pair) const;
	bool mayAudit() const;
	void acknowledge(int pair);
	void takeChoice(int pair, const scatter::lod::SwitchChoice& choice);
	void takeAudit(const scatter::lod::PairWorkload& work);
	void takeWork(int pair, const scatter::pairs::PairOutcome& outcome);

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
	/// place: where its owner keeps its index, as long as the pair is there.
	void addPair(btHybridLevelBodies* object0, btHybridLevelBodies* object1, int* place);
	/// A pair of a body with levels and what it may lie on.
	void addGround(btHybridLevelBodies* body, btHybridLevelBodies* ground, int* place);
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

	bool isAtFinest(int pair) const
	{
		return m_planned[pair].view.level == m_planned[pair].view.finest;
	}

	/// Between broadphase and narrowphase.
	void plan(const btCollisionObjectArray& objects, int numMoving, int numOverlappingPairs);

	/// In the narrowphase: what a pair is to do in this step, and what has become of it.
	scatter::pairs::PairPlan planPair(int pair);
	void take(int pair, const scatter::pairs::PairOutcome& outcome);

	/// Whether a pair has the level that it should have, and no contacts.
	bool isSettled(int pair) const
	{
		const scatter::lod::PlannedPair& planned = m_planned[pair];
		return planned.target == planned.view.level && !planned.view.touching;
	}

	/// Whether a pair's next step is one of looking for contacts at `level`, which it has, without credit, whatever others take.
	bool isForeseeable(int pair, int level) const
	{
		const scatter::lod::PlannedPair& planned = m_planned[pair];
		return planned.view.level == level && planned.target == level && !planned.view.credited && !(m_plans && planned.view.touching);
	}

	/// A pair that is settled was left without a look.
	void countQuiet(int pair)
	{
		m_governor.spend(m_planned[pair], 0, 0);
		m_stepInfo.m_pairs++;
		m_stepInfo.m_finestPairs += m_planned[pair].view.level == m_planned[pair].view.finest ? 1 : 0;
		m_stepInfo.m_creditedPairs += m_planned[pair].view.credited ? 1 : 0;
	}

	/// Whether the budget is about to be exceeded, so that what is not urgent should wait for a step.
	bool isShort() const
	{
		return m_plans && m_governor.isShort();
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

	btHybridPairView viewPair(int pair) const;

	/// Objects of pairs on credit, two for each.
	void findCredited(btAlignedObjectArray<btHybridLevelBodies*>& objects) const;

	/// Adds to the request of a body what holds it up.
	void viewObstacle(const btCollisionObject* body, btHybridRequestView& request) const;
};

#endif  // BT_HYBRID_PLANNER_H
