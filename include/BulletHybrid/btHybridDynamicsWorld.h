#ifndef BT_HYBRID_DYNAMICS_WORLD_H
#define BT_HYBRID_DYNAMICS_WORLD_H

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "BulletHybrid/btHybridCollision.h"
#include "BulletHybrid/btHybridObservation.h"
#include "BulletHybrid/btHybridRigidBody.h"
#include "BulletHybrid/btHybridSwitching.h"

class btHybridBodySwitching;
class btHybridContactVerifier;
class btHybridNarrowphase;
class btHybridCoarsestBounds;
class btHybridNeighbourhood;
class btHybridPlanner;
class btHybridRegistration;
class btHybridRequests;
class btITaskScheduler;

/// Of callbacks that are called while contacts are looked for.
enum btHybridPromises
{
	/// The dispatcher's near callback hands every pair on to btCollisionDispatcher::defaultNearCallback.
	BT_HYBRID_NEAR_CALLBACK_FORWARDS = 1,
	/// gContactAddedCallback may be called on any thread, and in any order of pairs.
	BT_HYBRID_CONTACT_ADDED_ON_ANY_THREAD = 2
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
/// Rays, sweeps and contact tests meet the collision shape, which is the finest level in pair switching, and so do
/// pairs that a btPairCachingGhostObject keeps for itself: those of a character, which it dispatches between steps.
///
/// Without hybrid bodies its results are bit-identical to btDiscreteDynamicsWorld.
class btHybridDynamicsWorld : public btDiscreteDynamicsWorld
{
	btAlignedObjectArray<btHybridRigidBody*> m_hybrids;
	btHybridSwitchingInfo m_switching;
	btHybridPairSwitchingInfo m_pairSwitching;
	btHybridSwitchingInfo m_effective;  ///< what m_switching acts as in the step under way
	bool m_loadIsFine;
	double m_stepBegan;     ///< milliseconds
	bool m_isTimed;         ///< inside a step whose budget is of milliseconds
	bool m_detects;         ///< inside performDiscreteCollisionDetection
	const char* m_refusal;  ///< of the last call that adds or removes an object
	bool m_isIndexed;       ///< the neighbourhood knows which object is which hybrid
	btAlignedObjectArray<const btCollisionObject*> m_held;

	btHybridRequests* m_requests;
	btHybridNeighbourhood* m_neighbourhood;
	btHybridCoarsestBounds* m_coarsestBounds;  ///< of the hybrids, by their numbers
	btHybridBodySwitching* m_bodySwitching;
	btHybridNarrowphase* m_narrowphase;
	btHybridRegistration* m_registration;
	btHybridPlanner* m_planner;  ///< the narrowphase's; 0 in body switching
	btHybridContactVerifier* m_verifier;
	int m_verifyEvery;

	void planBodies();
	void planPairs();
	void detectPlainly();
	void dispatchPairs();
	void solveIslands(btContactSolverInfo& info);
	double getStepMilliseconds() const;
	void closeRequests();
	void findAsked();
	void updateHybridAabb(btHybridRigidBody* body);
	bool owns(const btCollisionObject* object) const;
	bool accepts(const btCollisionObject* object);
	bool refuse(const char* reason);
	const char* checkPairCall() const;
	void registerHybrid(btRigidBody* body);
	void unregisterHybrid(btHybridRigidBody* hybrid);
	void forget(btCollisionObject* object);
	void dropContacts(bool ofAll);

	btHybridDynamicsWorld(const btHybridDynamicsWorld&);
	btHybridDynamicsWorld& operator=(const btHybridDynamicsWorld&);

public:
	BT_DECLARE_ALIGNED_ALLOCATOR();

	btHybridDynamicsWorld(btDispatcher* dispatcher, btBroadphaseInterface* pairCache,
	                      btConstraintSolver* constraintSolver, btCollisionConfiguration* collisionConfiguration,
	                      btHybridSwitchingMode mode = BT_HYBRID_PAIR_SWITCHING);

	/// Bodies may outlive the world: hybrids are in no world then, their requests are gone, and they can be added to
	/// another one. The listener is not called any more.
	virtual ~btHybridDynamicsWorld();

	virtual int stepSimulation(btScalar timeStep, int maxSubSteps = 1,
	                           btScalar fixedTimeStep = btScalar(1) / btScalar(60));

	btHybridSwitchingMode getSwitchingMode() const
	{
		return m_planner ? BT_HYBRID_PAIR_SWITCHING : BT_HYBRID_BODY_SWITCHING;
	}

	/// Changes what has a level, between two steps. Bodies are brought to their finest level and woken, contacts with
	/// hybrids are found anew, requests are retracted. When pair switching ends, its policies, budget, focus and
	/// btHybridPairSwitchingInfo start anew; what is written to the info from then on holds when it comes back.
	/// Returns 0, or the number of pairs on penetration credit that speak against it, and then nothing happens: body
	/// switching knows no credit, and their finest shapes, which overlap by more than 2 cm, would be pushed apart.
	/// -1, and nothing happens, inside a step's collision detection, where listeners are called.
	int setSwitchingMode(btHybridSwitchingMode mode);

