#include "btHybridPlanner.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cmath>
#include <limits>

#include "BulletHybrid/btHybridRigidBody.h"
#include "btHybridConversions.h"
#include "btHybridLevelBodies.h"
#include "lod/make_policy.h"
#include "pairs/ground_step.h"

using scatter::lod::BodyView;
using scatter::lod::PairView;
using scatter::lod::PlannedPair;
using scatter::lod::SwitchChoice;
using scatter::lod::SwitchKind;
using scatter::lod::Wish;
using scatter::pairs::PairOutcome;
using scatter::pairs::PairPlan;

namespace
{
// Policies look at a pair every so many steps, and at a new one at once.
const int c_adviceInterval = 4;

// Twice the logarithm to base 2, so that kinds differ by less than a half.
unsigned char kindOf(double numChildPairs)
{
	return static_cast<unsigned char>(btMin(int(2 * std::log2(btMax(numChildPairs, 1.0))), PlannedPair::kKinds - 1));
}

btScalar radiusOf(const btCollisionObject* object, const btHybridRigidBody* hybrid)
{
	btVector3 center;
	btScalar radius;
	const btCollisionShape* shape = hybrid ? hybrid->getLevels().getLevelShape(1) : object->getCollisionShape();
	shape->getBoundingSphere(center, radius);
	return center.length() + radius;
}

BodyView viewOf(const btCollisionObject* object)
{
	BodyView view;
	view.present = true;
	view.center = btHybridVec3(object->getWorldTransform().getOrigin());
	const btRigidBody* body = btRigidBody::upcast(object);
	if (body && body->getInvMass() > 0)
	{
		view.velocity = btHybridVec3(body->getLinearVelocity());
		view.mass = 1 / body->getInvMass();
	}
	const btHybridRigidBody* hybrid = btHybridRigidBody::upcast(object);
	view.radius = radiusOf(object, hybrid);
	view.held = hybrid && hybrid->isHeld();
	return view;
}
}  // namespace

btHybridPlanner::btHybridPlanner()
    : m_costs(scatter::lod::CostWeights()), m_governor(scatter::lod::GovernorDef()), m_listener(0), m_step(0), m_numCreated(0), m_numBelowFinest(0), m_asks(false), m_plans(false), m_advisesAll(false), m_needsTime(false), m_fixedUnits(0), m_units(0), m_lastUnits(0), m_budgetUnits(0), m_auditUnits(0)
{
}

void btHybridPlanner::setBudget(const scatter::lod::UnitBudget& budget, bool needsTime)
{
	m_budget = budget;
	m_needsTime = needsTime;
	m_governor = scatter::lod::Governor(scatter::lod::GovernorDef());
}

bool btHybridPlanner::hasBudget() const
{
	return m_budget.isLimited();
}

static const char c_noSpecification[] = "a policy needs a name, such as \"speed\"; 0 was given";

const char* btHybridPlanner::addPolicy(const char* specification)
{
	if (!specification)
		return c_noSpecification;
	auto policy = scatter::lod::makePolicy(specification, m_policies.grouping());
	if (!policy)
	{
		m_mistake = policy.error().message;
		return m_mistake.c_str();
	}
	m_policies.add(std::move(*policy));
	return 0;
}

const char* btHybridPlanner::checkPolicy(const char* specification)
{
	if (!specification)
		return c_noSpecification;
	const auto policy = scatter::lod::makePolicy(specification, m_policies.grouping());
	m_mistake = policy ? std::string() : policy.error().message;
	return policy ? 0 : m_mistake.c_str();
}

void btHybridPlanner::removePolicies()
{
	m_policies = scatter::lod::PolicyList();
	m_advisesAll = true;
	for (size_t i = 0; i < m_planned.size(); i++)
		m_planned[i].wish = Wish();
}

void btHybridPlanner::setFocus(const btVector3& eye, const btVector3& target, btScalar fieldOfView)
{
	m_situation.focus = scatter::lod::Focus{btHybridVec3(eye), btHybridVec3(target), fieldOfView};
}

void btHybridPlanner::removeFocus()
{
	m_situation.focus.reset();
}

scatter::lod::SwitchRules btHybridPlanner::getRules(int pair) const
{
	scatter::lod::SwitchRules rules;
	// What saves cost must not cost: a pair that is apart goes coarser for the budget only where that is free.
	rules.credit = m_info.m_credit && (m_planned[pair].view.touching || !m_planned[pair].byBudget);
	rules.safe = m_info.m_safetyConditions;
	rules.creditLevel = btMin(m_info.m_creditLevel, m_planned[pair].view.finest - 1);
	return rules;
}

