#ifndef BT_HYBRID_REDUCED_CONTACTS_H
#define BT_HYBRID_REDUCED_CONTACTS_H

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <vector>

#include "BulletHybrid/btHybridContactReduction.h"
#include "solver/contact_reduction.h"

/// Finds the contacts that others of the same two bodies stand for, and hides them from a solver for as long as it
/// works.
class btHybridReducedContacts
{
	/// The manifolds of two bodies.
	struct Pair
	{
		const btCollisionObject* m_other;
		unsigned m_lot;  ///< random, and the same as long as the two are in the world
		int m_next;      ///< pair of the same first body
		int m_last;      ///< of its manifolds
		int m_contacts;
	};

	struct Hidden
	{
		btManifoldPoint* m_point;
		btManifoldPoint* m_kept;  ///< stands for it
		btScalar m_distance;      ///< while it is hidden
	};

	std::vector<int> m_firstPair;  ///< of an object of the world
	std::vector<Pair> m_pairs;
	std::vector<int> m_order;   ///< of the pairs that are looked at, by their lots
	std::vector<int> m_before;  ///< of a manifold, the one before it of the same bodies
	std::vector<btManifoldPoint*> m_points;
	std::vector<scatter::solver::ReducibleContact> m_contacts;
	std::vector<Hidden> m_hidden;
	scatter::solver::ContactReduction m_reduction;
	btHybridContactReductionCount m_count;

	int pairOf(const btCollisionObject* first, const btCollisionObject* second);
	void group(btPersistentManifold** manifolds, int numManifolds);
	void order(int leastContacts);
	void collect(const Pair& pair, btPersistentManifold** manifolds);
	void remember();

public:
	/// Finds them anew: valid until contacts change.
	void find(btPersistentManifold** manifolds, int numManifolds, const btHybridContactReductionInfo& info);
	void forget();

	/// Of these only so many: of the same bodies in every step, as far as they have as many.
	void keepFirst(int most);

	void hide();
	/// After hide().
	void show();

	/// Of the last find().
	const btHybridContactReductionCount& getCount() const
	{
		return m_count;
	}
};

#endif  // BT_HYBRID_REDUCED_CONTACTS_H