	/// Asks for a level, 1 the coarsest. The request stands until the body has switched or the request is
	/// retracted; it replaces one that stands. False, and nothing happens, if the body is 0, not in this world,
	/// or has no such level, and in pair switching if getNarrowphaseMistake() says that pairs cannot switch.
	/// A request for the level in use retracts the one that stands.
	/// In pair switching the body has switched when none of its pairs is finer; from then on they are held to
	/// that level.
	bool requestLevel(btHybridRigidBody* body, int level, btHybridScope scope = BT_HYBRID_LOCAL);

	/// Whether a request stood. False, and nothing happens, if the body is 0 or not in this world.
	bool retractRequest(btHybridRigidBody* body);
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

	/// 0 for none. Not owned. From inside a listener's call, too: what happens from then on is told to the new one.
	void setListener(btHybridListener* listener);

	btHybridSwitchingInfo& getSwitchingInfo()
	{
		return m_switching;
	}

	/// Of the last step, and of the calls since the step before it.
	const btHybridStepInfo& getStepInfo() const;

	/// Pair switching. While bodies switch it is kept for when pairs do.
	btHybridPairSwitchingInfo& getPairSwitchingInfo()
	{
		return m_pairSwitching;
	}

	/// Pair switching: of the last step; all zero while bodies switch.
	btHybridPairStepInfo getPairStepInfo() const;

	// The calls from here to removeFocus() are about pair switching. They return 0, or what is wrong and how to mend
	// it, and then nothing has changed: that bodies switch in this world, that its pairs cannot
	// (getNarrowphaseMistake()), that it is in a step's collision detection, where listeners are called, or that a
	// value makes no sense. The message is valid until the next call.

	/// Adds one of the policies that come with the library, such as "speed" or "speed:from=5,to=20". Refuses 0, and
	/// names and parameters that are not known.
	const char* addPolicy(const char* specification);

	/// What addPolicy would return; nothing is added.
	const char* checkPolicy(const char* specification);
	const char* removePolicies();

	/// What stepSimulation may cost: its steps share it. Detail is taken away where it is worth least, and given back
	/// when there is room. It may be another one in each step: what was learned stays known until there is none.
	/// Milliseconds of processor time of the stepping thread: depends on the clock. Refuses what is not finite and
	/// above 0.
	const char* setBudgetMilliseconds(double milliseconds);

	/// Clock-free: as if a unit of predicted cost took so many milliseconds, in one step with hybrids after the other,
	/// and after the last from the first again. The same run after run, on any machine. Refuses 0 steps, and numbers
	/// that are not finite and above 0.
	const char* setBudgetMilliseconds(double milliseconds, const double* millisecondsPerUnit, int count);

	/// Units of predicted cost, about microseconds on a machine of 2020: the same run after run. Refuses what is not
	/// finite and above 0.
	const char* setBudgetUnits(double units);

	/// The units of every step, as btHybridPairStepInfo::budgetUnits had them in an earlier run, which is repeated
	/// exactly; a step that was given 0 is one without a budget, and what was revised or settled to 0 stays as it was
	/// given. After the last one it stays. Refuses 0 steps, and units that are negative or not finite.
	const char* replayBudget(const btHybridBudgetUnits* steps, int count);
	const char* removeBudget();

	/// What has become of the budget in the last step: kept, exceeded, or impossible, and what was given up for it.
	/// scatter::describe says it in words.
	btHybridBudgetState getBudgetState() const;

	/// Where the viewer looks, for the policy "focus". fieldOfView: vertical, radians. Refuses places that are not
	/// finite, and angles that are not between 0 and pi.
	const char* setFocus(const btVector3& eye, const btVector3& target, btScalar fieldOfView);
	const char* removeFocus();

	/// What the user holds is to be finest: pairs whatever policies, budget and requests ask for; bodies, in body
	/// switching, as soon as that is safe. A hybrid is also told for the policy "held". False, and nothing happens, if
	/// the object is 0 or not in this world; what leaves the world is not held any more.
	bool setHeld(btCollisionObject* object, bool held);

	/// The pair algorithm of hybrid bodies. The constructor registers it with the dispatcher for pairs of a
	/// compound with a compound or convex shape, in the place of create functions that were registered before;
	/// pairs without a hybrid of this world go on to those of the dispatcher's configuration. At most one hybrid world
	/// a dispatcher: a second one has Bullet's own algorithms as long as it lives. So does one with a
	/// btCollisionDispatcherMt or a dispatcher of another kind. getNarrowphaseMistake() tells.
	///
	/// Levels must not change in place. Shapes of other bodies may: what Bullet counts, places, scaling, margins,
	/// bounds and numbers of points are compared once a step; clean the pairs of a body after any other change,
	/// as of a mesh's vertices within its bounds (of all bodies that have it), and after one of
	/// gContactBreakingThreshold. Detectors registered for two boxes, two spheres or two hulls, and Bullet's multipoint
	/// settings, are not asked.
	const btHybridCollisionInfo& getCollisionInfo() const;