void btHybridPlanner::add(btHybridLevelBodies* object0, btHybridLevelBodies* object1, double numChildPairs, int* place)
{
	PlannedPair planned;
	planned.view.finest = btMax(object0->getNumLevels(), object1->getNumLevels());
	planned.target = planned.view.finest;
	planned.identity = m_numCreated++;
	planned.kind = kindOf(numChildPairs);
	*place = getNumPairs();
	m_planned.push_back(planned);
	const Pair pair = {{object0, object1}, place, 1, false, false, false, planned.target, m_step, m_step, 0};
	m_pairs.push_back(pair);
}

void btHybridPlanner::addPair(btHybridLevelBodies* object0, btHybridLevelBodies* object1, int* place)
{
	add(object0, object1, double(object0->getNumParts()) * object1->getNumParts(), place);
}

void btHybridPlanner::addGround(btHybridLevelBodies* body, btHybridLevelBodies* ground, int* place)
{
	add(body, ground, body->getNumParts(), place);
	m_pairs.back().m_isGround = true;
	m_pairs.back().m_coarsest = scatter::pairs::coarsestOnGround(body->getNumLevels());
	m_planned.back().wish.atLeast = static_cast<unsigned char>(m_pairs.back().m_coarsest);
}

void btHybridPlanner::removePair(int pair)
{
	if (m_pairs[pair].m_requested)
	{
		m_stepInfo.m_retractions++;
		tell(BT_HYBRID_PAIR_RETRACTED, pair, m_planned[pair].view.level, m_planned[pair].target, false);
	}
	m_planned[pair] = m_planned.back();
	m_planned.pop_back();
	m_pairs[pair] = m_pairs.back();
	*m_pairs[pair].m_place = pair;
	m_pairs.pop_back();
}

void btHybridPlanner::showBodies(const btCollisionObjectArray& objects)
{
	m_bodies.resize(objects.size());
	for (int i = 0; i < objects.size(); i++)
		m_bodies[i] = viewOf(objects[i]);
}

void btHybridPlanner::showPairs()
{
	m_views.resize(m_planned.size());
	for (size_t i = 0; i < m_planned.size(); i++)
	{
		m_planned[i].view.a = m_pairs[i].m_objects[0]->getObject()->getWorldArrayIndex();
		m_planned[i].view.b = m_pairs[i].m_objects[1]->getObject()->getWorldArrayIndex();
		m_views[i] = m_planned[i].view;
	}
}

void btHybridPlanner::advise(int pair)
{
	PlannedPair& planned = m_planned[pair];
	planned.wish = Wish();
	if (!m_policies.empty() && planned.view.a < m_bodies.size() && planned.view.b < m_bodies.size())
		planned.wish = m_policies.advise(m_situation, planned.view);
	if (m_pairs[pair].m_coarsest > 1)
	{
		planned.wish.atLeast = static_cast<unsigned char>(btMax(int(planned.wish.atLeast), m_pairs[pair].m_coarsest));
		planned.wish.atMost = btMax(planned.wish.atMost, planned.wish.atLeast);
	}
	const btCollisionObject* objects[2] = {m_pairs[pair].m_objects[0]->getObject(), m_pairs[pair].m_objects[1]->getObject()};
	// A sensor that is told of what is not there would not be of use.
	if (!objects[0]->hasContactResponse() || !objects[1]->hasContactResponse())
		planned.wish.atLeast = planned.view.finest;
	if (m_held.size() > 0 && (isHeld(objects[0]) || isHeld(objects[1])))
		planned.wish.atLeast = planned.view.finest;
}

bool btHybridPlanner::isHeld(const btCollisionObject* object) const
{
	return m_held.findLinearSearch2(object) >= 0;
}

void btHybridPlanner::setHeld(const btAlignedObjectArray<const btCollisionObject*>& held)
{
	m_held.copyFromArray(held);
	m_advisesAll = true;
}

void btHybridPlanner::applyAsked(int pair)
{
	Wish& wish = m_planned[pair].wish;
	for (int i = 0; i < 2; i++)
	{
		const int asked = m_pairs[pair].m_objects[i]->getAskedLevel();
		if (asked > 0 && asked < wish.atMost)
		{
			wish.atMost = static_cast<unsigned char>(asked);
			wish.askedBy = c_byProgram;
		}
	}
}

