#include <gmock/gmock.h>
#include <scatter/io/file.h>
#include <scatter/io/gltf.h>

#include <glm/geometric.hpp>
#include <string>

#include "io/gltf/text.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

using test::boxNode;
using test::GltfText;
using test::physicsNode;
using test::readGltf;
using testing::Contains;
using testing::HasSubstr;

/// A file with these nodes, all of them in the scene.
PhysicsDocument readNodes(const std::string& nodes, const std::string& roots = "0") {
  GltfText file;
  file.nodes = nodes;
  file.roots = roots;
  return readGltf(file.text());
}

/// The one shape of a static body whose node has these members.
DocumentShape readShape(const std::string& shape, const std::string& members = "") {
  GltfText file;
  file.shapes = shape;
  file.nodes = boxNode("", members);
  const PhysicsDocument document = readGltf(file.text());
  if (document.models.size() != 1 || document.models[0].shapes.size() != 1) {
    ADD_FAILURE() << "not one shape";
    return {};
  }
  return document.models[0].shapes[0];
}

template <class Kind>
Kind convexOf(const DocumentShape& shape) {
  const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
  if (convex == nullptr || !std::holds_alternative<Kind>(*convex)) {
    ADD_FAILURE() << "another kind of shape";
    return {};
  }
  return std::get<Kind>(*convex);
}

TEST(GltfReader, ReadsImplicitShapes) {
  EXPECT_EQ(convexOf<Box>(readShape(R"({"type":"box","box":{"size":[1,2,4]}})")).halfExtents,
            Vec3(0.5F, 1, 2));
  EXPECT_EQ(convexOf<Sphere>(readShape(R"({"type":"sphere","sphere":{"radius":3}})")).radius, 3.0F);
  const auto capsule = convexOf<Capsule>(
      readShape(R"({"type":"capsule","capsule":{"radiusTop":2,"radiusBottom":2,"height":3}})"));
  EXPECT_EQ(capsule.radius, 2.0F);
  EXPECT_EQ(capsule.halfHeight, 1.5F);
  const auto cylinder = convexOf<Cylinder>(
      readShape(R"({"type":"cylinder","cylinder":{"radiusTop":2,"radiusBottom":2,"height":3}})"));
  EXPECT_EQ(cylinder.radius, 2.0F);
  EXPECT_EQ(cylinder.halfHeight, 1.5F);
}

TEST(GltfReader, ShapesHaveTheDraftsStandardSizes) {
  EXPECT_EQ(convexOf<Box>(readShape(R"({"type":"box"})")).halfExtents, Vec3(0.5F));
  EXPECT_EQ(convexOf<Sphere>(readShape(R"({"type":"sphere"})")).radius, 0.5F);
  EXPECT_EQ(convexOf<Capsule>(readShape(R"({"type":"capsule"})")).halfHeight, 0.25F);
  EXPECT_EQ(convexOf<Cylinder>(readShape(R"({"type":"cylinder"})")).radius, 0.25F);
}

TEST(GltfReader, APlaneFacesUpInItsNode) {
  const DocumentShape shape = readShape(R"({"type":"plane"})", R"("translation":[1,2,3])");
  const auto& plane = std::get<DocumentPlane>(shape.geometry);
  EXPECT_EQ(plane.normal, Vec3(0, 1, 0));
  EXPECT_EQ(plane.offset, 0.0F);
}

TEST(GltfReader, APlaneOfFiniteSizeIsTwoTriangles) {
  const DocumentShape shape = readShape(R"({"type":"plane","plane":{"sizeX":2,"sizeZ":4}})");
  const auto& mesh = std::get<VisualMesh>(shape.geometry);
  ASSERT_EQ(mesh.triangles.size(), 2U);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal = glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
    EXPECT_GT(normal.y, 0.0F);
  }
}