	/// Drops the contacts of all pairs with a hybrid, and with m_plainBodies those of all others. Returns 0; or, inside
	/// a step's collision detection, where listeners are called, what is wrong, and then nothing has changed.
	const char* setCollisionInfo(const btHybridCollisionInfo& info);

	/// 0, or why hybrid pairs run in Bullet's own algorithms in this world, so that pairs do not switch, and how to
	/// mend it: another hybrid world has the dispatcher, or it is of a kind that takes no pair algorithm. Never
	/// changes.
	const char* getNarrowphaseMistake() const;

	/// Of the last step.
	const btHybridCollisionCounts& getCollisionCounts() const;
	btHybridCollisionMemory getCollisionMemory() const;

	/// A debug option: every n-th step, after the narrowphase, compares the contacts of all pairs with a hybrid, in
	/// pair switching of those at their finest level, with those of a plain Bullet world beside this one; see
	/// btHybridContactReport. That world makes every step, so all are slow. Does not change the simulation; asks
	/// filters (broadphase, dispatcher, children of compounds) once more, but no contact callback. Does not know create
	/// functions registered with the dispatcher, nor its near callback. Takes Bullet's global callbacks away meanwhile:
	/// not while another world is stepped on another thread. With a btAxisSweep3, whose proxies keep their numbers, it
	/// does not notice filter groups that change. 0 or less: never. Clears the report.
	void verifyContacts(int everyNSteps);
	const btHybridContactReport& getContactReport() const;

	/// The level in use between two objects whose broadphase bounds overlap, 1 the coarsest; the pair has as many
	/// levels as the body that has more. 0 if they do not overlap, neither is a hybrid, or one is 0 or not in this
	/// world.
	int getPairLevel(const btCollisionObject* objectA, const btCollisionObject* objectB) const;

	/// What a debugger shows of a pair of this world, and of the request for a body. For pairs without a hybrid, and
	/// for a body that is 0 or not in this world, all zero. Changes nothing.
	btHybridPairView viewPair(const btBroadphasePair& pair) const;
	btHybridRequestView viewRequest(const btHybridRigidBody* body) const;

	/// Adds all objects of pairs that are coarser than they could be, each once, partners without levels too; none
	/// without pair switching. Much cheaper than viewing each pair.
	void viewCoarserObjects(btAlignedObjectArray<btHybridCoarserObject>& objects) const;

	int getNumHybrids() const
	{
		return m_hybrids.size();
	}
	/// 0 if there are not so many.
	btHybridRigidBody* getHybrid(int index) const
	{
		return index >= 0 && index < m_hybrids.size() ? m_hybrids[index] : 0;
	}

	/// Nothing happens, and getRefusal() tells why, if an object that is to be added is 0 or already in a world, this
	/// one or another, or if one that is to be removed is 0 or not in this world. Hybrids come and go as rigid bodies:
	/// one that is added as a collision object is an ordinary one.
	virtual void addRigidBody(btRigidBody* body);
	virtual void addRigidBody(btRigidBody* body, int group, int mask);
	virtual void removeRigidBody(btRigidBody* body);
	virtual void addCollisionObject(btCollisionObject* collisionObject, int group = btBroadphaseProxy::StaticFilter,
	                                int mask = btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
	virtual void removeCollisionObject(btCollisionObject* collisionObject);

	/// Why the last call that adds or removes an object did nothing; 0 if it did what it should. The debug drawer, if
	/// there is one, is told as well.
	const char* getRefusal() const
	{
		return m_refusal;
	}

	/// How many threads, the caller's among them, look for the contacts of hybrids and of two plain boxes, and solve
	/// islands if the world's solver is a btHybridContactSolver: 1 to 64, 1 unless set otherwise. Results are the same
	/// bits for any number. Callbacks, listeners and the dispatcher's memory stay on the caller's thread; other threads
	/// read objects and shapes, the meshes of grounds one at a time, and write contacts while no callback that hears of
	/// contacts is set (gContactProcessedCallback and the like); otherwise they find out which parts are near each
	/// other, and how near. With a near callback of the program's own, which may leave pairs out, there is one thread
	/// unless the program promises otherwise; so there is in steps with few pairs, and on one core. Returns 0; or, for
	/// other numbers and inside a step, what is wrong, and then nothing has changed.
	const char* setNumThreads(int threads);
	int getNumThreads() const;

	/// What a program promises of its callbacks, any of btHybridPromises; none unless said otherwise. It makes a
	/// difference to threads alone.
	void setPromises(int promises);
	int getPromises() const;

	/// The threads of a program's own scheduler, which must outlive its use, in the place of the world's; 0: the
	/// world's again. It is called directly, so that it works in a Bullet that was built without threads. Returns 0;
	/// or, inside a step, what is wrong.
	const char* setTaskScheduler(btITaskScheduler* scheduler);

	/// Hybrids get the bounds of their coarsest level.
	virtual void updateAabbs();

	virtual void performDiscreteCollisionDetection();

protected:
	virtual void internalSingleStepSimulation(btScalar timeStep);
	virtual void solveConstraints(btContactSolverInfo& info);
	virtual void updateActivationState(btScalar timeStep);
};

#endif  // BT_HYBRID_DYNAMICS_WORLD_H
