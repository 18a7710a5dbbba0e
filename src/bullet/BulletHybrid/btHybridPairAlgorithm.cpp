#include "btHybridPairAlgorithm.h"

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btDiscreteCollisionDetectorInterface.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <LinearMath/btAabbUtil2.h>

#include "btHybridNarrowphase.h"
#include "btHybridPairLevel.h"
#include "btHybridPartBody.h"
#include "btHybridPlanner.h"

static_assert(sizeof(btHybridPairAlgorithm) <= sizeof(btCompoundCompoundCollisionAlgorithm), "does not fit into Bullet's pool of algorithms");

/// What one call of processCollision was given.
struct btHybridPairAlgorithm::Pass
{
	const btCollisionObjectWrapper* m_wraps[2];
	const btDispatcherInfo& m_info;
	btManifoldResult* m_result;
	scatter::BoundsTest m_bounds;
};

namespace
{
/// Tells a manifold result which parts are at work, as Bullet's compound algorithms do, for as long as it lives.
class ChildScope
{
	btManifoldResult* m_result;
	const btCollisionObjectWrapper* m_before[2];
	btTransform m_transforms[2];
	btCollisionObjectWrapper m_children[2];
	const btCollisionObjectWrapper* m_wraps[2];

public:
	ChildScope(btManifoldResult* result, const btHybridPartBody& bodyA, int partA, const btHybridPartBody& bodyB, int partB)
	    : m_result(result),
	      m_before{result->getBody0Wrap(), result->getBody1Wrap()},
	      m_transforms{bodyA.getChildTransform(partA, m_before[0]->getWorldTransform()), bodyB.getChildTransform(partB, m_before[1]->getWorldTransform())},
	      m_children{{m_before[0], bodyA.getChildShape(partA), m_before[0]->getCollisionObject(), m_transforms[0], -1, partA},
	                 {m_before[1], bodyB.getChildShape(partB), m_before[1]->getCollisionObject(), m_transforms[1], -1, partB}}
	{
		m_wraps[0] = bodyA.getChildIndex(partA) < 0 ? m_before[0] : &m_children[0];
		m_wraps[1] = bodyB.getChildIndex(partB) < 0 ? m_before[1] : &m_children[1];
		m_result->setBody0Wrap(m_wraps[0]);
		m_result->setBody1Wrap(m_wraps[1]);
		m_result->setShapeIdentifiersA(-1, bodyA.getChildIndex(partA));
		m_result->setShapeIdentifiersB(-1, bodyB.getChildIndex(partB));
	}
	~ChildScope()
	{
		m_result->setPersistentManifold(0);
		m_result->setBody0Wrap(m_before[0]);
		m_result->setBody1Wrap(m_before[1]);
	}

	const btCollisionObjectWrapper* getWrap(int body) const
	{
		return m_wraps[body];
	}
};

/// Keeps the one point that Bullet's GJK finds.
struct PointResult : public btDiscreteCollisionDetectorInterface::Result
{
	btVector3 m_normal;
	btVector3 m_point;
	btScalar m_distance;
	bool m_found;

