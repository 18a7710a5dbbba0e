// What a program asks of a btHybridDynamicsWorld whose pairs switch.
#include "BulletHybrid/btHybridDynamicsWorld.h"
#include "btHybridPlanner.h"
#include "btHybridSettings.h"

btHybridBudgetState btHybridDynamicsWorld::getBudgetState() const
{
	return m_planner ? m_planner->budgetState() : btHybridBudgetState();
}

btHybridPairStepInfo btHybridDynamicsWorld::getPairStepInfo() const
{
	return m_planner ? m_planner->counts() : btHybridPairStepInfo();
}

const char* btHybridDynamicsWorld::addPolicy(const char* specification)
{
	const char* mistake = checkPairCall();
	return mistake ? mistake : m_planner->addPolicy(specification);
}

const char* btHybridDynamicsWorld::checkPolicy(const char* specification)
{
	const char* mistake = checkPairCall();
	return mistake ? mistake : m_planner->checkPolicy(specification);
}

const char* btHybridDynamicsWorld::removePolicies()
{
	const char* mistake = checkPairCall();
	if (!mistake)
		m_planner->removePolicies();
	return mistake;
}

const char* btHybridDynamicsWorld::setBudgetMilliseconds(double milliseconds)
{
	const char* mistake = checkPairCall();
	if (!mistake)
		mistake = btHybridCheckBudget(milliseconds);
	if (!mistake)
		m_planner->setBudget(scatter::lod::UnitBudget::ofMilliseconds(milliseconds));
	return mistake;
}

const char* btHybridDynamicsWorld::setBudgetMilliseconds(double milliseconds, const double* millisecondsPerUnit,
                                                         int count)
{
	const char* mistake = checkPairCall();
	if (!mistake)
		mistake = btHybridCheckBudget(milliseconds);
	if (!mistake)
		mistake = btHybridCheckMachine(millisecondsPerUnit, count);
	if (!mistake)
		m_planner->setBudget(scatter::lod::UnitBudget::ofMilliseconds(
		    milliseconds, std::vector<double>(millisecondsPerUnit, millisecondsPerUnit + count)));
	return mistake;
}

const char* btHybridDynamicsWorld::setBudgetUnits(double units)
{
	const char* mistake = checkPairCall();
	if (!mistake)
		mistake = btHybridCheckBudgetUnits(units);
	if (!mistake)
		m_planner->setBudget(scatter::lod::UnitBudget::ofUnits(units));
	return mistake;
}

const char* btHybridDynamicsWorld::replayBudget(const btHybridBudgetUnits* steps, int count)
{
	const char* mistake = checkPairCall();
	if (!mistake)
		mistake = btHybridCheckReplay(steps, count);
	if (!mistake)
		m_planner->setBudget(scatter::lod::UnitBudget::replay(std::vector<btHybridBudgetUnits>(steps, steps + count)));
	return mistake;
}

const char* btHybridDynamicsWorld::removeBudget()
{
	const char* mistake = checkPairCall();
	if (!mistake)
		m_planner->setBudget(scatter::lod::UnitBudget());
	return mistake;
}

const char* btHybridDynamicsWorld::setFocus(const btVector3& eye, const btVector3& target, btScalar fieldOfView)
{
	const char* mistake = checkPairCall();
	if (!mistake)
		mistake = btHybridCheckFocus(eye, target, fieldOfView);
	if (!mistake)
		m_planner->setFocus(eye, target, fieldOfView);
	return mistake;
}

const char* btHybridDynamicsWorld::removeFocus()
{
	const char* mistake = checkPairCall();
	if (!mistake)
		m_planner->removeFocus();
	return mistake;
}
