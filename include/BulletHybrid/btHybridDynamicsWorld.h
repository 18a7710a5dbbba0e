#ifndef BT_HYBRID_DYNAMICS_WORLD_H
#define BT_HYBRID_DYNAMICS_WORLD_H

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "BulletHybrid/btHybridCollision.h"
#include "BulletHybrid/btHybridObservation.h"
#include "BulletHybrid/btHybridRigidBody.h"
#include "BulletHybrid/btHybridSwitching.h"

class btHybridContactVerifier;
class btHybridNarrowphase;
class btHybridNeighbourhood;
class btHybridPlanner;

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
	    : m_standingRequests(0), m_switchesCoarser(0), m_switchesFiner(0), m_retractions(0), m_blockedTries(0), m_separationQueries(0)
	{
	}
};

/// When and how bodies switch, in body switching.
struct btHybridSwitchingInfo
{
	/// The world asks for level 1 when another moving body is near, and for the finest level when none is.
	/// Static bodies count for safety, but do not ask for anything: a floor is always near.
	bool m_proximity;

	/// A request comes at least this many steps before the level-1 bounds of two bodies can touch at their
	/// present velocities; more than 1.
	btScalar m_proximitySteps;

	int m_retryInterval;      ///< steps between tries of a blocked request; at least 1
	int m_quietSteps;         ///< steps without a neighbour before the finest level is asked for
	btScalar m_safetyGap;     ///< distance that must separate shapes for a switch to be safe
	bool m_safetyConditions;  ///< off only to show what they prevent

	btHybridSwitchingInfo()
	    : m_proximity(true), m_proximitySteps(3), m_retryInterval(10), m_quietSteps(30), m_safetyGap(btScalar(0.01)), m_safetyConditions(true)
	{
	}
};

/// A btDiscreteDynamicsWorld that switches the encapsulation levels of btHybridRigidBody objects, between
/// the broadphase and the narrowphase, on request and only when it is safe.
///
/// In pair switching every pair of bodies has a level. By default everything is finest; policies, and a budget for the
/// cost of a step, take detail away and give it back. No switch pushes bodies apart: the shapes of the new level are
/// apart, or their overlap becomes penetration credit, which is added to the distance of their contacts.
///
/// In body switching every body has one: a finer level needs the body to be free of contact, a coarser one needs
/// the coarser shape to be free of collision.
///
/// Without hybrid bodies its results are bit-identical to btDiscreteDynamicsWorld.
class btHybridDynamicsWorld : public btDiscreteDynamicsWorld
{
	btAlignedObjectArray<btHybridRigidBody*> m_hybrids;
	btHybridSwitchingInfo m_switching;
	btHybridStepInfo m_stepInfo;
	btHybridStepInfo m_counting;  ///< of the step under way, and of calls since the last one
	btHybridListener* m_listener;
	bool m_loadIsFine;
	int m_step;
	int m_standingRequests;
	bool m_isIndexed;  ///< the neighbourhood knows which object is which hybrid
	btAlignedObjectArray<const btCollisionObject*> m_held;

	btHybridNeighbourhood* m_neighbourhood;
	btHybridNarrowphase* m_narrowphase;
	btHybridPlanner* m_planner;  ///< the narrowphase's; 0 in body switching
	btHybridContactVerifier* m_verifier;
	int m_verifyEvery;

	void planSwitching();
	void planPairs();
	void closeRequests();
	void findAsked();
	void closeCounts();
	void updateHybridAabb(btHybridRigidBody* body);
	void followProximity(btHybridRigidBody* body);
	void followHand(btHybridRigidBody* body);
	void tryRequest(btHybridRigidBody* body);
	bool isSafe(btHybridRigidBody* body, int level);
	const btCollisionObject* findObstacle(const btHybridRigidBody* body, int level);
	void switchLevel(btHybridRigidBody* body, int level);
	void makeRequest(btHybridRigidBody* body, int level, btHybridScope scope, bool byProximity);
	void retract(btHybridRigidBody* body, btHybridRetraction reason);
	void registerHybrid(btRigidBody* body);
	void forget(const btCollisionObject* object);
	void dropContactsOfHybrids();

	btHybridDynamicsWorld(const btHybridDynamicsWorld&);
	btHybridDynamicsWorld& operator=(const btHybridDynamicsWorld&);

public:
	BT_DECLARE_ALIGNED_ALLOCATOR();

	btHybridDynamicsWorld(btDispatcher* dispatcher, btBroadphaseInterface* pairCache, btConstraintSolver* constraintSolver, btCollisionConfiguration* collisionConfiguration, btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING);
	virtual ~btHybridDynamicsWorld();

	btHybridSwitchingMode getSwitchingMode() const
	{
		return m_planner ? BT_HYBRID_PAIR_SWITCHING : BT_HYBRID_BODY_SWITCHING;
	}

	/// Changes what has a level, between two steps. Bodies are brought to their finest level and woken, contacts with
	/// hybrids are found anew, requests are retracted; policies, budget and btHybridPairSwitchingInfo start anew.
	/// Returns 0, or the number of pairs on penetration credit that speak against it, and then nothing happens: body
	/// switching knows no credit, and their finest shapes, which overlap by more than 2 cm, would be pushed apart.
	int setSwitchingMode(btHybridSwitchingMode mode);

