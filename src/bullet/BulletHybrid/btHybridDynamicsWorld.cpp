#include "BulletHybrid/btHybridDynamicsWorld.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <LinearMath/btQuickprof.h>

#include <limits>

#include "btHybridAheadEngine.h"
#include "btHybridAwakePairs.h"
#include "btHybridBodySwitching.h"
#include "btHybridCoarsestBounds.h"
#include "btHybridContactGroups.h"
#include "btHybridContactVerifier.h"
#include "btHybridEarlyRest.h"
#include "btHybridGhostPairs.h"
#include "btHybridManifolds.h"
#include "btHybridNarrowphase.h"
#include "btHybridNeighbourhood.h"
#include "btHybridPlanner.h"
#include "btHybridRegistration.h"
#include "btHybridRequests.h"
#include "btHybridSettings.h"
#include "btHybridStepClock.h"

namespace
{
const char c_insideDetection[] =
    "this is a step's collision detection, where listeners are called; call between two steps";

/// Marks the collision detection of a step, for as long as it lives.
class DetectionScope
{
	bool& m_detects;

public:
	explicit DetectionScope(bool& detects) : m_detects(detects)
	{
		m_detects = true;
	}
	~DetectionScope()
	{
		m_detects = false;
	}
};
}  // namespace

btHybridDynamicsWorld::btHybridDynamicsWorld(btDispatcher* dispatcher, btBroadphaseInterface* pairCache,
                                             btConstraintSolver* constraintSolver,
                                             btCollisionConfiguration* collisionConfiguration,
                                             btHybridSwitchingMode mode)
    : btDiscreteDynamicsWorld(dispatcher, pairCache, constraintSolver, collisionConfiguration),
      m_loadIsFine(false),
      m_stepBegan(0),
      m_isTimed(false),
      m_detects(false),
      m_refusal(0),
      m_isIndexed(false),
      m_requests(new btHybridRequests),
      m_neighbourhood(new btHybridNeighbourhood),
      m_coarsestBounds(new btHybridCoarsestBounds),
      m_bodySwitching(new btHybridBodySwitching(*m_requests, *m_neighbourhood)),
      m_narrowphase(new btHybridNarrowphase(mode == BT_HYBRID_PAIR_SWITCHING)),
      m_registration(new btHybridRegistration(dispatcher, this, m_narrowphase)),
      m_planner(m_narrowphase->getPlanner()),
      m_verifier(new btHybridContactVerifier),
      m_verifyEvery(0)
{
}

btHybridDynamicsWorld::~btHybridDynamicsWorld()
{
	for (int i = 0; i < m_collisionObjects.size(); i++)
	{
		btHybridRigidBody* hybrid = dynamic_cast<btHybridRigidBody*>(m_collisionObjects[i]);
		if (!hybrid || hybrid->m_world != this)
			continue;
		hybrid->m_world = 0;
		hybrid->m_home = 0;
		hybrid->m_hybridIndex = -1;
		hybrid->m_request = btHybridRequest();
		// So that it is in no world for Bullet, either.
		hybrid->setWorldArrayIndex(-1);
	}
	// Pairs may end after the world.
	if (m_planner)
		m_planner->setListener(0);
	delete m_verifier;
	delete m_registration;
	m_narrowphase->removeUser();
	delete m_bodySwitching;
	delete m_coarsestBounds;
	delete m_neighbourhood;
	delete m_requests;
}

int btHybridDynamicsWorld::setSwitchingMode(btHybridSwitchingMode mode)
{
	const btScalar c_mostOverlap = btScalar(0.02);
	if (m_detects)
		return -1;
	if (mode == getSwitchingMode())
		return 0;
	const int numDeep = m_planner ? m_narrowphase->countDeepPairs(c_mostOverlap) : 0;
	if (numDeep > 0)
		return numDeep;
	retractAllRequests();
	dropContacts(false);
	if (m_planner)
		m_pairSwitching = btHybridPairSwitchingInfo();
	m_narrowphase->setSwitchesPairs(mode == BT_HYBRID_PAIR_SWITCHING);
	m_planner = m_narrowphase->getPlanner();
	for (int i = 0; i < m_hybrids.size(); i++)
	{
		btHybridRigidBody* body = m_hybrids[i];
		body->m_level = body->getFinestLevel();
		body->setCollisionShape(body->m_levels->getLevelShape(body->m_level));
		body->m_lonelySteps = 0;
		body->activate();
	}
	if (m_planner)
	{
		m_planner->setListener(m_requests->getListener());
		m_planner->setHeld(m_held);
	}
	return 0;
}

