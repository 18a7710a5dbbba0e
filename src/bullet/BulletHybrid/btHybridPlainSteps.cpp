#include "btHybridPlainSteps.h"

#include <BulletCollision/CollisionDispatch/btBoxBoxCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <typeinfo>

#include "btHybridAheadEngine.h"
#include "btHybridWrapped.h"

namespace
{
const btCollisionObject* objectOf(const btBroadphaseProxy* proxy)
{
	return static_cast<const btCollisionObject*>(proxy->m_clientObject);
}
}  // namespace

bool btHybridPlainSteps::isAmong(const btCollisionAlgorithm& algorithm)
{
	return typeid(algorithm) == typeid(btBoxBoxCollisionAlgorithm);
}

bool btHybridPlainSteps::mayMake(const btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                                 const btHybridAhead& ahead)
{
	const btCollisionObject* a = objectOf(pair.m_pProxy0);
	const btCollisionObject* b = objectOf(pair.m_pProxy1);
	return btHybridAheadRules::mayStep(ahead, a, b) && dispatcher.needsCollision(a, b);
}

void btHybridPlainSteps::make(const btBroadphasePair& pair, const btDispatcherInfo& info)
{
	const btCollisionObjectWrapper a = btHybridWrapped(objectOf(pair.m_pProxy0));
	const btCollisionObjectWrapper b = btHybridWrapped(objectOf(pair.m_pProxy1));
	btManifoldResult result(&a, &b);
	pair.m_algorithm->processCollision(&a, &b, info, &result);
}