TEST(GltfReader, ATaperedCylinderIsAHullThatIsNamed) {
  GltfText file;
  file.shapes = R"({"type":"cylinder","cylinder":{"radiusTop":0,"radiusBottom":1,"height":2}})";
  file.nodes = boxNode("");
  const PhysicsDocument document = readGltf(file.text());
  const auto hull = convexOf<ConvexHull>(document.models.at(0).shapes.at(0));
  EXPECT_THAT(hull.vertices, Contains(Vec3(0, 1, 0)));
  EXPECT_THAT(hull.vertices, Contains(Vec3(1, -1, 0)));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("a cylinder with two radii is read as a convex hull")));
}

TEST(GltfReader, ScaleGoesIntoSizesWhereItIsExact) {
  EXPECT_EQ(convexOf<Box>(readShape(R"({"type":"box"})", R"("scale":[2,-4,6])")).halfExtents, Vec3(1, 2, 3));
  EXPECT_EQ(convexOf<Sphere>(readShape(R"({"type":"sphere"})", R"("scale":[3,3,-3])")).radius, 1.5F);
  const auto cylinder = convexOf<Cylinder>(readShape(R"({"type":"cylinder"})", R"("scale":[2,3,2])"));
  EXPECT_EQ(cylinder.radius, 0.5F);
  EXPECT_EQ(cylinder.halfHeight, 0.75F);
}

TEST(GltfReader, ScaleThatChangesTheKindMakesANamedHull) {
  GltfText file;
  file.shapes = R"({"type":"sphere"})";
  file.nodes = boxNode("", R"("scale":[1,2,1])");
  const PhysicsDocument document = readGltf(file.text());
  const auto hull = convexOf<ConvexHull>(document.models.at(0).shapes.at(0));
  EXPECT_THAT(hull.vertices, Contains(Vec3(0, 1, 0)));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("makes an ellipsoid of the sphere")));
}

TEST(GltfReader, AShearedBoxIsTheHullOfItsCorners) {
  // A parent's scale across a turned child: turned by 45 degrees about z, then twice as long along x.
  GltfText file;
  file.nodes = R"({"scale":[2,1,1],"children":[1]},)" +
               boxNode("", R"("rotation":[0,0,0.3826834,0.9238795],"translation":[1,0,0])");
  const PhysicsDocument document = readGltf(file.text());
  const DocumentShape& shape = document.models.at(0).shapes.at(0);
  const auto hull = convexOf<ConvexHull>(shape);
  ASSERT_EQ(hull.vertices.size(), 8U);
  const Vec3 corner = document.bodies[0].pose(shape.pose(hull.vertices[7]));
  // The corner (0.5, 1, 2), turned, stretched and moved with its node.
  const float c = 0.70710678F;
  EXPECT_LT(glm::distance(corner, Vec3(2.0F * (1.0F + c * (0.5F - 1.0F)), c * (0.5F + 1.0F), 2.0F)), 1e-5F);
  EXPECT_TRUE(std::none_of(document.warnings.begin(), document.warnings.end(),
                           [](const std::string& w) { return w.find("hull") != std::string::npos; }));
}

TEST(GltfReader, MatrixAndTransformsAreTheSame) {
  const PhysicsDocument a = readNodes(boxNode("{}", R"("matrix":[0,2,0,0,-3,0,0,0,0,0,4,0,5,6,7,1])"));
  const PhysicsDocument b = readNodes(
      boxNode("{}", R"("translation":[5,6,7],"rotation":[0,0,0.70710678118,0.70710678118],"scale":[2,3,4])"));
  EXPECT_LT(glm::distance(convexOf<Box>(a.models.at(0).shapes.at(0)).halfExtents,
                          convexOf<Box>(b.models.at(0).shapes.at(0)).halfExtents),
            1e-6F);
  EXPECT_EQ(a.bodies.at(0).pose.position, b.bodies.at(0).pose.position);
  EXPECT_LT(glm::length(a.bodies[0].pose.rotation - b.bodies[0].pose.rotation), 1e-6F);
}