void btHybridPlanner::plan(const btCollisionObjectArray& objects, int numMoving, int numOverlappingPairs)
{
	m_step++;
	m_auditUnits = 0;
	m_fixedUnits = m_costs.fixedUnits(objects.size(), numOverlappingPairs);
	m_units = m_fixedUnits;
	m_budgetUnits = m_budget.next();
	m_plans = hasBudget() || !m_policies.empty() || m_asks || m_numBelowFinest > 0;
	if (!m_plans)
		return;
	if (!m_policies.empty())
	{
		showBodies(objects);
		showPairs();
		m_situation.bodies = m_bodies;
		m_situation.pairs = m_views;
		m_situation.step = m_step;
		m_situation.load.units = m_lastUnits;
		m_situation.load.budget = hasBudget() ? m_budgetUnits : 0;
		m_policies.observe(m_situation);
	}
	for (size_t i = 0; i < m_planned.size(); i++)
	{
		PlannedPair& planned = m_planned[i];
		if (planned.blockedSteps > 0)
			planned.blockedSteps--;
		if ((int(i) + m_step) % c_adviceInterval == 0 || m_asks || m_advisesAll)
			advise(int(i));
		if (m_asks)
			applyAsked(int(i));
		m_pairs[i].m_targetBefore = planned.target;
	}
	m_advisesAll = false;
	m_governor.setCreditLevel(m_info.m_creditLevel);
	m_governor.plan(m_planned, m_costs, m_fixedUnits, m_budgetUnits, numMoving);
	for (size_t i = 0; i < m_planned.size(); i++)
		followRequest(int(i));
}

// A request is a target that is not the level; it stands until the switch, or until it is the level again.
void btHybridPlanner::followRequest(int pair)
{
	const PlannedPair& planned = m_planned[pair];
	Pair& followed = m_pairs[pair];
	if (planned.view.level == 0)
		return;
	if (planned.target == planned.view.level)
	{
		if (!followed.m_requested)
			return;
		followed.m_requested = followed.m_acknowledged = false;
		m_stepInfo.m_retractions++;
		tell(BT_HYBRID_PAIR_RETRACTED, pair, planned.view.level, followed.m_targetBefore, false);
		return;
	}
	if (followed.m_requested && planned.target == followed.m_targetBefore)
		return;
	if (!followed.m_requested)
		followed.m_stepRequested = m_step;
	followed.m_requested = true;
	followed.m_acknowledged = false;
	tell(BT_HYBRID_PAIR_REQUESTED, pair, planned.view.level, planned.target, false);
}

void btHybridPlanner::tell(btHybridPairEventKind kind, int pair, int from, int to, bool onCredit) const
{
	if (!m_listener)
		return;
	btHybridPairEvent event;
	event.m_kind = kind;
	event.m_objectA = m_pairs[pair].m_objects[0]->getObject();
	event.m_objectB = m_pairs[pair].m_objects[1]->getObject();
	event.m_fromLevel = from;
	event.m_toLevel = to;
	event.m_onCredit = onCredit;
	event.m_policy = whoAsks(pair, event.m_scope);
	m_listener->pairEvent(event);
}

const char* btHybridPlanner::whoAsks(int pair, btHybridScope& scope) const
{
	const PlannedPair& planned = m_planned[pair];
	const bool byProgram = planned.wish.askedBy == c_byProgram;
	const bool isKnown = byProgram || planned.wish.askedBy < m_policies.size();
	if (planned.byBudget || !isKnown || planned.wish.atMost >= planned.view.finest || planned.target > planned.wish.atMost)
	{
		scope = hasBudget() ? BT_HYBRID_GLOBAL : BT_HYBRID_LOCAL;
		return hasBudget() ? "governor" : "default";
	}
	scope = byProgram ? BT_HYBRID_LOCAL : m_policies[planned.wish.askedBy].scope();
	return byProgram ? "program" : m_policies[planned.wish.askedBy].name().data();
}

