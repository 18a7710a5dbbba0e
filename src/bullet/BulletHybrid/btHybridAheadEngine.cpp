#include "btHybridAheadEngine.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include "BulletHybrid/btHybridDynamicsWorld.h"

using scatter::pairs::ManifoldNote;

// What a program keeps with a point has one owner.
static btPersistentManifold* adopt(btDispatcher* dispatcher, const btCollisionObject* a, const btCollisionObject* b,
                                   btPersistentManifold* standIn)
{
	btPersistentManifold* manifold = dispatcher->getNewManifold(a, b);
	for (int i = 0; i < standIn->getNumContacts(); i++)
	{
		manifold->addManifoldPoint(standIn->getContactPoint(i));
		standIn->getContactPoint(i).m_userPersistentData = 0;
	}
	return manifold;
}

btHybridAdoption::btHybridAdoption(btDispatcher* dispatcher, const btCollisionObject* a, const btCollisionObject* b,
                                   const std::vector<ManifoldNote>& notes)
{
	for (const ManifoldNote& note : notes)
	{
		if (!note.isNew)
		{
			dispatcher->releaseManifold(find(note.manifold));
			continue;
		}
		const Adopted one = {note.manifold, adopt(dispatcher, a, b, static_cast<btPersistentManifold*>(note.manifold))};
		m_adopted.push_back(one);
	}
}

btPersistentManifold* btHybridAdoption::find(void* manifold) const
{
	for (const Adopted& one : m_adopted)
		if (one.m_standIn == manifold)
			return one.m_manifold;
	return static_cast<btPersistentManifold*>(manifold);
}

namespace
{
bool areContactsUnheard()
{
	return !gContactDestroyedCallback && !gContactProcessedCallback && !gContactStartedCallback &&
	       !gContactEndedCallback && !gCompoundChildShapePairCallback && !gCompoundCompoundChildShapePairCallback;
}

bool isMixedByBullet()
{
	return gCalculateCombinedRestitutionCallback == &btManifoldResult::calculateCombinedRestitution &&
	       gCalculateCombinedFrictionCallback == &btManifoldResult::calculateCombinedFriction &&
	       gCalculateCombinedRollingFrictionCallback == &btManifoldResult::calculateCombinedRollingFriction &&
	       gCalculateCombinedSpinningFrictionCallback == &btManifoldResult::calculateCombinedSpinningFriction &&
	       gCalculateCombinedContactDampingCallback == &btManifoldResult::calculateCombinedContactDamping &&
	       gCalculateCombinedContactStiffnessCallback == &btManifoldResult::calculateCombinedContactStiffness;
}
}  // namespace

bool btHybridAheadRules::isDispatchSure(const btCollisionDispatcher* dispatcher, const btDispatcherInfo& info,
                                        int promises)
{
	const bool forwards = (promises & BT_HYBRID_NEAR_CALLBACK_FORWARDS) ||
	                      dispatcher->getNearCallback() == btCollisionDispatcher::defaultNearCallback;
	return forwards && info.m_dispatchFunc == btDispatcherInfo::DISPATCH_DISCRETE;
}

bool btHybridAheadRules::mayStep()
{
	return areContactsUnheard() && isMixedByBullet();
}

bool btHybridAheadRules::mayAdd(int promises)
{
	return !gContactAddedCallback || (promises & BT_HYBRID_CONTACT_ADDED_ON_ANY_THREAD);
}

bool btHybridAheadRules::mayStep(const btHybridAhead& ahead, const btCollisionObject* a, const btCollisionObject* b)
{
	return ahead.m_mayStep && (ahead.m_mayAdd || !((a->getCollisionFlags() | b->getCollisionFlags()) &
	                                               btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK));
}
