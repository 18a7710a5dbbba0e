#ifndef BT_HYBRID_REQUEST_H
#define BT_HYBRID_REQUEST_H

#include <scatter/lod/request.h>

class btCollisionObject;
class btHybridRigidBody;

/// Who asked for a level: one body, a cluster of bodies, or the whole world.
typedef scatter::Scope btHybridScope;
const btHybridScope BT_HYBRID_LOCAL = scatter::Scope::kLocal;
const btHybridScope BT_HYBRID_GROUP = scatter::Scope::kGroup;
const btHybridScope BT_HYBRID_GLOBAL = scatter::Scope::kGlobal;

/// Why a request was withdrawn before it was fulfilled.
enum btHybridRetraction
{
	BT_HYBRID_RETRACTED_BY_CALLER,      ///< by retractRequest, or replaced by another request
	BT_HYBRID_RETRACTED_BY_SEPARATION,  ///< a coarser level is not needed any more: no neighbour is near
	BT_HYBRID_RETRACTED_BY_APPROACH,    ///< a finer level is not wanted any more: a neighbour is near
	BT_HYBRID_RETRACTED_BY_LOAD,        ///< a coarser level is not needed: the load is fine
	BT_HYBRID_RETRACTED_BY_REMOVAL      ///< the body left the world
};

/// A standing wish to change a body's level. It persists until the switch has happened or it is retracted.
struct btHybridRequest
{
	int m_targetLevel;  ///< 0: no request stands
	btHybridScope m_scope;
	bool m_byProximity;   ///< made by the world's own proximity policy
	bool m_acknowledged;  ///< the world has tried it at least once
	int m_tries;          ///< failed tries so far
	int m_stepMade;       ///< the world's step count when it was made
	int m_nextTry;        ///< the world's step count of the next try

	/// Body switching: what the last failed try was too near to; 0 if there was none, or it has left the world.
	const btCollisionObject* m_blockedBy;

	btHybridRequest()
	    : m_targetLevel(0),
	      m_scope(BT_HYBRID_LOCAL),
	      m_byProximity(false),
	      m_acknowledged(false),
	      m_tries(0),
	      m_stepMade(0),
	      m_nextTry(0),
	      m_blockedBy(0)
	{
	}

	bool isStanding() const
	{
		return m_targetLevel != 0;
	}
};

/// What happened to the level of a pair.
typedef scatter::LevelEventKind btHybridPairEventKind;
const btHybridPairEventKind BT_HYBRID_PAIR_REQUESTED =
    scatter::LevelEventKind::kRequested;  ///< a policy wants another level than the pair has, or now wants another one
const btHybridPairEventKind BT_HYBRID_PAIR_ACKNOWLEDGED =
    scatter::LevelEventKind::kAcknowledged;  ///< the pair tries for the first time
const btHybridPairEventKind BT_HYBRID_PAIR_BLOCKED =
    scatter::LevelEventKind::kBlocked;  ///< it is not safe; it will try again
const btHybridPairEventKind BT_HYBRID_PAIR_SWITCHED = scatter::LevelEventKind::kSwitched;
const btHybridPairEventKind BT_HYBRID_PAIR_RETRACTED =
    scatter::LevelEventKind::kRetracted;  ///< not wanted any more, or one of the bodies is gone

struct btHybridPairEvent
{
	btHybridPairEventKind m_kind;
	const btCollisionObject* m_objectA;
	const btCollisionObject* m_objectB;
	int m_fromLevel;  ///< of the pair, before the event
	int m_toLevel;    ///< that is asked for, or was switched to
	btHybridScope m_scope;
	const char* m_policy;  ///< who asked: a policy's name, "governor", "program", or "default"; a constant
	bool m_onCredit;
};

/// Hears what becomes of requests. Called inside stepSimulation (or inside the call that made or retracted
/// the request); must not add or remove bodies.
class btHybridListener
{
public:
	virtual ~btHybridListener()
	{
	}

	virtual void requested(btHybridRigidBody* /*body*/, const btHybridRequest& /*request*/)
	{
	}
	virtual void acknowledged(btHybridRigidBody* /*body*/, const btHybridRequest& /*request*/)
	{
	}

	/// A try failed its safety condition; it is repeated after the retry interval.
	virtual void blocked(btHybridRigidBody* /*body*/, const btHybridRequest& /*request*/)
	{
	}

	/// The body has switched. If request.m_targetLevel differs from toLevel, the request still stands.
	virtual void switched(btHybridRigidBody* /*body*/, int /*fromLevel*/, int /*toLevel*/,
	                      const btHybridRequest& /*request*/)
	{
	}
	virtual void retracted(btHybridRigidBody* /*body*/, const btHybridRequest& /*request*/,
	                       btHybridRetraction /*reason*/)
	{
	}

	/// Pair switching: about two bodies.
	virtual void pairEvent(const btHybridPairEvent& /*event*/)
	{
	}
};

#endif  // BT_HYBRID_REQUEST_H
