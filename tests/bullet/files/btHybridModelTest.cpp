#include <BulletHybrid/btHybridDynamicsWorld.h>
#include <BulletHybridFiles/btHybridModel.h>
#include <btBulletDynamicsCommon.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/io/file.h>
#include <scatter/io/gltf.h>
#include <scatter/io/model_file.h>
#include <scatter/io/model_library.h>
#include <scatter/world/world.h>

#include <memory>
#include <string>

#include "bullet/physics/shapes.h"
#include "bullet/shapes/conversions.h"
#include "io/documents.h"
#include "io/temporary_folder.h"

namespace scatter::test {
namespace {

std::string fileOf(const std::string& model) {
  return std::string(SCATTER_TEST_MODEL_DIR) + "/" + model + ".dae";
}

/// A convex shape in all that Bullet makes contacts of.
std::string describedConvex(const btConvexShape& shape) {
  std::string text = std::string(shape.getName()) + " " + std::to_string(shape.getMargin());
  btVector3 low;
  btVector3 high;
  shape.getAabb(btTransform::getIdentity(), low, high);
  std::vector<btVector3> points{low, high};
  if (shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE) {
    const auto& hull = static_cast<const btConvexHullShape&>(shape);
    for (int i = 0; i < hull.getNumPoints(); ++i) points.push_back(hull.getUnscaledPoints()[i]);
  }
  for (const btVector3& point : points) {
    for (int axis = 0; axis < 3; ++axis) text += " " + std::to_string(point[axis]);
  }
  return text;
}

std::string described(const btCollisionShape& shape) {
  if (!shape.isCompound()) return describedConvex(static_cast<const btConvexShape&>(shape));
  const auto& compound = static_cast<const btCompoundShape&>(shape);
  std::string text = std::to_string(compound.getNumChildShapes()) + " parts";
  for (int i = 0; i < compound.getNumChildShapes(); ++i) {
    text += "\n" + describedConvex(static_cast<const btConvexShape&>(*compound.getChildShape(i))) + " at";
    btScalar matrix[16];
    compound.getChildTransform(i).getOpenGLMatrix(matrix);
    for (const btScalar value : matrix) text += " " + std::to_string(value);
  }
  return text;
}

void expectSameLevels(const btHybridLevelSet& actual, const btHybridLevelSet& expected) {
  ASSERT_EQ(actual.getNumLevels(), expected.getNumLevels());
  for (int level = 1; level <= expected.getNumLevels(); ++level) {
    EXPECT_EQ(described(*actual.getLevelShape(level)), described(*expected.getLevelShape(level)));
  }
}

void expectNear(const btTransform& actual, const btTransform& expected, btScalar tolerance = 1e-6F) {
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(actual.getOrigin()[axis], expected.getOrigin()[axis], tolerance);
    for (int column = 0; column < 3; ++column) {
      EXPECT_NEAR(actual.getBasis()[axis][column], expected.getBasis()[axis][column], tolerance);
    }
  }
}

class HybridModelOfTheLibrary : public testing::TestWithParam<const char*> {};

TEST_P(HybridModelOfTheLibrary, IsWhatABulletWorldOfScatterHas) {
  btHybridModel model;
  ASSERT_EQ(model.load(fileOf(GetParam()).c_str()), nullptr);
  const auto library = loadModel(GetParam());
  ASSERT_TRUE(library) << library.error().message;
  BulletShapeBuilder builder;
  const auto shape = builder.build((*library)->levels);
  ASSERT_TRUE(shape) << shape.error().message;
  expectSameLevels(model.getLevels(), (*shape)->levels());
  EXPECT_EQ(model.getName(), (*library)->name);
  EXPECT_EQ(model.getMass(), (*library)->mass);
  EXPECT_EQ(model.getLocalInertia(), toBullet((*shape)->inertia() * (*library)->mass));
  EXPECT_EQ(model.getFriction(), (*library)->friction);
  EXPECT_EQ(model.getRestitution(), (*library)->restitution);
  expectNear(model.getCenterOfMass(), toBullet((*shape)->center()));
}

TEST_P(HybridModelOfTheLibrary, HasLevelsThatNest) {
  btHybridModel model;
  ASSERT_EQ(model.load(fileOf(GetParam()).c_str()), nullptr);
  btHybridLevelSet proven;
  EXPECT_GT(model.getLevels().getNumLevels(), 1);
  for (int level = 1; level <= model.getLevels().getNumLevels(); ++level) {
    EXPECT_STREQ(proven.addLevel(model.getLevels().getLevelShape(level)), nullptr);
  }
}

INSTANTIATE_TEST_SUITE_P(, HybridModelOfTheLibrary, testing::Values("hunter", "fighter_hulls", "mug", "lamp"),
                         [](const auto& tested) { return tested.param; });

TEST(HybridModel, IsTheSameFromGltf) {
  const TemporaryFolder folder;
  const std::string path = (folder / "ship.glb").string();
  const auto document = readDocument(fileOf("hunter_hulls"));
  ASSERT_TRUE(document) << document.error().message;
  ASSERT_TRUE(writeGltfDocument(*document, path));
  btHybridModel collada;
  btHybridModel gltf;
  ASSERT_EQ(collada.load(fileOf("hunter_hulls").c_str()), nullptr);
  ASSERT_EQ(gltf.load(path.c_str()), nullptr);
  expectSameLevels(gltf.getLevels(), collada.getLevels());
  EXPECT_EQ(gltf.getMass(), collada.getMass());
  EXPECT_EQ(gltf.getLocalInertia(), collada.getLocalInertia());
}

/// A file with a box of 1 m, turned about the z axis, at x = 3, of 12.5 kg.
class HybridModelOfABox : public testing::Test {
 protected:
  void SetUp() override {
    Document box;
    box.finest =
        "<shape><box><half_extents>0.5 0.5 0.5</half_extents></box><translate>3 0 0</translate>"
        "<rotate>0 0 1 90</rotate></shape>";
    ASSERT_TRUE(writeFile(path_, box.text()));
    ASSERT_EQ(model_.load(path_.c_str()), nullptr);
  }

