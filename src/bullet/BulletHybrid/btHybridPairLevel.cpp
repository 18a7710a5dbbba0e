#include "btHybridPairLevel.h"

#include <limits>

#include "btHybridPlanner.h"
#include "collision/part_query.h"
#include "lod/pair_switch.h"

using scatter::ChildPair;
using scatter::lod::CreditAccount;
using scatter::lod::SwitchChoice;
using scatter::lod::SwitchKind;

namespace
{
// Two bodies touch if they are this near, metres.
const btScalar c_touching = btScalar(0.01);

// Further away it does not matter how wide a gap is.
const float c_widestGap = 0.25f;

// Audit distances by which an audit may be late before the coarse shapes collide in the place of the finest ones.
const btScalar c_lateness = 2;

// How far a pair may move before the first audit, metres; from then on as far again as it has moved.
const double c_firstAudit = 0.002;

// A switch may make a penetration this much deeper by rounding, metres.
const btScalar c_tolerance = btScalar(0.002);

btPersistentManifold* manifoldOf(const ChildPair& child)
{
	return static_cast<btPersistentManifold*>(child.contact);
}

btScalar leastDistance(const btPersistentManifold* manifold)
{
	btScalar least = BT_LARGE_FLOAT;
	for (int i = 0; i < manifold->getNumContacts(); i++)
		least = btMin(least, manifold->getContactPoint(i).getDistance());
	return least;
}

// A contact without error reduction takes the bodies' approach away, but does not press them apart.
bool presses(const btManifoldPoint& point)
{
	return !(point.m_contactPointFlags & BT_CONTACT_FLAG_HAS_CONTACT_ERP) || point.m_contactERP > 0;
}

btScalar pressOf(const btPersistentManifold* manifold)
{
	btScalar most = 0;
	for (int i = 0; i < manifold->getNumContacts(); i++)
		if (presses(manifold->getContactPoint(i)))
			most = btMax(most, -manifold->getContactPoint(i).getDistance());
	return most;
}

// Of a contact, where the bodies are now, without credit.
btScalar distanceAt(const btManifoldPoint& point, const btTransform& transform0, const btTransform& transform1)
{
	return (transform0(point.m_localPointA) - transform1(point.m_localPointB)).dot(point.m_normalWorldOnB);
}

btScalar pressAt(const btPersistentManifold* manifold, const btTransform& transform0, const btTransform& transform1)
{
	btScalar most = 0;
	for (int i = 0; i < manifold->getNumContacts(); i++)
		if (presses(manifold->getContactPoint(i)))
			most = btMax(most, -distanceAt(manifold->getContactPoint(i), transform0, transform1));
	return most;
}
}  // namespace

btHybridPairLevel::btHybridPairLevel(btHybridNarrowphase& narrowphase, btHybridLevelBodies* const* objects, btHybridPairMemory& memory, int plan, const btTransform& transform0, const btTransform& transform1)
    : m_narrowphase(narrowphase), m_planner(*narrowphase.getPlanner()), m_objects(objects), m_memory(memory), m_plan(plan), m_transform0(transform0), m_transform1(transform1), m_hasFrame(false), m_partsLevel(getLevel()), m_least(BT_LARGE_FLOAT), m_press(0), m_mostPress(0), m_contacts(0), m_manifolds(0)
{
}

const scatter::Frame& btHybridPairLevel::getFrameB()
{
	if (!m_hasFrame)
		m_frameB = scatter::relativeFrame(btHybridFrameOf(m_transform0), btHybridFrameOf(m_transform1));
	m_hasFrame = true;
	return m_frameB;
}

int btHybridPairLevel::getLevel() const
{
	return m_planner.getPair(m_plan).view.level;
}

int btHybridPairLevel::getFinest() const
{
	return m_planner.getPair(m_plan).view.finest;
}

const scatter::PartList& btHybridPairLevel::getParts(int object, int level)
{
	return m_narrowphase.getBody(m_objects[object], m_objects[object]->getLevelIn(level))->getBody().parts();
}

