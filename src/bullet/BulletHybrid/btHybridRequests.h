#ifndef BT_HYBRID_REQUESTS_H
#define BT_HYBRID_REQUESTS_H

#include "BulletHybrid/btHybridRigidBody.h"
#include "BulletHybrid/btHybridSwitching.h"

/// The requests for the levels of a world's bodies: makes, retracts and fulfils them, counts that and tells the
/// listener.
class btHybridRequests
{
	btHybridListener* m_listener;
	btHybridStepInfo m_stepInfo;
	btHybridStepInfo m_counting;  ///< of the step under way, and of calls since the last one
	int m_step;
	int m_standing;

	btHybridRequests(const btHybridRequests&);
	btHybridRequests& operator=(const btHybridRequests&);

public:
	btHybridRequests() : m_listener(0), m_step(0), m_standing(0)
	{
	}

	void setListener(btHybridListener* listener)
	{
		m_listener = listener;
	}
	btHybridListener* getListener() const
	{
		return m_listener;
	}

	void beginStep()
	{
		m_step++;
	}
	int getStep() const
	{
		return m_step;
	}

	/// Ends the counts of a step.
	void endStep();
	const btHybridStepInfo& getStepInfo() const
	{
		return m_stepInfo;
	}

	int getNumStanding() const
	{
		return m_standing;
	}

	/// Replaces one that stands.
	void make(btHybridRigidBody* body, int level, btHybridScope scope, bool byProximity);
	void retract(btHybridRigidBody* body, btHybridRetraction reason);

	/// Before the first try.
	void acknowledge(btHybridRigidBody* body);

	/// A try has failed; the next one is `retryInterval` steps after this one.
	void countQuery()
	{
		m_counting.m_separationQueries++;
	}
	void delay(btHybridRigidBody* body, int retryInterval);
	void setObstacle(btHybridRigidBody* body, const btCollisionObject* obstacle);
	void block(btHybridRigidBody* body);

	/// The body has this level now; the request ends if that is what it asked for.
	void fulfil(btHybridRigidBody* body, int level);
};

#endif  // BT_HYBRID_REQUESTS_H
