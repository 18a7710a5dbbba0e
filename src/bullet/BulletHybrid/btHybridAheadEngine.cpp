#include "btHybridAheadEngine.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>

#include "BulletHybrid/btHybridDynamicsWorld.h"
#include "pairs/pair.h"

using scatter::pairs::ManifoldNote;

btPersistentManifold* btHybridStepMemory::standIn(const btCollisionObject* a, const btCollisionObject* b, btScalar breakingThreshold)
{
	if (m_used == m_standIns.size())
		m_standIns.push_back(std::unique_ptr<btPersistentManifold>(new btPersistentManifold));
	btPersistentManifold* manifold = m_standIns[m_used++].get();
	manifold->setNumContacts(0);
	manifold->setBodies(a, b);
	manifold->setContactBreakingThreshold(breakingThreshold);
	return manifold;
}

void* btHybridAheadEngine::newManifold()
{
	btPersistentManifold* manifold = m_memory.standIn(m_wraps[0]->getCollisionObject(), m_wraps[1]->getCollisionObject(), threshold());
	const ManifoldNote note = {manifold, true};
	m_notes.push_back(note);
	return manifold;
}

void btHybridAheadEngine::release(void* manifold)
{
	const ManifoldNote note = {manifold, false};
	m_notes.push_back(note);
}

namespace
{
bool areContactsUnheard()
{
	return !gContactDestroyedCallback && !gContactProcessedCallback && !gContactStartedCallback && !gContactEndedCallback && !gCompoundChildShapePairCallback && !gCompoundCompoundChildShapePairCallback;
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

bool btHybridAheadEngine::isDispatchSure(const btCollisionDispatcher* dispatcher, const btDispatcherInfo& info, int promises)
{
	const bool forwards = (promises & BT_HYBRID_NEAR_CALLBACK_FORWARDS) || dispatcher->getNearCallback() == btCollisionDispatcher::defaultNearCallback;
	return forwards && info.m_dispatchFunc == btDispatcherInfo::DISPATCH_DISCRETE;
}

bool btHybridAheadEngine::mayStep()
{
	return areContactsUnheard() && isMixedByBullet();
}

bool btHybridAheadEngine::mayAdd(int promises)
{
	return !gContactAddedCallback || (promises & BT_HYBRID_CONTACT_ADDED_ON_ANY_THREAD);
}

bool btHybridAheadEngine::hearsOfNew(const btCollisionObject* object)
{
	return (object->getCollisionFlags() & btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK) != 0;
}

namespace
{
struct Adopted
{
	void* m_standIn;
	btPersistentManifold* m_manifold;
};

// What a program keeps with a point has one owner.
btPersistentManifold* adopt(btDispatcher* dispatcher, const btCollisionObject* a, const btCollisionObject* b, btPersistentManifold& standIn)
{
	btPersistentManifold* manifold = dispatcher->getNewManifold(a, b);
	for (int i = 0; i < standIn.getNumContacts(); i++)
	{
		manifold->addManifoldPoint(standIn.getContactPoint(i));
		standIn.getContactPoint(i).m_userPersistentData = 0;
	}
	return manifold;
}

btPersistentManifold* find(const btAlignedObjectArray<Adopted>& adopted, void* manifold)
{
	for (int i = 0; i < adopted.size(); i++)
		if (adopted[i].m_standIn == manifold)
			return adopted[i].m_manifold;
	return static_cast<btPersistentManifold*>(manifold);
}
}  // namespace

void btHybridAheadEngine::tell(btDispatcher* dispatcher, const btCollisionObject* a, const btCollisionObject* b, scatter::pairs::Pair& pair)
{
	btAlignedObjectArray<Adopted> adopted;
	for (const ManifoldNote& note : pair.ahead->notes)
	{
		if (!note.isNew)
		{
			dispatcher->releaseManifold(find(adopted, note.manifold));
			continue;
		}
		const Adopted one = {note.manifold, adopt(dispatcher, a, b, *btHybridContacts::at(note.manifold))};
		adopted.push_back(one);
	}
	for (scatter::ChildPair& child : pair.parts.children())
	{
		if (adopted.size() == 0)
			break;
		if (child.contact)
			child.contact = find(adopted, child.contact);
	}
}
