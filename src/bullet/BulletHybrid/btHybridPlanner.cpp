#include "btHybridPlanner.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "BulletHybrid/btHybridRigidBody.h"
#include "btHybridConversions.h"
#include "btHybridLevelBodies.h"
#include "btHybridShapeRadius.h"

using scatter::lod::BodyView;
using scatter::lod::LooseContacts;
using scatter::lod::PlannedPair;

namespace
{
const char c_noSpecification[] = "a policy needs a name, such as \"speed\"; 0 was given";

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
	view.radius = hybrid ? hybrid->getLevels().getCoarsestRadius() : btHybridRadiusOf(object->getCollisionShape());
	view.held = hybrid && hybrid->isHeld();
	return view;
}

bool isAwake(const btCollisionObject* object)
{
	return object->isActive() && !object->isStaticOrKinematicObject();
}

bool isSolved(const btPersistentManifold* manifold)
{
	return isAwake(manifold->getBody0()) || isAwake(manifold->getBody1());
}

const btCollisionObject* objectOf(const scatter::pairs::PlannedBody& body)
{
	return static_cast<const btCollisionObject*>(body.object());
}
}  // namespace

btHybridPlanner::btHybridPlanner() : m_listener(0), m_leftOut(0)
{
}

void btHybridPlanner::setInfo(const btHybridPairSwitchingInfo& info)
{
	setSettings(
	    {info.m_credit, info.m_creditLevel, info.m_retryInterval, info.m_auditDistance, info.m_safetyConditions});
}

const char* btHybridPlanner::remember(const scatter::Result<void>& result)
{
	m_mistake = result ? std::string() : result.error().message;
	return result ? 0 : m_mistake.c_str();
}

const char* btHybridPlanner::addPolicy(const char* specification)
{
	return specification ? remember(Planner::addPolicy(specification)) : c_noSpecification;
}

const char* btHybridPlanner::checkPolicy(const char* specification)
{
	return specification ? remember(Planner::checkPolicy(specification)) : c_noSpecification;
}

void btHybridPlanner::setFocus(const btVector3& eye, const btVector3& target, btScalar fieldOfView)
{
	Planner::setFocus({btHybridVec3(eye), btHybridVec3(target), fieldOfView});
}

void btHybridPlanner::setListener(btHybridListener* listener)
{
	m_listener = listener;
	Planner::setListener(listener ? this : 0);
}

void btHybridPlanner::hear(const scatter::pairs::PairEvent& event)
{
	btHybridPairEvent told;
	told.m_kind = event.kind;
	told.m_objectA = objectOf(*event.a);
	told.m_objectB = objectOf(*event.b);
	told.m_fromLevel = event.from;
	told.m_toLevel = event.to;
	told.m_scope = event.asker.scope;
	told.m_policy = event.asker.name;
	told.m_onCredit = event.onCredit;
	m_listener->pairEvent(told);
}

void btHybridPlanner::setHeld(const btAlignedObjectArray<const btCollisionObject*>& held)
{
	std::vector<const void*> objects;
	objects.reserve(held.size());
	for (int i = 0; i < held.size(); i++)
		objects.push_back(held[i]);
	Planner::setHeld(std::move(objects));
}

void btHybridPlanner::addPair(btHybridLevelBodies* object0, btHybridLevelBodies* object1, int* place)
{
	Planner::addPair(*object0, *object1, btMax(object0->getNumLevels(), object1->getNumLevels()),
	                 double(object0->getNumParts()) * object1->getNumParts(), place);
}

void btHybridPlanner::addGround(btHybridLevelBodies* body, btHybridLevelBodies* ground, int* place)
{
	Planner::addGround(*body, *ground, body->getNumLevels(), body->getNumParts(), place);
}

void btHybridPlanner::plan(const btCollisionObjectArray& objects, const btAlignedObjectArray<btRigidBody*>& moving,
                           int numOverlappingPairs, int numJoints, btScalar timeStep,
                           const scatter::lod::StepClock& clock)
{
	if (needsBodies())
	{
		m_bodies.resize(objects.size());
		for (int i = 0; i < objects.size(); i++)
			m_bodies[i] = viewOf(objects[i]);
	}
	int numAwake = 0;
	for (int i = 0; i < moving.size(); i++)
		numAwake += moving[i]->isActive() ? 1 : 0;
	Planner::plan({m_bodies, {objects.size(), numAwake, numOverlappingPairs, numJoints}, float(timeStep), clock});
}

