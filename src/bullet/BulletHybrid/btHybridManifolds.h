#ifndef BT_HYBRID_MANIFOLDS_H
#define BT_HYBRID_MANIFOLDS_H

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include "btHybridConversions.h"
#include "pairs/manifolds.h"

/// Bullet's manifolds, and their points as pairs look at them.
class btHybridContacts
{
	// What this library takes the error reduction of a point away with.
	static const int c_easeFlags = BT_CONTACT_FLAG_HAS_CONTACT_ERP | BT_CONTACT_FLAG_HAS_CONTACT_CFM;

public:
	static btPersistentManifold* at(void* manifold)
	{
		return static_cast<btPersistentManifold*>(manifold);
	}
	static const btPersistentManifold* at(const void* manifold)
	{
		return static_cast<const btPersistentManifold*>(manifold);
	}

	static scatter::pairs::ContactPoint read(const btManifoldPoint& point);
	static void addTo(scatter::pairs::ContactTally& tally, const btPersistentManifold& manifold);
	static void write(const scatter::pairs::ContactPoint& plain, btManifoldPoint& point);
	static void move(btManifoldPoint& point, btPersistentManifold* to);
	static void addImpulses(const btManifoldPoint& from, btManifoldPoint& to);
	static float carry(btPersistentManifold* manifold, const btCollisionObject* a, const btCollisionObject* b);
	static void prefetch(const void* manifold);

	/// Of the same, what says whose it is.
	static void prefetchObjects(const void* manifold);

	/// Whether any point is going to be left by refreshContactPoints(), with the bodies where they are. Changes
	/// nothing.
	static bool wouldOutlast(const btPersistentManifold& manifold);

	/// What carry() is going to return. Changes nothing.
	static float wouldSlide(const btPersistentManifold& manifold);
	static btScalar getThreshold(const btCollisionDispatcher* dispatcher, const btCollisionObject* a,
	                             const btCollisionObject* b);
};

/// The part of an engine that is about manifolds.
template <class Engine>
class btHybridManifolds : public Engine
{
protected:
	btCollisionDispatcher* m_dispatcher;
	const btCollisionObjectWrapper* m_wraps[2];  ///< in the order of a manifold's bodies

	btHybridManifolds(btCollisionDispatcher* dispatcher, const btCollisionObjectWrapper* body0,
	                  const btCollisionObjectWrapper* body1)
	    : m_dispatcher(dispatcher), m_wraps{body0, body1}
	{
	}

public:
	virtual bool outlasts(void* manifold) const
	{
		btHybridContacts::at(manifold)->refreshContactPoints(m_wraps[0]->getCollisionObject()->getWorldTransform(),
		                                                     m_wraps[1]->getCollisionObject()->getWorldTransform());
		return countPoints(manifold) > 0;
	}
	virtual void* newManifold()
	{
		return m_dispatcher->getNewManifold(m_wraps[0]->getCollisionObject(), m_wraps[1]->getCollisionObject());
	}
	virtual void release(void* manifold)
	{
		m_dispatcher->releaseManifold(btHybridContacts::at(manifold));
	}
	virtual int countPoints(const void* manifold) const
	{
		return btHybridContacts::at(manifold)->getNumContacts();
	}
	virtual bool isFull(const void* manifold) const
	{
		return countPoints(manifold) == MANIFOLD_CACHE_SIZE;
	}
	virtual scatter::pairs::ContactPoint point(const void* manifold, int index) const
	{
		return btHybridContacts::read(btHybridContacts::at(manifold)->getContactPoint(index));
	}
	virtual void addTo(scatter::pairs::ContactTally& tally, const void* manifold) const
	{
		btHybridContacts::addTo(tally, *btHybridContacts::at(manifold));
	}
	virtual void write(void* manifold, int index, const scatter::pairs::ContactPoint& plain)
	{
		btHybridContacts::write(plain, btHybridContacts::at(manifold)->getContactPoint(index));
	}
	virtual float carry(void* manifold)
	{
		return btHybridContacts::carry(btHybridContacts::at(manifold), m_wraps[0]->getCollisionObject(),
		                               m_wraps[1]->getCollisionObject());
	}
	virtual float distanceNow(const void* manifold, int index) const
	{
		const btManifoldPoint& point = btHybridContacts::at(manifold)->getContactPoint(index);
		return (m_wraps[0]->getWorldTransform()(point.m_localPointA) -
		        m_wraps[1]->getWorldTransform()(point.m_localPointB))
		    .dot(point.m_normalWorldOnB);
	}
	virtual void move(void* from, int index, void* to)
	{
		btHybridContacts::move(btHybridContacts::at(from)->getContactPoint(index), btHybridContacts::at(to));
	}
	virtual void addImpulses(const void* from, int index, void* to, int indexTo)
	{
		btHybridContacts::addImpulses(btHybridContacts::at(from)->getContactPoint(index),
		                              btHybridContacts::at(to)->getContactPoint(indexTo));
	}
	virtual void prefetch(const void* manifold) const
	{
		btHybridContacts::prefetch(manifold);
	}
	virtual float threshold() const
	{
		return btHybridContacts::getThreshold(m_dispatcher, m_wraps[0]->getCollisionObject(),
		                                      m_wraps[1]->getCollisionObject());
	}
};

#endif  // BT_HYBRID_MANIFOLDS_H