void btHybridDynamicsWorld::setListener(btHybridListener* listener)
{
	m_requests->setListener(listener);
	if (m_planner)
		m_planner->setListener(listener);
}

bool btHybridDynamicsWorld::requestLevel(btHybridRigidBody* body, int level, btHybridScope scope)
{
	if (!body || body->m_world != this || level < 1 || level > body->getFinestLevel())
		return false;
	if (m_planner && getNarrowphaseMistake())
		return false;
	if (level == body->m_level)
	{
		m_requests->retract(body, BT_HYBRID_RETRACTED_BY_CALLER);
		return true;
	}
	m_requests->make(body, level, scope, false);
	if (m_planner && m_requests->getNumStanding() > 0)
		m_planner->setAsks(true);
	return true;
}

bool btHybridDynamicsWorld::retractRequest(btHybridRigidBody* body)
{
	if (!body || body->m_world != this || !body->m_request.isStanding())
		return false;
	m_requests->retract(body, BT_HYBRID_RETRACTED_BY_CALLER);
	return true;
}

void btHybridDynamicsWorld::retractAllRequests()
{
	for (int i = 0; i < m_hybrids.size(); i++)
		m_requests->retract(m_hybrids[i], BT_HYBRID_RETRACTED_BY_CALLER);
}

void btHybridDynamicsWorld::updateAabbs()
{
	if (m_hybrids.size() == 0)
	{
		btDiscreteDynamicsWorld::updateAabbs();
		return;
	}
	if (!m_isIndexed || m_neighbourhood->getNumObjects() != m_collisionObjects.size())
		m_neighbourhood->indexHybrids(m_collisionObjects.size(), m_hybrids);
	m_isIndexed = true;
	m_effective = btHybridEffective(m_switching);
	// In body switching bounds are those of the report, as its requests are made when bounding boxes meet
	// (section 4.5.2).
	m_coarsestBounds->beginStep(m_planner ? m_broadphasePairCache->getOverlappingPairCache()->getNumOverlappingPairs()
	                                      : 0);
	BT_PROFILE("updateAabbs");
	for (int i = 0; i < m_collisionObjects.size(); i++)
	{
		btCollisionObject* object = m_collisionObjects[i];
		if (!m_forceUpdateAllAabbs && !object->isActive())
			continue;
		const int hybrid = m_neighbourhood->hybridOfObject(i);
		if (hybrid >= 0)
			updateHybridAabb(m_hybrids[hybrid]);
		else
			updateSingleAabb(object);
	}
}

void btHybridDynamicsWorld::updateHybridAabb(btHybridRigidBody* body)
{
	btVector3 aabbMin, aabbMax;
	m_coarsestBounds->getAabb(body->m_hybridIndex, *body->m_levels, body->getWorldTransform(), aabbMin, aabbMax);
	if (getDispatchInfo().m_useContinuous && !body->isStaticOrKinematicObject())
	{
		btVector3 nextMin, nextMax;
		m_coarsestBounds->getAabb(body->m_hybridIndex, *body->m_levels, body->getInterpolationWorldTransform(), nextMin,
		                          nextMax);
		aabbMin.setMin(nextMin);
		aabbMax.setMax(nextMax);
	}
	// The safety queries look at the pairs of these bounds, so the gap must fit in.
	const btScalar margin = btMax(m_effective.m_safetyGap, gContactBreakingThreshold);
	const btVector3 wide(margin, margin, margin);
	aabbMin -= wide;
	aabbMax += wide;
	if ((aabbMax - aabbMin).length2() < btScalar(1e12))
		m_broadphasePairCache->setAabb(body->getBroadphaseHandle(), aabbMin, aabbMax, m_dispatcher1);
	else
		updateSingleAabb(body);  // Bullet's own refusal of an overflowing AABB
}

const btHybridStepInfo& btHybridDynamicsWorld::getStepInfo() const
{
	return m_requests->getStepInfo();
}

