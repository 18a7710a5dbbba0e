#include "btHybridNarrowphase.h"

#include <BulletCollision/CollisionDispatch/btCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>

#include <mutex>
#include <new>

#include "BulletHybrid/btHybridRigidBody.h"
#include "btHybridPairAlgorithm.h"
#include "btHybridPlanner.h"

btCollisionAlgorithm* btHybridNarrowphase::CreateFunc::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap)
{
	if (!m_narrowphase->takes(info, body0Wrap, body1Wrap))
		return m_default->CreateCollisionAlgorithm(info, body0Wrap, body1Wrap);
	void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(btHybridPairAlgorithm));
	return new (memory) btHybridPairAlgorithm(info, m_narrowphase, body0Wrap, body1Wrap);
}

static bool isTaken(int shapeType)
{
	return btBroadphaseProxy::isConvex(shapeType) || btBroadphaseProxy::isCompound(shapeType);
}

// The narrowphases that are in charge of a dispatcher: it does not tell who has registered with it, and worlds may be made
// in several threads.
static std::mutex s_inChargeMutex;
static btHybridNarrowphase* s_inCharge = 0;

btHybridNarrowphase::btHybridNarrowphase(btDispatcher* dispatcher, const btHybridDynamicsWorld* world, bool switchesPairs)
    : m_detectorRuns(0), m_step(0), m_dispatches(false), m_users(1), m_world(world), m_dispatcher(0), m_mistake(takeCharge(dispatcher)), m_planner(switchesPairs ? new btHybridPlanner : 0)
{
	if (m_dispatcher)
		registerCreateFuncs();
}

const char* btHybridNarrowphase::takeCharge(btDispatcher* dispatcher)
{
	m_next = 0;
	if (dynamic_cast<btCollisionDispatcherMt*>(dispatcher))
		return "hybrid pairs run in Bullet's own algorithms, because the dispatcher is a btCollisionDispatcherMt; use a btCollisionDispatcher";
	btCollisionDispatcher* const known = dynamic_cast<btCollisionDispatcher*>(dispatcher);
	if (!known)
		return "hybrid pairs run in Bullet's own algorithms, because the dispatcher is no btCollisionDispatcher; use one, or derive from it";
	const std::lock_guard<std::mutex> lock(s_inChargeMutex);
	for (const btHybridNarrowphase* other = s_inCharge; other; other = other->m_next)
		if (other->m_dispatcher == known)
			return "hybrid pairs run in Bullet's own algorithms, because another btHybridDynamicsWorld has the dispatcher; give every world its own";
	m_dispatcher = known;
	m_next = s_inCharge;
	s_inCharge = this;
	return 0;
}

void btHybridNarrowphase::registerCreateFuncs()
{
	const int types = MAX_BROADPHASE_COLLISION_TYPES;
	m_createFuncs.resize(2 * types);
	for (int type = 0; type < types; type++)
	{
		const int pairs[2][2] = {{COMPOUND_SHAPE_PROXYTYPE, type}, {type, COMPOUND_SHAPE_PROXYTYPE}};
		for (int k = 0; k < 2 && isTaken(type); k++)
		{
			CreateFunc& create = m_createFuncs[2 * type + k];
			create.m_narrowphase = this;
			create.m_default = m_dispatcher->getCollisionConfiguration()->getCollisionAlgorithmCreateFunc(pairs[k][0], pairs[k][1]);
			m_dispatcher->registerCollisionCreateFunc(pairs[k][0], pairs[k][1], &create);
		}
	}
}

btHybridNarrowphase::~btHybridNarrowphase()
{
	for (int i = 0; i < m_freePairs.size(); i++)
		delete m_freePairs[i];
	delete m_planner;
}

void btHybridNarrowphase::setSwitchesPairs(bool switchesPairs)
{
	btAssert(m_pairs.size() == 0);
	delete m_planner;
	m_planner = switchesPairs ? new btHybridPlanner : 0;
}

void btHybridNarrowphase::retire()
{
	for (int type = 0; m_dispatcher && type < MAX_BROADPHASE_COLLISION_TYPES; type++)
	{
		if (!isTaken(type))
			continue;
		m_dispatcher->registerCollisionCreateFunc(COMPOUND_SHAPE_PROXYTYPE, type, m_createFuncs[2 * type].m_default);
		m_dispatcher->registerCollisionCreateFunc(type, COMPOUND_SHAPE_PROXYTYPE, m_createFuncs[2 * type + 1].m_default);
	}
	{
		const std::lock_guard<std::mutex> lock(s_inChargeMutex);
		for (btHybridNarrowphase** link = &s_inCharge; *link; link = &(*link)->m_next)
		{
			if (*link != this)
				continue;
			*link = m_next;
			break;
		}
	}
	removeUser();
}

