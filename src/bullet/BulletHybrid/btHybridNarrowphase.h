#ifndef BT_HYBRID_NARROWPHASE_H
#define BT_HYBRID_NARROWPHASE_H

#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <LinearMath/btHashMap.h>

#include "BulletHybrid/btHybridCollision.h"
#include "btHybridHeldContacts.h"
#include "btHybridLevelBodies.h"
#include "btHybridPartBody.h"
#include "btHybridParts.h"
#include "collision/part_pair.h"
#include "collision/part_query.h"
#include "lod/credit.h"

class btCollisionDispatcher;
class btDispatcher;
class btHybridDynamicsWorld;
class btHybridPlanner;

/// What a pair remembers, in memory that is pooled.
struct btHybridPairMemory
{
	scatter::PartPair m_parts;
	scatter::lod::CreditAccount m_credit;
	btHybridHeldContacts m_held;
	double m_freshUntil;  ///< the pair's motion up to which the held contacts are good, and no others can have come up
	double m_latest;      ///< and how much later an audit may come
	double m_seenMotion;  ///< the pair's motion, when it was last looked at
	float m_units;        ///< what it costs a step, on average, while on credit

	btScalar m_overlap;  ///< of the finest shapes, that their contacts did not press when the pair left its finest level
	float m_gap;         ///< between the finest shapes, when it was last measured for the credit
	btScalar m_least;    ///< distance of its contacts after the last step
	bool m_switched;     ///< its level is new in this step
	bool m_onCredit;     ///< and was taken on credit
	bool m_mayAudit;     ///< in this step
	bool m_excuses;      ///< child pairs on credit have no contacts of their own while those that are held are good
	bool m_returns;      ///< gives the contacts held back to its child pairs, being at the finest level again
	bool m_returned;     ///< did so when it was last looked at
	bool m_reused;       ///< kept the contacts of the step before
	bool m_restarted;    ///< dropped all contacts when it was last looked at
	int m_index;         ///< in the pool
};

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

	btHybridCollisionInfo m_info;
	scatter::PairSteps m_steps;
	scatter::PairWork m_work;
	int m_detectorRuns;
	mutable btHybridCollisionCounts m_counts;
	int m_step;
	bool m_dispatches;  ///< a step's pairs are at work, so that shapes do not change
	int m_users;

	const btHybridDynamicsWorld* m_world;  ///< its owner; only an address, as it may be gone
	btCollisionDispatcher* m_dispatcher;   ///< 0 if it is not in charge there
	const char* m_mistake;                 ///< and why
	btHybridNarrowphase* m_next;           ///< of those in charge
	btAlignedObjectArray<CreateFunc> m_createFuncs;

	btHashMap<btHashPtr, btHybridLevelBodies*> m_objects;
	btHashMap<btHashPtr, btHybridParts*> m_parts;
	scatter::PairScratch m_pairScratch;
	scatter::PartQuery m_query;
	scatter::PartPair m_auditPair;
	btAlignedObjectArray<int> m_scratch;
	btAlignedObjectArray<btHybridPairMemory*> m_pairs;      ///< in use
	btAlignedObjectArray<btHybridPairMemory*> m_freePairs;  ///< kept for their memory
	btHybridPlanner* m_planner;

	~btHybridNarrowphase();
	btHybridNarrowphase(const btHybridNarrowphase&);
	btHybridNarrowphase& operator=(const btHybridNarrowphase&);

	const char* takeCharge(btDispatcher* dispatcher);
	void registerCreateFuncs();
	bool isForeign(const btCollisionObjectWrapper* wrap) const;
	bool hasPartLists(const btCollisionObjectWrapper* wrap) const;
	bool takes(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap) const;
	btHybridParts* acquireParts(const btCollisionShape* shape);
	void releaseParts(btHybridParts* parts);
	void replaceParts(btHybridPartBody* body, const btCollisionShape* shape);

public:
	/// With pair switching it has a planner.
	btHybridNarrowphase(btDispatcher* dispatcher, const btHybridDynamicsWorld* world, bool switchesPairs);

	/// 0, or why it is not in charge of the dispatcher's hybrid pairs, and how to mend it.
	const char* getMistake() const
	{
		return m_mistake;
	}

	/// Of the levels of pairs; 0 without pair switching.
	btHybridPlanner* getPlanner()
	{
		return m_planner;
	}
	const btHybridPlanner* getPlanner() const
	{
		return m_planner;
	}

	/// Starts anew with a planner or without one. No pair algorithm must be left.
	void setSwitchesPairs(bool switchesPairs);

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
	int getDetectorRuns() const
	{
		return m_detectorRuns;
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

	/// For a look at the finest level of a pair that is at a coarser one.
	scatter::PartPair& getAuditPair()
	{
		return m_auditPair;
	}

	scatter::PartQuery& getQuery()
	{
		return m_query;
	}

	/// Memory for the inside of one function.
	btAlignedObjectArray<int>& getScratch()
	{
		return m_scratch;
	}

	btHybridLevelBodies* acquireObject(const btCollisionObject* object);
	void releaseObject(btHybridLevelBodies* object);

	/// The object with the shape of one of its levels.
	btHybridPartBody* getBody(btHybridLevelBodies* object, int level);

	/// Takes in a changed shape, and where the body is. False if the shape is no part list any more.
	bool updateBody(btHybridPartBody* body, const btCollisionShape* shape, const btTransform& transform);

	btHybridPairMemory* acquirePair();
	void releasePair(btHybridPairMemory* pair);
};

#endif  // BT_HYBRID_NARROWPHASE_H
