#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "scenes/document_scene.h"

namespace scatter::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A document in which things can be put one by one.
class Document {
 public:
  std::size_t model(std::vector<DocumentShape> shapes, DocumentMotion motion = DocumentMotion::kDynamic) {
    DocumentModel model;
    model.name = "model-" + std::to_string(document.models.size() + 1);
    model.shapes = std::move(shapes);
    model.motion = motion;
    document.models.push_back(std::move(model));
    return document.models.size() - 1;
  }

  std::size_t body(const char* name, std::size_t model, const Vec3& place = Vec3(0.0F)) {
    DocumentBody body;
    body.name = name;
    body.model = model;
    body.pose.position = place;
    document.bodies.push_back(body);
    return document.bodies.size() - 1;
  }

  DocumentJoint& joint(std::optional<std::size_t> a, std::optional<std::size_t> b, const Vec3& place) {
    DocumentJoint joint;
    joint.name = "joint";
    joint.bodyA = a;
    joint.bodyB = b;
    joint.frameA.position = a ? place - document.bodies[*a].pose.position : place;
    joint.frameB.position = b ? place - document.bodies[*b].pose.position : place;
    joint.linear = {{{0, 0}, {0, 0}, {0, 0}}};
    joint.angular = joint.linear;
    document.joints.push_back(joint);
    return document.joints.back();
  }

  PhysicsDocument document;
};

DocumentShape shape(ConvexShape convex, const Vec3& place = Vec3(0.0F)) {
  DocumentShape result;
  result.geometry = std::move(convex);
  result.pose.position = place;
  return result;
}

/// The document in a world.
class DocumentWorld {
 public:
  explicit DocumentWorld(const PhysicsDocument& document)
      : plan(std::make_shared<const DocumentPlan>(planDocument(document, "d.dae").value())),
        world(makeBulletPhysics({})) {
    const auto built = DocumentScene(plan).build(world, {});
    EXPECT_TRUE(built) << built.error().message;
  }

  [[nodiscard]] WorldObject& operator[](const char* name) const {
    WorldObject* object = world.find(name);
    EXPECT_NE(object, nullptr) << name;
    return *object;
  }
  void step(int steps) {
    for (int i = 0; i < steps; ++i) world.step(1.0F / 60.0F);
  }

  std::shared_ptr<const DocumentPlan> plan;
  World world;
};

TEST(DocumentScene, BodiesStandWhereTheDocumentSays) {
  Document d;
  const std::size_t ball = d.model({shape(Sphere{0.5F})});
  const std::size_t body = d.body("ball", ball, {1, 2, 3});
  d.document.bodies[body].linearVelocity = {4, 5, 6};
  d.document.bodies[body].angularVelocity = {0, 1, 0};
  d.body("other", ball, {9, 2, 3});
  const DocumentWorld scene(d.document);
  EXPECT_EQ(scene["ball"].state().pose.position, Vec3(1, 2, 3));
  EXPECT_EQ(scene["ball"].state().linearVelocity, Vec3(4, 5, 6));
  EXPECT_EQ(scene["ball"].state().angularVelocity, Vec3(0, 1, 0));
  EXPECT_EQ(scene["other"].def().mass, 1.0F);
  EXPECT_TRUE(std::holds_alternative<Sphere>(scene["ball"].def().shape));
  EXPECT_THAT(scene.plan->warnings, IsEmpty());
}

TEST(DocumentScene, LevelsMakeAHybrid) {
  Document d;
  LevelSetDef levels;
  levels.name = "l";
  levels.levels = {Level{{{Box{Vec3(1.0F)}, {}}}}, Level{{{Box{Vec3(0.5F)}, {}}}}};
  const std::size_t model = d.model({shape(Box{Vec3(0.5F)})});
  d.document.models[model].levels = LevelSet::create(std::move(levels)).value();
  d.body("a", model);
  const DocumentWorld scene(d.document);
  EXPECT_EQ(std::get<std::shared_ptr<const LevelSet>>(scene["a"].def().shape),
            d.document.models[model].levels);
}

