#include <gmock/gmock.h>
#include <scatter/io/file.h>
#include <scatter/io/gltf.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "io/gltf/comparison.h"
#include "io/gltf/random.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class GltfWriter : public testing::Test {
 protected:
  GltfWriter() {
    LevelSetDef levels;
    levels.name = "ship";
    levels.levels = {{{{Box{Vec3(3)}, {}}}},
                     {{{Box{Vec3(1)}, {}}, {Sphere{1}, {Vec3(1, 0, 0), kNoRotation}}}}};
    DocumentModel ship;
    ship.name = "ship";
    ship.levels = LevelSet::create(levels).value();
    for (const ConvexPart& part : ship.levels->finest().parts) {
      ship.shapes.push_back({.geometry = part.shape, .pose = part.pose});
    }
    ship.mass = 12.0F;
    document_.models.push_back(ship);
    document_.bodies = {{.name = "one"}, {.name = "two", .linearVelocity = Vec3(1, 2, 3)}};
  }

  [[nodiscard]] json write() {
    const auto written = writeGltfDocument(document_, file_);
    EXPECT_TRUE(written.has_value()) << written.error().message;
    return json::parse(readFile(file_).value());
  }

  /// What is read after an edit of the file.
  [[nodiscard]] PhysicsDocument readEdited(const json& edited) const {
    EXPECT_TRUE(writeFile(file_, edited.dump()));
    auto document = readGltfDocument(file_);
    EXPECT_TRUE(document.has_value()) << document.error().message;
    return document.value_or(PhysicsDocument{});
  }

  void expectRefused(const std::string& message) const {
    const auto written = writeGltfDocument(document_, file_);
    ASSERT_FALSE(written.has_value());
    EXPECT_THAT(written.error().message, HasSubstr(message));
    EXPECT_TRUE(folder_.isEmpty());
  }

  static json& physicsOf(json& node) { return node["extensions"]["KHR_physics_rigid_bodies"]; }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "scene.gltf";
  PhysicsDocument document_;
};

TEST_F(GltfWriter, OtherProgramsSeeTheFinestLevelAsColliders) {
  json file = write();
  json& body = file["nodes"][0];
  EXPECT_EQ(physicsOf(body)["motion"]["mass"], 12.0);
  ASSERT_EQ(body["children"].size(), 2U);
  const json& shapes = file["extensions"]["KHR_implicit_shapes"]["shapes"];
  ASSERT_EQ(shapes.size(), 2U) << "bodies of a model share its shapes";
  EXPECT_EQ(shapes[0]["box"]["size"], json({2.0, 2.0, 2.0}));
  EXPECT_EQ(shapes[1]["sphere"]["radius"], 1.0);
  const json& levels = body["extras"]["scatter_levels"]["levels"];
  ASSERT_EQ(levels.size(), 1U);
  EXPECT_EQ(levels[0][0]["box"]["size"], json({6.0, 6.0, 6.0}));
  EXPECT_EQ(file["nodes"][file["scenes"][0]["nodes"][1].get<std::size_t>()]["name"], "two");
}

TEST_F(GltfWriter, WithoutOurExtrasThePlainBodiesAreRead) {
  json file = write();
  file["scenes"][0].erase("extras");
  for (json& node : file["nodes"]) {
    node.erase("extras");
  }
  const PhysicsDocument read = readEdited(file);
  ASSERT_EQ(read.bodies.size(), 2U);
  EXPECT_EQ(read.models.at(read.bodies[0].model).shapes.size(), 2U);
  EXPECT_EQ(read.bodies[1].linearVelocity, Vec3(1, 2, 3));
  EXPECT_EQ(read.models[0].levels, nullptr);
}

TEST_F(GltfWriter, WhatSomeoneChangedInTheNodesCounts) {
  json file = write();
  physicsOf(file["nodes"][0])["motion"]["mass"] = 99.0;
  physicsOf(file["nodes"][0])["motion"]["isKinematic"] = true;
  for (json& node : file["nodes"]) {
    if (node.value("name", "") == "two") {
      physicsOf(node)["motion"]["linearVelocity"] = {7, 0, 0};
    }
  }
  const PhysicsDocument read = readEdited(file);
  ASSERT_EQ(read.bodies.size(), 2U);
  EXPECT_EQ(read.models.size(), 1U);
  EXPECT_EQ(read.bodies[0].mass, 99.0F);
  EXPECT_EQ(read.bodies[0].motion, DocumentMotion::kKinematic);
  EXPECT_EQ(read.bodies[1].linearVelocity, Vec3(7, 0, 0));
  EXPECT_FALSE(read.bodies[1].mass.has_value());
}

