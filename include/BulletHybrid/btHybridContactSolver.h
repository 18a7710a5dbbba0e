#ifndef BT_HYBRID_CONTACT_SOLVER_H
#define BT_HYBRID_CONTACT_SOLVER_H

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include "BulletHybrid/btHybridContactReduction.h"

class btHybridContactGroups;
class btITaskScheduler;

/// What the last call of solveGroup was about.
struct btHybridContactSolverInfo
{
	int m_pairs;    ///< of bodies, whose contacts are solved four pairs at a time
	int m_points;   ///< their contacts
	int m_colours;  ///< sets of pairs without a moving body in common, which are solved one after another; of the group
	                ///< that has the most
	int m_rows;     ///< the places of four that the contacts take; some have fewer in them
	int m_groups;   ///< of islands, which are solved beside each other
	int m_bulletManifolds;  ///< whose contacts are Bullet's own business, see btHybridContactSolver
	btHybridContactReductionCount m_reduced;

	btHybridContactSolverInfo() : m_pairs(0), m_points(0), m_colours(0), m_rows(0), m_groups(0), m_bulletManifolds(0)
	{
	}
};

/// A btSequentialImpulseConstraintSolver that solves contacts four pairs of bodies at a time, for any
/// btDiscreteDynamicsWorld: give it to the constructor in the place of Bullet's. It finds the same impulses as
/// Bullet's with another order of contacts, so motions differ as they do between two orders of Bullet's. The same
/// bits, run after run, for any number of threads, on one machine.
///
/// It heeds all of btContactSolverInfo: restitution, warm starting, split impulses, both friction directions,
/// per-contact cfm, erp, stiffness and damping, locked axes, kinematic bodies, iterations and residual. Joints are
/// solved by Bullet, before the contacts in each iteration. So are the contacts of a manifold that has rolling
/// friction, a friction anchor, friction directions set by the program (SOLVER_ENABLE_FRICTION_DIRECTION_CACHING)
/// or a body with anisotropic friction, and all contacts with SOLVER_RANDMIZE_ORDER or
/// SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS: right, and no faster.
///
/// Not for btMultiBodyDynamicsWorld and what is made of it, which need a btMultiBodyConstraintSolver. One solver a
/// world.
ATTRIBUTE_ALIGNED16(class)
btHybridContactSolver : public btSequentialImpulseConstraintSolver
{
	btHybridContactGroups* m_groups;
	bool m_clampsFriction;
	bool m_reduces;
	btHybridContactReductionInfo m_reduction;

	btHybridContactSolver(const btHybridContactSolver&);
	btHybridContactSolver& operator=(const btHybridContactSolver&);

	friend class btHybridDynamicsWorld;

	void setJoined(int body);
	void convertManifold(btPersistentManifold * manifold, bool leavesAll, const btContactSolverInfo& info);
	bool hasBulletRows() const;
	btScalar solveBulletPushes();

protected:
	virtual void convertJoints(btTypedConstraint * *constraints, int numConstraints, const btContactSolverInfo& info);
	virtual void convertContacts(btPersistentManifold * *manifolds, int numManifolds, const btContactSolverInfo& info);
	virtual void solveGroupCacheFriendlySplitImpulseIterations(
	    btCollisionObject * *bodies, int numBodies, btPersistentManifold** manifolds, int numManifolds,
	    btTypedConstraint** constraints, int numConstraints, const btContactSolverInfo& info,
	    btIDebugDraw* debugDrawer);
	virtual btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int numBodies,
	                                      btPersistentManifold** manifolds, int numManifolds,
	                                      btTypedConstraint** constraints, int numConstraints,
	                                      const btContactSolverInfo& info, btIDebugDraw* debugDrawer);

	virtual btScalar solveGroupCacheFriendlyIterations(btCollisionObject * *bodies, int numBodies,
	                                                   btPersistentManifold** manifolds, int numManifolds,
	                                                   btTypedConstraint** constraints, int numConstraints,
	                                                   const btContactSolverInfo& info, btIDebugDraw* debugDrawer);

	/// One iteration of joints and of the contacts that are Bullet's own business.
	virtual btScalar solveBulletRows(int iteration, btTypedConstraint** constraints, int numConstraints,
	                                 const btContactSolverInfo& info);

	virtual btScalar solveGroupCacheFriendlyFinish(btCollisionObject * *bodies, int numBodies,
	                                               const btContactSolverInfo& info);

public:
	BT_DECLARE_ALIGNED_ALLOCATOR();

	btHybridContactSolver();
	virtual ~btHybridContactSolver();

	/// Whether a contact that bears nothing has no friction: true unless set otherwise. Bullet's solver leaves such
	/// a contact the friction of the iteration before: a slab that lies on many contacts sticks on slopes that are
	/// too steep for it.
	void setFrictionClamp(bool clamps)
	{
		m_clampsFriction = clamps;
	}
	bool getFrictionClamp() const
	{
		return m_clampsFriction;
	}

	/// Leaves out contacts as btHybridContactReduction does, but for next to nothing where no two bodies have many:
	/// the solver knows anyway which contacts are whose. Not unless called, and no more after
	/// removeContactReduction().
	void setContactReduction(const btHybridContactReductionInfo& info);
	void removeContactReduction()
	{
		m_reduces = false;
	}

	/// How many threads, the caller's among them, solve islands that do not touch each other: 1 to 64, 1 unless set
	/// otherwise. In a btHybridDynamicsWorld they are the world's, whatever is set here, and all islands of a step are
	/// shared out at once; in other worlds, those that Bullet hands over in one piece: see
	/// btContactSolverInfo::m_minimumSolverBatchSize. Returns 0, or for other numbers what is wrong.
	const char* setNumThreads(int threads);
	int getNumThreads() const;

	/// The threads of a program's own scheduler, which must outlive its use, in the place of the solver's; 0: the
	/// solver's again.
	void setTaskScheduler(btITaskScheduler * scheduler);

	btHybridContactSolverInfo getContactSolverInfo() const;
};

#endif  // BT_HYBRID_CONTACT_SOLVER_H