TEST(DocumentScene, MassIsTheBodysElseTheModelsElseTheShapes) {
  Document d;
  DocumentShape dense = shape(Box{Vec3(0.5F)});
  dense.density = 250.0F;  // one cubic metre
  const std::size_t byDensity = d.model({dense});
  const std::size_t byModel = d.model({dense});
  d.document.models[byModel].mass = 7.0F;
  d.body("shapes", byDensity);
  d.body("model", byModel, {9, 0, 0});
  d.document.bodies[d.body("body", byModel, {19, 0, 0})].mass = 3.0F;
  const DocumentWorld scene(d.document);
  EXPECT_FLOAT_EQ(scene["shapes"].def().mass, 250.0F);
  EXPECT_EQ(scene["model"].def().mass, 7.0F);
  EXPECT_EQ(scene["body"].def().mass, 3.0F);
}

TEST(DocumentScene, ShapesOfDifferentDensityMoveTheCentreOfMass) {
  Document d;
  DocumentShape light = shape(Box{Vec3(0.5F)}, {-1, 0, 0});
  DocumentShape heavy = shape(Box{Vec3(0.5F)}, {1, 0, 0});
  light.mass = 1.0F;
  heavy.mass = 3.0F;
  d.body("a", d.model({light, heavy}));
  const DocumentWorld scene(d.document);
  EXPECT_FLOAT_EQ(scene["a"].def().mass, 4.0F);
  // (-1 · 1 + 1 · 3) / 4
  EXPECT_NEAR(scene["a"].state().centerOfMass.x, 0.5F, 1e-5F);
}

TEST(DocumentScene, AMassFrameGivesCentreAndInertia) {
  Document d;
  const std::size_t model = d.model({shape(Box{Vec3(0.5F)})});
  d.document.models[model].mass = 2.0F;
  d.document.models[model].massFrame =
      DocumentMassFrame{.pose = {{0.25F, 0, 0}, kNoRotation}, .inertia = Vec3(8, 8, 8)};
  d.body("a", model);
  const DocumentWorld scene(d.document);
  EXPECT_NEAR(scene["a"].state().centerOfMass.x, 0.25F, 1e-6F);
  // An impulse of 4 Ns, 2 m from the centre of mass, on 8 kg m²: 1 rad/s.
  scene["a"].applyImpulse({0, 0, 4}, {2.25F, 0, 0});
  EXPECT_NEAR(scene["a"].state().angularVelocity.y, -1.0F, 1e-5F);
}

TEST(DocumentScene, StaticBodiesMayHaveAllKindsOfShapes) {
  Document d;
  DocumentShape plane;
  plane.geometry = DocumentPlane{{0, 2, 0}, 1.0F};  // a surface at y = 0.5
  plane.pose.position = {0, 1, 0};
  DocumentShape mesh;
  mesh.geometry = VisualMesh{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}};
  const std::size_t ground = d.model({shape(Box{Vec3(0.5F)}), plane, mesh}, DocumentMotion::kStatic);
  d.body("ground", ground, {0, 10, 0});
  const DocumentWorld scene(d.document);
  ASSERT_EQ(scene.world.objects().size(), 3U);
  EXPECT_TRUE(std::holds_alternative<Compound>(scene["ground"].def().shape));
  const auto& surface = std::get<Plane>(scene["ground-2"].def().shape);
  EXPECT_EQ(surface.normal, Vec3(0, 1, 0));
  EXPECT_FLOAT_EQ(surface.offset, 11.5F);
  EXPECT_TRUE(std::holds_alternative<std::shared_ptr<const TriangleMesh>>(scene["ground-3"].def().shape));
}

