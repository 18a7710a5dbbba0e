#include "btHybridPairAlgorithm.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <limits>

#include "btHybridAheadEngine.h"
#include "btHybridNarrowphase.h"
#include "btHybridPlanner.h"
#include "btHybridWrapped.h"

static_assert(sizeof(btHybridPairAlgorithm) <= sizeof(btCompoundCompoundCollisionAlgorithm),
              "does not fit into Bullet's pool of algorithms");

using scatter::ChildPair;
using scatter::pairs::Pair;

btHybridPairAlgorithm::btHybridPairAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                             btHybridNarrowphase* narrowphase,
                                             const btCollisionObjectWrapper* body0Wrap,
                                             const btCollisionObjectWrapper* body1Wrap)
    : btHybridAlgorithm(info, narrowphase),
      m_bodies(narrowphase->getObjects().acquire(body0Wrap->getCollisionObject(), narrowphase->getPlanner()),
               narrowphase->getObjects().acquire(body1Wrap->getCollisionObject(), narrowphase->getPlanner())),
      m_index(-1),
      m_planIndex(-1),
      m_switches(m_narrowphase->getPlannerOfNew() &&
                 btMax(m_bodies.m_objects[0]->getNumLevels(), m_bodies.m_objects[1]->getNumLevels()) > 0)
{
	m_narrowphase->addUser();
	m_narrowphase->getPairs(m_switches).add(&m_index);
	if (m_switches)
		m_narrowphase->getPlanner()->addPair(m_bodies.m_objects[0], m_bodies.m_objects[1], &m_planIndex);
	m_bodies.take(btMax(m_bodies.m_objects[0]->getNumLevels(), m_bodies.m_objects[1]->getNumLevels()),
	              m_narrowphase->getObjects());
}

