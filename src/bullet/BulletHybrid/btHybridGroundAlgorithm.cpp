#include "btHybridGroundAlgorithm.h"

#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>

#include <mutex>
#include <utility>

#include "btHybridAheadEngine.h"
#include "btHybridNarrowphase.h"
#include "btHybridPlanner.h"
#include "btHybridWrapped.h"
#include "pairs/ground_step.h"

static_assert(sizeof(btHybridGroundAlgorithm) <= sizeof(btCompoundCompoundCollisionAlgorithm),
              "does not fit into Bullet's pool of algorithms");

using scatter::pairs::GroundContact;
using scatter::pairs::GroundPair;

btHybridGroundAlgorithm::btHybridGroundAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                                 btHybridNarrowphase* narrowphase,
                                                 const btCollisionObjectWrapper* body0Wrap,
                                                 const btCollisionObjectWrapper* body1Wrap, int side)
    : btHybridAlgorithm(info, narrowphase), m_bodies(0), m_ground(0), m_index(-1), m_planIndex(-1)
{
	const btCollisionObjectWrapper* wraps[2] = {body0Wrap, body1Wrap};
	btHybridObjects& objects = m_narrowphase->getObjects();
	btHybridPlanner* planner = m_narrowphase->getPlannerOfNew();
	btHybridLevelBodies* body = objects.acquire(wraps[side]->getCollisionObject(), m_narrowphase->getPlanner());
	const bool switches = planner && body->getNumLevels() > 0;
	m_bodies = new btHybridGroundBodies(body, wraps[1 - side]->getCollisionObject(), side, switches);
	m_bodies->take(body->getNumLevels(), objects);
	m_narrowphase->addUser();
	m_narrowphase->getGrounds().add(&m_index);
	shareGround();
	if (!switches)
		return;
	m_ground = objects.acquire(wraps[1 - side]->getCollisionObject(), false);
	planner->addGround(body, m_ground, &m_planIndex);
}

// While no other thread is at work.
void btHybridGroundAlgorithm::shareGround()
{
	btHybridGround& ground = m_bodies->m_ground;
	const float radius = m_bodies->m_body->getBody().parts().radius();
	ground.follow(m_bodies->m_groundObject->getCollisionShape(), radius);
	if (!ground.isSmall(radius))
		return;
	bool isNew;
	const std::shared_ptr<const scatter::pairs::WholeGround> whole =
	    m_narrowphase->getWholeGrounds().acquire(ground, isNew);
	if (!whole)
		return;
	getPair().region.share(whole, isNew);
	getPair().versions[1] = ground.getVersion();
}

// What is freed here was got from the dispatcher, whichever call was under way.
btHybridGroundAlgorithm::~btHybridGroundAlgorithm()
{
	m_narrowphase->getForesight().forget(this);
	for (const GroundContact& contact : getPair().contacts)
		m_dispatcher->releaseManifold(btHybridContacts::at(contact.manifold));
	m_fallback.release(m_dispatcher);
	// What it shares is looked up anew after the last pair that has it.
	getPair().region.forget();
	m_narrowphase->getGrounds().remove(m_index);
	if (m_ground)
	{
		m_narrowphase->getPlanner()->removePair(m_planIndex);
		m_narrowphase->getObjects().release(m_ground);
	}
	m_narrowphase->getObjects().release(m_bodies->m_object);
	delete m_bodies;
	m_narrowphase->removeUser();
}

GroundPair& btHybridGroundAlgorithm::getPair() const
{
	return m_narrowphase->getGrounds()[m_index];
}

bool btHybridGroundAlgorithm::hasOthers() const
{
	return getPair().hasRecycled || getPair().passage.holds();
}

bool btHybridGroundAlgorithm::hasRestarted() const
{
	return getPair().restarted;
}

// Most bodies over a ground do not touch it: they are left without a look at anything but where they are.
bool btHybridGroundAlgorithm::isSettled() const
{
	const btHybridPlanner* planner = getPlanner();
	return getPair().quietUntil >= 0 && (!planner || planner->isSettled(m_planIndex));
}

bool btHybridGroundAlgorithm::staysQuiet(btHybridGroundEngine& engine) const
{
	const GroundPair& pair = getPair();
	scatter::pairs::PlacedBody body;
	if (!isSettled())
		return false;
	const float ahead = m_narrowphase->getSteps().passages ? glm::length(engine.wayAhead()) : 0;
	return engine.follow(body) &&
	       scatter::pairs::staysQuiet(pair, body, engine.groundFrame(), engine.groundVersion(), ahead);
}

