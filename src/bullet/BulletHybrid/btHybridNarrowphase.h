#ifndef BT_HYBRID_NARROWPHASE_H
#define BT_HYBRID_NARROWPHASE_H

#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <LinearMath/btHashMap.h>

#include "BulletHybrid/btHybridCollision.h"
#include "btHybridPartBody.h"
#include "btHybridParts.h"
#include "collision/part_pair.h"

class btCollisionDispatcher;
class btDispatcher;

/// Registers the pair algorithm with a dispatcher and holds what its pairs share. Counted by its owner and
/// by the pair algorithms, because these live as long as their broadphase pairs.
class btHybridNarrowphase
{
	/// Stands in for the create functions of one pair of shape types.
	struct CreateFunc : public btCollisionAlgorithmCreateFunc
	{
		btHybridNarrowphase* m_narrowphase;
		btCollisionAlgorithmCreateFunc* m_default;

		virtual btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap);
	};

	struct PooledPair : public scatter::PartPair
	{
		int m_index;  ///< in m_pairs
	};

	btHybridCollisionInfo m_info;
	scatter::PairSteps m_steps;
	scatter::PairWork m_work;
	int m_detectorRuns;
	mutable btHybridCollisionCounts m_counts;
	int m_step;
	bool m_dispatches;  ///< a step's pairs are at work, so that shapes do not change
	int m_users;

	btCollisionDispatcher* m_dispatcher;  ///< 0 if it takes no create functions, or runs pairs in parallel
	btAlignedObjectArray<CreateFunc> m_createFuncs;

	btHashMap<btHashPtr, btHybridPartBody*> m_bodies;
	btHashMap<btHashPtr, btHybridParts*> m_parts;
	scatter::PairScratch m_pairScratch;
	btAlignedObjectArray<int> m_scratch;
	btAlignedObjectArray<PooledPair*> m_pairs;      ///< in use
	btAlignedObjectArray<PooledPair*> m_freePairs;  ///< kept for their memory

	~btHybridNarrowphase();
	btHybridNarrowphase(const btHybridNarrowphase&);
	btHybridNarrowphase& operator=(const btHybridNarrowphase&);

	bool takes(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap) const;
	btHybridParts* acquireParts(const btCollisionShape* shape);
	void releaseParts(btHybridParts* parts);
	void replaceParts(btHybridPartBody* body, const btCollisionShape* shape);

public:
	explicit btHybridNarrowphase(btDispatcher* dispatcher);

	/// By its owner: takes the create functions back. Pair algorithms must not outlive the dispatcher.
	void retire();
	void addUser()
	{
		m_users++;
	}
	void removeUser();

	const btHybridCollisionInfo& getInfo() const
	{
		return m_info;
	}
	const scatter::PairSteps& getSteps() const
	{
		return m_steps;
	}
	void setInfo(const btHybridCollisionInfo& info);

	void beginStep();

	/// Around the dispatch of a step's pairs.
	void setDispatching(bool dispatches)
	{
		m_dispatches = dispatches;
	}

	int getDispatcherFlags() const;

	/// Of the step under way.
	scatter::PairWork& getWork()
	{
		return m_work;
	}
	void countDetectorRun()
	{
		m_detectorRuns++;
	}
	const btHybridCollisionCounts& getCounts() const;
	btHybridCollisionMemory getMemory() const;

	scatter::PairScratch& getPairScratch()
	{
		return m_pairScratch;
	}

	/// Memory for the inside of one function.
	btAlignedObjectArray<int>& getScratch()
	{
		return m_scratch;
	}

	btHybridPartBody* acquireBody(const btCollisionObjectWrapper* wrap);
	void releaseBody(btHybridPartBody* body);

	/// Takes in a changed shape, and where the body is. False if the shape is no part list any more.
	bool updateBody(btHybridPartBody* body, const btCollisionObjectWrapper* wrap);

	scatter::PartPair* acquirePair();
	void releasePair(scatter::PartPair* pair);
};

#endif  // BT_HYBRID_NARROWPHASE_H
