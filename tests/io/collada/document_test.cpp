#include <scatter/io/collada.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>
#include <string>

#include "io/collada/samples.h"
#include "io/documents.h"

namespace scatter {
namespace {

using test::expectNear;
using test::parsed;
using test::SceneFile;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

const ConvexShape& convexShape(const PhysicsDocument& document, std::size_t model = 0,
                               std::size_t shape = 0) {
  return std::get<ConvexShape>(document.models.at(model).shapes.at(shape).geometry);
}

void expectInterval(const DocumentLimit& limit, float lower, float upper) {
  EXPECT_NEAR(limit.lower, lower, 1e-5F);
  EXPECT_NEAR(limit.upper, upper, 1e-5F);
}

TEST(ColladaDocument, ReadsABodyWhereItsNodeStands) {
  SceneFile file;
  file.world = "<gravity>0 -9.81 0</gravity><time_step>0.01</time_step>";
  const PhysicsDocument document = parsed(file.text());
  EXPECT_THAT(document.warnings, SizeIs(0));
  ASSERT_THAT(document.bodies, SizeIs(1));
  EXPECT_EQ(document.name, "test");
  EXPECT_EQ(document.bodies[0].name, "thing");
  EXPECT_EQ(document.bodies[0].pose.position, Vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(document.gravity, Vec3(0.0F, -9.81F, 0.0F));
  EXPECT_EQ(document.timeStep, 0.01F);
  EXPECT_EQ(document.models.at(0).mass, 5.0F);
  EXPECT_EQ(document.models.at(0).motion, DocumentMotion::kDynamic);
  EXPECT_EQ(document.models.at(0).levels, nullptr);
  EXPECT_EQ(std::get<Box>(convexShape(document)).halfExtents, Vec3(1.0F, 2.0F, 3.0F));
}

TEST(ColladaDocument, ReadsWhatMayaWrites) {
  const PhysicsDocument document = parsed(test::exporterSample("Maya"));
  expectNear(document.gravity, {0.0F, -9.81F, 0.0F});
  EXPECT_FLOAT_EQ(document.timeStep.value_or(0.0F), 0.03F);
  ASSERT_THAT(document.bodies, SizeIs(2));
  const DocumentBody& ground = document.bodies[0];
  const DocumentBody& box = document.bodies[1];
  EXPECT_EQ(box.name, "box");
  expectNear(box.pose.position, {0.0F, 5.405F, 0.0F});
  expectNear(box.pose.rotation * Vec3(1.0F, 0.0F, 0.0F), {0.0F, 0.0F, -1.0F});
  expectNear(box.linearVelocity, {-0.1F, 0.0F, 0.0F});
  const DocumentModel& rubber = document.models.at(box.model);
  EXPECT_EQ(rubber.shapes.at(0).mass, 1.0F);
  EXPECT_EQ(document.materials.at(rubber.material.value_or(9)).staticFriction, 0.3F);
  EXPECT_THAT(rubber.mesh.triangles, SizeIs(4));
  // Scaled by its node, in centimetres.
  const DocumentModel& floor = document.models.at(ground.model);
  EXPECT_EQ(floor.motion, DocumentMotion::kStatic);
  expectNear(std::get<ConvexHull>(convexShape(document, ground.model)).vertices.back(), {25.0F, 1.0F, 25.0F});
  expectNear(floor.mesh.vertices.back(), {25.0F, 1.0F, 25.0F});
  EXPECT_THAT(document.warnings, Contains(HasSubstr("convex_hull_of should begin with '#'")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("<hollow>: hollow shapes are not supported")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("leads back to the physics model around it")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("<node>: its scale goes into the shapes")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("profile \"MAYA\" is not read")));
}

TEST(ColladaDocument, ReadsWhatBlenderWrites) {
  const PhysicsDocument document = parsed(test::exporterSample("Blender"));
  EXPECT_EQ(document.gravity, Vec3(0.0F, -9.81F, 0.0F));
  ASSERT_THAT(document.bodies, SizeIs(2));
  EXPECT_EQ(document.bodies[0].pose.position, Vec3(1.0F, 3.0F, -2.0F));
  // A quarter turn about the file's z axis is one about y.
  expectNear(document.bodies[0].pose.rotation * Vec3(1.0F, 0.0F, 0.0F), {0.0F, 0.0F, -1.0F});
  const DocumentModel& floor = document.models.at(document.bodies[1].model);
  EXPECT_EQ(floor.motion, DocumentMotion::kStatic);
  EXPECT_FALSE(floor.mass.has_value());
  const Vec3 half = std::get<Box>(convexShape(document, 1)).halfExtents;
  EXPECT_EQ(half.x, 7.5F);
  EXPECT_TRUE(half.z > 0.0F && half.z <= 1e-3F);
  // The box is thin along the file's z axis, which points up.
  expectNear(floor.shapes[0].pose.rotation * Vec3(0.0F, 0.0F, 1.0F), {0.0F, 1.0F, 0.0F});
  EXPECT_THAT(document.warnings, Contains(HasSubstr("<half_extends> is taken as <half_extents>")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("0 is not a positive length; a thin shape is taken")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("names no <rigid_body>; the only one")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("<mass>: 0 is not a mass")));
}

TEST(ColladaDocument, ReadsWhatBulletWrites) {
  const PhysicsDocument document = parsed(test::exporterSample("Bullet"));
  ASSERT_THAT(document.bodies, SizeIs(2));
  expectNear(document.bodies[0].angularVelocity, {0.0F, glm::half_pi<float>(), 0.0F});
  EXPECT_EQ(document.bodies[0].pose.position, Vec3(1.0F, 1.0F, 0.0F));
  expectNear(document.bodies[1].pose.position, {4.0F, 5.0F, 6.0F});
  expectNear(document.bodies[1].pose.rotation * Vec3(1.0F, 0.0F, 0.0F), {0.0F, 0.0F, -1.0F});
  EXPECT_EQ(document.models.at(0).massFrame->inertia, Vec3(0.4F, 0.5F, 0.1F));
  EXPECT_EQ(document.models.at(1).motion, DocumentMotion::kStatic);
  EXPECT_FALSE(document.models.at(1).massFrame.has_value());
  ASSERT_THAT(document.joints, SizeIs(1));
  const DocumentJoint& hinge = document.joints[0];
  EXPECT_FALSE(hinge.bodyA.has_value());
  EXPECT_EQ(hinge.bodyB, 0U);
  EXPECT_EQ(hinge.frameA.position, Vec3(0.5F, 1.0F, 0.0F));
  EXPECT_EQ(hinge.frameB.position, Vec3(-0.5F, 0.0F, 0.0F));
  EXPECT_TRUE(hinge.bodiesCollide);
  EXPECT_GT(hinge.angular[1].lower, hinge.angular[1].upper);
  expectInterval(hinge.angular[0], 0.0F, 0.0F);
  expectInterval(hinge.linear[2], 0.0F, 0.0F);
}

TEST(ColladaDocument, ReadsWhatPhysXWrites) {
  const PhysicsDocument document = parsed(test::exporterSample("PhysX"));
  const DocumentModel& model = document.models.at(0);
  EXPECT_EQ(std::get<Capsule>(convexShape(document)).halfHeight, 1.0F);
  EXPECT_EQ(model.shapes[0].density, 10.0F);
  EXPECT_EQ(model.shapes[0].material, 0U);
  EXPECT_EQ(model.shapes[0].pose.position, Vec3(0.0F, 1.0F, 0.0F));
  EXPECT_EQ(model.massFrame->pose.position, Vec3(0.0F, 0.25F, 0.0F));
  // A cone: its tip and a ring.
  const auto& cone = std::get<ConvexHull>(convexShape(document, 0, 1)).vertices;
  EXPECT_EQ(std::count(cone.begin(), cone.end(), Vec3(0.0F, 1.0F, 0.0F)), 1);
  EXPECT_GT(cone.size(), 15U);
  const auto& plane = std::get<DocumentPlane>(document.models.at(1).shapes.at(0).geometry);
  EXPECT_EQ(plane.normal, Vec3(0.0F, 1.0F, 0.0F));
  EXPECT_EQ(plane.offset, 2.0F);
  ASSERT_THAT(document.joints, SizeIs(1));
  EXPECT_FALSE(document.joints[0].bodiesCollide);
  EXPECT_EQ(document.joints[0].bodyA, 1U);
  EXPECT_EQ(document.joints[0].bodyB, 0U);
  EXPECT_GT(document.joints[0].linear[0].lower, document.joints[0].linear[0].upper);
  EXPECT_EQ(document.joints[0].linear[1].lower, -1.0F);
  EXPECT_GE(document.joints[0].linear[1].upper, 1e5F);
  EXPECT_THAT(document.warnings, Contains(HasSubstr("<linear>: springs are not supported")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("<density>: is not known in <technique_common>")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("profile \"PhysX\" is not read")));
}

TEST(ColladaDocument, ReadsCollada15) {
  const PhysicsDocument document = parsed(test::exporterSample("Newer"));
  ASSERT_THAT(document.bodies, SizeIs(2));
  EXPECT_EQ(std::get<Capsule>(convexShape(document)).radius, 0.2F);
  EXPECT_THAT(document.models.at(0).shapes, SizeIs(1));
  expectNear(document.bodies[1].pose.position, {0.0F, 1.0F, 0.0F});
  EXPECT_TRUE(std::holds_alternative<ConvexHull>(convexShape(document, 1)));
  ASSERT_THAT(document.joints, SizeIs(1));
  EXPECT_EQ(document.joints[0].bodyA, 0U);
  EXPECT_EQ(document.joints[0].bodyB, 1U);
  EXPECT_THAT(document.warnings, Contains(HasSubstr("<geometry>: has no <mesh> or <convex_mesh>")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("<radius>: elliptic shapes")));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("<library_joints>: is not supported")));
}

TEST(ColladaDocument, MergesWarningsThatSayTheSame) {
  SceneFile file;
  const std::string shape = "<shape><hollow>true</hollow><sphere><radius>1</radius></sphere></shape>";
  file.common = shape + shape + shape;
  EXPECT_THAT(
      parsed(file.text()).warnings,
      ElementsAre("test.dae:5: <hollow>: hollow shapes are not supported; it is taken as solid (3 times)"));
}

TEST(ColladaDocument, ReadsLevelsAsTheModelReaderDoes) {
  test::Document model = test::richDocument();
  const PhysicsDocument document = parsed(model.text());
  ASSERT_NE(document.models.at(0).levels, nullptr);
  EXPECT_EQ(document.models[0].levels->count(), 3);
  EXPECT_EQ(document.models[0].levels->hullMargin(), 0.01F);
  EXPECT_THAT(document.models[0].shapes, SizeIs(6));
  EXPECT_EQ(document.models[0].name, "brick");
  // Without a physics scene, everything is there once.
  EXPECT_THAT(document.bodies, SizeIs(1));
  EXPECT_THAT(document.warnings, Contains(HasSubstr("has no physics scene")));
}

TEST(ColladaDocument, TakesDensitiesAndInertiaInTheUnitOfTheFile) {
  SceneFile file;
  file.asset = "<unit meter=\"0.01\"/>";
  file.common =
      "<inertia>10000 20000 30000</inertia><shape><density>0.001</density><sphere><radius>50</radius>"
      "</sphere></shape>";
  const PhysicsDocument document = parsed(file.text());
  EXPECT_FLOAT_EQ(document.models.at(0).shapes.at(0).density.value_or(0.0F), 1000.0F);
  expectNear(document.models[0].massFrame->inertia.value_or(Vec3(0.0F)), {1.0F, 2.0F, 3.0F});
}

TEST(ColladaDocument, WarnsOfGravityInCentimetres) {
  SceneFile file;
  file.asset = "<unit meter=\"0.01\"/>";
  file.world = "<gravity>0 -9.81 0</gravity>";
  const PhysicsDocument document = parsed(file.text());
  expectNear(document.gravity, {0.0F, -0.0981F, 0.0F});
  EXPECT_THAT(document.warnings, Contains(HasSubstr("test.dae:11: <gravity>: is in the file's unit")));
}

TEST(ColladaDocument, ReadsTrianglesThatAreAShape) {
  SceneFile file;
  file.libraries = "<library_geometries>" +
                   test::geometry("g", "mesh", 3, "0 0 0 1 0 0 0 0 1",
                                  "<tristrips><input semantic=\"VERTEX\" source=\"#g-v\" offset=\"0\"/>"
                                  "<p>0 1 2 0</p></tristrips>") +
                   "</library_geometries>";
  file.common = "<dynamic>false</dynamic><shape><instance_geometry url=\"#g\"/></shape>";
  const PhysicsDocument document = parsed(file.text());
  using Triangle = std::array<std::uint32_t, 3>;
  EXPECT_THAT(std::get<VisualMesh>(document.models.at(0).shapes.at(0).geometry).triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 0}));
}

TEST(ColladaDocument, ReadsOwnFieldsAndNamesOthers) {
  SceneFile file;
  file.libraries =
      "<library_force_fields><force_field id=\"pull\"><technique profile=\"SCATTER\"><point>"
      "<center>1 2 3</center><acceleration>9</acceleration><radius>50</radius></point></technique>"
      "</force_field><force_field id=\"wind\"><technique profile=\"OTHER\"/></force_field>"
      "</library_force_fields>";
  file.instances =
      "<instance_force_field url=\"#pull\"/><instance_force_field url=\"#wind\"/>" + file.instances;
  const PhysicsDocument document = parsed(file.text());
  ASSERT_THAT(document.fields, SizeIs(1));
  EXPECT_EQ(document.fields[0].name, "pull");
  EXPECT_EQ(document.fields[0].center, Vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(document.fields[0].acceleration, 9.0F);
  EXPECT_EQ(document.fields[0].radius, 50.0F);
  EXPECT_THAT(document.warnings, Contains(HasSubstr("test.dae:3: <force_field>: has no <technique")));
}

}  // namespace
}  // namespace scatter
