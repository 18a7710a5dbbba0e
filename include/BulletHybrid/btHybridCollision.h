#ifndef BT_HYBRID_COLLISION_H
#define BT_HYBRID_COLLISION_H

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <LinearMath/btAlignedObjectArray.h>
#include <scatter/collision/pair_algorithm.h>

/// How the pair algorithm finds the child pairs of two bodies that are near each other.
typedef scatter::PairMidphase btHybridMidphase;
const btHybridMidphase BT_HYBRID_WORLD_BOXES = scatter::PairMidphase::kWorldBoxes;
const btHybridMidphase BT_HYBRID_PART_BOXES = scatter::PairMidphase::kPartBoxes;
const btHybridMidphase BT_HYBRID_NEIGHBOUR_LIST = scatter::PairMidphase::kNeighbourList;

/// The narrowphase of bodies that are lists of convex parts.
struct btHybridCollisionInfo
{
	bool m_pairAlgorithm;  ///< off: Bullet's own algorithms, as in btDiscreteDynamicsWorld

	/// Also for pairs in which neither body has levels, if their shapes are compounds of convex shapes, or one is and
	/// the other one is convex, a plane, a triangle mesh or a height field; and for a bare hull against a hull or a
	/// box, and a bare hull or box on a triangle mesh or a height field. Off, so that a world without hybrids gives the
	/// same bits as btDiscreteDynamicsWorld.
	bool m_plainBodies;

	/// recycling: at most half of gContactBreakingThreshold; less than 0, or no number, is 0.
	scatter::PairSteps m_steps;

	btHybridCollisionInfo() : m_pairAlgorithm(true), m_plainBodies(false)
	{
	}
};

/// Work of the pair algorithm in one step. Exact: the same run after run.
typedef scatter::PairWork btHybridCollisionCounts;

/// What the pair algorithm holds at the moment, without contact manifolds. Pairs that have ended leave their
/// memory, which is not counted, to pairs to come.
struct btHybridCollisionMemory
{
	int m_pairs;              ///< broadphase pairs that have a pair algorithm
	int m_childPairs;         ///< in all neighbour lists
	size_t m_pairBytes;       ///< of all pairs, without their child pairs
	size_t m_childPairBytes;  ///< of all child pairs, room for growth included
	size_t m_bodyBytes;       ///< of all bodies: world bounds, motion
	size_t m_partBytes;       ///< of all part lists: vertices, bounds

	btHybridCollisionMemory()
	    : m_pairs(0), m_childPairs(0), m_pairBytes(0), m_childPairBytes(0), m_bodyBytes(0), m_partBytes(0)
	{
	}
};

/// A child pair that is in contact in Bullet and not in the world, or the other way round.
struct btHybridMissedContact
{
	const btCollisionObject* m_bodyA;
	const btCollisionObject* m_bodyB;
	int m_childA;  ///< index in the body's compound shape; -1 if its shape is not a compound
	int m_childB;
	btScalar m_distance;  ///< of the contact that there is, metres, negative if deep
};

/// How the contacts of hybrid bodies compare with Bullet's, over all verified steps since the verification was turned
/// on.
///
/// Bullet's are those of a plain Bullet collision world with the same objects at the same places, whose manifolds begin
/// each step with the points that the hybrid world's began it with. Compared are child pairs of bodies of which one is
/// a hybrid, that the dispatcher lets collide, whose shapes are convex or compounds of convex children, and children of
/// such a compound with a plane, a triangle mesh or a height field, which counts as one: pairs that were looked at at
/// their finest level: not those that kept the contacts of the step before, nor bodies that are held because they pass
/// through their ground (PairSteps::passages). A pair that begins anew, as it is new, has come back to its finest
/// level, or a shape of it has changed, begins without points in both worlds. A child pair is in contact if it has
/// contact points; of two spheres each point counts, as Bullet finds them anew.
struct btHybridContactReport
{
	int m_steps;        ///< verified
	long m_childPairs;  ///< that Bullet's midphase has let through
	long m_expected;    ///< child pairs in contact in Bullet, but for those in the two last counts
	long m_missed;      ///< of those, not in contact in the world
	long m_extra;       ///< in contact in the world and not in Bullet, but for those in the two last counts

	/// Differences that rounding decides. Of the bounds by which the midphase lets a child pair through: they overlap
	/// by no more than single precision loses on the way to them (about four of its last digits of the coordinates). Or
	/// of the distance: computed in double precision, and proven by a plane on one side and two points on the other, it
	/// differs from the contact breaking threshold, for spheres from zero, by no more than 1e-4 of it, 1e-6 of the
	/// distance of the cores, and that rounding. Or the points are from before the verification, or from before such a
	/// decision.
	long m_doubtful;

	/// Differences in which the same proof shows Bullet to be wrong by more than that: it has found a contact of shapes
	/// that are further apart than the threshold, or none of shapes that are nearer. Its GJK does, with needles, plates
	/// and parts of millimetres, and with triangles of a mesh that has a margin.
	long m_bulletErrs;

	btAlignedObjectArray<btHybridMissedContact> m_lastMissed;  ///< of the last verified step
	btAlignedObjectArray<btHybridMissedContact> m_lastExtra;   ///< of the last verified step

	btHybridContactReport()
	    : m_steps(0), m_childPairs(0), m_expected(0), m_missed(0), m_extra(0), m_doubtful(0), m_bulletErrs(0)
	{
	}
};

#endif  // BT_HYBRID_COLLISION_H
