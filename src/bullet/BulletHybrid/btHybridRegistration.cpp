#include "btHybridRegistration.h"

#include <BulletCollision/CollisionDispatch/btCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>

#include <mutex>
#include <new>

#include "BulletHybrid/btHybridRigidBody.h"
#include "btHybridGroundAlgorithm.h"
#include "btHybridNarrowphase.h"
#include "btHybridPairAlgorithm.h"

template <class Algorithm, class... More>
static btCollisionAlgorithm* create(btCollisionAlgorithmConstructionInfo& info, More... more)
{
	void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm));
	return new (memory) Algorithm(info, more...);
}

btCollisionAlgorithm* btHybridRegistration::CreateFunc::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body0Wrap,
    const btCollisionObjectWrapper* body1Wrap)
{
	if (!m_registration->mayTake(info, body0Wrap, body1Wrap))
		return m_default->CreateCollisionAlgorithm(info, body0Wrap, body1Wrap);
	const int side = m_registration->findSideOnGround(body0Wrap, body1Wrap);
	if (side >= 0)
		return create<btHybridGroundAlgorithm>(info, m_registration->m_narrowphase, body0Wrap, body1Wrap, side);
	if (m_registration->hasPartLists(body0Wrap) && m_registration->hasPartLists(body1Wrap))
		return create<btHybridPairAlgorithm>(info, m_registration->m_narrowphase, body0Wrap, body1Wrap);
	return m_default->CreateCollisionAlgorithm(info, body0Wrap, body1Wrap);
}

static bool isPolyhedron(int shapeType)
{
	return shapeType == BOX_SHAPE_PROXYTYPE || shapeType == CONVEX_HULL_SHAPE_PROXYTYPE;
}

// Bare polyhedra where the algorithm is worth it: two boxes, and a polyhedron on a plane, are as cheap in Bullet's own
// algorithms
// (`ground_bench --only rocks`, `--only crates`).
static bool isBareTaken(int type0, int type1)
{
	if (isPolyhedron(type0) && isPolyhedron(type1))
		return type0 == CONVEX_HULL_SHAPE_PROXYTYPE || type1 == CONVEX_HULL_SHAPE_PROXYTYPE;
	const int other = isPolyhedron(type0) ? type1 : type0;
	return (isPolyhedron(type0) || isPolyhedron(type1)) && btBroadphaseProxy::isConcave(other) &&
	       btHybridGround::maybe(other) && other != STATIC_PLANE_PROXYTYPE;
}

static bool isTaken(int type0, int type1)
{
	const bool isCompound0 = btBroadphaseProxy::isCompound(type0);
	if (!isCompound0 && !btBroadphaseProxy::isCompound(type1))
		return isBareTaken(type0, type1);
	const int other = isCompound0 ? type1 : type0;
	return btBroadphaseProxy::isConvex(other) || btBroadphaseProxy::isCompound(other) || btHybridGround::maybe(other);
}

static const int c_types = MAX_BROADPHASE_COLLISION_TYPES;

template <class Use>
static void forEachTaken(Use use)
{
	for (int type0 = 0; type0 < c_types; type0++)
		for (int type1 = 0; type1 < c_types; type1++)
			if (isTaken(type0, type1))
				use(type0, type1);
}

// Those that are in charge of a dispatcher: it does not tell who has registered with it, and worlds may be made in
// several threads.
static std::mutex s_inChargeMutex;
static btHybridRegistration* s_inCharge = 0;

btHybridRegistration::btHybridRegistration(btDispatcher* dispatcher, const btHybridDynamicsWorld* world,
                                           btHybridNarrowphase* narrowphase)
    : m_narrowphase(narrowphase), m_world(world), m_dispatcher(0), m_next(0), m_mistake(takeCharge(dispatcher))
{
	m_narrowphase->addUser();
	if (!m_dispatcher)
		return;
	// The dispatcher keeps their addresses.
	m_createFuncs.reserve(c_types * c_types);
	forEachTaken(
	    [this](int type0, int type1)
	    {
		    CreateFunc create;
		    create.m_registration = this;
		    create.m_default = m_dispatcher->getCollisionConfiguration()->getCollisionAlgorithmCreateFunc(type0, type1);
		    m_createFuncs.push_back(create);
		    m_dispatcher->registerCollisionCreateFunc(type0, type1, &m_createFuncs[m_createFuncs.size() - 1]);
	    });
}

btHybridRegistration::~btHybridRegistration()
{
	int next = 0;
	if (m_dispatcher)
		forEachTaken([this, &next](int type0, int type1)
		             { m_dispatcher->registerCollisionCreateFunc(type0, type1, m_createFuncs[next++].m_default); });
	giveUpCharge();
	m_narrowphase->removeUser();
}