bool btHybridPairLevel::isSeparated(int level, btScalar gap)
{
	m_planner.countQuery();
	return m_narrowphase.getQuery().isSeparated(getParts(0, level), getParts(1, level), getFrameB(), gap);
}

float btHybridPairLevel::depthOf(int a, int b)
{
	return scatter::partDepth(getParts(0, m_partsLevel).part(a), getParts(1, m_partsLevel).part(b), getFrameB());
}

bool btHybridPairLevel::choose()
{
	const int target = m_planner.getTarget(m_plan);
	const scatter::lod::PlannedPair& planned = m_planner.getPair(m_plan);
	const scatter::lod::PairView& view = planned.view;
	m_memory.m_switched = false;
	m_memory.m_mayAudit = m_planner.getInfo().m_auditDistance > 0 && m_planner.mayAudit();
	const bool canWait = target > view.level && view.level >= planned.wish.atLeast && !planned.mustSave;
	const bool isPutOff = view.level > 0 && (planned.blockedSteps > 0 || (canWait && m_planner.isShort()));
	if (target == view.level || isPutOff)
		return false;
	m_planner.acknowledge(m_plan);
	// Coarser shapes that all but touch where finer ones do: the contacts are better held than dropped.
	const btScalar nearby = view.touching ? c_touching : btScalar(0);
	const SwitchChoice choice = scatter::lod::chooseLevel(view, target, m_planner.getRules(m_plan), [&](int level, float gap)
	                                                      { return isSeparated(level, level < view.level ? gap + nearby : gap); });
	const bool isNew = view.level == 0;
	m_planner.take(m_plan, choice);
	if (choice.kind == SwitchKind::kStay || choice.kind == SwitchKind::kBlocked)
		return false;
	m_memory.m_switched = !isNew;
	m_memory.m_onCredit = choice.kind == SwitchKind::kOnCredit;
	measureContactsBefore();
	return true;
}

void btHybridPairLevel::measureContactsBefore()
{
	const std::vector<ChildPair>& children = m_memory.m_parts.children();
	for (size_t i = 0; i < children.size(); i++)
		if (children[i].touching)
			m_mostPress = btMax(m_mostPress, pressAt(manifoldOf(children[i]), m_transform0, m_transform1));
	for (int i = 0; i < m_memory.m_held.getNumManifolds(); i++)
		m_mostPress = btMax(m_mostPress, pressAt(m_memory.m_held.getManifold(i), m_transform0, m_transform1));
}

void btHybridPairLevel::settleFinest(const btAlignedObjectArray<int>& awake)
{
	const bool hadCredit = !m_memory.m_credit.empty();
	shrinkCredit();
	settleContacts(awake, hadCredit);
	m_mostPress = btMax(m_mostPress, m_press);
	m_press = 0;
	m_least = BT_LARGE_FLOAT;
	m_manifolds = m_contacts = 0;
}

void btHybridPairLevel::open()
{
	const bool wasFinest = m_partsLevel == getFinest();
	m_partsLevel = getLevel();
	if (wasFinest)
		m_memory.m_overlap = getEasedOverlap();
	m_memory.m_credit.close();
	m_memory.m_excuses = m_memory.m_onCredit && getLevel() < getFinest();
	if (!m_memory.m_excuses)
		return;
	// Contacts of the finest shapes, found just now, tell the gap.
	const btScalar least = m_memory.m_held.getLeastDistance();
	m_memory.m_gap = wasFinest && least < m_memory.m_parts.threshold() ? float(least) : findGap();
	openCredit();
}

float btHybridPairLevel::findGap()
{
	m_planner.countQuery();
	return m_narrowphase.getQuery().distance(getParts(0, getFinest()), getParts(1, getFinest()), getFrameB(), c_widestGap);
}

// Every overlap that there is at the new level is given credit for.
void btHybridPairLevel::openCredit()
{
	const std::vector<scatter::PartQuery::Overlap>& overlaps = m_narrowphase.getQuery().overlaps(getParts(0, getLevel()), getParts(1, getLevel()), getFrameB());
	for (size_t i = 0; i < overlaps.size(); i++)
		m_memory.m_credit.grant(overlaps[i].a, overlaps[i].b, overlaps[i].depth, m_memory.m_gap);
	// The pair's motion starts again with the level.
	m_memory.m_seenMotion = 0;
	m_memory.m_freshUntil = 0;
	freshen(m_memory.m_gap);
}

