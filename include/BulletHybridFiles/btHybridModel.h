#ifndef BT_HYBRID_MODEL_H
#define BT_HYBRID_MODEL_H

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletHybrid/btHybridLevelSet.h>

struct btHybridModelContent;

/// A rigid body of a COLLADA (.dae) or glTF (.gltf, .glb) physics file: its encapsulation levels as Bullet's shapes,
/// and what it weighs. It owns shapes and levels, is shared by any number of bodies, and must outlive them. Metres,
/// kilograms; y is up, whatever the file uses.
///
/// A file has shapes in a frame of its own, the model's frame. Bullet moves a body by its centre of mass and wants the
/// inertia along the principal axes, so the levels are in the frame getCenterOfMass(). It is the same at all levels, so
/// that a switch moves nothing. toBodyTransform and toModelTransform lead from the one frame to the other.
class btHybridModel
{
	btHybridModelContent* m_content;

	btHybridModel(const btHybridModel&);
	btHybridModel& operator=(const btHybridModel&);

public:
	/// Empty: no levels, no mass.
	btHybridModel();
	~btHybridModel();

	/// Reads a rigid body. bodyName is its name in the file's scene, or that of its model; it may be 0 if the file has
	/// no two bodies that differ in shape, mass or motion. Levels are those that `scatter levels build` writes; a body
	/// without them has its shapes as the only level. That they nest is proven while they are read.
	///
	/// Returns 0, or one line that says what is wrong, where, and how to mend it, valid until the next call; then the
	/// model is as it was before. It is wrong to load into a model that has levels: bodies may use them.
	const char* load(const char* fileName, const char* bodyName = 0);

	/// In the file; an empty string before load.
	const char* getName() const;

	/// Coarsest first, in the frame getCenterOfMass(); empty before load.
	const btHybridLevelSet& getLevels() const;

	/// Kilograms; 0, as Bullet has it, if the file says that the body is static or kinematic.
	btScalar getMass() const;

	/// Of a body of getMass(), about the axes of getCenterOfMass(): kg m². For another mass scale it alike.
	const btVector3& getLocalInertia() const;

	/// The centre of mass and the principal axes, in the model's frame. With a motion state:
	/// btDefaultMotionState(modelTransform, getCenterOfMass().inverse()).
	const btTransform& getCenterOfMass() const;

	btScalar getFriction() const;
	btScalar getRestitution() const;

	/// Where the body is (btRigidBody::getWorldTransform) if the model is at modelTransform, as it is drawn, and the
	/// reverse.
	btTransform toBodyTransform(const btTransform& modelTransform) const;
	btTransform toModelTransform(const btTransform& bodyTransform) const;

	/// For btHybridRigidBody(info, &model.getLevels()), or for a btRigidBody that is always at the finest level: mass,
	/// inertia, friction, restitution, the finest shape, and the start at toBodyTransform(modelTransform).
	btRigidBody::btRigidBodyConstructionInfo getConstructionInfo(const btTransform& modelTransform) const;

	/// What the file has and the reader leaves out or mends, a line each; index counts from 0. 0 if there is no such
	/// line.
	int getNumWarnings() const;
	const char* getWarning(int index) const;
};

#endif  // BT_HYBRID_MODEL_H