	PointResult()
	    : m_normal(0, 0, 0), m_point(0, 0, 0), m_distance(0), m_found(false)
	{
	}
	virtual void setShapeIdentifiersA(int, int)
	{
	}
	virtual void setShapeIdentifiersB(int, int)
	{
	}
	virtual void addContactPoint(const btVector3& normalOnBInWorld, const btVector3& pointInWorld, btScalar depth)
	{
		m_normal = normalOnBInWorld;
		m_point = pointInWorld;
		m_distance = depth;
		m_found = true;
	}
};

/// Takes in where two bodies are, as Bullet does with a manifold.
class Keeper : public scatter::ContactKeeper
{
	const btTransform& m_transform0;
	const btTransform& m_transform1;

public:
	Keeper(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap)
	    : m_transform0(body0Wrap->getCollisionObject()->getWorldTransform()), m_transform1(body1Wrap->getCollisionObject()->getWorldTransform())
	{
	}
	virtual bool outlasts(void* contact) const
	{
		btPersistentManifold* manifold = static_cast<btPersistentManifold*>(contact);
		manifold->refreshContactPoints(m_transform0, m_transform1);
		return manifold->getNumContacts() > 0;
	}
};

btVector3 toWorld(const scatter::Frame& frame, const scatter::Vec3& point)
{
	const scatter::Vec3 world = frame(point);
	return btVector3(world.x, world.y, world.z);
}

// A filter that a program may have set for the children of compounds.
bool userLetsThrough(const btHybridPartBody& bodyA, int partA, const btHybridPartBody& bodyB, int partB)
{
	const bool isChildA = bodyA.getChildIndex(partA) >= 0;
	if (isChildA && bodyB.getChildIndex(partB) >= 0)
		return !gCompoundCompoundChildShapePairCallback || gCompoundCompoundChildShapePairCallback(bodyA.getChildShape(partA), bodyB.getChildShape(partB));
	if (!gCompoundChildShapePairCallback)
		return true;
	// Bullet names the compound's child last.
	return isChildA ? gCompoundChildShapePairCallback(bodyB.getChildShape(partB), bodyA.getChildShape(partA)) : gCompoundChildShapePairCallback(bodyA.getChildShape(partA), bodyB.getChildShape(partB));
}

// The manifolds of a pile do not fit into a cache: of one with a single point, what is looked at.
void fetch(const void* manifold)
{
#if defined(__GNUC__)
	const char* bytes = static_cast<const char*>(manifold);
	for (size_t i = 0; i < sizeof(btManifoldPoint); i += 64)
		__builtin_prefetch(bytes + i, 1);
	__builtin_prefetch(bytes + sizeof(btPersistentManifold) - 64, 1);
#else
	(void)manifold;
#endif
}
}  // namespace

// Shows a manifold result, and what is called with it, the shapes of the pair's level in the place of the finest ones,
// for as long as it lives.
class btHybridPairAlgorithm::LevelScope
{
	btManifoldResult* m_result;
	const btCollisionObjectWrapper* m_before[2];
	btCollisionObjectWrapper m_levels[2];

public:
	LevelScope(btManifoldResult* result, const btCollisionObjectWrapper* body0Wrap, const btCollisionShape* shape0, const btCollisionObjectWrapper* body1Wrap, const btCollisionShape* shape1)
	    : m_result(result),
	      m_before{result->getBody0Wrap(), result->getBody1Wrap()},
	      m_levels{{0, shape0, body0Wrap->getCollisionObject(), body0Wrap->getWorldTransform(), -1, -1},
	               {0, shape1, body1Wrap->getCollisionObject(), body1Wrap->getWorldTransform(), -1, -1}}
	{
		m_result->setBody0Wrap(&m_levels[0]);
		m_result->setBody1Wrap(&m_levels[1]);
	}
	~LevelScope()
	{
		m_result->setBody0Wrap(m_before[0]);
		m_result->setBody1Wrap(m_before[1]);
	}

	const btCollisionObjectWrapper* getWrap(int body) const
	{
		return &m_levels[body];
	}
};

btHybridPairAlgorithm::btHybridPairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, btHybridNarrowphase* narrowphase, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap)
    : btCollisionAlgorithm(info), m_narrowphase(narrowphase), m_fallback(0), m_plan(-1), m_quietUntil(-BT_LARGE_FLOAT), m_jumps(0)
{
	m_narrowphase->addUser();
	m_objects[0] = m_narrowphase->acquireObject(body0Wrap->getCollisionObject());
	m_objects[1] = m_narrowphase->acquireObject(body1Wrap->getCollisionObject());
	m_memory = m_narrowphase->acquirePair();
	m_pair = &m_memory->m_parts;
	if (m_narrowphase->getPlanner())
		m_plan = m_narrowphase->getPlanner()->addPair(this, m_objects[0], m_objects[1]);
	takeLevel(btMax(m_objects[0]->getNumLevels(), m_objects[1]->getNumLevels()));
}

btHybridPairAlgorithm::~btHybridPairAlgorithm()
{
	releaseContacts();
	m_memory->m_held.release(m_dispatcher);
	releaseFallback();
	if (m_plan >= 0)
		m_narrowphase->getPlanner()->removePair(m_plan);
	m_narrowphase->releasePair(m_memory);
	m_narrowphase->releaseObject(m_objects[0]);
	m_narrowphase->releaseObject(m_objects[1]);
	m_narrowphase->removeUser();
}

void btHybridPairAlgorithm::takeLevel(int level)
{
	for (int i = 0; i < 2; i++)
		m_bodies[i] = m_narrowphase->getBody(m_objects[i], m_objects[i]->getLevelIn(level));
	m_versions[0] = m_versions[1] = -1;
}

