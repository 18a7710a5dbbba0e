#include "btHybridParallelWorld.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <LinearMath/btPoolAllocator.h>

#include "BulletHybrid/btHybridRigidBody.h"
#include "btHybridAlgorithm.h"
#include "btHybridPlanner.h"
#include "btHybridWrapped.h"

btHybridChildKey::btHybridChildKey(const btCollisionObject* body0, const btCollisionObject* body1, int child0,
                                   int child1)
{
	const int number0 = body0->getBroadphaseHandle()->m_uniqueId;
	const int number1 = body1->getBroadphaseHandle()->m_uniqueId;
	const bool swap = number1 < number0;
	m_numbers[swap] = number0;
	m_numbers[!swap] = number1;
	m_bodies[swap] = body0;
	m_bodies[!swap] = body1;
	m_children[swap] = child0;
	m_children[!swap] = child1;
}

bool btHybridChildKey::less(const btHybridChildKey& a, const btHybridChildKey& b)
{
	for (int i = 0; i < 2; i++)
		if (a.m_numbers[i] != b.m_numbers[i])
			return a.m_numbers[i] < b.m_numbers[i];
	return a.m_children[0] != b.m_children[0] ? a.m_children[0] < b.m_children[0] : a.m_children[1] < b.m_children[1];
}

const btHybridChildManifold* btHybridChildManifold::find(const btAlignedObjectArray<btHybridChildManifold>& sorted,
                                                         const btHybridChildKey& key)
{
	int first = 0;
	int last = sorted.size();
	while (first < last)
	{
		const int middle = first + (last - first) / 2;
		if (btHybridChildKey::less(sorted[middle].m_key, key))
			first = middle + 1;
		else
			last = middle;
	}
	return first < sorted.size() && !btHybridChildKey::less(key, sorted[first].m_key) ? &sorted[first] : 0;
}

/// Has the shape and the place of an object, and stands in for it.
class btHybridParallelWorld::StandIn : public btCollisionObject
{
public:
	btCollisionObject* m_original;
	int m_uniqueId;  ///< of the original's broadphase proxy
	int m_seen;      ///< the last step in which the original was there

	explicit StandIn(btCollisionObject* original)
	    : m_original(original), m_uniqueId(original->getBroadphaseHandle()->m_uniqueId), m_seen(0)
	{
		// Bullet's bounds of rigid bodies take in where they are about to be.
		if (original->getInternalType() == CO_RIGID_BODY)
			m_internalType = CO_RIGID_BODY;
		setCollisionShape(original->getCollisionShape());
		follow();
	}

	void follow()
	{
		setWorldTransform(m_original->getWorldTransform());
		setInterpolationWorldTransform(m_original->getInterpolationWorldTransform());
		setCollisionFlags(m_original->getCollisionFlags());
		forceActivationState(m_original->getActivationState());
	}

	static const btCollisionObject* originalOf(const btCollisionObject* standIn)
	{
		return static_cast<const StandIn*>(standIn)->m_original;
	}
	static const btCollisionObject* originalOf(const btBroadphaseProxy* proxy)
	{
		return originalOf(static_cast<const btCollisionObject*>(proxy->m_clientObject));
	}
};

/// The create functions of the original's configuration, in pools of its own.
class btHybridParallelWorld::Configuration : public btDefaultCollisionConfiguration
{
	btCollisionConfiguration* m_model;

	static btDefaultCollisionConstructionInfo pools(btCollisionConfiguration* model)
	{
		btDefaultCollisionConstructionInfo info;
		info.m_customCollisionAlgorithmMaxElementSize = model->getCollisionAlgorithmPool()->getElementSize();
		return info;
	}

public:
	explicit Configuration(btCollisionConfiguration* model)
	    : btDefaultCollisionConfiguration(pools(model)), m_model(model)
	{
	}
	virtual btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int type0, int type1)
	{
		return m_model->getCollisionAlgorithmCreateFunc(type0, type1);
	}
	virtual btCollisionAlgorithmCreateFunc* getClosestPointsAlgorithmCreateFunc(int type0, int type1)
	{
		return m_model->getClosestPointsAlgorithmCreateFunc(type0, type1);
	}
};

