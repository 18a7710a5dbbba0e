#ifndef BT_HYBRID_CONTACT_REDUCTION_H
#define BT_HYBRID_CONTACT_REDUCTION_H

#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>

class btHybridReducedContacts;

/// What is left out of the contacts of two bodies, see btHybridContactReduction.
struct btHybridContactReductionInfo
{
	/// How many contacts stay of those of two bodies whose normals are within 5 degrees. Less than 1 is 1.
	int m_mostAlike;

	/// Two bodies that have fewer contacts keep them all. Less than 1 is 1.
	int m_leastContacts;

	btHybridContactReductionInfo() : m_mostAlike(8), m_leastContacts(32)
	{
	}
};

/// What the last call of solveGroup did.
struct btHybridContactReductionCount
{
	int m_pairs;     ///< of bodies whose contacts were reduced
	int m_contacts;  ///< of them
	int m_left;      ///< those that the solver was shown

	btHybridContactReductionCount() : m_pairs(0), m_contacts(0), m_left(0)
	{
	}
};

/// A constraint solver that hands contacts to another one, without those that others of the same two bodies stand
/// for: a wheel of 37 hulls that lies on a floor has 100 contacts, of which 8 bear it as well, in a fraction of the
/// time. Give it to the constructor of any btDiscreteDynamicsWorld or of one that is made of it; the solver behind
/// it must be one that the world would take itself, and outlive it.
///
/// The contacts stay in their manifolds, where callbacks and drawing see all of them; what was left out has no
/// impulse, and what it bore is borne by the nearest that is left. Contacts with a cfm or erp of their own, with a
/// friction anchor or rolling friction all stay.
class btHybridContactReduction : public btConstraintSolver
{
	btConstraintSolver* m_own;
	btConstraintSolver* m_solver;
	btHybridReducedContacts* m_reduced;
	btHybridContactReductionInfo m_info;

	btHybridContactReduction(const btHybridContactReduction&);
	btHybridContactReduction& operator=(const btHybridContactReduction&);

public:
	/// 0: a btSequentialImpulseConstraintSolver of its own.
	explicit btHybridContactReduction(btConstraintSolver* solver = 0);
	virtual ~btHybridContactReduction();

	virtual void prepareSolve(int numBodies, int numManifolds);
	virtual btScalar solveGroup(btCollisionObject** bodies, int numBodies, btPersistentManifold** manifolds,
	                            int numManifolds, btTypedConstraint** constraints, int numConstraints,
	                            const btContactSolverInfo& info, btIDebugDraw* debugDrawer, btDispatcher* dispatcher);
	virtual void allSolved(const btContactSolverInfo& info, btIDebugDraw* debugDrawer);
	virtual void reset();
	virtual btConstraintSolverType getSolverType() const;

	btHybridContactReductionInfo& getContactReductionInfo()
	{
		return m_info;
	}
	const btHybridContactReductionInfo& getContactReductionInfo() const
	{
		return m_info;
	}
	btHybridContactReductionCount getCount() const;
};

#endif  // BT_HYBRID_CONTACT_REDUCTION_H
