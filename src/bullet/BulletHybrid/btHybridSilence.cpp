#include "btHybridSilence.h"

btHybridSilence::btHybridSilence()
    : m_added(gContactAddedCallback),
      m_processed(gContactProcessedCallback),
      m_destroyed(gContactDestroyedCallback),
      m_started(gContactStartedCallback),
      m_ended(gContactEndedCallback)
{
	m_combiners[0] = gCalculateCombinedRestitutionCallback;
	m_combiners[1] = gCalculateCombinedFrictionCallback;
	m_combiners[2] = gCalculateCombinedRollingFrictionCallback;
	m_combiners[3] = gCalculateCombinedSpinningFrictionCallback;
	m_combiners[4] = gCalculateCombinedContactDampingCallback;
	m_combiners[5] = gCalculateCombinedContactStiffnessCallback;
	gContactAddedCallback = 0;
	gContactProcessedCallback = 0;
	gContactDestroyedCallback = 0;
	gContactStartedCallback = 0;
	gContactEndedCallback = 0;
	gCalculateCombinedRestitutionCallback = &btManifoldResult::calculateCombinedRestitution;
	gCalculateCombinedFrictionCallback = &btManifoldResult::calculateCombinedFriction;
	gCalculateCombinedRollingFrictionCallback = &btManifoldResult::calculateCombinedRollingFriction;
	gCalculateCombinedSpinningFrictionCallback = &btManifoldResult::calculateCombinedSpinningFriction;
	gCalculateCombinedContactDampingCallback = &btManifoldResult::calculateCombinedContactDamping;
	gCalculateCombinedContactStiffnessCallback = &btManifoldResult::calculateCombinedContactStiffness;
}

btHybridSilence::~btHybridSilence()
{
	gContactAddedCallback = m_added;
	gContactProcessedCallback = m_processed;
	gContactDestroyedCallback = m_destroyed;
	gContactStartedCallback = m_started;
	gContactEndedCallback = m_ended;
	gCalculateCombinedRestitutionCallback = m_combiners[0];
	gCalculateCombinedFrictionCallback = m_combiners[1];
	gCalculateCombinedRollingFrictionCallback = m_combiners[2];
	gCalculateCombinedSpinningFrictionCallback = m_combiners[3];
	gCalculateCombinedContactDampingCallback = m_combiners[4];
	gCalculateCombinedContactStiffnessCallback = m_combiners[5];
}