const btHybridCollisionInfo& btHybridDynamicsWorld::getCollisionInfo() const
{
	return m_narrowphase->getInfo();
}

const char* btHybridDynamicsWorld::setCollisionInfo(const btHybridCollisionInfo& info)
{
	if (m_detects)
		return c_insideDetection;
	dropContacts(info.m_plainBodies || getCollisionInfo().m_plainBodies);
	m_narrowphase->setInfo(info);
	return 0;
}

const char* btHybridDynamicsWorld::getNarrowphaseMistake() const
{
	return m_registration->getMistake();
}

// Of all pairs with a hybrid, or of all.
static void dropContactsOf(btOverlappingPairCache* cache, bool ofAll, btDispatcher* dispatcher)
{
	btBroadphasePairArray& pairs = cache->getOverlappingPairArray();
	for (int i = 0; i < pairs.size(); i++)
	{
		const btCollisionObject* first = static_cast<const btCollisionObject*>(pairs[i].m_pProxy0->m_clientObject);
		const btCollisionObject* second = static_cast<const btCollisionObject*>(pairs[i].m_pProxy1->m_clientObject);
		if (ofAll || btHybridRigidBody::upcast(first) || btHybridRigidBody::upcast(second))
			cache->cleanOverlappingPair(pairs[i], dispatcher);
	}
}

void btHybridDynamicsWorld::dropContacts(bool ofAll)
{
	dropContactsOf(m_broadphasePairCache->getOverlappingPairCache(), ofAll, getDispatcher());
	for (int i = 0; i < m_collisionObjects.size(); i++)
		if (btOverlappingPairCache* own = btHybridGhostPairs(m_collisionObjects[i]))
			dropContactsOf(own, ofAll, getDispatcher());
}

const btHybridCollisionCounts& btHybridDynamicsWorld::getCollisionCounts() const
{
	return m_narrowphase->getCounts();
}

btHybridCollisionMemory btHybridDynamicsWorld::getCollisionMemory() const
{
	return m_narrowphase->getMemory();
}

int btHybridDynamicsWorld::getPairLevel(const btCollisionObject* objectA, const btCollisionObject* objectB) const
{
	if (!owns(objectA) || !owns(objectB))
		return 0;
	if (!btHybridRigidBody::upcast(objectA) && !btHybridRigidBody::upcast(objectB))
		return 0;
	btBroadphaseProxy* proxyA = const_cast<btBroadphaseProxy*>(objectA->getBroadphaseHandle());
	btBroadphaseProxy* proxyB = const_cast<btBroadphaseProxy*>(objectB->getBroadphaseHandle());
	const btBroadphasePair* pair = m_broadphasePairCache->getOverlappingPairCache()->findPair(proxyA, proxyB);
	if (!pair)
		return 0;
	return viewPair(*pair).m_level;
}

void btHybridDynamicsWorld::verifyContacts(int everyNSteps)
{
	m_verifyEvery = everyNSteps;
	m_verifier->reset();
}

const btHybridContactReport& btHybridDynamicsWorld::getContactReport() const
{
	return m_verifier->getReport();
}

const char* btHybridDynamicsWorld::setNumThreads(int threads)
{
	if (m_detects)
		return "the number of threads cannot change inside a step: change it between two";
	const char* mistake = btHybridCheckThreads(threads);
	if (!mistake)
		m_narrowphase->getForesight().getThreads()->setNumThreads(threads);
	return mistake;
}

int btHybridDynamicsWorld::getNumThreads() const
{
	return m_narrowphase->getForesight().getThreads()->getNumThreads();
}

void btHybridDynamicsWorld::setPromises(int promises)
{
	m_narrowphase->getForesight().setPromises(promises);
}

int btHybridDynamicsWorld::getPromises() const
{
	return m_narrowphase->getForesight().getPromises();
}

const char* btHybridDynamicsWorld::setTaskScheduler(btITaskScheduler* scheduler)
{
	if (m_detects)
		return "the task scheduler cannot change inside a step: change it between two";
	m_narrowphase->getForesight().getThreads()->setScheduler(scheduler);
	return 0;
}

