#include "bullet/physics/joints.h"

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>
#include <BulletDynamics/ConstraintSolver/btSliderConstraint.h>

#include "bullet/shapes/conversions.h"

namespace scatter {

namespace {

/// The two bodies and the joint's frame in each of them.
struct Ends {
  btRigidBody& a;
  btRigidBody& b;
  btTransform inA;
  btTransform inB;
};

std::unique_ptr<btTypedConstraint> make(const PointJoint&, const Ends& ends) {
  return std::make_unique<btPoint2PointConstraint>(ends.a, ends.b, ends.inA.getOrigin(),
                                                   ends.inB.getOrigin());
}

std::unique_ptr<btTypedConstraint> make(const HingeJoint& def, const Ends& ends) {
  // With the reference in A, angles are those of B relative to A.
  auto hinge =
      std::make_unique<btHingeConstraint>(ends.a, ends.b, ends.inA, ends.inB, /*useReferenceFrameA=*/true);
  if (def.lower <= def.upper) hinge->setLimit(def.lower, def.upper);
  return hinge;
}

std::unique_ptr<btTypedConstraint> make(const SliderJoint& def, const Ends& ends) {
  auto slider = std::make_unique<btSliderConstraint>(ends.a, ends.b, ends.inA, ends.inB,
                                                     /*useLinearReferenceFrameA=*/true);
  slider->setLowerLinLimit(def.lower);
  slider->setUpperLinLimit(def.upper);
  return slider;
}

std::unique_ptr<btTypedConstraint> make(const FixedJoint&, const Ends& ends) {
  return std::make_unique<btFixedConstraint>(ends.a, ends.b, ends.inA, ends.inB);
}

std::unique_ptr<btTypedConstraint> make(const SixDofJoint& def, const Ends& ends) {
  auto joint = std::make_unique<btGeneric6DofSpring2Constraint>(ends.a, ends.b, ends.inA, ends.inB, RO_XYZ);
  joint->setLinearLowerLimit(toBullet(def.linearLower));
  joint->setLinearUpperLimit(toBullet(def.linearUpper));
  // Bullet measures the angles of A relative to B.
  joint->setAngularLowerLimit(toBullet(-def.angularUpper));
  joint->setAngularUpperLimit(toBullet(-def.angularLower));
  return joint;
}

}  // namespace

std::unique_ptr<btTypedConstraint> makeConstraint(const JointDef& def, BulletBody& a, BulletBody& b) {
  const Ends ends{a.rigid(), b.rigid(), a.fromCenter(def.frame), b.fromCenter(def.frame)};
  return std::visit([&ends](const auto& kind) { return make(kind, ends); }, def.kind);
}

}  // namespace scatter