/// Lets collide what the original's dispatcher does, and writes into every manifold which children it is of.
class btHybridParallelWorld::Dispatcher : public btCollisionDispatcher
{
	btDispatcher* m_model;
	const btCollisionObject* m_objects[2];
	int m_children[2];

public:
	const btHybridParallelWorld& m_owner;

	Dispatcher(btCollisionConfiguration* configuration, btDispatcher* model, const btHybridParallelWorld& owner)
	    : btCollisionDispatcher(configuration), m_model(model), m_owner(owner)
	{
		// The flags say whether the contact breaking threshold is relative to the shapes.
		if (const btCollisionDispatcher* dispatcher = dynamic_cast<const btCollisionDispatcher*>(model))
			setDispatcherFlags(dispatcher->getDispatcherFlags() & CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
		beginPair(0, 0);
	}

	void beginPair(const btCollisionObject* object0, const btCollisionObject* object1)
	{
		m_objects[0] = object0;
		m_objects[1] = object1;
		m_children[0] = m_children[1] = -1;
	}
	void setChild(const btCollisionObject* object, int child)
	{
		m_children[object == m_objects[1]] = child;
	}

	virtual bool needsCollision(const btCollisionObject* a, const btCollisionObject* b)
	{
		return m_model->needsCollision(StandIn::originalOf(a), StandIn::originalOf(b));
	}

	// Some algorithms make their manifolds at once, before any result hears of the children.
	virtual btCollisionAlgorithm* findAlgorithm(const btCollisionObjectWrapper* wrap0,
	                                            const btCollisionObjectWrapper* wrap1, btPersistentManifold* shared,
	                                            ebtDispatcherQueryType type)
	{
		setChild(wrap0->getCollisionObject(), wrap0->m_index);
		setChild(wrap1->getCollisionObject(), wrap1->m_index);
		return btCollisionDispatcher::findAlgorithm(wrap0, wrap1, shared, type);
	}

	virtual btPersistentManifold* getNewManifold(const btCollisionObject* body0, const btCollisionObject* body1)
	{
		btPersistentManifold* manifold = btCollisionDispatcher::getNewManifold(body0, body1);
		manifold->m_companionIdA = m_children[body0 == m_objects[1]];
		manifold->m_companionIdB = m_children[body1 == m_objects[1]];
		return manifold;
	}
};

/// Tells the dispatcher which children are at work.
class btHybridParallelWorld::Result : public btManifoldResult
{
	Dispatcher& m_dispatcher;

public:
	Result(Dispatcher& dispatcher, const btCollisionObjectWrapper* wrap0, const btCollisionObjectWrapper* wrap1)
	    : btManifoldResult(wrap0, wrap1), m_dispatcher(dispatcher)
	{
	}
	virtual void setShapeIdentifiersA(int part, int index)
	{
		btManifoldResult::setShapeIdentifiersA(part, index);
		m_dispatcher.setChild(getBody0Internal(), index);
	}
	virtual void setShapeIdentifiersB(int part, int index)
	{
		btManifoldResult::setShapeIdentifiersB(part, index);
		m_dispatcher.setChild(getBody1Internal(), index);
	}
};

/// The pairs with a hybrid that the original's broadphase would keep.
class btHybridParallelWorld::Filter : public btOverlapFilterCallback
{
	btOverlappingPairCache* m_model;

public:
	explicit Filter(btOverlappingPairCache* model) : m_model(model)
	{
	}
	virtual bool needBroadphaseCollision(btBroadphaseProxy* proxy0, btBroadphaseProxy* proxy1) const
	{
		const btCollisionObject* a = StandIn::originalOf(proxy0);
		const btCollisionObject* b = StandIn::originalOf(proxy1);
		if (!btHybridRigidBody::upcast(a) && !btHybridRigidBody::upcast(b))
			return false;
		return m_model->needsBroadphaseCollision(const_cast<btBroadphaseProxy*>(a->getBroadphaseHandle()),
		                                         const_cast<btBroadphaseProxy*>(b->getBroadphaseHandle()));
	}
};

btHybridParallelWorld::btHybridParallelWorld(btCollisionWorld* original) : m_original(original), m_planner(0), m_step(0)
{
	btCollisionDispatcher* model = static_cast<btCollisionDispatcher*>(original->getDispatcher());
	m_configuration = new Configuration(model->getCollisionConfiguration());
	m_dispatcher = new Dispatcher(m_configuration, model, *this);
	m_dispatcher->setNearCallback(collide);
	m_broadphase = new btDbvtBroadphase;
	m_filter = new Filter(original->getBroadphase()->getOverlappingPairCache());
	m_broadphase->getOverlappingPairCache()->setOverlapFilterCallback(m_filter);
	m_world = new btCollisionWorld(m_dispatcher, m_broadphase, m_configuration);
}

btHybridParallelWorld::~btHybridParallelWorld()
{
	for (int i = m_world->getNumCollisionObjects() - 1; i >= 0; i--)
		remove(static_cast<StandIn*>(m_world->getCollisionObjectArray()[i]));
	delete m_world;
	delete m_filter;
	delete m_broadphase;
	delete m_dispatcher;
	delete m_configuration;
}

void btHybridParallelWorld::remove(StandIn* standIn)
{
	StandIn** known = m_standIns.find(btHashPtr(standIn->m_original));
	if (known && *known == standIn)
		m_standIns.remove(btHashPtr(standIn->m_original));
	m_world->removeCollisionObject(standIn);
	delete standIn;
}

void btHybridParallelWorld::follow()
{
	m_step++;
	btAlignedObjectArray<StandIn*> added;
	const btCollisionObjectArray& objects = m_original->getCollisionObjectArray();
	for (int i = 0; i < objects.size(); i++)
	{
		StandIn** known = m_standIns.find(btHashPtr(objects[i]));
		StandIn* standIn = known ? *known : 0;
		if (objects[i]->getInternalType() == btCollisionObject::CO_SOFT_BODY)
			continue;
		// Another object may have come to where one was.
		if (!standIn || standIn->m_uniqueId != objects[i]->getBroadphaseHandle()->m_uniqueId)
		{
			standIn = new StandIn(objects[i]);
			added.push_back(standIn);
			m_standIns.insert(btHashPtr(objects[i]), standIn);
		}
		else if (standIn->getCollisionShape() != objects[i]->getCollisionShape())
		{
			standIn->setCollisionShape(objects[i]->getCollisionShape());
			m_broadphase->getOverlappingPairCache()->cleanProxyFromPairs(standIn->getBroadphaseHandle(), m_dispatcher);
		}
		standIn->follow();
		standIn->m_seen = m_step;
	}
	for (int i = m_world->getNumCollisionObjects() - 1; i >= 0; i--)
	{
		StandIn* standIn = static_cast<StandIn*>(m_world->getCollisionObjectArray()[i]);
		if (standIn->m_seen != m_step)
			remove(standIn);
	}
	// In the order of the originals in their broadphase, which is the order of the two in a pair.
	added.quickSort([](const StandIn* a, const StandIn* b) { return a->m_uniqueId < b->m_uniqueId; });
	for (int i = 0; i < added.size(); i++)
		m_world->addCollisionObject(added[i]);
	cleanPairs();
}

// Where a program has cleaned a pair of the original, it begins anew here, too.
void btHybridParallelWorld::cleanPairs()
{
	btOverlappingPairCache* cache = m_broadphase->getOverlappingPairCache();
	btBroadphasePairArray& pairs = cache->getOverlappingPairArray();
	for (int i = 0; i < pairs.size(); i++)
	{
		const btBroadphasePair* original =
		    findPair(StandIn::originalOf(pairs[i].m_pProxy0), StandIn::originalOf(pairs[i].m_pProxy1));
		if (!original || !original->m_algorithm)
			cache->cleanOverlappingPair(pairs[i], m_dispatcher);
	}
}

void btHybridParallelWorld::step()
{
	m_world->getDispatchInfo() = m_original->getDispatchInfo();
	m_world->getDispatchInfo().m_debugDraw = 0;
	m_world->setForceUpdateAllAabbs(m_original->getForceUpdateAllAabbs());
	m_world->performDiscreteCollisionDetection();
}

const btBroadphasePair* btHybridParallelWorld::findPair(const btCollisionObject* a, const btCollisionObject* b) const
{
	btBroadphaseProxy* proxyA = const_cast<btBroadphaseProxy*>(a->getBroadphaseHandle());
	btBroadphaseProxy* proxyB = const_cast<btBroadphaseProxy*>(b->getBroadphaseHandle());
	return m_original->getBroadphase()->getOverlappingPairCache()->findPair(proxyA, proxyB);
}

const btHybridAlgorithm* btHybridParallelWorld::findAlgorithm(const btCollisionObject* a,
                                                              const btCollisionObject* b) const
{
	const btBroadphasePair* pair = findPair(a, b);
	return pair ? dynamic_cast<const btHybridAlgorithm*>(pair->m_algorithm) : 0;
}

btHybridParallelWorld::Fate btHybridParallelWorld::getFate(const btCollisionObject* a, const btCollisionObject* b) const
{
	if (!btHybridRigidBody::upcast(a) && !btHybridRigidBody::upcast(b))
		return LEFT_ALONE;
	if (!m_original->getDispatcher()->needsCollision(a, b))
		return LEFT_ALONE;
	const btHybridAlgorithm* algorithm = findAlgorithm(a, b);
	if (!algorithm)
		return LOOKED_AT_FINEST;
	if (m_planner && algorithm->getPlanIndex() >= 0 && !m_planner->isAtFinest(algorithm->getPlanIndex()))
		return AT_COARSER;
	return algorithm->hasOthers() ? HAS_OTHERS : LOOKED_AT_FINEST;
}

// As btCollisionDispatcher::defaultNearCallback, with a result that knows the children.
void btHybridParallelWorld::collide(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                                    const btDispatcherInfo& info)
{
	Dispatcher& own = static_cast<Dispatcher&>(dispatcher);
	const btCollisionObject* a = StandIn::originalOf(pair.m_pProxy0);
	const btCollisionObject* b = StandIn::originalOf(pair.m_pProxy1);
	if (own.m_owner.getFate(a, b) != LOOKED_AT_FINEST)
		return;
	const btHybridAlgorithm* algorithm = own.m_owner.findAlgorithm(a, b);
	if (algorithm && algorithm->hasRestarted())
		own.m_owner.m_broadphase->getOverlappingPairCache()->cleanOverlappingPair(pair, &dispatcher);
	btCollisionObject* object0 = static_cast<btCollisionObject*>(pair.m_pProxy0->m_clientObject);
	btCollisionObject* object1 = static_cast<btCollisionObject*>(pair.m_pProxy1->m_clientObject);
	const btCollisionObjectWrapper wrap0 = btHybridWrapped(object0);
	const btCollisionObjectWrapper wrap1 = btHybridWrapped(object1);
	own.beginPair(object0, object1);
	if (!pair.m_algorithm)
		pair.m_algorithm = own.findAlgorithm(&wrap0, &wrap1, 0, BT_CONTACT_POINT_ALGORITHMS);
	Result result(own, &wrap0, &wrap1);
	pair.m_algorithm->processCollision(&wrap0, &wrap1, info, &result);
}

void btHybridParallelWorld::getManifolds(btAlignedObjectArray<btHybridChildManifold>& manifolds) const
{
	manifolds.resizeNoInitialize(0);
	for (int i = 0; i < m_dispatcher->getNumManifolds(); i++)
	{
		btPersistentManifold* manifold = m_dispatcher->getManifoldByIndexInternal(i);
		const btCollisionObject* body0 = StandIn::originalOf(manifold->getBody0());
		const btCollisionObject* body1 = StandIn::originalOf(manifold->getBody1());
		manifolds.push_back(
		    btHybridChildManifold(manifold, body0, body1, manifold->m_companionIdA, manifold->m_companionIdB));
	}
	if (manifolds.size() > 1)
		manifolds.quickSort(btHybridChildManifold::less);
}
