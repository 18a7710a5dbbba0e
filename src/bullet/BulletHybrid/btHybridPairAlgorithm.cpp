#include "btHybridPairAlgorithm.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include "btHybridNarrowphase.h"
#include "btHybridPlanner.h"

static_assert(sizeof(btHybridPairAlgorithm) <= sizeof(btCompoundCompoundCollisionAlgorithm), "does not fit into Bullet's pool of algorithms");

using scatter::ChildPair;
using scatter::pairs::Pair;

btHybridPairAlgorithm::btHybridPairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, btHybridNarrowphase* narrowphase, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap)
    : btHybridAlgorithm(info),
      m_narrowphase(narrowphase),
      m_bodies(narrowphase->getObjects().acquire(body0Wrap->getCollisionObject(), narrowphase->getPlanner()), narrowphase->getObjects().acquire(body1Wrap->getCollisionObject(), narrowphase->getPlanner())),
      m_index(-1),
      m_planIndex(-1),
      m_switches(m_narrowphase->getPlanner() && btMax(m_bodies.m_objects[0]->getNumLevels(), m_bodies.m_objects[1]->getNumLevels()) > 0)
{
	m_narrowphase->addUser();
	m_narrowphase->getPairs(m_switches).add(&m_index);
	if (m_switches)
		m_narrowphase->getPlanner()->addPair(m_bodies.m_objects[0], m_bodies.m_objects[1], &m_planIndex);
	m_bodies.take(btMax(m_bodies.m_objects[0]->getNumLevels(), m_bodies.m_objects[1]->getNumLevels()), m_narrowphase->getObjects());
}

// What is freed here was got from the dispatcher, whichever call was under way.
btHybridPairAlgorithm::~btHybridPairAlgorithm()
{
	btManifoldArray own;
	getPair().forEachManifold([&own](void* manifold)
	                          { own.push_back(static_cast<btPersistentManifold*>(manifold)); });
	for (int i = 0; i < own.size(); i++)
		m_dispatcher->releaseManifold(own[i]);
	m_fallback.release(m_dispatcher);
	if (m_switches)
		m_narrowphase->getPlanner()->removePair(m_planIndex);
	m_narrowphase->getPairs(m_switches).remove(m_index);
	for (int i = 0; i < 2; i++)
		m_narrowphase->getObjects().release(m_bodies.m_objects[i]);
	m_narrowphase->removeUser();
}

Pair& btHybridPairAlgorithm::getPair() const
{
	return m_narrowphase->getPairs(m_switches)[m_index];
}

bool btHybridPairAlgorithm::hasReused() const
{
	return getPair().origin != scatter::pairs::ContactOrigin::kFound;
}

bool btHybridPairAlgorithm::hasRestarted() const
{
	return getPair().restarted;
}

// Most pairs of a pile are apart and hardly move: they are left without a look at anything but what all pairs share.
bool btHybridPairAlgorithm::staysQuiet(btHybridPairEngine& engine) const
{
	Pair& pair = getPair();
	scatter::pairs::PlacedBodies bodies;
	return pair.quietUntil >= 0 && m_narrowphase->getPlanner()->isSettled(m_planIndex) && engine.follow(bodies) && scatter::pairs::staysQuiet(pair, bodies);
}

void btHybridPairAlgorithm::processCollision(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	btHybridNarrowphase& shared = *m_narrowphase;
	btHybridPlanner* planner = m_switches ? shared.getPlanner() : 0;
	const btHybridPairCall call = {{body0Wrap, body1Wrap}, dispatchInfo, resultOut};
	btHybridPairEngine engine(static_cast<btCollisionDispatcher*>(m_dispatcher), shared.getObjects(), m_bodies, call, m_fallback, shared.getSteps().ownGjk, m_switches);
	Pair& pair = getPair();
	if (!planner)
	{
		scatter::pairs::collidePair(pair, m_bodies.m_level, shared.getSteps(), engine, shared.beginPair(), shared.getWork());
		shared.endPair();
		return;
	}
	if (staysQuiet(engine))
	{
		planner->countQuiet(m_planIndex);
		shared.getWork().pairs++;
		shared.getWork().pairsSkipped++;
		return;
	}
	const scatter::pairs::PairPlan plan = planner->planPair(m_planIndex);
	const scatter::pairs::PairOutcome outcome = scatter::pairs::stepPair(pair, plan, shared.getSteps(), engine, shared.beginPair(), shared.getWork());
	shared.endPair();
	planner->take(m_planIndex, outcome);
}

void btHybridPairAlgorithm::getAllContactManifolds(btManifoldArray& manifoldArray)
{
	m_fallback.getManifolds(manifoldArray);
	getPair().forEachManifold([&manifoldArray](void* manifold)
	                          { manifoldArray.push_back(static_cast<btPersistentManifold*>(manifold)); });
}

void btHybridPairAlgorithm::getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const
{
	addFallback(manifolds);
	const auto add = [&manifolds](const void* manifold, btScalar credit, bool isHeld)
	{
		const btHybridManifoldView view = {static_cast<const btPersistentManifold*>(manifold), credit, isHeld};
		manifolds.push_back(view);
	};
	const Pair& pair = getPair();
	for (const void* manifold : pair.held.manifolds())
		add(manifold, 0, true);
	for (const ChildPair& child : pair.parts.children())
		if (child.contact)
			add(child.contact, pair.credit.account.of(child.a, child.b), false);
}
