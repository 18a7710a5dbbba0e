#include "BulletHybrid/btHybridInstallation.h"

#include "btHybridNarrowphase.h"
#include "btHybridRegistration.h"

btHybridInstallation::btHybridInstallation(btDispatcher* dispatcher)
    : m_narrowphase(new btHybridNarrowphase(false)),
      m_registration(new btHybridRegistration(dispatcher, 0, m_narrowphase))
{
	setCollisionInfo(btHybridCollisionInfo());
}

btHybridInstallation::~btHybridInstallation()
{
	delete m_registration;
	m_narrowphase->removeUser();
}

const char* btHybridInstallation::getMistake() const
{
	return m_registration->getMistake();
}

const btHybridCollisionInfo& btHybridInstallation::getCollisionInfo() const
{
	return m_narrowphase->getInfo();
}

void btHybridInstallation::setCollisionInfo(const btHybridCollisionInfo& info)
{
	btHybridCollisionInfo acting = info;
	acting.m_plainBodies = true;
	m_narrowphase->setInfo(acting);
}

btHybridCollisionCounts btHybridInstallation::takeCollisionCounts()
{
	const btHybridCollisionCounts counts = m_narrowphase->getCounts();
	m_narrowphase->beginStep();
	return counts;
}

btHybridCollisionMemory btHybridInstallation::getCollisionMemory() const
{
	return m_narrowphase->getMemory();
}