	/// Asks for a level, 1 the coarsest. The request stands until the body has switched or the request is
	/// retracted; it replaces one that stands. False, and nothing happens, if the body is not in this world
	/// or has no such level. A request for the level in use retracts the one that stands.
	/// In pair switching the body has switched when none of its pairs is finer; from then on they are held to
	/// that level.
	bool requestLevel(btHybridRigidBody* body, int level, btHybridScope scope = BT_HYBRID_LOCAL);
	void retractRequest(btHybridRigidBody* body);
	void retractAllRequests();

	/// The global policy's word. While the load is fine the proximity policy asks for nothing, and its
	/// requests that stand are retracted at the next step.
	void setLoadIsFine(bool fine)
	{
		m_loadIsFine = fine;
	}
	bool getLoadIsFine() const
	{
		return m_loadIsFine;
	}

	/// 0 for none. Not owned.
	void setListener(btHybridListener* listener);

	btHybridSwitchingInfo& getSwitchingInfo()
	{
		return m_switching;
	}

	/// Of the last step, and of the calls since the step before it.
	const btHybridStepInfo& getStepInfo() const
	{
		return m_stepInfo;
	}

	/// Pair switching; asserted.
	btHybridPairSwitchingInfo& getPairSwitchingInfo();

	/// Pair switching: of the last step.
	btHybridPairStepInfo getPairStepInfo() const;

	/// Pair switching: adds one of the policies that come with the library, such as "speed" or "speed:from=5,to=20".
	/// 0, or what is wrong with it, valid until the next call.
	const char* addPolicy(const char* specification);

	/// What addPolicy would return; nothing is added.
	const char* checkPolicy(const char* specification);
	void removePolicies();

	/// Pair switching: what a step may cost. Detail is taken away where it is worth least, and given back when there
	/// is room.
	/// Milliseconds of processor time of the stepping thread: depends on the clock.
	void setBudgetMilliseconds(double milliseconds);

	/// Units of predicted cost, about microseconds on a machine of 2020: the same run after run.
	void setBudgetUnits(double units);

	/// The units of every step, as btHybridPairStepInfo::m_budgetUnits had them in an earlier run, which is repeated
	/// exactly. After the last one it stays.
	void replayBudget(const double* units, int count);
	void removeBudget();

	/// Where the viewer looks, for the policy "focus".
	void setFocus(const btVector3& eye, const btVector3& target, btScalar fieldOfView);
	void removeFocus();

	/// What the user holds is to be finest: pairs whatever policies, budget and requests ask for; bodies, in body
	/// switching, as soon as that is safe. A hybrid is also told for the policy "held".
	void setHeld(btCollisionObject* object, bool held);

	/// The pair algorithm of hybrid bodies. The constructor registers it with the dispatcher for pairs of a
	/// compound with a compound or convex shape, in the place of create functions that were registered before;
	/// pairs without a hybrid go on to those of the dispatcher's configuration. At most one hybrid world a
	/// dispatcher. Not with a btCollisionDispatcherMt or a dispatcher of another kind: there Bullet's own
	/// algorithms run.
	///
	/// Levels must not change in place. Shapes of other bodies may: what Bullet counts, places, scaling, margins,
	/// bounds and numbers of points are compared once a step; clean the pairs of a body after any other change,
	/// and after one of gContactBreakingThreshold. Detectors registered for two boxes, two spheres or two hulls,
	/// and Bullet's multipoint settings, are not asked.
	const btHybridCollisionInfo& getCollisionInfo() const;

	/// Drops the contacts of all pairs with a hybrid. Not inside a step.
	void setCollisionInfo(const btHybridCollisionInfo& info);

	/// Of the last step.
	const btHybridCollisionCounts& getCollisionCounts() const;
	btHybridCollisionMemory getCollisionMemory() const;

	/// A debug option: every n-th step, after the narrowphase, tests all child pairs of all overlapping pairs
	/// with a hybrid, in pair switching of those at their finest level, by brute force and compares with the contacts there are. Slow: seconds a step in a big
	/// pile. Does not change the simulation. 0: never. Clears the report.
	void verifyContacts(int everyNSteps);
	const btHybridContactReport& getContactReport() const;

	/// The level in use between two objects whose broadphase bounds overlap, 1 the coarsest; the pair has as many
	/// levels as the body that has more. 0 if they do not overlap or neither is a hybrid.
	int getPairLevel(const btCollisionObject* objectA, const btCollisionObject* objectB) const;

	/// What a debugger shows of a pair of this world, and of the request for a body. For pairs without a hybrid all zero.
	/// Changes nothing.
	btHybridPairView viewPair(const btBroadphasePair& pair) const;
	btHybridRequestView viewRequest(const btHybridRigidBody* body) const;

	int getNumHybrids() const
	{
		return m_hybrids.size();
	}
	btHybridRigidBody* getHybrid(int index) const
	{
		return m_hybrids[index];
	}

	virtual void addRigidBody(btRigidBody* body);
	virtual void addRigidBody(btRigidBody* body, int group, int mask);
	virtual void removeRigidBody(btRigidBody* body);
	virtual void removeCollisionObject(btCollisionObject* collisionObject);

	/// Hybrids get the bounds of their coarsest level.
	virtual void updateAabbs();

	virtual void performDiscreteCollisionDetection();

protected:
	virtual void internalSingleStepSimulation(btScalar timeStep);
};

#endif  // BT_HYBRID_DYNAMICS_WORLD_H
