#include "btHybridCoarsestBounds.h"

namespace
{
// A point moves by less than this share of its distance from the origin along any axis, until bounds are found anew.
// Those of bodies that rest or drift last for seconds, and are wider by less than contacts begin apart for bodies of a
// metre.
const btScalar c_turn = btScalar(0.01);

bool hasHardlyTurned(const btMatrix3x3& before, const btMatrix3x3& now)
{
	for (int i = 0; i < 3; i++)
		if (!((now[i] - before[i]).length2() < c_turn * c_turn))
			return false;
	return true;
}
}  // namespace

void btHybridCoarsestBounds::add()
{
	Turned turned;
	turned.m_basis.setValue(0, 0, 0, 0, 0, 0, 0, 0, 0);
	turned.m_min.setZero();
	turned.m_max.setZero();
	m_turned.push_back(turned);
}

void btHybridCoarsestBounds::remove(int body)
{
	m_turned[body] = m_turned[m_turned.size() - 1];
	m_turned.pop_back();
}

// Bounds that fit have half of the pairs, or more, that Bullet's would have.
void btHybridCoarsestBounds::beginStep(int pairs)
{
	m_fits = (m_fits ? 2 * pairs : pairs) > m_turned.size();
}

void btHybridCoarsestBounds::find(const btHybridLevelSet& levels, const btMatrix3x3& basis, Turned& turned)
{
	turned.m_basis = basis;
	levels.getCoarsestAabb(btTransform(basis, btVector3(0, 0, 0)), turned.m_min, turned.m_max);
	btVector3 furthest = turned.m_max.absolute();
	furthest.setMax(turned.m_min.absolute());
	const btScalar slack = c_turn * furthest.length();
	turned.m_min -= btVector3(slack, slack, slack);
	turned.m_max += btVector3(slack, slack, slack);
}

void btHybridCoarsestBounds::getAabb(int body, const btHybridLevelSet& levels, const btTransform& transform,
                                     btVector3& aabbMin, btVector3& aabbMax)
{
	if (!m_fits || levels.m_balls.size() == 0)
		return levels.getLevelShape(1)->getAabb(transform, aabbMin, aabbMax);
	Turned& turned = m_turned[body];
	if (!hasHardlyTurned(turned.m_basis, transform.getBasis()))
		find(levels, transform.getBasis(), turned);
	aabbMin = transform.getOrigin() + turned.m_min;
	aabbMax = transform.getOrigin() + turned.m_max;
}