TEST(GltfReader, ChildrenMakeACompoundBody) {
  const PhysicsDocument document =
      readNodes(boxNode(R"({"mass":3})", R"("name":"a","translation":[0,0,1],"children":[1,2])") + "," +
                boxNode("", R"("translation":[1,0,0])") + "," +
                boxNode(R"({"mass":5})", R"("name":"c","translation":[0,2,0])"));
  ASSERT_EQ(document.bodies.size(), 2U);
  const DocumentModel& first = document.models[document.bodies[0].model];
  ASSERT_EQ(first.shapes.size(), 2U);
  EXPECT_EQ(first.shapes[1].pose.position, Vec3(1, 0, 0));
  EXPECT_EQ(first.mass, 3.0F);
  // A child that moves by itself is a body of its own.
  EXPECT_EQ(document.bodies[1].name, "c");
  EXPECT_EQ(document.bodies[1].pose.position, Vec3(0, 2, 1));
}

TEST(GltfReader, CollidersWithoutMotionAreStaticBodies) {
  const PhysicsDocument document =
      readNodes(R"({"children":[1,2]},)" + boxNode("") + "," + boxNode("", R"("name":"wall")"));
  ASSERT_EQ(document.bodies.size(), 2U);
  EXPECT_EQ(document.models[0].motion, DocumentMotion::kStatic);
  EXPECT_EQ(document.bodies[1].name, "wall");
}

TEST(GltfReader, BodiesThatAreAlikeShareAModel) {
  const PhysicsDocument document =
      readNodes(boxNode(R"({"mass":3})") + "," + boxNode(R"({"mass":3})", R"("translation":[9,0,0])") + "," +
                    boxNode(R"({"mass":4})"),
                "0,1,2");
  EXPECT_EQ(document.models.size(), 2U);
  EXPECT_EQ(document.bodies.at(0).model, document.bodies.at(1).model);
  EXPECT_NE(document.bodies.at(0).model, document.bodies.at(2).model);
}

TEST(GltfReader, NamesOfBodiesAreUnique) {
  const PhysicsDocument document =
      readNodes(boxNode("{}", R"("name":"x")") + "," + boxNode("{}", R"("name":"x")"), "0,1");
  EXPECT_EQ(document.bodies.at(0).name, "x");
  EXPECT_EQ(document.bodies.at(1).name, "x 2");
}

TEST(GltfReader, VelocitiesTurnIntoTheWorld) {
  const PhysicsDocument document =
      readNodes(boxNode(R"({"linearVelocity":[1,0,0],"angularVelocity":[0,0,2]})",
                        R"("rotation":[0,0,0.70710678118,0.70710678118])"));
  EXPECT_LT(glm::distance(document.bodies.at(0).linearVelocity, Vec3(0, 1, 0)), 1e-6F);
  EXPECT_LT(glm::distance(document.bodies.at(0).angularVelocity, Vec3(0, 0, 2)), 1e-6F);
}

TEST(GltfReader, MassPropertiesAreRead) {
  const PhysicsDocument document = readNodes(boxNode(
      R"({"mass":2,"centerOfMass":[1,2,3],"inertiaDiagonal":[4,5,6],"inertiaOrientation":[1,0,0,0]})"));
  const DocumentModel& model = document.models.at(0);
  EXPECT_EQ(model.mass, 2.0F);
  ASSERT_TRUE(model.massFrame.has_value());
  EXPECT_EQ(model.massFrame->pose.position, Vec3(1, 2, 3));
  EXPECT_EQ(model.massFrame->inertia, Vec3(4, 5, 6));
  EXPECT_EQ(model.massFrame->pose.rotation, Quat(0, 1, 0, 0));
}

TEST(GltfReader, ABodyWithoutMassHasTheDensityOfWater) {
  const PhysicsDocument document = readNodes(boxNode("{}"));
  EXPECT_FALSE(document.models.at(0).mass.has_value());
  EXPECT_EQ(document.models[0].shapes.at(0).density, 1000.0F);
}

