#pragma once

#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <scatter/world/step_report.h>

namespace scatter {

/// What a hybrid world reports about its switching, in the words of Physics: added to what the counters hold.
void addBodyCounts(const btHybridStepInfo& info, StepCounters& counters);
void addPairCounts(const btHybridPairStepInfo& info, StepCounters& counters);

}  // namespace scatter