void btHybridPairAlgorithm::releaseContacts()
{
	for (size_t i = 0; i < m_pair->children().size(); i++)
		releaseManifold(m_pair->children()[i]);
	m_pair->reset(0);
}

void btHybridPairAlgorithm::fallBack(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	releaseContacts();
	m_memory->m_held.release(m_dispatcher);
	m_versions[0] = -1;
	if (!m_fallback)
		m_fallback = m_dispatcher->findAlgorithm(body0Wrap, body1Wrap, 0, BT_CONTACT_POINT_ALGORITHMS);
	m_fallback->processCollision(body0Wrap, body1Wrap, dispatchInfo, resultOut);
}

void btHybridPairAlgorithm::releaseFallback()
{
	if (!m_fallback)
		return;
	m_fallback->~btCollisionAlgorithm();
	m_dispatcher->freeCollisionAlgorithm(m_fallback);
	m_fallback = 0;
}

void btHybridPairAlgorithm::restart(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap)
{
	releaseContacts();
	// As the dispatcher gives it to manifolds.
	btScalar threshold = gContactBreakingThreshold;
	if (m_narrowphase->getDispatcherFlags() & btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD)
		threshold = btMin(body0Wrap->getCollisionObject()->getCollisionShape()->getContactBreakingThreshold(threshold), body1Wrap->getCollisionObject()->getCollisionShape()->getContactBreakingThreshold(threshold));
	m_pair->reset(threshold);
	m_memory->m_restarted = true;
	m_versions[0] = m_bodies[0]->getVersion();
	m_versions[1] = m_bodies[1]->getVersion();
}

void btHybridPairAlgorithm::processCollision(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	if (m_plan >= 0)
		processPlanned(body0Wrap, body1Wrap, dispatchInfo, resultOut);
	else
		process(body0Wrap, body1Wrap, dispatchInfo, resultOut);
}

void btHybridPairAlgorithm::processPlanned(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	if (staysQuiet(body0Wrap, body1Wrap))
		return;
	const scatter::PairWork before = m_narrowphase->getWork();
	const int detectorRuns = m_narrowphase->getDetectorRuns();
	btHybridPairLevel level(*m_narrowphase, m_objects, *m_memory, m_plan, body0Wrap->getWorldTransform(), body1Wrap->getWorldTransform());
	const bool wasFinest = level.getLevel() == level.getFinest();
	if (level.choose())
	{
		changeLevel(level, wasFinest, body0Wrap, body1Wrap, dispatchInfo, resultOut);
	}
	else if (mayReuse())
	{
		reuse(level, body0Wrap, body1Wrap);
		return;
	}
	m_memory->m_reused = false;
	m_memory->m_returned = m_memory->m_returns;
	m_memory->m_held.refresh(body0Wrap->getWorldTransform(), body1Wrap->getWorldTransform());
	processLevel(body0Wrap, body1Wrap, dispatchInfo, resultOut);
	level.settleCredit(m_narrowphase->getScratch());
	if (level.needsAudit())
	{
		const scatter::PairWork beforeAudit = m_narrowphase->getWork();
		const int detectorRunsBefore = m_narrowphase->getDetectorRuns();
		audit(level, body0Wrap, body1Wrap, dispatchInfo, resultOut);
		m_narrowphase->getPlanner()->takeAudit(workSince(beforeAudit, detectorRunsBefore));
	}
	if (!level.keepsHeld())
		m_memory->m_held.release(m_dispatcher);
	scatter::lod::PairWorkload work = workSince(before, detectorRuns);
	level.report(work);
	m_quietUntil = m_memory->m_held.isEmpty() && !m_fallback ? m_pair->quietUntil() : -BT_LARGE_FLOAT;
	m_jumps = m_pair->jumps();
}

// With the shapes of the level that the bodies have taken.
void btHybridPairAlgorithm::processLevel(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	m_narrowphase->getScratch().resizeNoInitialize(0);
	LevelScope scope(resultOut, body0Wrap, m_bodies[0]->getShapeNow(), body1Wrap, m_bodies[1]->getShapeNow());
	process(scope.getWrap(0), scope.getWrap(1), dispatchInfo, resultOut);
}

