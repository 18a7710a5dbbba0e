#ifndef BT_HYBRID_PAIR_ALGORITHM_H
#define BT_HYBRID_PAIR_ALGORITHM_H

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include "BulletHybrid/btHybridObservation.h"
#include "collision/part_pair.h"
#include "lod/cost_model.h"

class btHybridLevelBodies;
class btHybridNarrowphase;
class btHybridPairLevel;
class btHybridPartBody;
struct btHybridPairMemory;

/// The narrowphase of two lists of convex parts, owned by their broadphase pair. What is near what is
/// scatter::PartPair's business; manifolds, and the contacts that are Bullet's own, are this one's.
/// Small, because Bullet's pool takes algorithms of any size without looking.
class btHybridPairAlgorithm : public btCollisionAlgorithm
{
	btHybridNarrowphase* m_narrowphase;
	btHybridLevelBodies* m_objects[2];
	btHybridPartBody* m_bodies[2];  ///< the objects at the pair's level
	btHybridPairMemory* m_memory;
	scatter::PartPair* m_pair;         ///< in m_memory, but for an audit
	btCollisionAlgorithm* m_fallback;  ///< Bullet's own, while a shape is no list of parts any more
	int m_versions[2];
	int m_plan;  ///< the pair's place in the planner; -1 without pair switching

	// Of m_pair, so that a pair that is left at once needs no look at it.
	double m_quietUntil;
	int m_jumps;

	struct Pass;
	class LevelScope;

	void takeLevel(int level);
	scatter::lod::PairWorkload workSince(const scatter::PairWork& before, int detectorRuns) const;
	bool staysQuiet(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap);
	void process(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);
	void processPlanned(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);
	void changeLevel(btHybridPairLevel& level, bool wasFinest, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);
	void processLevel(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);
	void audit(btHybridPairLevel& level, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);
	bool mayReuse() const;
	void reuse(btHybridPairLevel& level, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap);
	bool isExcused(scatter::ChildPair& child);
	void restart(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap);
	void releaseContacts();
	void fallBack(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);
	void releaseFallback();
	void processChildren(const Pass& pass);
	static void refresh(btPersistentManifold* manifold, const Pass& pass);
	void processChild(scatter::ChildPair& child, const Pass& pass);
	bool leavesOverlap(const scatter::ChildPair& child, const Pass& pass) const;
	bool isOverlooked(const scatter::ChildPair& child, const Pass& pass) const;
	bool areSpheres(const scatter::ChildPair& child) const;
	void findContacts(scatter::ChildPair& child, const Pass& pass);
	void keepContact(scatter::ChildPair& child, const scatter::PartContact& contact, const Pass& pass);
	void detect(scatter::ChildPair& child, const Pass& pass);
	bool looksFromB(const scatter::ChildPair& child) const;
	bool isOdd(int body, int part) const;
	void detectByGjk(scatter::ChildPair& child, const Pass& pass);
	btPersistentManifold* manifoldOf(scatter::ChildPair& child, const Pass& pass);
	void releaseManifold(scatter::ChildPair& child);

public:
	btHybridPairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, btHybridNarrowphase* narrowphase, const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap);
	virtual ~btHybridPairAlgorithm();

	int getPlanIndex() const
	{
		return m_plan;
	}
	void setPlanIndex(int plan)
	{
		m_plan = plan;
	}

	/// Whether it kept its contacts in the last step instead of looking for them, or was given those that were held.
	bool hasReused() const;

	/// Whether it began anew when it was last at work, because it was new, its level was, or a shape had changed.
	bool hasRestarted() const;

	/// Pair switching: whether the finest shapes overlap deeper than this, or may do.
	bool overlapsFinely(btScalar depth) const;

	virtual void processCollision(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);

	/// Not used by dynamics worlds, which sweep bodies themselves.
	virtual btScalar calculateTimeOfImpact(btCollisionObject* body0, btCollisionObject* body1, const btDispatcherInfo& dispatchInfo, btManifoldResult* resultOut);

	virtual void getAllContactManifolds(btManifoldArray& manifoldArray);

	/// The same, with the credit of each.
	void getManifolds(btAlignedObjectArray<btHybridManifoldView>& manifolds) const;
};

#endif  // BT_HYBRID_PAIR_ALGORITHM_H