bool btHybridGroundAlgorithm::mayBeForeseen() const
{
	if (!m_bodies->m_object->getObject()->isActive() && !m_bodies->m_groundObject->isActive())
		return false;
	return m_planIndex < 0 || m_narrowphase->getPlanner()->isForeseeable(m_planIndex, m_bodies->m_level);
}

bool btHybridGroundAlgorithm::follow(btDispatcher* dispatcher)
{
	const btCollisionObject* object = m_bodies->m_object->getObject();
	if (!dispatcher->needsCollision(object, m_bodies->m_groundObject))
		return false;
	const btCollisionShape* shape =
	    m_bodies->m_switches ? m_bodies->m_body->getShapeNow() : object->getCollisionShape();
	if (!m_narrowphase->getObjects().update(m_bodies->m_body, shape, object->getWorldTransform()))
		return false;
	m_bodies->m_ground.follow(m_bodies->m_groundObject->getCollisionShape(),
	                          m_bodies->m_body->getBody().parts().radius());
	return m_bodies->m_ground.getKind() != BT_HYBRID_NO_GROUND;
}

scatter::pairs::PlacedBody btHybridGroundAlgorithm::getPlaced() const
{
	scatter::pairs::PlacedBody placed;
	placed.body = &m_bodies->m_body->getBody();
	placed.version = m_bodies->m_body->getVersion();
	return placed;
}

namespace
{
/// What processCollision() would be called with.
struct CallAhead
{
	btCollisionObjectWrapper m_body;
	btCollisionObjectWrapper m_ground;
	btManifoldResult m_result;
	btHybridGroundCall m_call;

	CallAhead(const btHybridGroundBodies& bodies, const btDispatcherInfo& info)
	    : m_body(btHybridWrapped(bodies.m_object->getObject())),
	      m_ground(btHybridWrapped(bodies.m_groundObject)),
	      m_result(bodies.m_side == 0 ? &m_body : &m_ground, bodies.m_side == 0 ? &m_ground : &m_body),
	      m_call{&m_body, &m_ground, info, &m_result}
	{
	}
};

/// Bullet's meshes count their longest search, which is no work for two threads at once.
class AheadEngine : public btHybridAheadEngine<btHybridGroundEngine>
{
	std::mutex& m_meshes;

public:
	template <class... Rest>
	explicit AheadEngine(std::mutex& meshes, Rest&&... rest)
	    : btHybridAheadEngine<btHybridGroundEngine>(std::forward<Rest>(rest)...), m_meshes(meshes)
	{
	}
	virtual bool collect(const scatter::Vec3& low, const scatter::Vec3& high, scatter::pairs::GroundPieces& pieces)
	{
		const std::scoped_lock lock(m_meshes);
		return btHybridGroundEngine::collect(low, high, pieces);
	}
};
}  // namespace

btHybridForeseen btHybridGroundAlgorithm::foresee(btHybridAhead& ahead, btHybridStepMemory& memory)
{
	GroundPair& pair = getPair();
	const scatter::pairs::PlacedBody placed = getPlaced();
	const scatter::Frame ground = btHybridFrameOf(m_bodies->m_groundObject->getWorldTransform());
	const int version = m_bodies->m_ground.getVersion();
	const scatter::PairSteps& steps = m_narrowphase->getSteps();
	const scatter::Vec3 way = steps.passages ? btHybridWayAhead(m_bodies->m_object->getObject(),
	                                                            m_bodies->m_groundObject, ahead.m_info->m_timeStep)
	                                         : scatter::Vec3(0);
	if (isSettled() && scatter::pairs::staysQuiet(pair, placed, ground, version, glm::length(way)))
		return foreseeQuiet(memory);
	CallAhead call(*m_bodies, *ahead.m_info);
	scatter::pairs::StepAhead& step = memory.m_foresight.takeStep();
	AheadEngine engine(ahead.m_meshes, memory, step.notes, static_cast<btCollisionDispatcher*>(m_dispatcher),
	                   m_narrowphase->getObjects(), *m_bodies, call.m_call, m_fallback, memory.m_bounds);
	const size_t used = memory.m_foresight.used;
	scatter::pairs::PairPlan plan;
	if (m_planIndex >= 0)
		plan = m_narrowphase->getPlanner()->planPair(m_planIndex);
	const bool keeps = m_planIndex >= 0 && scatter::pairs::onlyKeeps(pair, plan, placed, ground, version);
	bool isDecided = keeps || scatter::pairs::onlyCarries(pair, placed, m_bodies->m_level, ground, version, steps);
	if (!isDecided && scatter::pairs::isForeseeable(pair, placed, m_bodies->m_level, ground, version, steps))
		isDecided = scatter::pairs::foresee(pair, placed, ground, steps, engine, memory.m_step.ground.region,
		                                    ahead.m_locks, memory.m_foresight);
	if (!isDecided || !btHybridAheadRules::mayStep(ahead, m_bodies->m_object->getObject(), m_bodies->m_groundObject))
		return btHybridForeseen::IN_PART;
	stepAhead(step, plan, engine, memory);
	// The step has made use of it: the next pair may have its memory.
	memory.m_foresight.used = used;
	return foreseeMade(step, memory);
}