// What is held is what the finest shapes have where the bodies are now: contacts of the step before may be gone by now.
void btHybridPairAlgorithm::changeLevel(btHybridPairLevel& level, bool wasFinest, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	const bool isFinest = level.getLevel() == level.getFinest();
	m_memory->m_returns = isFinest && !m_memory->m_held.isEmpty();
	if (!isFinest && !level.isOnCredit())
		m_memory->m_held.release(m_dispatcher);
	else if (wasFinest)
	{
		processLevel(body0Wrap, body1Wrap, dispatchInfo, resultOut);
		level.settleFinest(m_narrowphase->getScratch());
		m_memory->m_held.gather(m_pair->children(), m_dispatcher);
	}
	level.open();
	releaseContacts();
	takeLevel(level.getLevel());
}

bool btHybridPairAlgorithm::hasReused() const
{
	return m_memory->m_reused || m_memory->m_returned;
}

bool btHybridPairAlgorithm::hasRestarted() const
{
	return m_memory->m_restarted;
}

// Not twice running, so that what comes upon the pair is found a step late at most.
bool btHybridPairAlgorithm::mayReuse() const
{
	return !m_memory->m_reused && !m_fallback && m_memory->m_held.isEmpty() && m_versions[0] >= 0 && m_narrowphase->getPlanner()->mayReuse(m_plan);
}

// Keeps the contacts of the step before, where the bodies are now.
void btHybridPairAlgorithm::reuse(btHybridPairLevel& level, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap)
{
	btAlignedObjectArray<int>& touching = m_narrowphase->getScratch();
	touching.resizeNoInitialize(0);
	std::vector<scatter::ChildPair>& children = m_pair->children();
	for (size_t i = 0; i < children.size(); i++)
	{
		if (!children[i].touching)
			continue;
		btPersistentManifold* manifold = static_cast<btPersistentManifold*>(children[i].contact);
		manifold->refreshContactPoints(body0Wrap->getWorldTransform(), body1Wrap->getWorldTransform());
		children[i].touching = manifold->getNumContacts() > 0;
		touching.push_back(int(i));
	}
	level.settleCredit(touching);
	m_memory->m_reused = true;
	scatter::lod::PairWorkload work;
	work.reuses = true;
	level.report(work);
	m_quietUntil = -BT_LARGE_FLOAT;
}

scatter::lod::PairWorkload btHybridPairAlgorithm::workSince(const scatter::PairWork& before, int detectorRuns) const
{
	const scatter::PairWork& after = m_narrowphase->getWork();
	scatter::lod::PairWorkload work;
	work.rebuilds = after.rebuilds - before.rebuilds;
	work.childPairs = after.childPairs - after.childPairsAsleep - before.childPairs + before.childPairsAsleep;
	work.gjkRuns = after.gjkRuns - before.gjkRuns;
	work.gjkIterations = after.gjkIterations - before.gjkIterations;
	work.detectorRuns = m_narrowphase->getDetectorRuns() - detectorRuns;
	return work;
}

// Most pairs of a pile are apart and hardly move: they are left without a look at anything but what all pairs share.
bool btHybridPairAlgorithm::staysQuiet(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap)
{
	btHybridPlanner& planner = *m_narrowphase->getPlanner();
	if (m_quietUntil < 0 || !planner.isSettled(m_plan))
		return false;
	const btCollisionObjectWrapper* wraps[2] = {body0Wrap, body1Wrap};
	double travel = 0;
	int jumps = 0;
	for (int i = 0; i < 2; i++)
	{
		if (!m_narrowphase->updateBody(m_bodies[i], m_bodies[i]->getShapeNow(), wraps[i]->getWorldTransform()) || m_versions[i] != m_bodies[i]->getVersion())
			return false;
		travel += m_bodies[i]->getBody().travel();
		jumps += m_bodies[i]->getBody().jumps();
	}
	if (!(travel < m_quietUntil) || jumps != m_jumps)
		return false;
	planner.countQuiet(m_plan);
	m_narrowphase->getWork().pairs++;
	m_narrowphase->getWork().pairsSkipped++;
	return true;
}

// A look at the finest level from a coarser one: how near are the shapes, and what contacts would they have.
void btHybridPairAlgorithm::audit(btHybridPairLevel& level, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	if (!level.mayTouch())
	{
		m_memory->m_held.release(m_dispatcher);
		level.takeAudit();
		return;
	}
	btHybridPartBody* const bodies[2] = {m_bodies[0], m_bodies[1]};
	const int versions[2] = {m_versions[0], m_versions[1]};
	m_pair = &m_narrowphase->getAuditPair();
	takeLevel(level.getFinest());
	{
		LevelScope scope(resultOut, body0Wrap, m_bodies[0]->getShape(), body1Wrap, m_bodies[1]->getShape());
		process(scope.getWrap(0), scope.getWrap(1), dispatchInfo, resultOut);
	}
	m_memory->m_held.gather(m_pair->children(), m_dispatcher);
	releaseContacts();
	m_pair = &m_memory->m_parts;
	for (int i = 0; i < 2; i++)
	{
		m_bodies[i] = bodies[i];
		m_versions[i] = versions[i];
	}
	level.takeAudit();
}