TEST(GltfReader, InertiaWithoutACentreIsAtTheShapesCentre) {
  const PhysicsDocument document = readNodes(boxNode(R"({"inertiaDiagonal":[4,5,6]})", R"("children":[1])") +
                                             "," + boxNode("", R"("translation":[2,0,0])"));
  ASSERT_TRUE(document.models.at(0).massFrame.has_value());
  EXPECT_LT(glm::distance(document.models[0].massFrame->pose.position, Vec3(1, 0, 0)), 1e-6F);
}

TEST(GltfReader, InfiniteMassIsKinematicAndNamed) {
  const PhysicsDocument document = readNodes(boxNode(R"({"mass":0,"inertiaDiagonal":[0,1,1]})"));
  EXPECT_EQ(document.models.at(0).motion, DocumentMotion::kKinematic);
  EXPECT_THAT(document.warnings,
              Contains(HasSubstr("nodes[0].extensions.KHR_physics_rigid_bodies.motion.mass: ")));
}

TEST(GltfReader, InfiniteInertiaIsAVeryLargeOne) {
  const PhysicsDocument document = readNodes(boxNode(R"({"mass":1,"inertiaDiagonal":[0,2,3]})"));
  EXPECT_EQ(document.models.at(0).massFrame.value().inertia.value(), Vec3(3e4F, 2.0F, 3.0F));
  const PhysicsDocument stiff = readNodes(boxNode(R"({"mass":1,"inertiaDiagonal":[0,0,0]})"));
  EXPECT_EQ(stiff.models.at(0).massFrame.value().inertia.value(), Vec3(1e12F));
}

TEST(GltfReader, MaterialsOfAllShapesOrOfEach) {
  GltfText file;
  file.materials = R"({"name":"ice","staticFriction":0.1,"dynamicFriction":0.05,"restitution":0.25},{})";
  const auto collider = [](int material) {
    return R"("collider":{"geometry":{"shape":0},"physicsMaterial":)" + std::to_string(material) + "}";
  };
  file.nodes = physicsNode(collider(0), R"("children":[1])") + "," + physicsNode(collider(0)) + "," +
               physicsNode(collider(0), R"("children":[3])") + "," + physicsNode(collider(1));
  file.roots = "0,2";
  const PhysicsDocument document = readGltf(file.text());
  ASSERT_EQ(document.materials.size(), 2U);
  EXPECT_EQ(document.materials[0].name, "ice");
  EXPECT_EQ(document.materials[0].staticFriction, 0.1F);
  EXPECT_EQ(document.materials[0].dynamicFriction, 0.05F);
  EXPECT_EQ(document.materials[0].restitution, 0.25F);
  EXPECT_EQ(document.materials[1].dynamicFriction, 0.6F);
  ASSERT_EQ(document.models.size(), 2U);
  EXPECT_EQ(document.models[0].material, 0U);
  EXPECT_FALSE(document.models[0].shapes[0].material.has_value());
  EXPECT_FALSE(document.models[1].material.has_value());
  EXPECT_EQ(document.models[1].shapes[1].material, 1U);
}

TEST(GltfReader, GravityFactorsAndFiltersAreTheBodys) {
  GltfText file;
  file.filters =
      R"({"collisionSystems":["ghost","player"],"collideWithSystems":["floor"]},{"notCollideWithSystems":["ghost"]})";
  const auto collider = [](int filter) {
    return R"("collider":{"geometry":{"shape":0},"collisionFilter":)" + std::to_string(filter) + "}";
  };
  file.nodes = physicsNode(R"("motion":{"gravityFactor":-0.5},)" + collider(0)) + "," +
               physicsNode(collider(1)) + "," + boxNode(R"({})");
  file.roots = "0,1,2";
  const PhysicsDocument document = readGltf(file.text());
  ASSERT_EQ(document.filters.size(), 2U);
  EXPECT_EQ(document.filters[0], (DocumentFilter{{"ghost", "player"}, {"floor"}, {}}));
  EXPECT_EQ(document.filters[1], (DocumentFilter{{}, {}, {"ghost"}}));
  ASSERT_EQ(document.bodies.size(), 3U);
  EXPECT_EQ(document.bodies[0].gravityFactor, -0.5F);
  EXPECT_EQ(document.bodies[0].filter, 0U);
  EXPECT_EQ(document.bodies[1].filter, 1U);
  EXPECT_EQ(document.bodies[2].gravityFactor, 1.0F);
  EXPECT_FALSE(document.bodies[2].filter.has_value());
}

