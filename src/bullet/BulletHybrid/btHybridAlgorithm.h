#ifndef BT_HYBRID_ALGORITHM_H
#define BT_HYBRID_ALGORITHM_H

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include "BulletHybrid/btHybridObservation.h"
#include "btHybridFallback.h"
#include "btHybridLookahead.h"
#include "btHybridStepMemory.h"

class btHybridNarrowphase;
class btHybridPlanner;

/// What has been found out about the step of a pair before it comes.
struct btHybridForeseen
{
	enum Kind : unsigned char
	{
		NOTHING,
		LATER,    ///< when its portion begins, see scatter::pairs::Planner::portionOf()
		PLAIN,    ///< Bullet's own step, which any thread may make
		IN_PART,  ///< what needs nothing of Bullet; its step makes use of it
		QUIET,    ///< its bodies stay apart
		MADE,     ///< it has been made, which is m_made
		DONE      ///< either, and nothing is left to be told to anyone
	};
	Kind m_kind;
	const scatter::pairs::StepAhead* m_made;

	btHybridForeseen(Kind kind = NOTHING, const scatter::pairs::StepAhead* made = 0) : m_kind(kind), m_made(made)
	{
	}
};

/// The narrowphase of a pair of objects of which at least one is a list of convex parts, owned by their broadphase
/// pair.
class btHybridAlgorithm : public btCollisionAlgorithm
{
	int m_place;  ///< among the pairs of the step under way, if it is foreseen

protected:
	btHybridNarrowphase* const m_narrowphase;
	btHybridFallback m_fallback;

	/// Plans the levels of the pair; 0 if it does not switch.
	btHybridPlanner* getPlanner() const;

	/// Its step is quiet: of what has been found out, and now that it has come.
	btHybridForeseen foreseeQuiet(btHybridStepMemory& memory) const;
	void takeQuiet() const;

	/// Its step has been made, the last of `memory`, by a thread.
	btHybridForeseen foreseeMade(const scatter::pairs::StepAhead& made, btHybridStepMemory& memory) const;

	/// Adds the manifolds of the fallback, which have no credit.
	void addFallback(btAlignedObjectArray<btHybridManifoldView>& manifolds) const
	{
		btManifoldArray own;
		m_fallback.getManifolds(own);
		for (int i = 0; i < own.size(); i++)
		{
			const btHybridManifoldView view = {own[i], 0, false};
			manifolds.push_back(view);
		}
	}

public:
	btHybridAlgorithm(const btCollisionAlgorithmConstructionInfo& info, btHybridNarrowphase* narrowphase)
	    : btCollisionAlgorithm(info), m_place(0), m_narrowphase(narrowphase)
	{
	}

	/// A pair cache may hold pairs of a narrowphase that another one has replaced.
	bool isOf(const btHybridNarrowphase& narrowphase) const
	{
		return m_narrowphase == &narrowphase;
	}

	/// Where btHybridForesight has it; only this can tell whether that is of the step under way.
	void setPlace(int place)
	{
		m_place = place;
	}
	int getPlace() const
	{
		return m_place;
	}

	/// Whether its step is likely to be one that can be foreseen. Changes nothing.
	virtual bool mayBeForeseen() const = 0;

	/// Moves its bodies to where its objects are, if its step is going to come. Whether they are there.
	virtual bool follow(btDispatcher* dispatcher) = 0;

	/// Fetches memory that foresee() is going to need soon.
	virtual void fetch(btHybridLookahead::Stage stage) const = 0;

	/// Finds out about its step what needs nothing of Bullet, or makes it. Any number of pairs at once.
	virtual btHybridForeseen foresee(btHybridAhead& ahead, btHybridStepMemory& memory) = 0;

	/// Its step has come, which is quiet or made: that is its end.
	virtual void takeForeseen(const btHybridForeseen& foreseen) = 0;

	/// Fetches memory that takeForeseen() is going to need soon.
	virtual void fetchForeseen() const = 0;

	/// Its step has not come, or has made use of what was found out.
	virtual void endForesight(const btHybridForeseen& foreseen) = 0;

	/// In the planner; -1 if the pair does not switch.
	virtual int getPlanIndex() const = 0;

	/// Whether its contacts are others than a look finds: it kept those of the step before, was given some that were
	/// held, or holds a body that has passed through its ground.
	virtual bool hasOthers() const = 0;

	/// Whether it began anew when it was last at work, because it was new, its level was, or a shape had changed.
	virtual bool hasRestarted() const = 0;

	/// All manifolds, with the credit of each.
	virtual void getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const = 0;

	/// Not used by dynamics worlds, which sweep bodies themselves.
	virtual btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
	                                       btManifoldResult*)
	{
		return 1;
	}
};

#endif  // BT_HYBRID_ALGORITHM_H
