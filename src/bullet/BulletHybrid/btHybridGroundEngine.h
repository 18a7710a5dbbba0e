#ifndef BT_HYBRID_GROUND_ENGINE_H
#define BT_HYBRID_GROUND_ENGINE_H

#include <vector>

#include "btHybridFallback.h"
#include "btHybridGround.h"
#include "btHybridLevelBodies.h"
#include "btHybridManifolds.h"
#include "btHybridObjects.h"
#include "btHybridPartBody.h"
#include "btHybridPartBounds.h"
#include "pairs/ground_engine.h"

class btManifoldResult;
struct btDispatcherInfo;

/// A body of parts and its ground, of one pair of objects.
struct btHybridGroundBodies
{
	btHybridLevelBodies* m_object;
	const btCollisionObject* m_groundObject;
	btHybridPartBody* m_body;  ///< with the shape of the level that the pair has looked at last
	btHybridGround m_ground;
	int m_level;
	int m_side;  ///< of the body in the pair of objects, 0 or 1
	bool m_switches;

	btHybridGroundBodies(btHybridLevelBodies* object, const btCollisionObject* ground, int side, bool switches)
	    : m_object(object), m_groundObject(ground), m_body(0), m_level(-1), m_side(side), m_switches(switches)
	{
	}

	void take(int level, btHybridObjects& objects);
};

/// What one call of processCollision was given; the body first.
struct btHybridGroundCall
{
	const btCollisionObjectWrapper* m_body;
	const btCollisionObjectWrapper* m_ground;
	const btDispatcherInfo& m_info;
	btManifoldResult* m_result;
};

/// How far a body is about to move against its ground at their velocities, in the ground's frame. Of links of
/// multi-bodies Bullet keeps no velocity where this could find it.
scatter::Vec3 btHybridWayAhead(const btCollisionObject* body, const btCollisionObject* ground, btScalar timeStep);

/// Bullet, as a body of parts and its ground see it in one step.
class btHybridGroundEngine : public btHybridManifolds<scatter::pairs::GroundEngine>
{
	btHybridObjects& m_objects;
	btHybridGroundBodies& m_bodies;
	const btHybridGroundCall& m_call;
	btHybridFallback& m_fallback;
	btCollisionObjectWrapper m_levelWrap;  ///< the body with the shape of its level
	bool m_isBounded;                      ///< the ground's bounds are known
	btVector3 m_groundMin[2];              ///< in the world, and in the body's frame
	btVector3 m_groundMax[2];
	std::vector<btHybridPartBounds>& m_parts;

	btTransform getPartTransform(int part) const;
	void boundGround();
	const btHybridPartBounds& getBounds(int part);
	bool meetsInWorld(int part);
	bool meetsLeaf(int part);

public:
	/// parts: memory that engines use in turn. All must outlive it.
	btHybridGroundEngine(btCollisionDispatcher* dispatcher, btHybridObjects& objects, btHybridGroundBodies& bodies,
	                     const btHybridGroundCall& call, btHybridFallback& fallback,
	                     std::vector<btHybridPartBounds>& parts);

	/// Where the two are, with the shapes that were looked at last; no contacts are going to be looked for.
	bool follow(scatter::pairs::PlacedBody& body);

	virtual bool place(int level, scatter::pairs::PlacedBody& body);
	virtual scatter::Frame groundFrame() const;
	virtual scatter::Vec3 wayAhead() const;
	virtual int groundVersion();
	virtual float groundMargin() const;
	virtual std::optional<scatter::pairs::HalfSpace> halfSpace() const;
	virtual bool collect(const scatter::Vec3& low, const scatter::Vec3& high, scatter::pairs::GroundPieces& pieces);
	virtual float reach(const scatter::Vec3& direction) const;
	virtual bool fallBack();
	virtual void looked(void* manifold);
	virtual bool letsMeet(int part) const;
	virtual bool keeps(int part);
	virtual bool mayMeet(const scatter::pairs::GroundPieces& pieces, const scatter::ChildPair& child);
	virtual void add(void* manifold, const scatter::pairs::GroundPieces& pieces, const scatter::ChildPair& child,
	                 const scatter::PartContact& contact, const scatter::Frame& frame);
	virtual bool find(void* manifold, const scatter::pairs::GroundPieces& pieces, const scatter::ChildPair& child,
	                  const scatter::Frame& frame, scatter::PartContact& contact);
	virtual void detect(void* manifold, const scatter::pairs::GroundPieces& pieces, const scatter::ChildPair& child);
};

#endif  // BT_HYBRID_GROUND_ENGINE_H
