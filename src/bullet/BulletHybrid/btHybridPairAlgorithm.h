#ifndef BT_HYBRID_PAIR_ALGORITHM_H
#define BT_HYBRID_PAIR_ALGORITHM_H

#include "btHybridAlgorithm.h"
#include "btHybridPairEngine.h"
#include "pairs/pair.h"

/// The narrowphase of two lists of convex parts, owned by their broadphase pair: hands Bullet's calls to the pair in
/// the narrowphase's table. Small, because Bullet's pool takes algorithms of any size without looking.
class btHybridPairAlgorithm : public btHybridAlgorithm
{
	btHybridPairBodies m_bodies;
	int m_index;  ///< of the pair, in its table
	int m_planIndex;
	bool m_switches;

	scatter::pairs::Pair& getPair() const;
	bool staysQuiet(const scatter::pairs::PlacedBodies& bodies) const;
	scatter::pairs::PlacedBodies getPlaced() const;
	const scatter::pairs::StepAhead& stepAhead(const btHybridAhead& ahead, const scatter::pairs::PairPlan& plan,
	                                           btHybridStepMemory& memory);
	void takeAhead(const scatter::pairs::StepAhead& step);

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

	virtual void processCollision(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap,
	                              const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);

	virtual bool mayBeForeseen() const;
	virtual bool follow(btDispatcher* dispatcher);
	virtual void fetch(btHybridLookahead::Stage stage) const;
	virtual btHybridForeseen foresee(btHybridAhead& ahead, btHybridStepMemory& memory);
	virtual void takeForeseen(const btHybridForeseen& foreseen);
	virtual void fetchForeseen() const;
	virtual void endForesight(const btHybridForeseen& foreseen);

	virtual void getAllContactManifolds(btManifoldArray& manifoldArray);
	virtual void getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const;
};

#endif  // BT_HYBRID_PAIR_ALGORITHM_H