void btHybridDynamicsWorld::performDiscreteCollisionDetection()
{
	const DetectionScope scope(m_detects);
	m_requests->beginStep();
	m_narrowphase->beginStep();
	if (m_planner)
		m_planner->forgetContacts();
	if (m_hybrids.size() == 0 && !getCollisionInfo().m_plainBodies)
	{
		m_requests->endStep();
		detectPlainly();
		return;
	}
	BT_PROFILE("performDiscreteCollisionDetection");
	m_narrowphase->getForesight().expect();
	updateAabbs();
	computeOverlappingPairs();
	if (m_planner)
		planPairs();
	else
		planBodies();
	if (m_verifyEvery > 0)
		m_verifier->begin(m_planner, this);
	dispatchPairs();
	if (m_planner)
	{
		m_planner->finish(getDispatcher(), {getSolverInfo().m_numIterations,
		                                    [this] { return btHybridEarlyRest::areStill(m_nonStaticRigidBodies); }});
		closeRequests();
	}
	if (m_verifyEvery > 0)
		m_verifier->finish(this, m_requests->getStep() % m_verifyEvery == 0);
}

// Bullet's own, but for threads, which may take steps of plain pairs.
void btHybridDynamicsWorld::detectPlainly()
{
	if (!m_narrowphase->getForesight().getThreads()->areMany())
	{
		btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
		return;
	}
	BT_PROFILE("performDiscreteCollisionDetection");
	m_narrowphase->getForesight().expect();
	updateAabbs();
	computeOverlappingPairs();
	dispatchPairs();
}

// Where threads have been at work little is left to do. A near callback of the program's own is shown all pairs, and a
// dispatcher that is not ours to use may show any pair to anyone: nothing is done before it.
void btHybridDynamicsWorld::dispatchPairs()
{
	BT_PROFILE("dispatchAllCollisionPairs");
	btOverlappingPairCache* pairs = m_broadphasePairCache->getOverlappingPairCache();
	if (getNarrowphaseMistake())
	{
		m_dispatcher1->dispatchAllCollisionPairs(pairs, getDispatchInfo(), m_dispatcher1);
		return;
	}
	btHybridForesight& foresight = m_narrowphase->getForesight();
	btCollisionDispatcher* dispatcher = static_cast<btCollisionDispatcher*>(m_dispatcher1);
	m_narrowphase->getObjects().setDispatching(true);
	foresight.begin(*m_narrowphase, dispatcher, *pairs, getDispatchInfo());
	btHybridAwakePairs awake(pairs, &foresight);
	const bool isUsual = btHybridAheadRules::isDispatchSure(dispatcher, getDispatchInfo(), 0);
	m_dispatcher1->dispatchAllCollisionPairs(isUsual && foresight.isAtWork() ? &awake : pairs, getDispatchInfo(),
	                                         m_dispatcher1);
	foresight.end(*m_narrowphase);
	m_narrowphase->getObjects().setDispatching(false);
}

// The steps that Bullet is going to make of the time that it is given.
int btHybridDynamicsWorld::stepSimulation(btScalar timeStep, int maxSubSteps, btScalar fixedTimeStep)
{
	const int due = maxSubSteps > 0 && fixedTimeStep > 0 ? int((m_localTime + timeStep) / fixedTimeStep) : 1;
	if (m_planner)
		m_planner->shareBudget(maxSubSteps > 0 ? btMin(due, maxSubSteps) : 1);
	return btDiscreteDynamicsWorld::stepSimulation(timeStep, maxSubSteps, fixedTimeStep);
}

void btHybridDynamicsWorld::internalSingleStepSimulation(btScalar timeStep)
{
	if (!m_planner || m_hybrids.size() == 0 || !m_planner->needsTime())
	{
		btDiscreteDynamicsWorld::internalSingleStepSimulation(timeStep);
		return;
	}
	m_stepBegan = btHybridStepClock::getThreadMilliseconds();
	m_isTimed = true;
	btDiscreteDynamicsWorld::internalSingleStepSimulation(timeStep);
	m_planner->takeTime();
	m_isTimed = false;
}

double btHybridDynamicsWorld::getStepMilliseconds() const
{
	return m_isTimed ? btHybridStepClock::getThreadMilliseconds() - m_stepBegan : 0;
}