const char* btHybridRegistration::takeCharge(btDispatcher* dispatcher)
{
	if (dynamic_cast<btCollisionDispatcherMt*>(dispatcher))
		return "hybrid pairs run in Bullet's own algorithms, because the dispatcher is a btCollisionDispatcherMt; use "
		       "a btCollisionDispatcher";
	btCollisionDispatcher* const known = dynamic_cast<btCollisionDispatcher*>(dispatcher);
	if (!known)
		return "hybrid pairs run in Bullet's own algorithms, because the dispatcher is no btCollisionDispatcher; use "
		       "one, or derive from it";
	const std::lock_guard<std::mutex> lock(s_inChargeMutex);
	for (const btHybridRegistration* other = s_inCharge; other; other = other->m_next)
		if (other->m_dispatcher == known)
			return "hybrid pairs run in Bullet's own algorithms, because another btHybridDynamicsWorld or "
			       "btHybridInstallation has the dispatcher; give every world its own";
	m_dispatcher = known;
	m_next = s_inCharge;
	s_inCharge = this;
	return 0;
}

void btHybridRegistration::giveUpCharge()
{
	const std::lock_guard<std::mutex> lock(s_inChargeMutex);
	for (btHybridRegistration** link = &s_inCharge; *link; link = &(*link)->m_next)
	{
		if (*link != this)
			continue;
		*link = m_next;
		break;
	}
}

// In pair switching a hybrid's collision shape is its finest level, and the others come into use as well.
bool btHybridRegistration::hasPartLists(const btCollisionObjectWrapper* wrap) const
{
	if (wrap->getCollisionShape() != wrap->getCollisionObject()->getCollisionShape() ||
	    !btHybridParts::isPartList(wrap->getCollisionShape()))
		return false;
	const btHybridRigidBody* hybrid =
	    m_narrowphase->getPlanner() ? btHybridRigidBody::upcast(wrap->getCollisionObject()) : 0;
	for (int level = 1; hybrid && level < hybrid->getFinestLevel(); level++)
		if (!btHybridParts::isPartList(hybrid->getLevels().getLevelShape(level)))
			return false;
	return true;
}

// A hybrid of another world, or of none.
bool btHybridRegistration::isForeign(const btCollisionObjectWrapper* wrap) const
{
	const btHybridRigidBody* hybrid = btHybridRigidBody::upcast(wrap->getCollisionObject());
	return hybrid && hybrid->getWorld() != m_world;
}

bool btHybridRegistration::mayTake(const btCollisionAlgorithmConstructionInfo& info,
                                   const btCollisionObjectWrapper* body0Wrap,
                                   const btCollisionObjectWrapper* body1Wrap) const
{
	if (!m_narrowphase->getInfo().m_pairAlgorithm || info.m_manifold)
		return false;
	const bool isPlain = !btHybridRigidBody::upcast(body0Wrap->getCollisionObject()) &&
	                     !btHybridRigidBody::upcast(body1Wrap->getCollisionObject());
	const bool isBare = !body0Wrap->getCollisionShape()->isCompound() && !body1Wrap->getCollisionShape()->isCompound();
	if (isPlain ? !m_narrowphase->getInfo().m_plainBodies : isBare)
		return false;
	return !isForeign(body0Wrap) && !isForeign(body1Wrap);
}

// Which of the two is a list of parts, if the other one is a ground for it; -1 if there is none. What has levels of its
// own is none.
int btHybridRegistration::findSideOnGround(const btCollisionObjectWrapper* body0Wrap,
                                           const btCollisionObjectWrapper* body1Wrap) const
{
	const btCollisionObjectWrapper* wraps[2] = {body0Wrap, body1Wrap};
	for (int side = 0; side < 2; side++)
	{
		const btCollisionObjectWrapper* body = wraps[side];
		const btCollisionObjectWrapper* ground = wraps[1 - side];
		const bool isWhole = ground->getCollisionShape() == ground->getCollisionObject()->getCollisionShape();
		const bool isBody =
		    body->getCollisionShape()->isCompound() || isPolyhedron(body->getCollisionShape()->getShapeType());
		if (!isBody || !isWhole || btHybridRigidBody::upcast(ground->getCollisionObject()))
			continue;
		btVector3 center;
		btScalar radius;
		body->getCollisionShape()->getBoundingSphere(center, radius);
		if (btHybridGround::kindOf(ground->getCollisionShape(), radius) != BT_HYBRID_NO_GROUND && hasPartLists(body))
			return side;
	}
	return -1;
}