void btHybridPlanner::finish(btDispatcher* dispatcher, const scatter::lod::SolverWork& solver)
{
	const LooseContacts own = ownContacts();
	const bool hasOthers = plans() && dispatcher->getNumManifolds() > own.manifolds;
	LooseContacts loose;
	for (int i = 0; hasOthers && i < dispatcher->getNumManifolds(); i++)
	{
		const btPersistentManifold* manifold = dispatcher->getManifoldByIndexInternal(i);
		if (!isSolved(manifold))
			continue;
		loose.manifolds++;
		loose.points += manifold->getNumContacts();
	}
	takeLoose({btMax(loose.manifolds - own.manifolds, 0), btMax(loose.points - own.points, 0)});
	settleSolver(dispatcher, solver);
	Planner::finish();
}

void btHybridPlanner::settleSolver(btDispatcher* dispatcher, const scatter::lod::SolverWork& solver)
{
	Planner::settle(solver,
	                [&](const scatter::lod::ThinningRule& rule)
	                {
		                findSolved(dispatcher);
		                btHybridContactReductionInfo info;
		                info.m_mostAlike = rule.mostAlike;
		                info.m_leastContacts = rule.leastContacts;
		                m_reduced.find(m_solved.data(), int(m_solved.size()), info);
		                const btHybridContactReductionCount& count = m_reduced.getCount();
		                return scatter::lod::SpareContacts{count.m_contacts, count.m_contacts - count.m_left};
	                });
	m_reduced.keepFirst(hiddenContacts());
	m_leftOut = iterationsLeftOut();
}

void btHybridPlanner::findSolved(btDispatcher* dispatcher)
{
	m_solved.clear();
	for (int i = 0; i < dispatcher->getNumManifolds(); i++)
	{
		btPersistentManifold* manifold = dispatcher->getManifoldByIndexInternal(i);
		if (isSolved(manifold))
			m_solved.push_back(manifold);
	}
}

void btHybridPlanner::wakeOwed()
{
	Planner::findOwed(m_owed);
	for (const scatter::pairs::PlannedBody* body : m_owed)
		objectOf(*body)->activate();
}

btHybridPairView btHybridPlanner::viewPair(int index) const
{
	btHybridPairView view;
	const PlannedPair& planned = pair(index);
	view.m_level = planned.view.level;
	view.m_finestLevel = planned.view.finest;
	view.m_credited = planned.view.credited;
	view.m_units = units(index);
	if (!request(index).stands)
		return view;
	const scatter::pairs::Asker asker = askerOf(index);
	view.m_request.m_targetLevel = planned.target;
	view.m_request.m_scope = asker.scope;
	view.m_request.m_policy = asker.name;
	view.m_request.m_waitingSteps = step() - request(index).stepMade;
	view.m_request.m_tried = request(index).tried;
	view.m_request.m_retrySteps = view.m_request.m_tried ? btMax(int(planned.blockedSteps), 1) : 0;
	return view;
}

void btHybridPlanner::viewObstacle(const btCollisionObject* object, btHybridRequestView& request) const
{
	const int index = findFinerPair(object);
	request.m_retrySteps = 1;
	if (index < 0)
		return;
	request.m_blockedBy = objectOf(body(index, objectOf(body(index, 0)) == object ? 1 : 0));
	request.m_retrySteps = btMax(int(pair(index).blockedSteps), 1);
}

void btHybridPlanner::viewCoarserObjects(btAlignedObjectArray<btHybridCoarserObject>& objects) const
{
	std::vector<scatter::pairs::CoarserBody> bodies;
	findCoarser(bodies);
	for (const scatter::pairs::CoarserBody& found : bodies)
	{
		const btHybridCoarserObject coarser = {objectOf(*found.body), found.level};
		objects.push_back(coarser);
	}
}

void btHybridPlanner::findCredited(btAlignedObjectArray<btHybridLevelBodies*>& objects) const
{
	for (int i = 0; i < countPairs(); i++)
		for (int k = 0; k < 2 && pair(i).view.credited && !isGround(i); k++)
			objects.push_back(static_cast<btHybridLevelBodies*>(&body(i, k)));
}
