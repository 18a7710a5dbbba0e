#include "btHybridSettings.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <cmath>

#include "btHybridFinite.h"

namespace
{
// What is not a number becomes the least.
btScalar within(btScalar value, btScalar least, btScalar most)
{
	return value > least ? btMin(value, most) : least;
}

}  // namespace

btHybridSwitchingInfo btHybridEffective(const btHybridSwitchingInfo& info)
{
	const int c_manySteps = 1000000;
	const btScalar c_furthest = 1000;
	btHybridSwitchingInfo effective = info;
	effective.m_proximitySteps = within(info.m_proximitySteps, 0, 1000);
	effective.m_retryInterval = btMin(btMax(info.m_retryInterval, 1), c_manySteps);
	effective.m_quietSteps = btMax(info.m_quietSteps, 1);
	effective.m_safetyGap = within(info.m_safetyGap, 0, c_furthest);
	return effective;
}

btHybridPairSwitchingInfo btHybridEffective(const btHybridPairSwitchingInfo& info)
{
	btHybridPairSwitchingInfo effective = info;
	effective.m_creditLevel = btMax(info.m_creditLevel, 1);
	effective.m_retryInterval = btMin(btMax(info.m_retryInterval, 1), 255);
	effective.m_auditDistance = within(info.m_auditDistance, 0, 1000);
	return effective;
}

btHybridCollisionInfo btHybridEffective(const btHybridCollisionInfo& info)
{
	btHybridCollisionInfo effective = info;
	// Points that have come further apart are no contacts any more.
	effective.m_steps.recycling = within(info.m_steps.recycling, 0, gContactBreakingThreshold / 2);
	return effective;
}

const char* btHybridCheckThreads(int threads)
{
	const int c_most = 64;
	return threads < 1 || threads > c_most ? "a world works on 1 to 64 threads" : 0;
}

const char* btHybridCheckBudget(double milliseconds)
{
	return std::isfinite(milliseconds) && milliseconds > 0
	           ? 0
	           : "a budget must be a finite number of milliseconds above 0; removeBudget() ends one";
}

const char* btHybridCheckBudgetUnits(double units)
{
	return std::isfinite(units) && units > 0
	           ? 0
	           : "a budget must be a finite number of units above 0; removeBudget() ends one";
}

const char* btHybridCheckReplay(const btHybridBudgetUnits* steps, int count)
{
	if (!steps || count <= 0)
		return "a budget to be replayed needs the units of at least one step; removeBudget() ends one";
	const auto isUnits = [](double units) { return std::isfinite(units) && units >= 0; };
	for (int i = 0; i < count; i++)
		if (!isUnits(steps[i].given) || !isUnits(steps[i].revised) || !isUnits(steps[i].settled))
			return "a budget to be replayed needs finite units in every step, not negative; 0 is a step without a "
			       "budget";
	return 0;
}

const char* btHybridCheckMachine(const double* millisecondsPerUnit, int count)
{
	if (!millisecondsPerUnit || count <= 0)
		return "a machine needs the milliseconds that a unit takes in at least one step";
	for (int i = 0; i < count; i++)
		if (!std::isfinite(millisecondsPerUnit[i]) || millisecondsPerUnit[i] <= 0)
			return "a machine needs a finite number of milliseconds above 0 for a unit of every step";
	return 0;
}

const char* btHybridCheckFocus(const btVector3& eye, const btVector3& target, btScalar fieldOfView)
{
	if (!btHybridIsFinite(eye) || !btHybridIsFinite(target))
		return "the focus needs an eye and a target that are finite; removeFocus() ends it";
	return fieldOfView > 0 && fieldOfView < SIMD_PI
	           ? 0
	           : "the focus needs a vertical field of view between 0 and pi, in radians";
}