TEST(GltfReader, WhatIsNotSupportedIsNamed) {
  GltfText file;
  file.materials = R"({"frictionCombine":"maximum","restitutionCombine":"multiply"})";
  file.filters = R"({"collideWithSystems":["a"],"notCollideWithSystems":["b"]},{})";
  file.nodes = physicsNode(R"("motion":{"mass":1},"trigger":{"geometry":{"shape":0}},)"
                           R"("collider":{"geometry":{"shape":0},"collisionFilter":0})",
                           R"("children":[2])") +
               R"(,{"mesh":0},)" + physicsNode(R"("collider":{"geometry":{"shape":0},"collisionFilter":1})");
  file.roots = "0,1";
  file.more = R"(,"animations":[{}],"meshes":[{"primitives":[]}])";
  const auto warnings = readGltf(file.text()).warnings;
  for (const char* part :
       {"physicsMaterials[0].frictionCombine: ", "collider: a body has one collision filter",
        "trigger: triggers", "collisionFilters[0]: says both", "animations: ", "belong to no rigid body",
        "what gravity is"}) {
    EXPECT_THAT(warnings, Contains(HasSubstr(part)));
  }
  EXPECT_EQ(warnings.size(), 7U);
  for (const std::string& warning : warnings) {
    EXPECT_THAT(warning, testing::StartsWith("test.gltf: "));
  }
}

TEST(GltfReader, WhatIsNotKnownOrNotUsedIsNamed) {
  GltfText file;
  file.materials = R"({"slipperiness":1})";
  file.joints = R"({"limits":[{"linearAxes":[0],"min":0,"max":0,"spring":1}],"breaks":1},{})";
  file.shapes = R"({"type":"box","box":{"size":[1,1,1],"margin":0.1}})";
  file.nodes = physicsNode(R"("motion":{"spinn":[0,0,0]},"engine":{},)"
                           R"("collider":{"geometry":{"shape":0},"layer":1},)"
                           R"("joint":{"connectedNode":1,"joint":0,"strength":1})") +
               "," + boxNode("{}") + "," + boxNode("{}");
  file.roots = "0,1";
  file.more = R"(,"extensionsUsed":["EXT_mesh_gpu_instancing","KHR_materials_clearcoat"])";
  const auto warnings = readGltf(file.text()).warnings;
  for (const char* part :
       {"physicsMaterials[0]: \"slipperiness\" is not known", "limits[0]: \"spring\"",
        "physicsJoints[0]: \"breaks\"", "box: \"margin\"", "motion: \"spinn\"",
        "KHR_physics_rigid_bodies: \"engine\"", "collider: \"layer\"", "joint: \"strength\"",
        "physicsJoints[1]: no node uses it", "nodes[2]: has physics, but stands outside the scene",
        "extensionsUsed[0]: this extension is not supported", "what gravity is"}) {
    EXPECT_THAT(warnings, Contains(HasSubstr(part)));
  }
  EXPECT_EQ(warnings.size(), 12U) << testing::PrintToString(warnings);
}

TEST(GltfReader, AFileWithoutPhysicsIsEmptyAndSaysSo) {
  const PhysicsDocument document = readGltf(R"({"asset":{"version":"2.0"}})");
  EXPECT_TRUE(document.bodies.empty());
  EXPECT_THAT(document.warnings, Contains(HasSubstr("has no physics")));
}