int btHybridPlanner::getTarget(int pair)
{
	PlannedPair& planned = m_planned[pair];
	if (planned.view.level > 0)
		return planned.target;
	planned.target = planned.view.finest;
	if (!m_plans)
		return planned.target;
	planned.view.a = m_pairs[pair].m_objects[0]->getObject()->getWorldArrayIndex();
	planned.view.b = m_pairs[pair].m_objects[1]->getObject()->getWorldArrayIndex();
	advise(pair);
	if (m_asks)
		applyAsked(pair);
	planned.target = static_cast<unsigned char>(m_governor.planNew(planned, m_costs));
	planned.byBudget = planned.target < btMin(planned.wish.atMost, planned.view.finest);
	return planned.target;
}

void btHybridPlanner::acknowledge(int pair)
{
	if (!m_pairs[pair].m_requested || m_pairs[pair].m_acknowledged)
		return;
	m_pairs[pair].m_acknowledged = true;
	tell(BT_HYBRID_PAIR_ACKNOWLEDGED, pair, m_planned[pair].view.level, m_planned[pair].target, false);
}

void btHybridPlanner::takeChoice(int pair, const SwitchChoice& choice)
{
	PlannedPair& planned = m_planned[pair];
	const int from = planned.view.level;
	if (choice.kind == SwitchKind::kBlocked)
	{
		m_stepInfo.m_blockedTries++;
		// Not all at once again.
		planned.blockedSteps = static_cast<unsigned char>(btMin(m_info.m_retryInterval + int(planned.identity % m_info.m_retryInterval), 255));
		tell(BT_HYBRID_PAIR_BLOCKED, pair, from, planned.target, false);
		return;
	}
	planned.view.level = static_cast<unsigned char>(choice.level);
	if (from == 0)
		return;
	const bool onCredit = choice.kind == SwitchKind::kOnCredit;
	spend(m_costs.weights().switched);
	m_stepInfo.m_creditSwitches += onCredit ? 1 : 0;
	if (choice.level < from)
		m_stepInfo.m_switchesCoarser++;
	else
		m_stepInfo.m_switchesFiner++;
	tell(BT_HYBRID_PAIR_SWITCHED, pair, from, choice.level, onCredit);
	if (choice.level == planned.target)
		m_pairs[pair].m_requested = m_pairs[pair].m_acknowledged = false;
}

// Of what belongs to no pair's usual work.
void btHybridPlanner::spend(double units)
{
	m_units += units;
	m_governor.spend(units);
}

void btHybridPlanner::countQueries(int queries)
{
	m_stepInfo.m_separationQueries += queries;
	for (int i = 0; i < queries; i++)
		spend(m_costs.weights().separationQuery);
}

// Queries that a pair in contact must have made before it should keep its contacts for this step, as the budget is about to
// be exceeded.
int btHybridPlanner::keepsFrom(int pair) const
{
	const PlannedPair& planned = m_planned[pair];
	const bool isPlain = planned.view.touching && planned.view.level == planned.view.finest && !planned.view.credited;
	for (int queries = 0; m_plans && isPlain && planned.wish.atLeast < planned.view.finest && queries <= planned.view.finest; queries++)
		if (m_governor.isShort(queries * m_costs.weights().separationQuery))
			return queries;
	return PairPlan::kNever;
}

PairPlan btHybridPlanner::planPair(int pair)
{
	PairPlan plan;
	plan.target = getTarget(pair);
	const PlannedPair& planned = m_planned[pair];
	plan.view = planned.view;
	const bool canWait = plan.target > plan.view.level && plan.view.level >= planned.wish.atLeast && !planned.mustSave;
	const bool isPutOff = plan.view.level > 0 && (planned.blockedSteps > 0 || (canWait && isShort()));
	plan.tries = plan.target != plan.view.level && !isPutOff;
	plan.rules = getRules(pair);
	plan.auditDistance = m_info.m_auditDistance;
	plan.mayAudit = m_info.m_auditDistance > 0 && mayAudit();
	plan.keepsFrom = keepsFrom(pair);
	return plan;
}

void btHybridPlanner::take(int pair, const PairOutcome& outcome)
{
	if (outcome.tried)
		acknowledge(pair);
	countQueries(outcome.choiceQueries);
	if (outcome.tried)
		takeChoice(pair, outcome.choice);
	m_stepInfo.m_unsafeSwitches += outcome.isUnsafe ? 1 : 0;
	btAssert(!outcome.isUnsafe || !m_info.m_safetyConditions);
	countQueries(outcome.gapQueries);
	if (outcome.audited)
		takeAudit(outcome.auditWork);
	takeWork(pair, outcome);
}