// Child pairs that overlap on credit have no contacts of their own while those of the finest level are good.
bool btHybridPairAlgorithm::isExcused(scatter::ChildPair& child)
{
	if (!m_memory->m_excuses || m_memory->m_credit.empty() || m_pair != &m_memory->m_parts || m_memory->m_credit.of(child.a, child.b) <= 0)
		return false;
	// An audit that is due but cannot be afforded may be late, but not for long.
	const double late = m_pair->motion() - m_memory->m_freshUntil;
	if (late >= m_memory->m_latest && !m_memory->m_mayAudit)
		return false;
	child.wake = m_memory->m_freshUntil;
	return true;
}

void btHybridPairAlgorithm::process(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	if (!m_narrowphase->updateBody(m_bodies[0], body0Wrap->getCollisionShape(), body0Wrap->getWorldTransform()) || !m_narrowphase->updateBody(m_bodies[1], body1Wrap->getCollisionShape(), body1Wrap->getWorldTransform()))
	{
		fallBack(body0Wrap, body1Wrap, dispatchInfo, resultOut);
		return;
	}
	releaseFallback();
	m_memory->m_restarted = false;
	if (m_versions[0] != m_bodies[0]->getVersion() || m_versions[1] != m_bodies[1]->getVersion())
		restart(body0Wrap, body1Wrap);

	scatter::PartBody& bodyA = m_bodies[0]->getBody();
	scatter::PartBody& bodyB = m_bodies[1]->getBody();
	const Keeper keeper(body0Wrap, body1Wrap);
	m_narrowphase->getPairScratch().keeper = &keeper;
	const bool isAwake = m_pair->advance(bodyA, bodyB, m_narrowphase->getSteps(), m_narrowphase->getPairScratch(), m_narrowphase->getWork());
	m_narrowphase->getPairScratch().keeper = 0;
	const std::vector<void*>& dropped = m_narrowphase->getPairScratch().dropped;
	for (size_t i = 0; i < dropped.size(); i++)
		m_dispatcher->releaseManifold(static_cast<btPersistentManifold*>(dropped[i]));
	if (m_memory->m_returns)
		m_memory->m_held.giveBack(m_pair->children(), m_dispatcher);
	m_memory->m_returns = false;
	if (!isAwake)
		return;
	const Pass pass = {{body0Wrap, body1Wrap}, dispatchInfo, resultOut, scatter::BoundsTest(bodyA, bodyB)};
	processChildren(pass);
	m_pair->settle(bodyA, bodyB, m_narrowphase->getSteps());
}

void btHybridPairAlgorithm::processChildren(const Pass& pass)
{
	std::vector<scatter::ChildPair>& children = m_pair->children();
	btAlignedObjectArray<int>& awake = m_narrowphase->getScratch();
	awake.resizeNoInitialize(0);
	for (size_t i = 0; i < children.size(); i++)
	{
		if (m_pair->isAsleep(children[i]))
			continue;
		if (children[i].touching)
			fetch(children[i].contact);
		awake.push_back(int(i));
	}
	m_narrowphase->getWork().childPairs += int(children.size());
	m_narrowphase->getWork().childPairsAsleep += int(children.size()) - awake.size();
	for (int i = 0; i < awake.size(); i++)
		processChild(children[awake[i]], pass);
}

void btHybridPairAlgorithm::refresh(btPersistentManifold* manifold, const Pass& pass)
{
	manifold->refreshContactPoints(pass.m_wraps[0]->getCollisionObject()->getWorldTransform(), pass.m_wraps[1]->getCollisionObject()->getWorldTransform());
}