class GltfJoints : public testing::Test {
 protected:
  /// The joint with these limits between a body and the world.
  [[nodiscard]] static PhysicsDocument read(const std::string& joint) {
    GltfText file;
    file.joints = joint;
    file.nodes = boxNode("{}", R"("translation":[0,5,0],"children":[1])") + "," +
                 physicsNode(R"("joint":{"connectedNode":2,"joint":0,"enableCollision":true})",
                             R"("name":"hinge","translation":[1,0,0])") +
                 R"(,{"translation":[1,5,0]})";
    file.roots = "0,2";
    return readGltf(file.text());
  }
};

TEST_F(GltfJoints, FramesAndAxesAreRead) {
  const PhysicsDocument document =
      read(R"({"limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[1],"min":-0.5,"max":1},)"
           R"({"angularAxes":[0],"max":1}]})");
  ASSERT_EQ(document.joints.size(), 1U);
  const DocumentJoint& joint = document.joints[0];
  EXPECT_EQ(joint.name, "hinge");
  EXPECT_EQ(joint.bodyA, 0U);
  EXPECT_FALSE(joint.bodyB.has_value());
  EXPECT_EQ(joint.frameA.position, Vec3(1, 0, 0));
  EXPECT_EQ(joint.frameB.position, Vec3(1, 5, 0));
  EXPECT_TRUE(joint.bodiesCollide);
  for (const DocumentLimit& limit : joint.linear) {
    EXPECT_EQ(limit.lower, 0.0F);
    EXPECT_EQ(limit.upper, 0.0F);
  }
  EXPECT_EQ(joint.angular[1].lower, -0.5F);
  EXPECT_EQ(joint.angular[1].upper, 1.0F);
  EXPECT_FLOAT_EQ(joint.angular[0].lower, -3.14159265F);
  EXPECT_GT(joint.angular[2].lower, joint.angular[2].upper);
}

TEST_F(GltfJoints, DrivesSoftAndWideLimitsAreNamed) {
  const PhysicsDocument document =
      read(R"({"limits":[{"linearAxes":[0,1],"max":2,"stiffness":3}],"drives":[{"type":"linear"}]})");
  EXPECT_THAT(document.warnings, Contains(HasSubstr("physicsJoints[0].drives: drives are not supported")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("limits[0].stiffness: soft limits")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("limits[0]: a limit over several axes")));
  EXPECT_EQ(document.joints.at(0).linear[1].upper, 2.0F);
}

TEST(GltfReader, ExternalBuffersAreReadBesideTheFile) {
  const test::TemporaryFolder folder;
  GltfText file;
  file.nodes = physicsNode(R"("collider":{"geometry":{"node":1,"convexHull":true}})") + R"(,{"mesh":0})";
  file.more =
      R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])"
      R"(,"buffers":[{"byteLength":48,"uri":"a%20b.bin"}],"bufferViews":[{"buffer":0,"byteLength":48}])"
      R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4}])";
  const std::vector<float> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  ASSERT_TRUE(writeFile(folder / "a b.bin", test::bytesOf(points)));
  ASSERT_TRUE(writeFile(folder / "x.gltf", file.text()));
  const auto document = readGltfDocument(folder / "x.gltf");
  ASSERT_TRUE(document.has_value()) << document.error().message;
  EXPECT_EQ(convexOf<ConvexHull>(document->models.at(0).shapes.at(0)).vertices.size(), 4U);
  EXPECT_EQ(document->name, "test");
  // From memory there is no folder to look in.
  const auto alone = parseGltfDocument(file.text(), "x.gltf");
  ASSERT_FALSE(alone.has_value());
  EXPECT_EQ(alone.error().message, "x.gltf: buffers[0].uri: only data and files beside this one are read");
}

}  // namespace
}  // namespace scatter