int btHybridNarrowphase::getDispatcherFlags() const
{
	return m_dispatcher->getDispatcherFlags();
}

void btHybridNarrowphase::removeUser()
{
	if (--m_users == 0)
		delete this;
}

void btHybridNarrowphase::setInfo(const btHybridCollisionInfo& info)
{
	m_info = info;
	m_steps.midphase = info.m_midphase == BT_HYBRID_WORLD_BOXES  ? scatter::PairMidphase::kWorldBounds
	                   : info.m_midphase == BT_HYBRID_PART_BOXES ? scatter::PairMidphase::kPartBoxes
	                                                             : scatter::PairMidphase::kNeighbourList;
	m_steps.motionBound = info.m_motionBound;
	m_steps.cachedAxis = info.m_cachedAxis;
	m_steps.ownGjk = info.m_ownGjk;
	m_steps.warmSimplex = info.m_warmSimplex;
}

void btHybridNarrowphase::beginStep()
{
	m_step++;
	m_work = scatter::PairWork();
	m_detectorRuns = 0;
}

const btHybridCollisionCounts& btHybridNarrowphase::getCounts() const
{
	m_counts.m_pairs = m_work.pairs;
	m_counts.m_pairsSkipped = m_work.pairsSkipped;
	m_counts.m_rebuilds = m_work.rebuilds;
	m_counts.m_childPairs = m_work.childPairs;
	m_counts.m_childPairsAsleep = m_work.childPairsAsleep;
	m_counts.m_boundsRejected = m_work.boundsRejected;
	m_counts.m_axisRejected = m_work.axisRejected;
	m_counts.m_gjkRuns = m_work.gjkRuns;
	m_counts.m_gjkIterations = m_work.gjkIterations;
	m_counts.m_detectorRuns = m_detectorRuns;
	return m_counts;
}

btHybridCollisionMemory btHybridNarrowphase::getMemory() const
{
	btHybridCollisionMemory memory;
	memory.m_pairs = m_pairs.size();
	for (int i = 0; i < m_pairs.size(); i++)
	{
		memory.m_childPairs += int(m_pairs[i]->m_parts.children().size());
		memory.m_pairBytes += sizeof(btHybridPairAlgorithm) + sizeof(btHybridPairMemory) + (m_planner ? btHybridPlanner::getPairBytes() : 0);
		memory.m_childPairBytes += m_pairs[i]->m_parts.childBytes();
	}
	for (int i = 0; i < m_objects.size(); i++)
	{
		const btAlignedObjectArray<btHybridPartBody*>& bodies = (*m_objects.getAtIndex(i))->m_bodies;
		for (int level = 0; level < bodies.size(); level++)
			if (bodies[level])
				memory.m_bodyBytes += sizeof(btHybridPartBody) + bodies[level]->getBody().bytes();
	}
	for (int i = 0; i < m_parts.size(); i++)
		memory.m_partBytes += (*m_parts.getAtIndex(i))->getBytes();
	return memory;
}

// In pair switching a hybrid's collision shape is its finest level, and the others come into use as well.
bool btHybridNarrowphase::hasPartLists(const btCollisionObjectWrapper* wrap) const
{
	if (wrap->getCollisionShape() != wrap->getCollisionObject()->getCollisionShape() || !btHybridParts::isPartList(wrap->getCollisionShape()))
		return false;
	const btHybridRigidBody* hybrid = m_planner ? btHybridRigidBody::upcast(wrap->getCollisionObject()) : 0;
	for (int level = 1; hybrid && level < hybrid->getFinestLevel(); level++)
		if (!btHybridParts::isPartList(hybrid->getLevels().getLevelShape(level)))
			return false;
	return true;
}

// A hybrid of another world, or of none.
bool btHybridNarrowphase::isForeign(const btCollisionObjectWrapper* wrap) const
{
	const btHybridRigidBody* hybrid = btHybridRigidBody::upcast(wrap->getCollisionObject());
	return hybrid && hybrid->getWorld() != m_world;
}