void btHybridPairAlgorithm::processChild(scatter::ChildPair& child, const Pass& pass)
{
	if (isExcused(child))
	{
		releaseManifold(child);
		return;
	}
	if (!pass.m_bounds.overlap(child.a, child.b) || !userLetsThrough(*m_bodies[0], child.a, *m_bodies[1], child.b))
	{
		m_narrowphase->getWork().boundsRejected++;
		if (child.touching && isOverlooked(child, pass))
			refresh(static_cast<btPersistentManifold*>(child.contact), pass);
		else
			releaseManifold(child);
		child.touching = child.contact && static_cast<btPersistentManifold*>(child.contact)->getNumContacts() > 0;
		return;
	}
	if (child.touching)
	{
		btPersistentManifold* manifold = static_cast<btPersistentManifold*>(child.contact);
		refresh(manifold, pass);
		child.touching = manifold->getNumContacts() > 0;
	}
	const bool isLazy = m_narrowphase->getInfo().m_lazyManifolds;
	if (!isLazy)
		manifoldOf(child, pass);
	findContacts(child, pass);
	if (!child.contact)
		return;
	btPersistentManifold* manifold = static_cast<btPersistentManifold*>(child.contact);
	// The callback hears of new contacts too, as far as Bullet keeps them.
	if (gContactProcessedCallback && !areSpheres(child))
		refresh(manifold, pass);
	child.touching = manifold->getNumContacts() > 0;
	if (!child.touching && isLazy)
		releaseManifold(child);
}

// Of a compound with a tree and one without, in this order, Bullet does not look at the second one's children while the
// leaf of the first one's child does not reach the second: what contacts they have stay.
bool btHybridPairAlgorithm::isOverlooked(const scatter::ChildPair& child, const Pass& pass) const
{
	const btCollisionShape* whole = m_bodies[1]->getShape();
	if (!m_bodies[0]->hasLeaves() || m_bodies[1]->hasLeaves() || !whole->isCompound() || leavesOverlap(child, pass))
		return false;
	btVector3 minA, maxA, minB, maxB;
	const btTransform poseA = m_bodies[0]->getChildTransform(child.a, pass.m_wraps[0]->getWorldTransform());
	m_bodies[0]->getChildShape(child.a)->getAabb(poseA, minA, maxA);
	whole->getAabb(pass.m_wraps[1]->getWorldTransform(), minB, maxB);
	return TestAabbAgainstAabb2(minA, maxA, minB, maxB);
}

// The test of the leaves that Bullet's compound algorithms make before a child pair comes into contact.
bool btHybridPairAlgorithm::leavesOverlap(const scatter::ChildPair& child, const Pass& pass) const
{
	const btTransform& frameA = pass.m_wraps[0]->getWorldTransform();
	const btTransform& frameB = pass.m_wraps[1]->getWorldTransform();
	if (!m_bodies[0]->hasLeaves() && !m_bodies[1]->hasLeaves())
		return true;
	btVector3 minA, maxA, minB, maxB;
	if (m_bodies[0]->hasLeaves())
	{
		m_bodies[0]->getLeaf(child.a, minA, maxA);
		m_bodies[1]->getLeafIn(child.b, frameA.inverseTimes(frameB), minB, maxB);
	}
	else
	{
		m_bodies[0]->getChildShape(child.a)->getAabb(frameB.inverseTimes(m_bodies[0]->getChildTransform(child.a, frameA)), minA, maxA);
		m_bodies[1]->getLeaf(child.b, minB, maxB);
	}
	return TestAabbAgainstAabb2(minA, maxA, minB, maxB);
}

// Of two spheres Bullet keeps no contact from step to step: what it hands to its detector it finds anew.
bool btHybridPairAlgorithm::areSpheres(const scatter::ChildPair& child) const
{
	return m_bodies[0]->getBody().parts().part(child.a).kind == scatter::PartKind::kSphere && m_bodies[1]->getBody().parts().part(child.b).kind == scatter::PartKind::kSphere;
}

void btHybridPairAlgorithm::findContacts(scatter::ChildPair& child, const Pass& pass)
{
	scatter::PartContact contact;
	const scatter::PairSteps& steps = m_narrowphase->getSteps();
	const scatter::ChildVerdict verdict = m_pair->judge(child, m_bodies[0]->getBody(), m_bodies[1]->getBody(), steps, contact, m_narrowphase->getWork());
	if (verdict == scatter::ChildVerdict::kApart)
		return;
	if ((!child.touching || areSpheres(child)) && !leavesOverlap(child, pass))
		return;
	switch (verdict)
	{
		case scatter::ChildVerdict::kContact:
			keepContact(child, contact, pass);
			break;
		case scatter::ChildVerdict::kAskEngine:
			m_narrowphase->countDetectorRun();
			if (steps.ownGjk)
				detect(child, pass);
			else
				detectByGjk(child, pass);
			break;
		case scatter::ChildVerdict::kApart:
			break;
	}
}