  TemporaryFolder folder_;
  std::string path_ = (folder_ / "box.dae").string();
  btHybridModel model_;
};

TEST_F(HybridModelOfABox, HasItsCentreOfMassWhereTheBoxIs) {
  EXPECT_EQ(model_.getCenterOfMass().getOrigin(), btVector3(3, 0, 0));
  EXPECT_EQ(model_.getMass(), 12.5F);
  // m (w² + h²) / 12
  EXPECT_NEAR(model_.getLocalInertia().x(), 12.5F / 6, 1e-5F);
  btVector3 low;
  btVector3 high;
  model_.getLevels().getCoarsestAabb(btTransform::getIdentity(), low, high);
  EXPECT_NEAR((low + high).length(), 0, 1e-6F);
  const btTransform turned(btQuaternion(btVector3(0, 1, 0), SIMD_HALF_PI), {1, 2, 4});
  EXPECT_NEAR((model_.toBodyTransform(turned).getOrigin() - btVector3(1, 2, 1)).length(), 0, 1e-5F);
  expectNear(model_.toModelTransform(model_.toBodyTransform(turned)), turned);
}

TEST_F(HybridModelOfABox, IsDrawnWhereAMotionStateSays) {
  const btTransform start(btQuaternion(btVector3(0, 1, 0), SIMD_HALF_PI), {1, 2, 4});
  btDefaultMotionState drawn(start, model_.getCenterOfMass().inverse());
  btRigidBody::btRigidBodyConstructionInfo info = model_.getConstructionInfo(start);
  expectNear(info.m_startWorldTransform, model_.toBodyTransform(start));
  info.m_motionState = &drawn;
  btHybridRigidBody body(info, &model_.getLevels());
  expectNear(body.getWorldTransform(), model_.toBodyTransform(start));
  body.setAngularVelocity({0, 1, 0});
  body.integrateVelocities(0.1F);
  drawn.setWorldTransform(body.getWorldTransform());
  expectNear(drawn.m_graphicsWorldTrans, model_.toModelTransform(body.getWorldTransform()));
}

TEST_F(HybridModelOfABox, IsLoadedOnce) {
  const btCollisionShape* shape = model_.getLevels().getLevelShape(1);
  EXPECT_STREQ(model_.load(fileOf("mug").c_str()),
               "this model is \"brick\" already; load another file into another btHybridModel");
  EXPECT_EQ(model_.getLevels().getLevelShape(1), shape);
}

TEST(HybridModel, HasNoMassIfItDoesNotMove) {
  const TemporaryFolder folder;
  const std::string path = (folder / "box.dae").string();
  Document box;
  box.mass = "<dynamic>false</dynamic><mass>12.5</mass>";
  ASSERT_TRUE(writeFile(path, box.text()));
  btHybridModel model;
  ASSERT_EQ(model.load(path.c_str()), nullptr);
  EXPECT_EQ(model.getMass(), 0);
  EXPECT_TRUE(model.getLocalInertia().isZero());
}

TEST(HybridModel, ShowsWhatTheReaderLeavesOut) {
  const TemporaryFolder folder;
  const std::string path = (folder / "box.dae").string();
  Document box;
  box.finest += "<hollow>true</hollow><unheard_of/>";
  ASSERT_TRUE(writeFile(path, box.text()));
  btHybridModel model;
  ASSERT_EQ(model.load(path.c_str()), nullptr);
  ASSERT_GT(model.getNumWarnings(), 0);
  EXPECT_THAT(model.getWarning(0), testing::StartsWith(path + ":"));
  EXPECT_EQ(model.getWarning(-1), nullptr);
  EXPECT_EQ(model.getWarning(model.getNumWarnings()), nullptr);
}

TEST(HybridModel, StaysEmptyIfAFileIsWrong) {
  const TemporaryFolder folder;
  const std::string path = (folder / "wrong.dae").string();
  btHybridModel model;
  const auto mistake = [&](const Document& document) -> std::string {
    EXPECT_TRUE(writeFile(path, document.text()));
    const char* said = model.load(path.c_str());
    return said != nullptr ? said : "";
  };
  Document sticksOut;
  sticksOut.extra = coarser(boxLevel(1, "0.2 2 2"), R"(margin="0.01" count="2")");
  EXPECT_THAT(mistake(sticksOut), testing::AllOf(testing::StartsWith(path), testing::HasSubstr("sticks out"),
                                                 testing::Not(testing::HasSubstr("\n"))));
  Document flat;
  flat.finest = "<shape><box><half_extents>0.5 -1 0.5</half_extents></box></shape>";
  EXPECT_THAT(mistake(flat), testing::StartsWith(path + ":7: "));
  EXPECT_STREQ(model.load("nowhere.dae"), "cannot read nowhere.dae: No such file or directory");
  EXPECT_STREQ(model.load(nullptr), "there is no file name; give that of a .dae, .gltf or .glb file");
  EXPECT_STREQ(model.load(fileOf("mug").c_str(), "jug"),
               (fileOf("mug") + R"(: has no rigid body "jug"; it has "mug")").c_str());
  EXPECT_EQ(model.getLevels().getNumLevels(), 0);
  EXPECT_STREQ(model.load(fileOf("mug").c_str(), "mug"), nullptr);
  EXPECT_GT(model.getLevels().getNumLevels(), 1);
}

/// Two ships fly toward each other, in a world of plain Bullet calls.
class Encounter {
 public:
  explicit Encounter(const btHybridModel& model) {
    world_.setGravity({0, 0, 0});
    for (const btScalar side : {-1.0F, 1.0F}) {
      const btTransform pose(btQuaternion::getIdentity(), btVector3(4.0F * side, 0.1F * side, 0));
      auto body = std::make_unique<btHybridRigidBody>(model.getConstructionInfo(pose), &model.getLevels());
      body->setLinearVelocity({-3.0F * side, 0, 0});
      world_.addRigidBody(body.get());
      ships_[side > 0 ? 1 : 0] = std::move(body);
    }
  }
  ~Encounter() {
    for (const auto& ship : ships_) world_.removeRigidBody(ship.get());
  }
  Encounter(const Encounter&) = delete;
  Encounter& operator=(const Encounter&) = delete;

