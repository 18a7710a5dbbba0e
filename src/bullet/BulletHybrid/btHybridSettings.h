#ifndef BT_HYBRID_SETTINGS_H
#define BT_HYBRID_SETTINGS_H

#include <LinearMath/btVector3.h>

#include "BulletHybrid/btHybridCollision.h"
#include "BulletHybrid/btHybridSwitching.h"

/// What the program's settings act as: their documentation says what is done with values that make no sense.
btHybridSwitchingInfo btHybridEffective(const btHybridSwitchingInfo& info);
btHybridPairSwitchingInfo btHybridEffective(const btHybridPairSwitchingInfo& info);
btHybridCollisionInfo btHybridEffective(const btHybridCollisionInfo& info);

/// 0, or what is wrong with it and how to mend it.
const char* btHybridCheckThreads(int threads);
const char* btHybridCheckBudget(double milliseconds);
const char* btHybridCheckBudgetUnits(double units);
const char* btHybridCheckReplay(const btHybridBudgetUnits* steps, int count);
const char* btHybridCheckMachine(const double* millisecondsPerUnit, int count);
const char* btHybridCheckFocus(const btVector3& eye, const btVector3& target, btScalar fieldOfView);

#endif  // BT_HYBRID_SETTINGS_H