TEST(DocumentScene, SaysWhatAWorldCannotDo) {
  Document d;
  d.document.materials = {{"ice", 0.2F, 0.1F, 0.5F}, {"wood", 0.5F, 0.5F, 0.0F}};
  DocumentShape plane;
  plane.geometry = DocumentPlane{};
  DocumentShape mesh;
  mesh.geometry =
      VisualMesh{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  mesh.material = 1;
  const std::size_t meshed = d.model({mesh});
  d.document.models[meshed].material = 0;
  d.body("mesh", meshed);
  d.body("twin", meshed, {9, 0, 0});
  d.body("plane", d.model({plane}), {0, -9, 0});
  const std::size_t ball = d.model({shape(Sphere{})}, DocumentMotion::kKinematic);
  d.document.bodies[d.body("moved", ball, {20, 0, 0})].linearVelocity = {1, 0, 0};
  d.joint(0, 1, Vec3(0.0F)).enabled = false;
  d.document.models[d.model({shape(Sphere{})})].name = "spare";
  d.document.timeStep = 0.01F;
  d.document.warnings = {"d.dae:3: <light>: left out"};
  const DocumentWorld scene(d.document);
  EXPECT_THAT(scene.plan->warnings,
              ElementsAre("d.dae:3: <light>: left out", HasSubstr("a body has one material; \"ice\""),
                          HasSubstr("material \"ice\": static friction"), HasSubstr("convex hull"),
                          HasSubstr("\"plane\": a plane can only be static"),
                          HasSubstr("\"moved\": nothing moves a kinematic body"),
                          HasSubstr("model \"spare\": no body is of it"), HasSubstr("not enabled"),
                          HasSubstr("time step")))
      << "each once";
  EXPECT_EQ(scene["mesh"].def().material.friction, 0.1F);
  EXPECT_EQ(scene["plane"].def().motion, Motion::kStatic);
}

TEST(DocumentScene, GravityAndFieldsAct) {
  Document d;
  const std::size_t ball = d.model({shape(Sphere{0.5F})});
  d.body("a", ball);
  d.document.gravity = {0, -2, 0};
  d.document.fields = {{"pull", {10, 0, 0}, 3.0F, 20.0F}};
  DocumentWorld scene(d.document);
  scene.step(60);
  EXPECT_NEAR(scene["a"].state().linearVelocity.y, -2.0F, 0.2F);
  EXPECT_NEAR(scene["a"].state().linearVelocity.x, 3.0F, 0.1F);
}

TEST(DocumentScene, NothingTurnsABodyWhoseInertiaIsEndless) {
  Document d;
  const std::size_t box = d.model({shape(Box{Vec3(0.5F)})});
  d.document.models[box].massFrame = DocumentMassFrame{{}, Vec3(1e12F)};
  d.body("stiff", box);
  DocumentWorld scene(d.document);
  scene["stiff"].applyImpulse({0, 0, 5}, {0.5F, 0.5F, 0});
  scene.step(10);
  EXPECT_LT(glm::length(scene["stiff"].state().angularVelocity), 1e-6F);
  EXPECT_NEAR(scene["stiff"].state().linearVelocity.z, 5.0F, 1e-3F);
}

TEST(DocumentScene, GravityFactorsAreTheBodys) {
  Document d;
  const std::size_t ball = d.model({shape(Sphere{0.5F})});
  d.body("falls", ball);
  d.document.bodies[d.body("floats", ball, {5, 0, 0})].gravityFactor = 0.0F;
  d.document.bodies[d.body("rises", ball, {9, 0, 0})].gravityFactor = -0.5F;
  d.document.gravity = {0, -2, 0};
  DocumentWorld scene(d.document);
  scene.step(60);
  EXPECT_NEAR(scene["falls"].state().linearVelocity.y, -2.0F, 1e-3F);
  EXPECT_EQ(scene["floats"].state().linearVelocity.y, 0.0F);
  EXPECT_NEAR(scene["rises"].state().linearVelocity.y, 1.0F, 1e-3F);
  // Another gravity acts with the same factors.
  scene.world.physics().setGravity({0, -4, 0});
  scene.step(60);
  EXPECT_NEAR(scene["falls"].state().linearVelocity.y, -6.0F, 1e-3F);
  EXPECT_EQ(scene["floats"].state().linearVelocity.y, 0.0F);
  EXPECT_NEAR(scene["rises"].state().linearVelocity.y, 3.0F, 1e-3F);
}

TEST(DocumentScene, BodiesCollideIfBothTheirFiltersAllowIt) {
  Document d;
  // Bodies of two systems at once are refused by who refuses one of them.
  d.document.filters = {
      {{"a"}, {}, {"b"}}, {{"b", "c"}, {}, {}}, {{"c"}, {"c"}, {}}, {{"d"}, {"a", "none"}, {}}};
  const std::size_t floor = d.model({shape(Box{{2.0F, 0.5F, 2.0F}})}, DocumentMotion::kStatic);
  const std::size_t ball = d.model({shape(Sphere{0.5F})});
  const std::optional<std::size_t> none;
  const auto collide = [](std::optional<std::size_t> a, std::optional<std::size_t> b) {
    const bool expected[5][5] = {                                     // a      b c    c      d      none
                                 {true, false, false, true, true},    // a: not with b, and c only with c
                                 {false, true, true, false, true},    // b and c: c's allow c
                                 {false, true, true, false, false},   // c: with c alone
                                 {true, false, false, false, false},  // d: with a alone
                                 {true, true, false, false, true}};   // without a filter
    return expected[a.value_or(4)][b.value_or(4)];
  };
  d.document.gravity = {0, -10, 0};
  const std::vector<std::optional<std::size_t>> filters{0, 1, 2, 3, none};
  for (std::size_t i = 0; i < 25; ++i) {
    const auto at = static_cast<float>(6 * i);
    d.document.bodies[d.body(("floor " + std::to_string(i)).c_str(), floor, {at, 0, 0})].filter =
        filters[i / 5];
    d.document.bodies[d.body(("ball " + std::to_string(i)).c_str(), ball, {at, 1.2F, 0})].filter =
        filters[i % 5];
  }
  DocumentWorld scene(d.document);
  scene.step(90);
  for (std::size_t i = 0; i < 25; ++i) {
    const float height = scene[("ball " + std::to_string(i)).c_str()].state().pose.position.y;
    EXPECT_EQ(height > 0.5F, collide(filters[i / 5], filters[i % 5])) << i / 5 << " and " << i % 5;
  }
}

TEST(DocumentScene, TooManySetsOfSystemsAreRefused) {
  Document d;
  for (int i = 0; i < 31; ++i) d.document.filters.push_back({{"system " + std::to_string(i)}, {}, {}});
  d.body("ball", d.model({shape(Sphere{0.5F})}));
  const auto plan = planDocument(d.document, "d.glb");
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().message,
            "d.glb: its bodies are of 31 different sets of collision systems; at most 30 are told apart");
}