TEST_F(GltfWriter, ABodyWithOtherCollidersIsNoLongerOfItsModel) {
  json file = write();
  // The second body loses a collider.
  for (json& node : file["nodes"]) {
    if (node.value("name", "") == "two") {
      node["children"].erase(1);
    }
  }
  const PhysicsDocument read = readEdited(file);
  ASSERT_EQ(read.models.size(), 2U);
  EXPECT_NE(read.models[0].levels, nullptr);
  EXPECT_EQ(read.models[1].shapes.size(), 1U);
  EXPECT_THAT(read.warnings, testing::Contains(HasSubstr("becomes a model of its own")));
}

TEST_F(GltfWriter, LevelsFollowTheScaleOfTheirNode) {
  json file = write();
  file["nodes"][0]["scale"] = {2, 2, 2};
  file["scenes"][0]["nodes"] = {0};
  const PhysicsDocument read = readEdited(file);
  ASSERT_EQ(read.models.size(), 1U);
  ASSERT_NE(read.models[0].levels, nullptr);
  EXPECT_EQ(std::get<Box>(read.models[0].levels->coarsest().parts.at(0).shape).halfExtents, Vec3(6));
  EXPECT_EQ(read.models[0].levels->finest().parts.at(1).pose.position, Vec3(2, 0, 0));
}

TEST_F(GltfWriter, ModelsWithoutBodiesStandOutsideTheScene) {
  document_.bodies.clear();
  const json file = write();
  EXPECT_FALSE(file["scenes"][0].contains("nodes"));
  EXPECT_EQ(test::findDifference(document_, readEdited(file)), "");
}

TEST_F(GltfWriter, DisabledJointsDoNothingInOtherPrograms) {
  DocumentJoint joint;
  joint.bodyA = 0;
  joint.enabled = false;
  document_.joints.push_back(joint);
  const json file = write();
  EXPECT_EQ(file.dump().find("\"joint\":{\"connectedNode\""), std::string::npos);
  EXPECT_EQ(test::findDifference(document_, readEdited(file)), "");
}

TEST_F(GltfWriter, TheSameDocumentGivesTheSameBytes) {
  test::RandomDocuments documents(3);
  const PhysicsDocument document = documents.next();
  ASSERT_TRUE(writeGltfDocument(document, folder_ / "a.glb"));
  ASSERT_TRUE(writeGltfDocument(document, folder_ / "b.glb"));
  EXPECT_EQ(readFile(folder_ / "a.glb").value(), readFile(folder_ / "b.glb").value());
}

TEST_F(GltfWriter, UnsoundDocumentsAreRefused) {
  const PhysicsDocument sound = document_;
  const auto refuse = [&](const auto& spoil, const char* message) {
    document_ = sound;
    spoil(document_);
    expectRefused(message);
  };
  using Doc = PhysicsDocument;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  refuse([](Doc& d) { d.bodies[1].model = 7; }, "body 1 (\"two\"): it is of a model that does not exist");
  refuse([](Doc& d) { d.bodies[1].name = "one"; }, "another body has the same name");
  refuse([](Doc& d) { d.bodies[1].name = "\xFF"; }, "its name is not UTF-8");
  refuse([](Doc& d) { d.bodies[0].pose.position.x = kNan; }, "a position is not finite");
  refuse([](Doc& d) { d.bodies[0].pose.rotation = Quat(2, 0, 0, 0); }, "a rotation is not of length 1");
  refuse([](Doc& d) { d.bodies[0].mass = -1.0F; }, "its mass of -1 kg is not positive");
  refuse([](Doc& d) { d.models[0].shapes.clear(); }, "model 0 (\"ship\"): it has no shapes");
  refuse([](Doc& d) { d.models[0].material = 0; }, "it names a material that does not exist");
  refuse([](Doc& d) { d.models[0].mesh.triangles = {{0, 1, 2}}; }, "a triangle names a vertex");
  refuse([](Doc& d) { d.models[0].shapes[0].geometry = ConvexShape(Sphere{0.0F}); },
         "a sphere has no sound size");
  refuse([](Doc& d) { d.models[0].shapes[0].geometry = ConvexShape(ConvexHull{}); }, "model 0");
  refuse([](Doc& d) { d.joints.emplace_back(); }, "joint 0 (\"\"): it joins a body or the world to itself");
  refuse([](Doc& d) { d.gravity.y = kNan; }, "gravity is not finite");
  refuse([](Doc& d) { d.timeStep = 0.0F; }, "the time step");
  refuse([](Doc& d) { d.materials.push_back({.restitution = 2.0F}); }, "its restitution is not from 0 to 1");
  refuse([](Doc& d) { d.fields.push_back({.radius = -1.0F}); }, "field 0");
}

TEST_F(GltfWriter, TheNameSaysTheFormat) {
  const auto written = writeGltfDocument(document_, folder_ / "scene.obj");
  ASSERT_FALSE(written.has_value());
  EXPECT_THAT(written.error().message, HasSubstr("the name should end in .gltf or .glb"));
  EXPECT_TRUE(folder_.isEmpty());
}

}  // namespace
}  // namespace scatter
