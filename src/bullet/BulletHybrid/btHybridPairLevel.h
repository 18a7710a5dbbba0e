#ifndef BT_HYBRID_PAIR_LEVEL_H
#define BT_HYBRID_PAIR_LEVEL_H

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include "btHybridNarrowphase.h"
#include "lod/cost_model.h"

class btHybridPlanner;

/// The level of one pair, for one step of its narrowphase: asks the planner what it should be and the shapes whether
/// that is safe, and keeps the account of penetration credit.
class btHybridPairLevel
{
	btHybridNarrowphase& m_narrowphase;
	btHybridPlanner& m_planner;
	btHybridLevelBodies* const* m_objects;
	btHybridPairMemory& m_memory;
	int m_plan;
	const btTransform& m_transform0;
	const btTransform& m_transform1;
	scatter::Frame m_frameB;  ///< of the second object, in the first one's frame; once it was asked for
	bool m_hasFrame;
	int m_partsLevel;  ///< whose parts the contacts are of: in a switch the level before, until open()

	btScalar m_least;      ///< distance of the pair's contacts
	btScalar m_press;      ///< how deep they press the bodies apart, metres
	btScalar m_mostPress;  ///< and may do after a switch: as deep as those of the level before, where the bodies are now
	int m_contacts;
	int m_manifolds;

	const scatter::Frame& getFrameB();
	const scatter::PartList& getParts(int object, int level);
	bool isSeparated(int level, btScalar gap);
	float depthOf(int a, int b);
	float findGap();
	void openCredit();
	void openFinestCredit();
	void measureContactsBefore();
	void freshen(float gap);
	void shrinkCredit();
	void settleContacts(const btAlignedObjectArray<int>& awake, bool hadCredit);
	void settleChild(const scatter::ChildPair& child, bool hadCredit);
	void checkSwitch() const;
	btScalar getEasedOverlap() const;
	void easeHeld();
	static void credit(btPersistentManifold* manifold, float credit);
	static void ease(btManifoldPoint& point);
	static void endCredit(btPersistentManifold* manifold);

public:
	/// transforms: where the objects are.
	btHybridPairLevel(btHybridNarrowphase& narrowphase, btHybridLevelBodies* const* objects, btHybridPairMemory& memory, int plan, const btTransform& transform0, const btTransform& transform1);

	/// Before the narrowphase: whether the pair changes its level. The contacts it has are to be dropped then, or, on credit
	/// at a coarser level than the finest, those of its finest level are to be held; after that, open().
	bool choose();

	/// A switch away from the finest level, on credit: its contacts were looked for once more, for the child pairs `awake`.
	void settleFinest(const btAlignedObjectArray<int>& awake);

	/// A switch: opens the account of the new level.
	void open();

	/// The pair's level, 1 the coarsest.
	int getLevel() const;
	int getFinest() const;
	bool isOnCredit() const
	{
		return m_memory.m_onCredit;
	}

	/// After the narrowphase: adds credit to the contacts of the child pairs that are awake.
	void settleCredit(const btAlignedObjectArray<int>& awake);

	/// Whether the contacts held are of use: on credit, and after its end until the pair has moved.
	bool keepsHeld() const;

	/// Whether the pair is on credit and has moved so far that its finest shapes must be looked at.
	bool needsAudit() const;

	/// An audit: whether the finest shapes are so near that they may have contacts, which are to be looked for. Then, with
	/// those found and held, takes the gap between the finest shapes for the credit.
	bool mayTouch();
	void takeAudit();

	/// Tells the planner what the pair has cost.
	void report(scatter::lod::PairWorkload& work);
};

#endif  // BT_HYBRID_PAIR_LEVEL_H
