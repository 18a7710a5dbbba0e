#include "btHybridStepMemory.h"

btPersistentManifold* btHybridStepMemory::standIn(const btCollisionObject* a, const btCollisionObject* b,
                                                  btScalar breakingThreshold)
{
	if (m_used == m_standIns.size())
		m_standIns.push_back(std::unique_ptr<btPersistentManifold>(new btPersistentManifold));
	btPersistentManifold* manifold = m_standIns[m_used++].get();
	manifold->setNumContacts(0);
	manifold->setBodies(a, b);
	manifold->setContactBreakingThreshold(breakingThreshold);
	return manifold;
}
