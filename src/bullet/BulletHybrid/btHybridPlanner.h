#ifndef BT_HYBRID_PLANNER_H
#define BT_HYBRID_PLANNER_H

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include <string>
#include <vector>

#include "BulletHybrid/btHybridObservation.h"
#include "BulletHybrid/btHybridRequest.h"
#include "BulletHybrid/btHybridSwitching.h"
#include "btHybridReducedContacts.h"
#include "pairs/planner.h"

class btHybridLevelBodies;

/// The planner of pairs for Bullet's objects: shows it the world, and tells the program's listener what it hears.
class btHybridPlanner : public scatter::pairs::Planner, private scatter::pairs::PairListener
{
	std::vector<scatter::lod::BodyView> m_bodies;
	btHybridListener* m_listener;
	std::string m_mistake;
	std::vector<btPersistentManifold*> m_solved;  ///< those of bodies that are awake
	btHybridReducedContacts m_reduced;
	int m_leftOut;                                     ///< of the solver's iterations
	std::vector<scatter::pairs::PlannedBody*> m_owed;  ///< inside wakeOwed()

	void settleSolver(btDispatcher* dispatcher, const scatter::lod::SolverWork& solver);
	void findSolved(btDispatcher* dispatcher);
	virtual void hear(const scatter::pairs::PairEvent& event);
	const char* remember(const scatter::Result<void>& result);

public:
	btHybridPlanner();

	void setInfo(const btHybridPairSwitchingInfo& info);
	/// 0, or what is wrong with it.
	const char* addPolicy(const char* specification);
	const char* checkPolicy(const char* specification);
	void setFocus(const btVector3& eye, const btVector3& target, btScalar fieldOfView);
	void setListener(btHybridListener* listener);
	void setHeld(const btAlignedObjectArray<const btCollisionObject*>& held);

	/// place: where its owner keeps its index, as long as the pair is there.
	void addPair(btHybridLevelBodies* object0, btHybridLevelBodies* object1, int* place);
	/// A pair of a body with levels and what it may lie on.
	void addGround(btHybridLevelBodies* body, btHybridLevelBodies* ground, int* place);

	/// Between broadphase and narrowphase.
	void plan(const btCollisionObjectArray& objects, const btAlignedObjectArray<btRigidBody*>& moving,
	          int numOverlappingPairs, int numJoints, btScalar timeStep, const scatter::lod::StepClock& clock);

	/// After the narrowphase.
	void finish(btDispatcher* dispatcher, const scatter::lod::SolverWork& solver);

	/// Before contacts change.
	void forgetContacts()
	{
		m_reduced.forget();
		m_leftOut = 0;
	}

	/// Of so many that the solver makes, those that the budget has room for.
	int getIterations(int usual) const
	{
		return btMax(usual - m_leftOut, btMin(usual, 1));
	}

	/// Contacts that the budget has no room for are hidden from here on to showContacts(), where they are solved.
	void hideContacts()
	{
		m_reduced.hide();
	}
	void showContacts()
	{
		m_reduced.show();
	}

	/// After a step: wakes what sleeps without detail that the budget has room for by now.
	void wakeOwed();

	btHybridPairView viewPair(int pair) const;

	void viewCoarserObjects(btAlignedObjectArray<btHybridCoarserObject>& objects) const;

	/// Objects of pairs on credit, two for each; not those of grounds.
	void findCredited(btAlignedObjectArray<btHybridLevelBodies*>& objects) const;

	/// Adds to the request of a body what holds it up.
	void viewObstacle(const btCollisionObject* body, btHybridRequestView& request) const;
};

#endif  // BT_HYBRID_PLANNER_H