bool btHybridNarrowphase::takes(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap) const
{
	if (!m_info.m_pairAlgorithm || info.m_manifold)
		return false;
	if (!btHybridRigidBody::upcast(body0Wrap->getCollisionObject()) && !btHybridRigidBody::upcast(body1Wrap->getCollisionObject()))
		return false;
	return !isForeign(body0Wrap) && !isForeign(body1Wrap) && hasPartLists(body0Wrap) && hasPartLists(body1Wrap);
}

btHybridParts* btHybridNarrowphase::acquireParts(const btCollisionShape* shape)
{
	btHybridParts** known = m_parts.find(btHashPtr(shape));
	btHybridParts* parts = known ? *known : 0;
	if (!parts || !parts->isCurrent(true))
	{
		// Bodies that still use the old one let go of it when they notice.
		parts = new btHybridParts(shape);
		m_parts.insert(btHashPtr(shape), parts);
	}
	parts->m_users++;
	return parts;
}

void btHybridNarrowphase::releaseParts(btHybridParts* parts)
{
	if (--parts->m_users > 0)
		return;
	btHybridParts** known = m_parts.find(btHashPtr(parts->getShape()));
	if (known && *known == parts)
		m_parts.remove(btHashPtr(parts->getShape()));
	delete parts;
}

btHybridLevelBodies* btHybridNarrowphase::acquireObject(const btCollisionObject* object)
{
	btHybridLevelBodies** known = m_objects.find(btHashPtr(object));
	btHybridLevelBodies* bodies = known ? *known : 0;
	if (!bodies)
	{
		bodies = new btHybridLevelBodies(object, m_planner ? btHybridRigidBody::upcast(object) : 0);
		m_objects.insert(btHashPtr(object), bodies);
	}
	bodies->m_users++;
	return bodies;
}

void btHybridNarrowphase::releaseObject(btHybridLevelBodies* object)
{
	if (--object->m_users > 0)
		return;
	m_objects.remove(btHashPtr(object->m_object));
	for (int level = 0; level < object->m_bodies.size(); level++)
	{
		if (!object->m_bodies[level])
			continue;
		releaseParts(object->m_bodies[level]->m_parts);
		delete object->m_bodies[level];
	}
	delete object;
}

btHybridPartBody* btHybridNarrowphase::getBody(btHybridLevelBodies* object, int level)
{
	btHybridPartBody*& body = object->m_bodies[level];
	if (!body)
		body = new btHybridPartBody(object->m_object, acquireParts(object->getShape(level)));
	return body;
}

void btHybridNarrowphase::replaceParts(btHybridPartBody* body, const btCollisionShape* shape)
{
	btHybridParts* old = body->m_parts;
	body->m_parts = acquireParts(shape);
	body->m_body.setParts(body->m_parts->getList());
	body->m_version++;
	releaseParts(old);
}

bool btHybridNarrowphase::updateBody(btHybridPartBody* body, const btCollisionShape* shape, const btTransform& transform)
{
	const bool isChecked = m_dispatches && body->m_checkedStep == m_step && shape == body->m_parts->getShape();
	if (isChecked)
		return true;
	if (shape != body->m_parts->getShape() || !body->m_parts->isCurrent(body->m_changes))
	{
		if (!btHybridParts::isPartList(shape))
			return false;
		replaceParts(body, shape);
	}
	if (m_dispatches)
		body->m_checkedStep = m_step;
	body->moveTo(transform);
	return true;
}

btHybridPairMemory* btHybridNarrowphase::acquirePair()
{
	if (m_freePairs.size() == 0)
		m_freePairs.push_back(new btHybridPairMemory);
	btHybridPairMemory* pair = m_freePairs[m_freePairs.size() - 1];
	m_freePairs.pop_back();
	pair->m_credit.close();
	pair->m_freshUntil = pair->m_latest = 0;
	pair->m_units = 0;
	pair->m_overlap = 0;
	pair->m_gap = 0;
	pair->m_least = BT_LARGE_FLOAT;
	pair->m_seenMotion = 0;
	pair->m_returns = pair->m_returned = pair->m_reused = pair->m_restarted = pair->m_switched = pair->m_onCredit = pair->m_mayAudit = pair->m_excuses = false;
	pair->m_index = m_pairs.size();
	m_pairs.push_back(pair);
	return pair;
}

void btHybridNarrowphase::releasePair(btHybridPairMemory* pair)
{
	btHybridPairMemory* last = m_pairs[m_pairs.size() - 1];
	m_pairs[pair->m_index] = last;
	last->m_index = pair->m_index;
	m_pairs.pop_back();
	m_freePairs.push_back(pair);
}
