#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "world/conformance/physics_conformance.h"

namespace scatter::test {

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

void setField(BodyDef& def, HeightField field) {
  def.shape = std::make_shared<const HeightField>(std::move(field));
  def.motion = Motion::kStatic;
}

struct BadBody {
  std::function<void(BodyDef&)> spoil;
  const char* message;
};

std::vector<BadBody> badBodies() {
  return {
      {[](BodyDef& d) { d.mass = -1.0F; }, "mass must be a positive number of kilograms, not -1"},
      {[](BodyDef& d) { d.mass = 0.0F; }, "mass must be a positive number of kilograms, not 0"},
      {[](BodyDef& d) { d.mass = kNaN; }, "mass must be a positive number of kilograms, not nan"},
      {[](BodyDef& d) { d.mass = kInf; }, "mass must be a positive number of kilograms, not inf"},
      {[](BodyDef& d) { d.pose.position.y = kNaN; }, "the pose is not finite"},
      {[](BodyDef& d) { d.pose.position.x = kInf; }, "the pose is not finite"},
      {[](BodyDef& d) { d.pose.rotation.w = kNaN; }, "the pose is not finite"},
      {[](BodyDef& d) {
         d.pose.rotation = {0, 0, 0, 0};
       },
       "unit quaternion, not one of length 0"},
      {[](BodyDef& d) { d.linearVelocity.z = kInf; }, "the linear velocity is not finite"},
      {[](BodyDef& d) { d.angularVelocity.z = kNaN; }, "the angular velocity is not finite"},
      {[](BodyDef& d) { d.material.friction = -0.1F; }, "friction must be zero or more, not -0.1"},
      {[](BodyDef& d) { d.material.restitution = 1.5F; }, "restitution must be between 0 and 1, not 1.5"},
      {[](BodyDef& d) { d.material.linearDamping = kNaN; },
       "linear damping must be between 0 and 1, not nan"},
      {[](BodyDef& d) {
         d.shape = Box{{1.0F, 0.0F, 1.0F}};
       },
       "\"crate\": box: half extents (1, 0, 1) must be positive"},
      {[](BodyDef& d) { d.shape = Sphere{-2.0F}; }, "\"crate\": sphere: radius -2 must be positive"},
      {[](BodyDef& d) {
         d.shape = Capsule{1.0F, kNaN};
       },
       "half height nan must be finite"},
      {[](BodyDef& d) {
         d.shape = Cylinder{kInf, 1.0F};
       },
       "radius inf must be positive and finite"},
      {[](BodyDef& d) { d.shape = ConvexHull{}; }, "\"crate\": convex hull: "},
      {[](BodyDef& d) {
         d.shape = ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, kNaN}}};
       },
       "vertex 4 (0, 0, nan) is not finite"},
      {[](BodyDef& d) {
         d.shape = ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
       },
       "lie in one plane"},
      {[](BodyDef& d) { d.shape = Compound{}; }, "needs at least one part"},
      {[](BodyDef& d) {
         d.shape = Compound{{{Box{}, {}}, {Sphere{0.0F}, {}}}};
       },
       "part 2: sphere: radius 0 must be positive"},
      {[](BodyDef& d) {
         d.shape = Compound{{{Box{}, {{kNaN, 0, 0}, kNoRotation}}}};
       },
       "part 1: position (nan, 0, 0) is not finite"},
      {[](BodyDef& d) { d.shape = Plane{}; }, "a plane can only be static"},
      {[](BodyDef& d) { d.shape = std::make_shared<const TriangleMesh>(); },
       "a triangle mesh can only be static"},
      {[](BodyDef& d) {
         d.shape = Plane{Vec3(0.0F), 0.0F};
         d.motion = Motion::kStatic;
       },
       "the plane's normal must not be zero"},
      {[](BodyDef& d) {
         d.shape = std::make_shared<const TriangleMesh>();
         d.motion = Motion::kStatic;
       },
       "the mesh has no triangles"},
      {[](BodyDef& d) {
         d.shape = std::make_shared<const TriangleMesh>(
             TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}});
         d.motion = Motion::kStatic;
       },
       "triangle 1 has the vertex index 3, but there are only 3 vertices"},
      {[](BodyDef& d) { d.shape = std::make_shared<const HeightField>(); },
       "a height field can only be static"},
      {[](BodyDef& d) {
         setField(d, {.columns = 1, .heights = {0, 0}});
       },
       "at least 2 columns and 2 rows"},
      {[](BodyDef& d) {
         setField(d, {.heights = {0, 0, 0}});
       },
       "the height field has 3 heights, but 2 columns and 2 rows"},
      {[](BodyDef& d) {
         setField(d, {.spacingZ = 0.0F, .heights = {0, 0, 0, 0}});
       },
       "the height field's spacing must be a positive number of metres, not 0"},
      {[](BodyDef& d) {
         setField(d, {.heights = {0, 0, kNaN, 0}});
       },
       "height 3 is not finite"},
      {[](BodyDef& d) { d.shape = std::shared_ptr<const LevelSet>(); }, "there is no level set"},
  };
}

}  // namespace