  void step() { world_.stepSimulation(1 / 60.F, 0, 1 / 60.F); }
  [[nodiscard]] bool isContact() { return world_.getPairLevel(ships_[0].get(), ships_[1].get()) > 0; }
  [[nodiscard]] const btHybridRigidBody& ship(int side) const { return *ships_[side]; }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btHybridDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::unique_ptr<btHybridRigidBody> ships_[2];
};

/// The same in a World of Scatter.
std::unique_ptr<World> labEncounter(const Model& model) {
  PhysicsDef def;
  def.world = WorldKind::kHybrid;
  def.gravity = Vec3(0.0F);
  def.profiling = false;
  auto world = std::make_unique<World>(makeBulletPhysics(def));
  for (const float side : {-1.0F, 1.0F}) {
    BodyDef body;
    body.shape = model.levels;
    body.mass = model.mass;
    body.material.friction = model.friction;
    body.material.restitution = model.restitution;
    body.pose.position = Vec3(4.0F * side, 0.1F * side, 0.0F);
    body.linearVelocity = Vec3(-3.0F * side, 0.0F, 0.0F);
    EXPECT_TRUE(world->add(body));
  }
  return world;
}

TEST(HybridModel, CollidesAsInAWorldOfScatter) {
  btHybridModel model;
  ASSERT_EQ(model.load(fileOf("hunter_hulls").c_str()), nullptr);
  Encounter encounter(model);
  const auto library = loadModel("hunter_hulls");
  ASSERT_TRUE(library) << library.error().message;
  const auto lab = labEncounter(**library);
  for (int frame = 0; frame < 60; ++frame) {
    encounter.step();
    lab->step(1.0F / 60.0F);
  }
  EXPECT_TRUE(encounter.isContact());
  EXPECT_LT(encounter.ship(0).getLinearVelocity().x(), 2.5F) << "they have not met";
  for (const int side : {0, 1}) {
    const btTransform drawn = model.toModelTransform(encounter.ship(side).getWorldTransform());
    expectNear(drawn, toBullet(lab->objects()[static_cast<std::size_t>(side)]->state().pose), 1e-4F);
  }
}

}  // namespace
}  // namespace scatter::test