btPersistentManifold* btHybridPairAlgorithm::manifoldOf(scatter::ChildPair& child, const Pass& pass)
{
	if (!child.contact)
		child.contact = m_dispatcher->getNewManifold(pass.m_wraps[0]->getCollisionObject(), pass.m_wraps[1]->getCollisionObject());
	return static_cast<btPersistentManifold*>(child.contact);
}

void btHybridPairAlgorithm::releaseManifold(scatter::ChildPair& child)
{
	if (child.contact)
		m_dispatcher->releaseManifold(static_cast<btPersistentManifold*>(child.contact));
	child.contact = 0;
	child.touching = false;
}

void btHybridPairAlgorithm::keepContact(scatter::ChildPair& child, const scatter::PartContact& contact, const Pass& pass)
{
	const scatter::Frame& frameA = m_bodies[0]->getBody().frame();
	const scatter::Vec3 normal = -frameA.rotate(contact.axis);
	ChildScope scope(pass.m_result, *m_bodies[0], child.a, *m_bodies[1], child.b);
	pass.m_result->setPersistentManifold(manifoldOf(child, pass));
	pass.m_result->addContactPoint(btVector3(normal.x, normal.y, normal.z), toWorld(frameA, contact.pointB), contact.distance);
}

namespace
{
// As btSphereSphereCollisionAlgorithm does it.
void collideSpheres(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, btManifoldResult* result)
{
	const btScalar radiusA = static_cast<const btSphereShape*>(a->getCollisionShape())->getRadius();
	const btScalar radiusB = static_cast<const btSphereShape*>(b->getCollisionShape())->getRadius();
	const btVector3 between = a->getWorldTransform().getOrigin() - b->getWorldTransform().getOrigin();
	const btScalar length = between.length();
	if (length > radiusA + radiusB)
		return;
	const btVector3 normal = length > SIMD_EPSILON ? between / length : btVector3(1, 0, 0);
	result->addContactPoint(normal, b->getWorldTransform().getOrigin() + radiusB * normal, length - (radiusA + radiusB));
}

void collideBoxes(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, const btDispatcherInfo& info, btManifoldResult* result)
{
	btDiscreteCollisionDetectorInterface::ClosestPointInput input;
	input.m_maximumDistanceSquared = BT_LARGE_FLOAT;
	input.m_transformA = a->getWorldTransform();
	input.m_transformB = b->getWorldTransform();
	btBoxBoxDetector detector(static_cast<const btBoxShape*>(a->getCollisionShape()), static_cast<const btBoxShape*>(b->getCollisionShape()));
	detector.getClosestPoints(input, *result, info.m_debugDraw);
}

/// Takes contacts of two shapes in the other order.
class FlippedResult : public btManifoldResult
{
	btManifoldResult* m_result;

public:
	FlippedResult(btManifoldResult* result, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b)
	    : btManifoldResult(b, a), m_result(result)
	{
		setPersistentManifold(result->getPersistentManifold());
	}
	virtual void addContactPoint(const btVector3& normalOnBInWorld, const btVector3& pointInWorld, btScalar depth)
	{
		m_result->addContactPoint(-normalOnBInWorld, pointInWorld + normalOnBInWorld * depth, depth);
	}
};

bool areBoth(int type, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b)
{
	return a->getCollisionShape()->getShapeType() == type && b->getCollisionShape()->getShapeType() == type;
}
}  // namespace

// What Bullet does with these two shapes, into this child pair's manifold. The algorithms for boxes and spheres
// insist on manifolds of their own, so their work is called directly.
void btHybridPairAlgorithm::detect(scatter::ChildPair& child, const Pass& pass)
{
	btPersistentManifold* manifold = manifoldOf(child, pass);
	ChildScope scope(pass.m_result, *m_bodies[0], child.a, *m_bodies[1], child.b);
	pass.m_result->setPersistentManifold(manifold);
	const btCollisionObjectWrapper* a = scope.getWrap(0);
	const btCollisionObjectWrapper* b = scope.getWrap(1);
	if (areBoth(BOX_SHAPE_PROXYTYPE, a, b))
		return collideBoxes(a, b, pass.m_info, pass.m_result);
	if (areBoth(SPHERE_SHAPE_PROXYTYPE, a, b))
	{
		manifold->clearManifold();
		return collideSpheres(a, b, pass.m_result);
	}
	const bool isFlipped = looksFromB(child);
	FlippedResult flipped(pass.m_result, a, b);
	if (isFlipped)
		btSwap(a, b);
	btCollisionAlgorithm* algorithm = m_dispatcher->findAlgorithm(a, b, manifold, BT_CONTACT_POINT_ALGORITHMS);
	algorithm->processCollision(a, b, pass.m_info, isFlipped ? &flipped : pass.m_result);
	algorithm->~btCollisionAlgorithm();
	m_dispatcher->freeCollisionAlgorithm(algorithm);
}

