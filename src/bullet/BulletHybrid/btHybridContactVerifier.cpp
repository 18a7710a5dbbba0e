#include "btHybridContactVerifier.h"

void btHybridContactVerifier::verify(btBroadphasePairArray& pairs, btDispatcher* dispatcher)
{
	(void)pairs;
	(void)dispatcher;
	m_report.m_steps++;
}
