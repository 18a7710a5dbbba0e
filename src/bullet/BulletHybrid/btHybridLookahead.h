#ifndef BT_HYBRID_LOOKAHEAD_H
#define BT_HYBRID_LOOKAHEAD_H

#include <cstddef>
#include <vector>

#include "pairs/pair_table.h"

/// Fetches the memory of the pairs that come next: what a pile's pairs know of each other does not fit into a cache,
/// and Bullet comes to them in an order that hardly changes from step to step. Changes no result.
class btHybridLookahead
{
	struct Visit
	{
		const void* m_algorithm;
		int m_index;            ///< of the pair, in its table
		const void* m_planned;  ///< what the planner knows of it; 0 if it does not switch
	};
	std::vector<Visit> m_last;  ///< in the step before
	std::vector<Visit> m_now;
	size_t m_place;  ///< in the step before, of the visit under way

	bool hasComeRound(const void* algorithm, size_t pairs) const;
	void findPlace(const void* algorithm);

public:
	btHybridLookahead() : m_place(0)
	{
	}

	/// What of a pair is fetched, from far ahead to near: each needs what the one before brought.
	enum Stage
	{
		PAIR,
		WAKEFUL,
		CHILDREN,
		CONTACTS,
		NUM_STAGES
	};
	static size_t aheadBy(Stage stage);
	static void fetch(const scatter::pairs::Pair& pair, Stage stage);

	/// Some memory that is going to be read or written.
	static void fetch(const void* from, size_t bytes);

	/// Begins a step. Where nobody says so, in worlds of another kind, it is seen by Bullet coming round.
	void begin();

	/// Bullet has come to a pair of a table; `all`: how many pairs all tables hold.
	void visit(const void* algorithm, int index, const scatter::pairs::PairTable& pairs, size_t all,
	           const void* planned);
};

#endif  // BT_HYBRID_LOOKAHEAD_H
