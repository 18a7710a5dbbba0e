#ifndef BT_HYBRID_CONTACT_GROUPS_H
#define BT_HYBRID_CONTACT_GROUPS_H

#include <memory>
#include <utility>
#include <vector>

#include "BulletHybrid/btHybridContactSolver.h"
#include "btHybridContactProblem.h"
#include "btHybridThreads.h"
#include "solver/island_groups.h"

/// The contacts of a step, as problems that can be solved beside each other: groups of islands, which do not depend on
/// the number of threads. One, the joined, is of bodies that joints or rows of Bullet's move as well, and is solved in
/// turns with these.
class btHybridContactGroups
{
public:
	typedef btHybridContactProblem::Side Side;

	struct Settings
	{
		bool m_clampsFriction;
		const btHybridContactReductionInfo* m_reduction;  ///< what is left out; 0: nothing
	};

	btHybridContactGroups();

	void clear();

	/// Takes the contacts of a manifold of bodies of which one moves. False, and nothing taken, if one of them needs
	/// rows of Bullet's.
	bool add(btPersistentManifold* manifold, Side side0, Side side1, const btContactSolverInfo& info);

	/// A solver body that something else than contacts of ours moves, too.
	void setJoined(int body)
	{
		m_joined.push_back(body);
	}

	/// After all manifolds: finds the groups.
	void group(const btAlignedObjectArray<btSolverBody>& bodies);

	/// All groups but the joined one, on all threads, from the contacts to their impulses. Of a pile that is almost all
	/// there is, what is independent of the order of iterations.
	void solve(btAlignedObjectArray<btSolverBody>& bodies, const btContactSolverInfo& info, const Settings& settings);

	/// Takes the contacts of the joined one, and begins to solve it.
	void beginJoined(const btAlignedObjectArray<btSolverBody>& bodies, const btContactSolverInfo& info,
	                 const Settings& settings);
	/// Ends what was begun.
	void finishJoined(btAlignedObjectArray<btSolverBody>& bodies, const btContactSolverInfo& info);
	btHybridContactProblem& joined()
	{
		return *m_problems[0];
	}

	void addTo(btHybridContactSolverInfo& info) const;

	/// Never 0.
	std::shared_ptr<btHybridThreads> m_threads;
	int m_bulletManifolds;

private:
	/// Contacts of two bodies.
	struct Member
	{
		btHybridContactPoints::Range m_range;
		Side m_a;  ///< moves
		Side m_b;
	};

	bool hasManyContacts() const;
	bool hasPile() const;
	void add(const Member& member);
	int countContacts(int group) const;
	void sortGroups();
	void take(int group);
	bool isLargestAlone() const;
	scatter::solver::Share pileThreads() const;
	void solveOne(int group, btAlignedObjectArray<btSolverBody>& bodies, const btContactSolverInfo& info,
	              const Settings& settings, const scatter::solver::Share& share);

	btHybridContactPoints m_points;
	std::vector<Member> m_members;
	std::vector<scatter::solver::IslandGroups::Link> m_links;  ///< of the members
	std::vector<int> m_joined;
	std::vector<int> m_places;  ///< of solver bodies that move, in their problems
	scatter::solver::IslandGroups m_groups;
	std::vector<std::pair<int, int>> m_order;  ///< less its contacts, and its number, of each group but the joined one
	std::vector<std::unique_ptr<btHybridContactProblem>> m_problems;  ///< as many as there have been groups
};

#endif  // BT_HYBRID_CONTACT_GROUPS_H