// Bullet's GJK does not always find the same in both orders of two shapes. In Bullet a compound's children come first,
// and with two compounds of which one has no tree, the second one's. A bare box, sphere, capsule or hull comes first
// here, for the sake of results that are what they were; the order matters for shapes of other kinds.
bool btHybridPairAlgorithm::looksFromB(const scatter::ChildPair& child) const
{
	if (!m_bodies[1]->getShape()->isCompound() || (m_bodies[0]->hasLeaves() && m_bodies[1]->hasLeaves()))
		return false;
	return m_bodies[0]->getShape()->isCompound() || isOdd(0, child.a) || isOdd(1, child.b);
}

bool btHybridPairAlgorithm::isOdd(int body, int part) const
{
	const scatter::PartKind kind = m_bodies[body]->getBody().parts().part(part).kind;
	return kind == scatter::PartKind::kEnclosed || kind == scatter::PartKind::kOpaque;
}

// In the place of scatter's GJK, to measure what that is worth.
void btHybridPairAlgorithm::detectByGjk(scatter::ChildPair& child, const Pass& pass)
{
	const btCollisionShape* shapes[2] = {m_bodies[0]->getChildShape(child.a), m_bodies[1]->getChildShape(child.b)};
	const int types[2] = {shapes[0]->getShapeType(), shapes[1]->getShapeType()};
	if (types[0] == types[1] && (types[0] == BOX_SHAPE_PROXYTYPE || types[0] == SPHERE_SHAPE_PROXYTYPE))
		return detect(child, pass);
	ChildScope scope(pass.m_result, *m_bodies[0], child.a, *m_bodies[1], child.b);
	btGjkPairDetector::ClosestPointInput input;
	input.m_transformA = scope.getWrap(0)->getWorldTransform();
	input.m_transformB = scope.getWrap(1)->getWorldTransform();
	const btScalar furthest = shapes[0]->getMargin() + shapes[1]->getMargin() + m_pair->threshold();
	input.m_maximumDistanceSquared = furthest * furthest;
	btVoronoiSimplexSolver simplex;
	btGjkEpaPenetrationDepthSolver penetration;
	btGjkPairDetector detector(static_cast<const btConvexShape*>(shapes[0]), static_cast<const btConvexShape*>(shapes[1]), &simplex, &penetration);
	PointResult result;
	detector.getClosestPoints(input, result, 0);
	btVector3 axis = result.m_found ? -result.m_normal : -detector.getCachedSeparatingAxis();
	if (axis.length2() > SIMD_EPSILON)
	{
		axis = pass.m_wraps[0]->getWorldTransform().getBasis().transpose() * axis.normalized();
		m_pair->learnAxis(child, m_bodies[0]->getBody(), m_bodies[1]->getBody(), scatter::Vec3(axis.x(), axis.y(), axis.z()));
	}
	if (!result.m_found || result.m_distance > m_pair->threshold())
		return;
	pass.m_result->setPersistentManifold(manifoldOf(child, pass));
	pass.m_result->addContactPoint(result.m_normal, result.m_point, result.m_distance);
}

btScalar btHybridPairAlgorithm::calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&, btManifoldResult*)
{
	return 1;
}

void btHybridPairAlgorithm::getAllContactManifolds(btManifoldArray& manifoldArray)
{
	if (m_fallback)
		m_fallback->getAllContactManifolds(manifoldArray);
	for (int i = 0; i < m_memory->m_held.getNumManifolds(); i++)
		manifoldArray.push_back(m_memory->m_held.getManifold(i));
	for (size_t i = 0; i < m_pair->children().size(); i++)
		if (m_pair->children()[i].contact)
			manifoldArray.push_back(static_cast<btPersistentManifold*>(m_pair->children()[i].contact));
}
