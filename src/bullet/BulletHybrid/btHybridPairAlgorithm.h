#ifndef BT_HYBRID_PAIR_ALGORITHM_H
#define BT_HYBRID_PAIR_ALGORITHM_H

#include "btHybridAlgorithm.h"
#include "btHybridPairEngine.h"
#include "pairs/pair.h"

class btHybridNarrowphase;

/// The narrowphase of two lists of convex parts, owned by their broadphase pair: hands Bullet's calls to the pair in
/// the narrowphase's table. Small, because Bullet's pool takes algorithms of any size without looking.
class btHybridPairAlgorithm : public btHybridAlgorithm
{
	btHybridNarrowphase* m_narrowphase;
	btHybridPairBodies m_bodies;
	int m_index;  ///< of the pair, in its table
	int m_planIndex;
	bool m_switches;

	/// What is known of the step under way, until it comes.
	enum Foreseen : unsigned char
	{
		NOTHING,
		QUIET,    ///< it stays quiet
		COUNTED,  ///< and has been counted as such
		MADE      ///< it has been made
	};
	Foreseen m_foreseen;

	scatter::pairs::Pair& getPair() const;
	bool staysQuiet(const scatter::pairs::PlacedBodies& bodies) const;
	scatter::pairs::PlacedBodies getPlaced() const;
	void stepAhead(const btHybridAhead& ahead, btHybridStepMemory& memory);
	void takeAhead();
	void takeQuiet();
	void foreseeQuiet(btHybridStepMemory& memory);

public:
	btHybridPairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, btHybridNarrowphase* narrowphase,
	                      const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap);
	virtual ~btHybridPairAlgorithm();

	virtual int getPlanIndex() const
	{
		return m_planIndex;
	}
	virtual bool hasOthers() const;
	virtual bool hasRestarted() const;

	/// Whether its step has been made already, or its bodies are known to stay apart in it: it is done then.
	bool passBy();

	/// Fetches memory that passBy() is going to need soon.
	void fetchNext() const;

	virtual void processCollision(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap,
	                              const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);

	virtual bool mayBeForeseen() const;
	virtual bool follow(btDispatcher* dispatcher);
	virtual void fetch(btHybridLookahead::Stage stage) const;
	virtual void foresee(btHybridAhead& ahead, btHybridStepMemory& memory);
	virtual void endForesight();

	virtual void getAllContactManifolds(btManifoldArray& manifoldArray);
	virtual void getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const;
};

#endif  // BT_HYBRID_PAIR_ALGORITHM_H