TEST_P(PhysicsConformance, RefusesBadBodiesInOneLine) {
  startWithGravity(kEarth);
  for (const BadBody& bad : badBodies()) {
    SCOPED_TRACE(bad.message);
    BodyDef def = bodyAt(Vec3(0.0F));
    def.name = "crate";
    bad.spoil(def);
    const auto body = physics().createBody(def);
    ASSERT_FALSE(body);
    EXPECT_THAT(body.error().message, testing::StartsWith("body \"crate\": "));
    EXPECT_THAT(body.error().message, testing::HasSubstr(bad.message));
    EXPECT_THAT(body.error().message, testing::Not(testing::HasSubstr("\n")));
  }
  step();
  EXPECT_EQ(physics().counters().objects, 0U);
}

TEST_P(PhysicsConformance, MassOfStaticBodiesIsIgnored) {
  startWithGravity(kEarth);
  for (const Motion motion : {Motion::kStatic, Motion::kKinematic}) {
    BodyDef def = bodyAt(Vec3(0.0F));
    def.mass = kNaN;
    def.motion = motion;
    EXPECT_TRUE(physics().createBody(def));
  }
}

TEST_P(PhysicsConformance, RefusesBadJoints) {
  startWithGravity(kEarth);
  BodyDef crate = bodyAt(Vec3(0.0F));
  crate.name = "crate";
  const BodyId a = add(crate);
  BodyDef wall = bodyAt({3.0F, 0.0F, 0.0F});
  wall.name = "wall";
  wall.motion = Motion::kStatic;
  const BodyId b = add(wall);
  const BodyId c = add(wall);
  const auto refusal = [this](BodyId first, BodyId second, JointKind kind, const Transform& frame = {}) {
    JointDef def;
    def.kind = kind;
    def.bodyA = first;
    def.bodyB = second;
    def.frame = frame;
    const auto joint = physics().createJoint(def);
    return joint ? std::string("no error") : joint.error().message;
  };
  EXPECT_EQ(refusal(a, a, PointJoint{}),
            "joint between \"crate\" and \"crate\": a body cannot be joined to itself");
  EXPECT_EQ(refusal(b, c, PointJoint{}),
            "joint between \"wall\" and \"wall\": at least one body must be dynamic");
  EXPECT_EQ(refusal(a, b, PointJoint{}, {{kNaN, 0, 0}, kNoRotation}),
            "joint between \"crate\" and \"wall\": the pose is not finite");
  EXPECT_THAT(refusal(a, b, HingeJoint{0.0F, kInf}), testing::HasSubstr("the limits are not finite"));
  EXPECT_THAT(refusal(a, b, HingeJoint{-4.0F, 1.0F}), testing::HasSubstr("between -pi and pi, not -4 and 1"));
  EXPECT_THAT(refusal(a, b, SliderJoint{kNaN, 1.0F}), testing::HasSubstr("the limits are not finite"));
  SixDofJoint sixDof;
  sixDof.angularUpper.y = kNaN;
  EXPECT_THAT(refusal(a, b, sixDof), testing::HasSubstr("the limits are not finite"));
}

TEST_P(PhysicsConformance, RefusesBadVehicles) {
  startWithGravity(kEarth);
  BodyDef def = bodyAt(Vec3(0.0F));
  def.name = "car";
  const BodyId car = add(def);
  const auto refusal = [this](const VehicleDef& vehicle) {
    const auto made = physics().createVehicle(vehicle);
    return made ? std::string("no error") : made.error().message;
  };
  VehicleDef vehicle;
  vehicle.chassis = car;
  EXPECT_EQ(refusal(vehicle), "vehicle on \"car\": a vehicle needs at least one wheel");
  vehicle.wheels.resize(2);
  vehicle.wheels[1].radius = 0.0F;
  EXPECT_EQ(refusal(vehicle),
            "vehicle on \"car\": wheel 2: radius must be a positive number of metres, not 0");
  vehicle.wheels[1].radius = 0.4F;
  vehicle.wheels[1].axle = vehicle.wheels[1].direction;
  EXPECT_THAT(refusal(vehicle), testing::HasSubstr("wheel 2: the direction and the axle must not be zero"));
  vehicle.wheels[1].axle = {1.0F, 0.0F, 0.0F};
  vehicle.suspensionStiffness = -1.0F;
  EXPECT_THAT(refusal(vehicle), testing::HasSubstr("suspension stiffness must be positive, not -1"));
  def.motion = Motion::kStatic;
  vehicle.chassis = add(def);
  EXPECT_EQ(refusal(vehicle), "vehicle on \"car\": the chassis must be dynamic");
}

}  // namespace scatter::test
