#ifndef BT_HYBRID_FALLBACK_H
#define BT_HYBRID_FALLBACK_H

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

/// Bullet's own algorithm for a pair of objects, while a shape is none that is known. Must have been released before
/// its end.
class btHybridFallback
{
	btCollisionAlgorithm* m_algorithm;

	btHybridFallback(const btHybridFallback&);
	btHybridFallback& operator=(const btHybridFallback&);

public:
	btHybridFallback() : m_algorithm(0)
	{
	}

	/// Null while there is none.
	btCollisionAlgorithm* get() const
	{
		return m_algorithm;
	}

	/// Takes over an algorithm that was got from the dispatcher; there must be none yet.
	void set(btCollisionAlgorithm* algorithm)
	{
		m_algorithm = algorithm;
	}

	/// Gives the algorithm, if there is one, back to the dispatcher that it was got from.
	void release(btDispatcher* dispatcher)
	{
		if (!m_algorithm)
			return;
		m_algorithm->~btCollisionAlgorithm();
		dispatcher->freeCollisionAlgorithm(m_algorithm);
		m_algorithm = 0;
	}

	/// Adds its manifolds.
	void getManifolds(btManifoldArray& manifolds) const
	{
		if (m_algorithm)
			m_algorithm->getAllContactManifolds(manifolds);
	}
};

#endif  // BT_HYBRID_FALLBACK_H