TEST(DocumentScene, AFileWithoutGravitySaysSo) {
  Document d;
  d.body("ball", d.model({shape(Sphere{0.5F})}));
  d.document.saysGravity = false;
  EXPECT_THAT(DocumentWorld(d.document).plan->warnings,
              ElementsAre(HasSubstr("does not say what gravity is")));
}

/// A body hangs from a static one; what it does in a second says what the joint is.
class DocumentJoints : public testing::Test {
 protected:
  DocumentJoints() {
    d.document.gravity = {0, -9.81F, 0};
    d.body("post", d.model({shape(Box{Vec3(0.1F)})}, DocumentMotion::kStatic), {0, 5, 0});
    d.body("arm", d.model({shape(Box{{1.0F, 0.1F, 0.1F}})}), {1.5F, 5, 0});
  }
  Document d;
};

TEST_F(DocumentJoints, AllLockedIsFixed) {
  d.joint(0, 1, {0.5F, 5, 0});
  DocumentWorld scene(d.document);
  EXPECT_TRUE(std::holds_alternative<FixedJoint>(scene.plan->joints[0].kind));
  scene.step(60);
  EXPECT_LT(glm::length(scene["arm"].state().pose.position - Vec3(1.5F, 5, 0)), 0.1F);
}

TEST_F(DocumentJoints, AllAnglesFreeIsAPoint) {
  d.joint(0, 1, {0.5F, 5, 0}).angular = {};
  EXPECT_TRUE(std::holds_alternative<PointJoint>(DocumentWorld(d.document).plan->joints[0].kind));
}

