#ifndef BT_HYBRID_BRUTE_FORCE_H
#define BT_HYBRID_BRUTE_FORCE_H

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>

/// A convex child at its world pose.
struct btHybridConvexChild
{
	const btCollisionShape* m_shape;
	btTransform m_transform;
	btVector3 m_min;
	btVector3 m_max;
	const btDbvtNode* m_leaf;  ///< in its compound's tree; 0 without one
	int m_index;               ///< -1 for a bare shape
	btScalar m_rounding;       ///< metres: what single precision may lose on the way to a distance or a bound

	btHybridConvexChild(const btCollisionShape* shape, const btTransform& body, const btTransform& transform, int index, const btDbvtNode* leaf);
};

/// A collision object as its convex children.
struct btHybridConvexSide
{
	const btCollisionObject* m_object;
	const btCompoundShape* m_compound;  ///< 0 for a bare convex shape
	btAlignedObjectArray<btHybridConvexChild> m_children;

	/// False if the shape is neither convex nor a compound of convex children.
	bool collect(const btCollisionObject* object);
};

/// Whether Bullet's midphase hands a child pair on to a detector. Rounding must not decide: the sign of the
/// slack says which way doubt goes. One that is new must pass the tree of leaves as well as the world bounds.
bool btHybridMidphaseKeeps(const btHybridConvexSide& a, const btHybridConvexChild& childA, const btHybridConvexSide& b, const btHybridConvexChild& childB, bool isNew, btScalar slack);

bool btHybridAreBoxes(const btHybridConvexChild& childA, const btHybridConvexChild& childB);

/// Whether a separating plane shows the children, as Bullet's GJK sees them, to be too far apart for a contact.
/// Gilbert's algorithm: slow, and of the same accuracy at every scale. See Gilbert, "An iterative procedure for
/// computing the minimum of a quadratic form on a convex set", 1966.
bool btHybridIsProvenApart(const btHybridConvexChild& childA, const btHybridConvexChild& childB, btScalar threshold);

/// Bullet's detectors for one child pair at a time, without memory of earlier steps, and without a trace in the
/// world: with a dispatcher of its own, as the order of manifolds matters to a solver, and while it lives
/// Bullet's global contact callbacks, which are the user's, are away.
class btHybridBruteForce
{
	ContactAddedCallback m_added;
	ContactProcessedCallback m_processed;
	ContactDestroyedCallback m_destroyed;
	ContactStartedCallback m_started;
	ContactEndedCallback m_ended;
	CalculateCombinedCallback m_combiners[6];

	btDefaultCollisionConfiguration m_configuration;
	btCollisionDispatcher* m_dispatcher;
	btDispatcherInfo m_info;
	btManifoldArray m_manifolds;
	btScalar m_threshold;

	btHybridBruteForce(const btHybridBruteForce&);
	btHybridBruteForce& operator=(const btHybridBruteForce&);

	void silenceCallbacks();
	bool ask(const btHybridConvexSide& a, const btHybridConvexChild& childA, const btHybridConvexSide& b, const btHybridConvexChild& childB, btScalar& distance);
	bool readManifold(const btPersistentManifold& manifold, const btHybridConvexChild& childA, const btHybridConvexChild& childB, btScalar& distance);

public:
	/// `model` is the world's dispatcher.
	explicit btHybridBruteForce(const btDispatcher* model);
	~btHybridBruteForce();

	/// The contact breaking threshold of the last contact found.
	btScalar getThreshold() const
	{
		return m_threshold;
	}

	/// Whether there is a contact safely within the threshold, and the smallest distance. The order of the
	/// two is Bullet's, unless reversed.
	bool findContact(const btHybridConvexSide& a, const btHybridConvexChild& childA, const btHybridConvexSide& b, const btHybridConvexChild& childB, bool reversed, btScalar& distance);
};

#endif  // BT_HYBRID_BRUTE_FORCE_H