void btHybridDynamicsWorld::solveConstraints(btContactSolverInfo& info)
{
	if (!m_planner)
	{
		solveIslands(info);
		return;
	}
	btContactSolverInfo afforded = info;
	afforded.m_numIterations = m_planner->getIterations(info.m_numIterations);
	m_planner->hideContacts();
	solveIslands(afforded);
	m_planner->showContacts();
}

void btHybridDynamicsWorld::updateActivationState(btScalar timeStep)
{
	const bool plans = m_planner && m_hybrids.size() > 0;
	if (plans && m_pairSwitching.m_earlyRest)
		m_planner->takeResting(
		    btHybridEarlyRest::hasten(m_nonStaticRigidBodies, m_narrowphase->getObjects(), *m_planner, timeStep));
	if (plans && m_pairSwitching.m_wakesForDetail)
		m_planner->wakeOwed();
	btDiscreteDynamicsWorld::updateActivationState(timeStep);
}

// All at once, so that a solver of ours can share them out. Bullet first asks every manifold for its objects, in an
// order that no cache foresees.
void btHybridDynamicsWorld::solveIslands(btContactSolverInfo& info)
{
	btPersistentManifold** manifolds = m_dispatcher1->getInternalManifoldPointer();
	for (int i = 0; i < m_dispatcher1->getNumManifolds(); i++)
		btHybridContacts::prefetchObjects(manifolds[i]);
	btHybridContactSolver* solver = dynamic_cast<btHybridContactSolver*>(m_constraintSolver);
	if (!solver)
	{
		btDiscreteDynamicsWorld::solveConstraints(info);
		return;
	}
	solver->m_groups->m_threads = m_narrowphase->getForesight().getThreads();
	btContactSolverInfo whole = info;
	whole.m_minimumSolverBatchSize = std::numeric_limits<int>::max();
	btDiscreteDynamicsWorld::solveConstraints(whole);
}

void btHybridDynamicsWorld::planBodies()
{
	BT_PROFILE("planSwitching");
	const btHybridBodySwitching::Step step = {
	    m_hybrids,   m_nonStaticRigidBodies,    m_held,      m_broadphasePairCache, getDispatcher(),
	    m_effective, m_dispatchInfo.m_timeStep, m_loadIsFine};
	// Without hybrids nothing is known of the world's objects, which are there for the sake of plain pairs then.
	if (m_hybrids.size() > 0)
		m_bodySwitching->plan(step);
	m_requests->endStep();
}

void btHybridDynamicsWorld::planPairs()
{
	BT_PROFILE("planSwitching");
	for (int i = 0; m_requests->getNumStanding() > 0 && i < m_hybrids.size(); i++)
		if (m_hybrids[i]->m_request.isStanding())
			m_requests->acknowledge(m_hybrids[i]);
	m_planner->setInfo(btHybridEffective(m_pairSwitching));
	m_planner->plan(m_collisionObjects, m_nonStaticRigidBodies,
	                m_broadphasePairCache->getOverlappingPairCache()->getNumOverlappingPairs(), m_constraints.size(),
	                m_dispatchInfo.m_timeStep, [this] { return getStepMilliseconds(); });
}

// A body has switched when all its pairs have.
void btHybridDynamicsWorld::closeRequests()
{
	for (int i = 0; m_requests->getNumStanding() > 0 && i < m_hybrids.size(); i++)
	{
		const btHybridRequest& request = m_hybrids[i]->m_request;
		if (request.isStanding() && request.m_acknowledged && m_planner->findFinerPair(m_hybrids[i]) < 0)
			m_requests->fulfil(m_hybrids[i], request.m_targetLevel);
	}
	m_requests->endStep();
	findAsked();
}

void btHybridDynamicsWorld::findAsked()
{
	bool asks = m_requests->getNumStanding() > 0;
	for (int i = 0; !asks && i < m_hybrids.size(); i++)
		asks = m_hybrids[i]->m_level < m_hybrids[i]->getFinestLevel();
	m_planner->setAsks(asks);
}

const char* btHybridDynamicsWorld::checkPairCall() const
{
	if (!m_planner)
		return "bodies switch in this world, not pairs; make it with BT_HYBRID_PAIR_SWITCHING, or call "
		       "setSwitchingMode first";
	if (m_detects)
		return c_insideDetection;
	return getNarrowphaseMistake();
}
