#ifndef BT_HYBRID_INSTALLATION_H
#define BT_HYBRID_INSTALLATION_H

#include "BulletHybrid/btHybridCollision.h"

class btDispatcher;
class btHybridNarrowphase;
class btHybridRegistration;

/// The pair algorithm in the dispatcher of any world (btDiscreteDynamicsWorld, btMultiBodyDynamicsWorld,
/// btSoftRigidDynamicsWorld, a bare btCollisionWorld), as long as this object lives:
///
///     btHybridInstallation installation(&dispatcher);
///     if (installation.getMistake()) puts(installation.getMistake());
///
/// Collides two objects of which one has a compound shape, whose children are convex or such compounds, and the other
/// one a compound of this kind, a convex shape, a static plane, a triangle mesh (btBvhTriangleMeshShape, scaled or
/// not), or a height field; also a bare btConvexHullShape with another one or a btBoxShape, and either on a mesh or a
/// height field. It does so in the place of create functions that were registered before; those that a program
/// registers afterwards are used. All other pairs go on to those of the dispatcher's configuration. The contacts are
/// those that Bullet finds, for a fraction of its time where compounds have many children, and for about two thirds of
/// it where bodies are bare. A btHybridRigidBody takes part with the shape that it has.
///
/// Levels that switch, policies and budgets need the stages of a btHybridDynamicsWorld, which installs the algorithm
/// itself: here everything is at its finest level.
///
/// Shapes may change in ways that Bullet counts (btCompoundShape::getUpdateRevision), and in the scaling and margin of
/// the whole; clean the pairs of a body after any other change, and after one of gContactBreakingThreshold. That holds
/// for the vertices of a mesh and the heights of a field, too, as Bullet asks for it itself; of a mesh that several
/// bodies have, of all of these. Detectors registered for two boxes, two spheres or two hulls, and Bullet's multipoint
/// settings but those for planes, are not asked. Not for several threads at once.
class btHybridInstallation
{
	btHybridNarrowphase* m_narrowphase;
	btHybridRegistration* m_registration;

	btHybridInstallation(const btHybridInstallation&);
	btHybridInstallation& operator=(const btHybridInstallation&);

public:
	/// Before the pairs that are to use it have come up; those that are there keep their algorithms.
	explicit btHybridInstallation(btDispatcher* dispatcher);

	/// Before the dispatcher's end. Pairs that use the algorithm keep it as long as their bounds overlap.
	~btHybridInstallation();

	/// 0, or why pairs run in Bullet's own algorithms, and how to mend it: the dispatcher has one already, or it is of
	/// a kind that takes none. Never changes.
	const char* getMistake() const;

	const btHybridCollisionInfo& getCollisionInfo() const;

	/// Between two steps. Whether pairs use the algorithm (m_pairAlgorithm) is decided when they come up. m_plainBodies
	/// acts as true.
	void setCollisionInfo(const btHybridCollisionInfo& info);

	/// Work since the last call, or since the beginning.
	btHybridCollisionCounts takeCollisionCounts();
	btHybridCollisionMemory getCollisionMemory() const;
};

#endif  // BT_HYBRID_INSTALLATION_H
