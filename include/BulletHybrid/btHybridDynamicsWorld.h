#ifndef BT_HYBRID_DYNAMICS_WORLD_H
#define BT_HYBRID_DYNAMICS_WORLD_H

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "BulletHybrid/btHybridCollision.h"
#include "BulletHybrid/btHybridRigidBody.h"

class btHybridContactVerifier;
class btHybridNarrowphase;
class btHybridNeighbourhood;

/// Counts of one step.
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

/// When and how bodies switch.
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
/// the broadphase and the narrowphase, on request and only when it is safe:
/// a finer level needs the body to be free of contact, a coarser one needs the coarser shape to be free of
/// collision. Without hybrid bodies its results are bit-identical to btDiscreteDynamicsWorld.
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

	btHybridNeighbourhood* m_neighbourhood;
	btHybridNarrowphase* m_narrowphase;
	btHybridContactVerifier* m_verifier;
	int m_verifyEvery;

	void planSwitching();
	void closeCounts();
	void updateHybridAabb(btHybridRigidBody* body);
	void followProximity(btHybridRigidBody* body);
	void tryRequest(btHybridRigidBody* body);
	bool isSafe(const btHybridRigidBody* body, int level);
	bool isSeparatedFromPartners(const btHybridRigidBody* body, int level);
	void switchLevel(btHybridRigidBody* body, int level);
	void makeRequest(btHybridRigidBody* body, int level, btHybridScope scope, bool byProximity);
	void retract(btHybridRigidBody* body, btHybridRetraction reason);
	void registerHybrid(btRigidBody* body);

	btHybridDynamicsWorld(const btHybridDynamicsWorld&);
	btHybridDynamicsWorld& operator=(const btHybridDynamicsWorld&);

public:
	BT_DECLARE_ALIGNED_ALLOCATOR();

	btHybridDynamicsWorld(btDispatcher* dispatcher, btBroadphaseInterface* pairCache, btConstraintSolver* constraintSolver, btCollisionConfiguration* collisionConfiguration);
	virtual ~btHybridDynamicsWorld();

	/// Asks for a level, 1 the coarsest. The request stands until the body has switched or the request is
	/// retracted; it replaces one that stands. False, and nothing happens, if the body is not in this world
	/// or has no such level. A request for the level in use retracts the one that stands.
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
	void setListener(btHybridListener* listener)
	{
		m_listener = listener;
	}

	btHybridSwitchingInfo& getSwitchingInfo()
	{
		return m_switching;
	}

	/// Of the last step, and of the calls since the step before it.
	const btHybridStepInfo& getStepInfo() const
	{
		return m_stepInfo;
	}

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
	/// with a hybrid by brute force and compares with the contacts there are. Slow: seconds a step in a big
	/// pile. Does not change the simulation. 0: never. Clears the report.
	void verifyContacts(int everyNSteps);
	const btHybridContactReport& getContactReport() const;

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
};

#endif  // BT_HYBRID_DYNAMICS_WORLD_H