TEST_F(DocumentJoints, OneFreeAngleIsAHingeAboutThatAxis) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    d.document.joints.clear();
    DocumentJoint& joint = d.joint(0, 1, {0.5F, 5, 0});
    joint.angular[axis] = {};
    DocumentWorld scene(d.document);
    ASSERT_TRUE(std::holds_alternative<HingeJoint>(scene.plan->joints[0].kind));
    const Vec3 own = scene.plan->joints[0].frame.rotation * Vec3(0, 0, 1);
    EXPECT_NEAR(own[static_cast<int>(axis)], 1.0F, 1e-6F);
    scene.step(30);
    // Gravity turns the arm about z; about x and y it cannot.
    const float drop = 5.0F - scene["arm"].state().pose.position.y;
    EXPECT_EQ(drop > 0.3F, axis == 2) << "axis " << axis << ", drop " << drop;
  }
}

TEST_F(DocumentJoints, HingeLimitsHold) {
  DocumentJoint& joint = d.joint(0, 1, {0.5F, 5, 0});
  joint.angular[2] = {-0.25F, 0.25F};
  DocumentWorld scene(d.document);
  scene.step(240);
  // The arm's middle is 1 m from the hinge.
  EXPECT_NEAR(scene["arm"].state().pose.position.y, 5.0F - std::sin(0.25F), 0.05F);
}

TEST_F(DocumentJoints, OneFreeDirectionIsASliderAlongIt) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    d.document.joints.clear();
    d.joint(0, 1, {0.5F, 5, 0}).linear[axis] = {-0.5F, 0.5F};
    DocumentWorld scene(d.document);
    ASSERT_TRUE(std::holds_alternative<SliderJoint>(scene.plan->joints[0].kind));
    scene.step(120);
    EXPECT_NEAR(scene["arm"].state().pose.position.y, axis == 1 ? 4.5F : 5.0F, 0.1F) << "axis " << axis;
  }
}

TEST_F(DocumentJoints, AnythingElseHasSixDegreesOfFreedom) {
  DocumentJoint& joint = d.joint(std::nullopt, 1, {0.5F, 5, 0});
  joint.angular[0] = {-0.1F, 0.2F};
  joint.angular[1] = {-2.0F, 0.2F};
  const DocumentWorld scene(d.document);
  const auto& kind = std::get<SixDofJoint>(scene.plan->joints[0].kind);
  EXPECT_EQ(kind.angularUpper.x, 0.2F);
  EXPECT_FLOAT_EQ(kind.angularLower.y, -0.5F * glm::pi<float>());
  EXPECT_THAT(scene.plan->warnings, ElementsAre(HasSubstr("90 degrees")));
  EXPECT_NE(scene.world.find("world"), nullptr);
}

TEST_F(DocumentJoints, FramesThatDoNotMeetAreNamed) {
  d.joint(0, 1, {0.5F, 5, 0}).frameB.position.x += 0.25F;
  EXPECT_THAT(DocumentWorld(d.document).plan->warnings,
              ElementsAre(HasSubstr("do not stand as its frames say")));
}

TEST(DocumentSceneErrors, NameTheFileAndTheBody) {
  Document d;
  EXPECT_EQ(planDocument(d.document, "d.dae").error().message, "d.dae: there are no rigid bodies in it");
  d.body("a", d.model({}));
  EXPECT_EQ(planDocument(d.document, "d.dae").error().message, "d.dae: body \"a\": it has no shape");
  d.document.bodies[0].mass = 0.0F;
  EXPECT_THAT(planDocument(d.document, "d.dae").error().message, HasSubstr("more than 0 kg"));
}

}  // namespace
}  // namespace scatter::test