// What is freed here was got from the dispatcher, whichever call was under way.
btHybridPairAlgorithm::~btHybridPairAlgorithm()
{
	m_narrowphase->getForesight().forget(this);
	btManifoldArray own;
	getPair().forEachManifold([&own](void* manifold) { own.push_back(static_cast<btPersistentManifold*>(manifold)); });
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

bool btHybridPairAlgorithm::hasOthers() const
{
	return getPair().origin != scatter::pairs::ContactOrigin::kFound;
}

bool btHybridPairAlgorithm::hasRestarted() const
{
	return getPair().restarted;
}

// Most pairs of a pile are apart and hardly move: they are left without a look at anything but what all pairs share.
bool btHybridPairAlgorithm::staysQuiet(const scatter::pairs::PlacedBodies& bodies) const
{
	Pair& pair = getPair();
	return pair.quietUntil >= 0 && m_narrowphase->getPlanner()->isSettled(m_planIndex) &&
	       scatter::pairs::staysQuiet(pair, bodies);
}

void btHybridPairAlgorithm::takeForeseen(const btHybridForeseen& foreseen)
{
	if (foreseen.m_made)
		takeAhead(*foreseen.m_made);
	else
		takeQuiet();
}

void btHybridPairAlgorithm::fetchForeseen() const
{
#if defined(__GNUC__)
	if (m_switches)
		__builtin_prefetch(&m_narrowphase->getPlanner()->pair(m_planIndex));
#endif
}

namespace
{
class ManifoldPeek : public scatter::pairs::ContactPeek
{
	const btHybridPairBodies& m_bodies;
	const bool m_carries;

	bool areBoth(const ChildPair& child, int type) const
	{
		return m_bodies.m_bodies[0]->getChildShape(child.a)->getShapeType() == type &&
		       m_bodies.m_bodies[1]->getChildShape(child.b)->getShapeType() == type;
	}

public:
	ManifoldPeek(const btHybridPairBodies& bodies, bool carries) : m_bodies(bodies), m_carries(carries)
	{
	}
	virtual bool carries() const
	{
		return m_carries;
	}
	virtual bool wouldOutlast(void* contact) const
	{
		return m_carries ? wouldSlide(contact) < std::numeric_limits<float>::infinity()
		                 : btHybridContacts::wouldOutlast(*btHybridContacts::at(contact));
	}
	virtual float wouldSlide(void* contact) const
	{
		btPersistentManifold* manifold = btHybridContacts::at(contact);
		return m_carries ? btHybridContacts::carry(manifold, manifold->getBody0(), manifold->getBody1())
		                 : btHybridContacts::wouldSlide(*manifold);
	}
	virtual bool keepsPoints(const void* contact) const
	{
		return btHybridContacts::wouldOutlast(*static_cast<const btPersistentManifold*>(contact));
	}
	// Other detectors take memory of the dispatcher.
	virtual bool detectsAnywhere(const ChildPair& child) const
	{
		return areBoth(child, BOX_SHAPE_PROXYTYPE) || areBoth(child, SPHERE_SHAPE_PROXYTYPE);
	}
};
}  // namespace

bool btHybridPairAlgorithm::mayBeForeseen() const
{
	const bool isAwake =
	    m_bodies.m_objects[0]->getObject()->isActive() || m_bodies.m_objects[1]->getObject()->isActive();
	if (!isAwake || !m_switches)
		return isAwake;
	return m_narrowphase->getPlanner()->isForeseeable(m_planIndex, m_bodies.m_level);
}

bool btHybridPairAlgorithm::follow(btDispatcher* dispatcher)
{
	const btCollisionObject* objects[2] = {m_bodies.m_objects[0]->getObject(), m_bodies.m_objects[1]->getObject()};
	if (!dispatcher->needsCollision(objects[0], objects[1]))
		return false;
	bool areThere = true;
	for (int i = 0; i < 2; i++)
	{
		const btCollisionShape* shape =
		    m_switches ? m_bodies.m_bodies[i]->getShapeNow() : objects[i]->getCollisionShape();
		areThere = m_narrowphase->getObjects().update(m_bodies.m_bodies[i], shape, objects[i]->getWorldTransform()) &&
		           areThere;
	}
	return areThere;
}

scatter::pairs::PlacedBodies btHybridPairAlgorithm::getPlaced() const
{
	scatter::pairs::PlacedBodies bodies;
	bodies.a = &m_bodies.m_bodies[0]->getBody();
	bodies.b = &m_bodies.m_bodies[1]->getBody();
	for (int i = 0; i < 2; i++)
		bodies.versions[i] = m_bodies.m_bodies[i]->getVersion();
	return bodies;
}

void btHybridPairAlgorithm::fetch(btHybridLookahead::Stage stage) const
{
	btHybridLookahead::fetch(getPair(), stage);
}

btHybridForeseen btHybridPairAlgorithm::foresee(btHybridAhead& ahead, btHybridStepMemory& memory)
{
	Pair& pair = getPair();
	const scatter::pairs::PlacedBodies bodies = getPlaced();
	if (m_switches && staysQuiet(bodies))
		return foreseeQuiet(memory);
	const ManifoldPeek peek(m_bodies, ahead.m_mayStep);
	if (!scatter::pairs::isForeseeable(pair, bodies, peek))
		return btHybridForeseen::NOTHING;
	const size_t used = memory.m_foresight.used;
	scatter::pairs::PairPlan plan;
	if (m_switches)
		plan = m_narrowphase->getPlanner()->planPair(m_planIndex);
	const bool keeps =
	    m_switches && scatter::pairs::keepsContacts(pair, plan, 0, relativeFrame(bodies.a->frame(), bodies.b->frame()));
	const bool isDecided = keeps || scatter::pairs::foresee(pair, bodies, m_narrowphase->getSteps(), peek,
	                                                        ahead.m_locks, memory.m_foresight);
	if (!isDecided ||
	    !btHybridAheadRules::mayStep(ahead, m_bodies.m_objects[0]->getObject(), m_bodies.m_objects[1]->getObject()))
		return btHybridForeseen::IN_PART;
	const scatter::pairs::StepAhead& made = stepAhead(ahead, plan, memory);
	// The step has made use of it: the next pair may have its memory.
	memory.m_foresight.used = used;
	return foreseeMade(made, memory);
}

// As the dispatcher's near callback calls it, and processCollision() the pair.
const scatter::pairs::StepAhead& btHybridPairAlgorithm::stepAhead(const btHybridAhead& ahead,
                                                                  const scatter::pairs::PairPlan& plan,
                                                                  btHybridStepMemory& memory)
{
	btHybridNarrowphase& shared = *m_narrowphase;
	const btCollisionObject* objects[2] = {m_bodies.m_objects[0]->getObject(), m_bodies.m_objects[1]->getObject()};
	const btCollisionObjectWrapper wrap0 = btHybridWrapped(objects[0]);
	const btCollisionObjectWrapper wrap1 = btHybridWrapped(objects[1]);
	btManifoldResult result(&wrap0, &wrap1);
	const btHybridPairCall call = {{&wrap0, &wrap1}, *ahead.m_info, &result};
	scatter::pairs::StepAhead& step = memory.m_foresight.takeStep();
	btHybridAheadEngine<btHybridPairEngine> engine(
	    memory, step.notes, static_cast<btCollisionDispatcher*>(m_dispatcher), shared.getObjects(), m_bodies, call,
	    m_fallback, shared.getSteps().ownGjk, m_switches);
	Pair& pair = getPair();
	if (m_switches)
		step.outcome = scatter::pairs::stepPair(pair, plan, shared.getSteps(), engine, memory.m_step, step.work);
	else
		scatter::pairs::collidePair(pair, m_bodies.m_level, shared.getSteps(), engine, memory.m_step, step.work);
	return step;
}

void btHybridPairAlgorithm::takeAhead(const scatter::pairs::StepAhead& step)
{
	if (!step.notes.empty())
		btHybridAdopt(getPair(), step.notes, m_dispatcher, m_bodies.m_objects[0]->getObject(),
		              m_bodies.m_objects[1]->getObject());
	m_narrowphase->takeAhead(step, m_planIndex);
}

void btHybridPairAlgorithm::endForesight(const btHybridForeseen& foreseen)
{
	Pair& pair = getPair();
	if (foreseen.m_made)
		takeAhead(*foreseen.m_made);
	if (!pair.foresight)
		return;
	for (void* manifold : pair.foresight->dropped)
		m_dispatcher->releaseManifold(btHybridContacts::at(manifold));
	pair.foresight = 0;
}

void btHybridPairAlgorithm::processCollision(const btCollisionObjectWrapper* body0Wrap,
                                             const btCollisionObjectWrapper* body1Wrap,
                                             const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	btHybridNarrowphase& shared = *m_narrowphase;
	if (shared.getForesight().passBy(getPlace(), this))
		return;
	btHybridPlanner* planner = m_switches ? shared.getPlanner() : 0;
	shared.getLookahead().visit(this, m_index, shared.getPairs(m_switches), shared.countPairs(),
	                            planner ? &planner->pair(m_planIndex) : 0);
	const btHybridPairCall call = {{body0Wrap, body1Wrap}, dispatchInfo, resultOut};
	btHybridPairEngine engine(static_cast<btCollisionDispatcher*>(m_dispatcher), shared.getObjects(), m_bodies, call,
	                          m_fallback, shared.getSteps().ownGjk, m_switches);
	Pair& pair = getPair();
	if (!planner)
	{
		scatter::pairs::collidePair(pair, m_bodies.m_level, shared.getSteps(), engine, shared.beginPair(),
		                            shared.getWork());
		shared.endPair();
		return;
	}
	scatter::pairs::PlacedBodies bodies;
	if (!pair.foresight && pair.quietUntil >= 0 && engine.follow(bodies) && staysQuiet(bodies))
		return takeQuiet();
	const scatter::pairs::PairPlan plan = planner->planPair(m_planIndex);
	const scatter::pairs::PairOutcome outcome =
	    scatter::pairs::stepPair(pair, plan, shared.getSteps(), engine, shared.beginPair(), shared.getWork());
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
