#ifndef BT_HYBRID_OBJECTS_H
#define BT_HYBRID_OBJECTS_H

#include <LinearMath/btHashMap.h>

#include "btHybridLevelBodies.h"
#include "btHybridPartBody.h"
#include "btHybridParts.h"

struct btHybridCollisionMemory;

/// The collision objects of all pairs, with the part lists of their shapes: each is made once, and shared by those who
/// use it.
class btHybridObjects
{
	btHashMap<btHashPtr, btHybridLevelBodies*> m_objects;
	btHashMap<btHashPtr, btHybridParts*> m_parts;
	int m_step;
	bool m_dispatches;  ///< a step's pairs are at work, so that shapes do not change
	bool m_isTold;      ///< when steps begin and dispatch, so that a thorough look is due once a step

	btHybridObjects(const btHybridObjects&);
	btHybridObjects& operator=(const btHybridObjects&);

	btHybridParts* acquireParts(const btCollisionShape* shape);
	void releaseParts(btHybridParts* parts);
	void replaceParts(btHybridPartBody* body, const btCollisionShape* shape);

public:
	btHybridObjects() : m_step(0), m_dispatches(false), m_isTold(false)
	{
	}

	void beginStep()
	{
		m_step++;
	}

	/// Around the dispatch of a step's pairs.
	void setDispatching(bool dispatches)
	{
		m_isTold = true;
		m_dispatches = dispatches;
	}

	bool isDispatching() const
	{
		return m_dispatches;
	}

	/// hasLevels: a hybrid's levels are those of its pairs.
	btHybridLevelBodies* acquire(const btCollisionObject* object, bool hasLevels);
	void release(btHybridLevelBodies* object);

	/// 0 if it is in no pair.
	const btHybridLevelBodies* find(const btCollisionObject* object) const
	{
		btHybridLevelBodies* const* known = m_objects.find(btHashPtr(object));
		return known ? *known : 0;
	}

	/// The object with the shape of one of its levels.
	btHybridPartBody* getBody(btHybridLevelBodies* object, int level);

	/// Takes in a changed shape, and where the body is. False if the shape is no part list any more.
	bool update(btHybridPartBody* body, const btCollisionShape* shape, const btTransform& transform);

	/// The same of a body whose shape may change in place; others stay where they are.
	bool refresh(btHybridPartBody* body, const btTransform& transform);

	/// Adds what it holds.
	void count(btHybridCollisionMemory& memory) const;
};

#endif  // BT_HYBRID_OBJECTS_H