// Nothing can come into contact before the gap has closed. Contacts that are new need not be all that there will be, as
// Bullet finds a point at a time, or only those that are deep: the first looks are soon.
void btHybridPairLevel::freshen(float gap)
{
	const double looks = btMin(double(m_planner.getInfo().m_auditDistance), btMax(c_firstAudit, m_memory.m_freshUntil));
	m_memory.m_freshUntil += btMax(double(gap - c_touching), looks);
	m_memory.m_latest = c_lateness * m_planner.getInfo().m_auditDistance;
}

// The finest shapes overlap a little: as deep as their contacts were found just now.
void btHybridPairLevel::openFinestCredit()
{
	const std::vector<ChildPair>& children = m_memory.m_parts.children();
	for (size_t i = 0; i < children.size(); i++)
	{
		const float depth = children[i].touching ? -leastDistance(manifoldOf(children[i])) : 0;
		if (depth > 0)
			m_memory.m_credit.grant(children[i].a, children[i].b, depth, 0);
	}
}

void btHybridPairLevel::settleCredit(const btAlignedObjectArray<int>& awake)
{
	const bool hadCredit = !m_memory.m_credit.empty();
	if (m_memory.m_switched && m_memory.m_onCredit && !m_memory.m_excuses)
		openFinestCredit();
	else
		shrinkCredit();
	settleContacts(awake, hadCredit);
}

void btHybridPairLevel::shrinkCredit()
{
	if (m_memory.m_credit.empty())
		return;
	m_memory.m_credit.shrink([this](int a, int b)
	                         { return depthOf(a, b); });
}

void btHybridPairLevel::settleContacts(const btAlignedObjectArray<int>& awake, bool hadCredit)
{
	const std::vector<ChildPair>& children = m_memory.m_parts.children();
	for (int i = 0; i < awake.size(); i++)
		if (children[awake[i]].touching)
			settleChild(children[awake[i]], hadCredit);
}

void btHybridPairLevel::settleChild(const ChildPair& child, bool hadCredit)
{
	btPersistentManifold* manifold = manifoldOf(child);
	const float granted = m_memory.m_credit.of(child.a, child.b);
	if (granted > 0)
		credit(manifold, granted);
	else if (hadCredit || m_memory.m_switched)
		endCredit(manifold);
	m_manifolds++;
	m_contacts += manifold->getNumContacts();
	m_least = btMin(m_least, leastDistance(manifold));
	m_press = btMax(m_press, pressOf(manifold));
}

bool btHybridPairLevel::keepsHeld() const
{
	const double motion = m_memory.m_parts.motion();
	return !m_memory.m_credit.empty() || (m_memory.m_excuses && motion >= m_memory.m_seenMotion && motion < m_memory.m_freshUntil);
}

bool btHybridPairLevel::needsAudit() const
{
	if (!m_memory.m_excuses || m_memory.m_credit.empty() || !m_memory.m_mayAudit)
		return false;
	const double motion = m_memory.m_parts.motion();
	const bool jumped = motion < m_memory.m_seenMotion;
	m_memory.m_seenMotion = motion;
	return jumped || motion >= m_memory.m_freshUntil;
}

bool btHybridPairLevel::mayTouch()
{
	m_planner.countAudit();
	if (m_memory.m_gap >= m_memory.m_parts.threshold())
		m_memory.m_gap = findGap();
	return m_memory.m_gap < m_memory.m_parts.threshold();
}

// Sliding along each other the finest shapes come upon other parts of each other.
void btHybridPairLevel::takeAudit()
{
	if (!m_memory.m_held.isEmpty())
		m_memory.m_gap = m_memory.m_held.getLeastDistance();
	else if (m_memory.m_gap < m_memory.m_parts.threshold())
		m_memory.m_gap = findGap();
	m_memory.m_credit.audit(m_memory.m_gap, [this](int a, int b)
	                        { return depthOf(a, b); });
	m_memory.m_freshUntil = m_memory.m_parts.motion();
	freshen(m_memory.m_gap);
	easeHeld();
}

