#ifndef BT_HYBRID_HELD_CONTACTS_H
#define BT_HYBRID_HELD_CONTACTS_H

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <vector>

#include "collision/part_pair.h"

class btDispatcher;

/// The contacts of a pair as they were last found at its finest level, kept while it is on credit at a coarser one: a
/// few for all child pairs together. Owns its manifolds as long as they are not released.
class btHybridHeldContacts
{
	static const int c_mostManifolds = 3;  ///< with two, towers sway

	btPersistentManifold* m_manifolds[c_mostManifolds];
	int m_count;

	struct Candidate;

	static void collect(const std::vector<scatter::ChildPair>& children, std::vector<Candidate>& candidates);
	void collectOld(std::vector<Candidate>& candidates, std::vector<const btManifoldPoint*>& replaced);
	btManifoldPoint* nearest(const btManifoldPoint& point);
	void inherit(const btManifoldPoint& from);
	void add(const btManifoldPoint& point, const btPersistentManifold* like, btDispatcher* dispatcher);

public:
	btHybridHeldContacts()
	    : m_count(0)
	{
	}

	/// Takes over the contacts of child pairs: the deepest, and those that differ most from it and from each other in
	/// place and direction. Those that were held before stay as long as nothing like them is found. What the contacts
	/// that are left out or replaced bore is borne by those like them.
	void gather(const std::vector<scatter::ChildPair>& children, btDispatcher* dispatcher);

	/// Takes in where the bodies are, as Bullet does with a manifold: contacts that have come apart end.
	void refresh(const btTransform& transform0, const btTransform& transform1);

	/// Gives the contacts back to the child pairs of the finest level that they were found for, as far as those are still
	/// neighbours, and holds none any more.
	void giveBack(std::vector<scatter::ChildPair>& children, btDispatcher* dispatcher);

	void release(btDispatcher* dispatcher);

	bool isEmpty() const
	{
		return m_count == 0;
	}
	int getNumManifolds() const
	{
		return m_count;
	}
	btPersistentManifold* getManifold(int index) const
	{
		return m_manifolds[index];
	}
	int getNumContacts() const;

	/// Of the nearest contact; large if there is none.
	btScalar getLeastDistance() const;
};

#endif  // BT_HYBRID_HELD_CONTACTS_H