// A fifth of the budget at most, so that looking does not cost the detail that it serves.
bool btHybridPlanner::mayAudit() const
{
	const double c_least = 0.06, c_most = 0.2;
	return !hasBudget() || (!isShort() && m_auditUnits < (c_least + (c_most - c_least) * m_governor.admission()) * m_budgetUnits);
}

void btHybridPlanner::takeAudit(const scatter::lod::PairWorkload& work)
{
	m_stepInfo.m_audits++;
	m_stepInfo.m_separationQueries++;
	m_auditUnits += m_costs.weights().audit + m_costs.units(work);
}

void btHybridPlanner::takeWork(int pair, const PairOutcome& outcome)
{
	PlannedPair& planned = m_planned[pair];
	PairView& view = planned.view;
	Pair& known = m_pairs[pair];
	const bool reuses = outcome.work.reuses;
	const double units = m_costs.units(outcome.work);
	m_units += units;
	m_governor.spend(planned, units, reuses ? btMax(double(planned.expected), units) : units);
	known.m_step = m_step;
	m_stepInfo.m_reusedPairs += reuses ? 1 : 0;
	if (outcome.credited)
		known.m_averageUnits += (float(units) - known.m_averageUnits) / 8;
	if (hasBudget() && !reuses)
		m_costs.learn(planned.cost, view.level, view.finest, outcome.touching, outcome.credited ? double(known.m_averageUnits) : units);
	const unsigned short most = std::numeric_limits<unsigned short>::max();
	view.contactSteps = !outcome.touching ? 0 : view.contactSteps < most ? view.contactSteps + 1
	                                                                     : most;
	view.touching = outcome.touching;
	view.credited = outcome.credited;
	const bool isFinest = view.level == view.finest;
	m_stepInfo.m_pairs++;
	m_stepInfo.m_finestPairs += isFinest ? 1 : 0;
	m_stepInfo.m_creditedPairs += outcome.credited ? 1 : 0;
	m_stepInfo.m_touchingPairs += outcome.touching ? 1 : 0;
	m_stepInfo.m_touchingFinest += outcome.touching && isFinest ? 1 : 0;
}

void btHybridPlanner::finish()
{
	if (m_plans)
		m_governor.learn(m_units);
	m_numBelowFinest = 0;
	for (size_t i = 0; m_plans && i < m_pairs.size(); i++)
		finishPair(int(i));
	m_lastUnits = m_units;
	m_stepInfo.m_units = m_units;
	m_stepInfo.m_plannedUnits = m_plans ? m_governor.planned() : 0;
	// Steps of a replayed run may have had none.
	m_stepInfo.m_budgetUnits = std::isfinite(m_budgetUnits) ? m_budgetUnits : 0;
	if (hasBudget() && m_units > m_budgetUnits)
		m_stepInfo.m_floorUnits = m_governor.floorUnits(m_planned, m_costs);
	m_lastStepInfo = m_stepInfo;
	m_stepInfo = btHybridPairStepInfo();
}

void btHybridPlanner::finishPair(int pair)
{
	PlannedPair& planned = m_planned[pair];
	m_numBelowFinest += planned.view.level < planned.view.finest ? 1 : 0;
	m_stepInfo.m_requests += m_pairs[pair].m_requested ? 1 : 0;
	// Asleep, or filtered out.
	if (hasBudget() && m_pairs[pair].m_step != m_step && planned.view.level > 0)
		m_costs.learn(planned.cost, planned.view.level, planned.view.finest, planned.view.touching, 0);
}

void btHybridPlanner::takeTime(double milliseconds)
{
	if (m_budget.isExceededBy(milliseconds))
		m_lastStepInfo.m_floorUnits = m_governor.floorUnits(m_planned, m_costs);
	m_budget.learn(m_units, milliseconds);
}

int btHybridPlanner::findFinerPair(const btCollisionObject* body) const
{
	for (size_t i = 0; i < m_pairs.size(); i++)
	{
		const bool isOne = m_pairs[i].m_objects[0]->getObject() == body || m_pairs[i].m_objects[1]->getObject() == body;
		// Pairs that are asleep, or that do not collide, hold up nobody.
		if (!isOne || m_pairs[i].m_step != m_step)
			continue;
		const Wish& wish = m_planned[i].wish;
		if (m_planned[i].view.level > btMax(wish.atMost, wish.atLeast))
			return int(i);
	}
	return -1;
}