// Of the finest shapes, as deep as their contacts do not press.
btScalar btHybridPairLevel::getEasedOverlap() const
{
	btScalar overlap = 0;
	for (int i = 0; i < m_memory.m_held.getNumManifolds(); i++)
	{
		const btPersistentManifold* manifold = m_memory.m_held.getManifold(i);
		for (int k = 0; k < manifold->getNumContacts(); k++)
			if (!presses(manifold->getContactPoint(k)))
				overlap = btMax(overlap, -distanceAt(manifold->getContactPoint(k), m_transform0, m_transform1));
	}
	return overlap;
}

// What was on credit at the finest level stays so: looking at it once more is no reason to press it apart.
void btHybridPairLevel::easeHeld()
{
	m_memory.m_overlap = btMin(m_memory.m_overlap, btMax(btScalar(-m_memory.m_gap), btScalar(0)));
	for (int i = 0; m_memory.m_overlap > 0 && i < m_memory.m_held.getNumManifolds(); i++)
	{
		btPersistentManifold* manifold = m_memory.m_held.getManifold(i);
		for (int k = 0; k < manifold->getNumContacts(); k++)
			if (manifold->getContactPoint(k).getDistance() >= -m_memory.m_overlap - c_tolerance)
				ease(manifold->getContactPoint(k));
	}
}

// No error reduction: where credit is at work, a distance below zero is no error to be corrected.
void btHybridPairLevel::credit(btPersistentManifold* manifold, float credit)
{
	for (int i = 0; i < manifold->getNumContacts(); i++)
	{
		btManifoldPoint& point = manifold->getContactPoint(i);
		point.setDistance(point.getDistance() + credit);
		ease(point);
	}
}

void btHybridPairLevel::ease(btManifoldPoint& point)
{
	// Springs that a program has given its bodies have no error reduction.
	if (point.m_contactPointFlags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING)
		return;
	point.m_contactPointFlags |= BT_CONTACT_FLAG_HAS_CONTACT_ERP | BT_CONTACT_FLAG_HAS_CONTACT_CFM;
	point.m_contactERP = 0;
	point.m_contactCFM = 0;
}

// A contact that is still deep keeps its ease until it is found anew: it may be older than where the parts are now.
void btHybridPairLevel::endCredit(btPersistentManifold* manifold)
{
	const int flags = BT_CONTACT_FLAG_HAS_CONTACT_ERP | BT_CONTACT_FLAG_HAS_CONTACT_CFM;
	for (int i = 0; i < manifold->getNumContacts(); i++)
	{
		btManifoldPoint& point = manifold->getContactPoint(i);
		if (point.getDistance() >= 0 && (point.m_contactPointFlags & flags) == flags && point.m_contactERP == 0 && point.m_contactCFM == 0)
			point.m_contactPointFlags &= ~flags;
	}
}

void btHybridPairLevel::report(scatter::lod::PairWorkload& work)
{
	work.manifolds = m_manifolds + m_memory.m_held.getNumManifolds();
	work.contacts = m_contacts + m_memory.m_held.getNumContacts();
	m_least = btMin(m_least, m_memory.m_held.getLeastDistance());
	for (int i = 0; i < m_memory.m_held.getNumManifolds(); i++)
		m_press = btMax(m_press, pressOf(m_memory.m_held.getManifold(i)));
	if (m_memory.m_switched)
		checkSwitch();
	m_memory.m_least = m_least;
	const bool isCredited = !m_memory.m_credit.empty();
	m_planner.takeWork(m_plan, work, m_least < c_touching, isCredited, isCredited ? &m_memory.m_units : 0);
}

// No switch may push: contacts that press deeper than those of the level before would here are counted. In every build.
void btHybridPairLevel::checkSwitch() const
{
	if (m_press <= m_mostPress + c_tolerance)
		return;
	m_planner.countUnsafe();
	btAssert(!m_planner.getInfo().m_safetyConditions);
}
