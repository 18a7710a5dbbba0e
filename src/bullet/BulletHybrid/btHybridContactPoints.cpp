#include "btHybridContactPoints.h"

#include "btHybridQuad.h"
#include "btHybridReducible.h"

using scatter::solver::ProblemPoint;

namespace
{
bool needsBullet(const btManifoldPoint& point, const btContactSolverInfo& info)
{
	const bool hasDirections = (info.m_solverMode & SOLVER_ENABLE_FRICTION_DIRECTION_CACHING) &&
	                           (point.m_contactPointFlags & BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED);
	return point.m_combinedRollingFriction > 0 || (point.m_contactPointFlags & BT_CONTACT_FLAG_FRICTION_ANCHOR) ||
	       hasDirections;
}

// Softness and error reduction of a contact, as btSequentialImpulseConstraintSolver::setupContactConstraint finds
// them.
void findLaw(const btManifoldPoint& point, const btContactSolverInfo& info, btScalar& cfm, btScalar& erp)
{
	cfm = info.m_globalCfm;
	erp = info.m_erp2;
	const int flags = point.m_contactPointFlags;
	if (flags & (BT_CONTACT_FLAG_HAS_CONTACT_CFM | BT_CONTACT_FLAG_HAS_CONTACT_ERP))
	{
		if (flags & BT_CONTACT_FLAG_HAS_CONTACT_CFM)
			cfm = point.m_contactCFM;
		if (flags & BT_CONTACT_FLAG_HAS_CONTACT_ERP)
			erp = point.m_contactERP;
	}
	else if (flags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING)
	{
		const btScalar spring = info.m_timeStep * point.m_combinedContactStiffness1;
		const btScalar resistance = btMax(spring + point.m_combinedContactDamping1, btScalar(SIMD_EPSILON));
		cfm = 1 / resistance;
		erp = spring / resistance;
	}
}

ProblemPoint contactOf(const btManifoldPoint& point, bool swaps, const btContactSolverInfo& info)
{
	btScalar cfm, erp;
	findLaw(point, info, cfm, erp);
	const bool warm = (info.m_solverMode & SOLVER_USE_WARMSTARTING) != 0;
	const btVector3& placeA = point.m_positionWorldOnA;
	const btVector3& placeB = point.m_positionWorldOnB;
	ProblemPoint contact;
	contact.onA = btHybridQuad(swaps ? placeB : placeA, point.getDistance());
	contact.onB = btHybridQuad(swaps ? placeA : placeB, point.m_combinedFriction);
	contact.normal =
	    btHybridQuad(swaps ? -point.m_normalWorldOnB : point.m_normalWorldOnB, point.m_combinedRestitution);
	contact.law =
	    btHybridQuad(btVector3(warm ? point.m_appliedImpulse * info.m_warmstartingFactor : btScalar(0), cfm, erp), 1);
	return contact;
}
}  // namespace

void btHybridContactPoints::clear()
{
	m_points.clear();
	m_sources.clear();
}

bool btHybridContactPoints::add(btPersistentManifold* manifold, bool swaps, const btContactSolverInfo& info,
                                Range& range)
{
	range.m_first = int(m_points.size());
	for (int i = 0; i < manifold->getNumContacts(); ++i)
	{
		btManifoldPoint& point = manifold->getContactPoint(i);
		if (!btHybridIsNear(*manifold, point))
			continue;
		if (needsBullet(point, info))
		{
			m_points.resize(range.m_first);
			m_sources.resize(range.m_first);
			return false;
		}
		m_points.push_back(contactOf(point, swaps, info));
		m_sources.push_back({&point, swaps, btHybridIsReducible(point)});
	}
	range.m_count = int(m_points.size()) - range.m_first;
	return true;
}