// As the dispatcher's near callback calls it, and processCollision() the pair.
void btHybridGroundAlgorithm::stepAhead(scatter::pairs::StepAhead& step, const scatter::pairs::PairPlan& plan,
                                        btHybridGroundEngine& engine, btHybridStepMemory& memory)
{
	const scatter::PairSteps& steps = m_narrowphase->getSteps();
	if (m_planIndex >= 0)
		step.outcome = scatter::pairs::stepGround(getPair(), plan, steps, engine, memory.m_step, step.work);
	else
		scatter::pairs::collideGround(getPair(), m_bodies->m_level, steps, engine, memory.m_step, step.work);
}

void btHybridGroundAlgorithm::takeAhead(const scatter::pairs::StepAhead& step)
{
	if (!step.notes.empty())
		btHybridAdopt(getPair(), step.notes, m_dispatcher, m_bodies->m_object->getObject(), m_bodies->m_groundObject);
	m_narrowphase->takeAhead(step, m_planIndex);
}

void btHybridGroundAlgorithm::takeForeseen(const btHybridForeseen& foreseen)
{
	if (foreseen.m_made)
		takeAhead(*foreseen.m_made);
	else
		takeQuiet();
}

void btHybridGroundAlgorithm::fetchForeseen() const
{
#if defined(__GNUC__)
	if (m_planIndex >= 0)
		__builtin_prefetch(&m_narrowphase->getPlanner()->pair(m_planIndex));
#endif
}

void btHybridGroundAlgorithm::endForesight(const btHybridForeseen& foreseen)
{
	if (foreseen.m_made)
		takeAhead(*foreseen.m_made);
	getPair().foresight = 0;
}

void btHybridGroundAlgorithm::processCollision(const btCollisionObjectWrapper* body0Wrap,
                                               const btCollisionObjectWrapper* body1Wrap,
                                               const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut)
{
	btHybridNarrowphase& shared = *m_narrowphase;
	if (shared.getForesight().passBy(getPlace(), this))
		return;
	btHybridPlanner* planner = getPlanner();
	const bool isFirst = m_bodies->m_side == 0;
	const btHybridGroundCall call = {isFirst ? body0Wrap : body1Wrap, isFirst ? body1Wrap : body0Wrap, dispatchInfo,
	                                 resultOut};
	btHybridGroundEngine engine(static_cast<btCollisionDispatcher*>(m_dispatcher), shared.getObjects(), *m_bodies, call,
	                            m_fallback, shared.getBounds());
	if (staysQuiet(engine))
		return takeQuiet();
	if (!planner)
	{
		scatter::pairs::collideGround(getPair(), m_bodies->m_level, shared.getSteps(), engine, shared.beginPair(),
		                              shared.getWork());
		shared.endPair();
		return;
	}
	const scatter::pairs::PairPlan plan = planner->planPair(m_planIndex);
	const scatter::pairs::PairOutcome outcome =
	    scatter::pairs::stepGround(getPair(), plan, shared.getSteps(), engine, shared.beginPair(), shared.getWork());
	shared.endPair();
	planner->take(m_planIndex, outcome);
}

void btHybridGroundAlgorithm::getAllContactManifolds(btManifoldArray& manifoldArray)
{
	m_fallback.getManifolds(manifoldArray);
	for (const GroundContact& contact : getPair().contacts)
		manifoldArray.push_back(btHybridContacts::at(contact.manifold));
}

void btHybridGroundAlgorithm::getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const
{
	addFallback(manifolds);
	for (const GroundContact& contact : getPair().contacts)
	{
		const btHybridManifoldView view = {btHybridContacts::at(contact.manifold), contact.credit, false};
		manifolds.push_back(view);
	}
}
