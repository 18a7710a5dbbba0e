#ifndef BT_HYBRID_GROUND_ALGORITHM_H
#define BT_HYBRID_GROUND_ALGORITHM_H

#include "btHybridAlgorithm.h"
#include "btHybridGroundEngine.h"
#include "pairs/ground_pair.h"

/// The narrowphase of a list of convex parts and what it may lie on: hands Bullet's calls to the pair in the
/// narrowphase's table. As in Bullet, each part has one manifold for all of the ground, with the part's body first.
/// Small, because Bullet's pool takes algorithms of any size without looking.
class btHybridGroundAlgorithm : public btHybridAlgorithm
{
	btHybridGroundBodies* m_bodies;
	btHybridLevelBodies* m_ground;  ///< for the planner; 0 if the pair does not switch
	int m_index;                    ///< of the pair, in its table
	int m_planIndex;

	scatter::pairs::GroundPair& getPair() const;
	scatter::pairs::PlacedBody getPlaced() const;
	void shareGround();
	void stepAhead(scatter::pairs::StepAhead& step, const scatter::pairs::PairPlan& plan, btHybridGroundEngine& engine,
	               btHybridStepMemory& memory);
	void takeAhead(const scatter::pairs::StepAhead& step);
	bool isSettled() const;
	bool staysQuiet(btHybridGroundEngine& engine) const;

public:
	/// side: of the body of parts in the pair, 0 or 1.
	btHybridGroundAlgorithm(const btCollisionAlgorithmConstructionInfo& info, btHybridNarrowphase* narrowphase,
	                        const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap,
	                        int side);
	virtual ~btHybridGroundAlgorithm();

	virtual int getPlanIndex() const
	{
		return m_planIndex;
	}
	virtual bool hasOthers() const;
	virtual bool hasRestarted() const;

	virtual bool mayBeForeseen() const;
	virtual bool follow(btDispatcher* dispatcher);
	virtual void fetch(btHybridLookahead::Stage) const
	{
	}
	virtual btHybridForeseen foresee(btHybridAhead& ahead, btHybridStepMemory& memory);
	virtual void takeForeseen(const btHybridForeseen& foreseen);
	virtual void fetchForeseen() const;
	virtual void endForesight(const btHybridForeseen& foreseen);

	virtual void processCollision(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap,
	                              const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);
	virtual void getAllContactManifolds(btManifoldArray& manifoldArray);
	virtual void getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const;
};

#endif  // BT_HYBRID_GROUND_ALGORITHM_H
