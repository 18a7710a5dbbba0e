#include <scatter/io/collada.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "io/collada/samples.h"
#include "io/documents.h"

namespace scatter {
namespace {

using test::expectNear;
using test::parsed;
using test::SceneFile;
using testing::Contains;
using testing::HasSubstr;
using testing::SizeIs;

/// Where the body of a file with this transform stack stands.
Transform placed(const std::string& stack) {
  SceneFile file;
  file.nodes = "<node id=\"n\">" + stack + "</node>";
  const PhysicsDocument document = parsed(file.text());
  return document.bodies.empty() ? Transform{} : document.bodies[0].pose;
}

TEST(ColladaNodes, ReadMatricesRowByRow) {
  const Transform pose = placed("<matrix>0 -1 0 5  1 0 0 6  0 0 1 7  0 0 0 1</matrix>");
  expectNear(pose.position, {5.0F, 6.0F, 7.0F});
  expectNear(pose.rotation * Vec3(1.0F, 0.0F, 0.0F), {0.0F, 1.0F, 0.0F});
}

TEST(ColladaNodes, LookAlongTheNegativeZAxis) {
  const Transform pose = placed("<lookat>1 2 3  1 2 -9  0 1 0</lookat>");
  expectNear(pose.position, {1.0F, 2.0F, 3.0F});
  expectNear(pose.rotation * Vec3(0.0F, 0.0F, -1.0F), {0.0F, 0.0F, -1.0F});
  const Transform turned = placed("<lookat>0 0 0  4 0 0  0 1 0</lookat>");
  expectNear(turned.rotation * Vec3(0.0F, 0.0F, -1.0F), {1.0F, 0.0F, 0.0F});
  expectNear(turned.rotation * Vec3(0.0F, 1.0F, 0.0F), {0.0F, 1.0F, 0.0F});
}

TEST(ColladaNodes, ApplyStacksInOrder) {
  const Transform pose =
      placed("<rotate>0 0 1 90</rotate><translate>1 0 0</translate><rotate>0 0 1 90</rotate>");
  expectNear(pose.position, {0.0F, 1.0F, 0.0F});
  expectNear(pose.rotation * Vec3(1.0F, 0.0F, 0.0F), {-1.0F, 0.0F, 0.0F});
}

TEST(ColladaNodes, NameWhatTheyDoNotSupport) {
  SceneFile file;
  file.nodes = "<node id=\"n\"><skew>45 1 0 0 0 1 0</skew></node>";
  EXPECT_THAT(parsed(file.text()).warnings, Contains("test.dae:8: <skew>: is not supported and is ignored"));
}

TEST(ColladaNodes, StandInTheNodesAroundThemAndInThoseThatInstanceThem) {
  SceneFile file;
  file.libraries =
      "<library_nodes><node id=\"part\"><translate>0 0 1</translate>"
      "<node id=\"n\"><translate>1 0 0</translate></node></node></library_nodes>";
  file.nodes = "<node><rotate>0 1 0 90</rotate><instance_node url=\"#part\"/></node>";
  const PhysicsDocument document = parsed(file.text());
  expectNear(document.bodies.at(0).pose.position, {1.0F, 0.0F, -1.0F});
  EXPECT_THAT(document.warnings, SizeIs(0));
}

TEST(ColladaNodes, ShowTheirMeshInTheFrameOfTheBody) {
  SceneFile file;
  file.libraries = "<library_geometries>" + test::geometry("g", "mesh", 1, "1 0 0") + "</library_geometries>";
  file.nodes =
      "<node id=\"n\"><translate>5 0 0</translate><instance_geometry url=\"#g\"/>"
      "<node><translate>0 2 0</translate><instance_geometry url=\"#g\"/></node>"
      "<node id=\"other\"><instance_geometry url=\"#g\"/></node></node>";
  file.instances =
      "<instance_physics_model url=\"#m\"><instance_rigid_body body=\"b\" target=\"#n\"/>"
      "<instance_rigid_body body=\"b\" target=\"#other\"/></instance_physics_model>";
  const PhysicsDocument document = parsed(file.text());
  ASSERT_THAT(document.bodies, SizeIs(2));
  // The inner node has a body of its own, which takes its mesh along.
  EXPECT_THAT(document.models.at(document.bodies[0].model).mesh.vertices,
              testing::ElementsAre(Vec3(1.0F, 0.0F, 0.0F), Vec3(1.0F, 2.0F, 0.0F)));
  EXPECT_THAT(document.models.at(document.bodies[1].model).mesh.vertices,
              testing::ElementsAre(Vec3(1.0F, 0.0F, 0.0F)));
  EXPECT_NE(document.bodies[0].model, document.bodies[1].model);
}

/// The shape of a body whose node has this scale.
DocumentShape scaled(const std::string& scale, const std::string& shape, std::string* warnings = nullptr) {
  SceneFile file;
  file.common = "<shape>" + shape + "</shape>";
  file.nodes = "<node id=\"n\"><scale>" + scale + "</scale></node>";
  const PhysicsDocument document = parsed(file.text());
  for (const std::string& warning : document.warnings) {
    if (warnings != nullptr) {
      warnings->append(warning);
    }
  }
  return document.models.at(0).shapes.at(0);
}

TEST(ColladaScale, GoesIntoBoxesExactly) {
  const DocumentShape straight =
      scaled("1 2 -3", "<box><half_extents>1 1 1</half_extents></box><translate>1 1 1</translate>");
  EXPECT_EQ(std::get<Box>(std::get<ConvexShape>(straight.geometry)).halfExtents, Vec3(1.0F, 2.0F, 3.0F));
  expectNear(straight.pose.position, {1.0F, 2.0F, -3.0F});
  // A turned box becomes a hull of its scaled corners.
  const DocumentShape turned =
      scaled("2 1 1", "<box><half_extents>1 1 1</half_extents></box><rotate>0 0 1 45</rotate>");
  const auto& corners = std::get<ConvexHull>(std::get<ConvexShape>(turned.geometry)).vertices;
  ASSERT_THAT(corners, SizeIs(8));
  for (const Vec3& corner : corners) {
    const Vec3 image = turned.pose(corner);
    EXPECT_NEAR(std::abs(image.x) / 2.0F + std::abs(image.y), std::sqrt(2.0F), 1e-5F);
  }
}

TEST(ColladaScale, GoesIntoRoundShapesWhereTheyStayRound) {
  const auto sphere = scaled("2 2 2", "<sphere><radius>1</radius></sphere>");
  EXPECT_EQ(std::get<Sphere>(std::get<ConvexShape>(sphere.geometry)).radius, 2.0F);
  const auto cylinder = scaled("2 3 2", "<cylinder><height>2</height><radius>1 1</radius></cylinder>");
  EXPECT_EQ(std::get<Cylinder>(std::get<ConvexShape>(cylinder.geometry)).radius, 2.0F);
  EXPECT_EQ(std::get<Cylinder>(std::get<ConvexShape>(cylinder.geometry)).halfHeight, 3.0F);
  std::string warnings;
  const auto ellipsoid = scaled("1 2 3", "<sphere><radius>1</radius></sphere>", &warnings);
  for (const Vec3& v : std::get<ConvexHull>(std::get<ConvexShape>(ellipsoid.geometry)).vertices) {
    EXPECT_NEAR(glm::length(v / Vec3(1.0F, 2.0F, 3.0F)), 1.0F, 1e-5F);
  }
  EXPECT_THAT(warnings, HasSubstr("a convex hull is taken for its round shapes"));
}

TEST(ColladaScale, GoesIntoPlanes) {
  const auto plane =
      scaled("1 3 1", "<plane><equation>0 1 0 -2</equation></plane><translate>0 1 0</translate>");
  EXPECT_EQ(std::get<DocumentPlane>(plane.geometry).offset + plane.pose.position.y, 9.0F);
}

TEST(ColladaInstance, OverridesWhatItsBodySays) {
  SceneFile file;
  file.instances =
      "<instance_physics_model url=\"#m\"><instance_rigid_body body=\"b\" target=\"#n\"/>"
      "<instance_rigid_body body=\"b\" name=\"odd\" target=\"#n\"><technique_common>"
      "<angular_velocity>0 0 180</angular_velocity><velocity>1 2 3</velocity><dynamic>false</dynamic>"
      "<mass>7</mass><inertia>1 1 1</inertia><physics_material><technique_common><restitution>1</restitution>"
      "</technique_common></physics_material><shape><sphere><radius>4</radius></sphere></shape>"
      "</technique_common></instance_rigid_body></instance_physics_model>";
  const PhysicsDocument document = parsed(file.text());
  ASSERT_THAT(document.bodies, SizeIs(2));
  const DocumentBody& odd = document.bodies[1];
  EXPECT_EQ(odd.motion, DocumentMotion::kStatic);
  EXPECT_EQ(odd.mass, 7.0F);
  EXPECT_EQ(odd.linearVelocity, Vec3(1.0F, 2.0F, 3.0F));
  EXPECT_NEAR(odd.angularVelocity.z, 3.1415926F, 1e-5F);
  EXPECT_NE(odd.model, document.bodies[0].model);
  const DocumentModel& model = document.models.at(odd.model);
  EXPECT_EQ(std::get<Sphere>(std::get<ConvexShape>(model.shapes.at(0).geometry)).radius, 4.0F);
  EXPECT_EQ(document.materials.at(model.material.value_or(9)).restitution, 1.0F);
  EXPECT_FALSE(document.bodies[0].motion.has_value());
  // Both stand at one node; names are unique all the same.
  EXPECT_EQ(document.bodies[0].name, "thing");
  EXPECT_EQ(odd.name, "thing-2");
}

TEST(ColladaInstance, SharesAModelThatLooksTheSame) {
  SceneFile file;
  file.nodes = "<node id=\"n\"/><node id=\"k\"><translate>9 0 0</translate></node>";
  file.instances =
      "<instance_physics_model url=\"#m\"><instance_rigid_body body=\"b\" target=\"#n\"/>"
      "<instance_rigid_body body=\"b\" target=\"#k\"/></instance_physics_model>";
  const PhysicsDocument document = parsed(file.text());
  EXPECT_THAT(document.models, SizeIs(1));
  EXPECT_THAT(document.bodies, SizeIs(2));
}

TEST(ColladaInstance, IsKinematicIfItsOwnDataSaysSo) {
  SceneFile file;
  file.common = "<dynamic>false</dynamic>" + file.common;
  file.instances =
      "<instance_physics_model url=\"#m\"><instance_rigid_body body=\"b\" target=\"#n\"><technique_common>"
      "<dynamic>false</dynamic></technique_common><extra><technique profile=\"SCATTER\"><motion>kinematic"
      "</motion></technique></extra></instance_rigid_body></instance_physics_model>";
  const PhysicsDocument document = parsed(file.text());
  EXPECT_EQ(document.models.at(0).motion, DocumentMotion::kStatic);
  EXPECT_EQ(document.bodies.at(0).motion, DocumentMotion::kKinematic);
}

TEST(ColladaInstance, IsFoundInModelsInModels) {
  SceneFile file;
  file.models =
      "<physics_model id=\"outer\"><instance_physics_model url=\"#m\"><instance_rigid_body body=\"b\" "
      "target=\"#n\"/></instance_physics_model><rigid_constraint sid=\"j\"><ref_attachment/>"
      "<attachment rigid_body=\"b\"/><technique_common/></rigid_constraint></physics_model>";
  file.instances =
      "<instance_physics_model url=\"#outer\"><instance_rigid_constraint constraint=\"j\"/>"
      "</instance_physics_model>";
  const PhysicsDocument document = parsed(file.text());
  EXPECT_THAT(document.bodies, SizeIs(1));
  ASSERT_THAT(document.joints, SizeIs(1));
  EXPECT_EQ(document.joints[0].bodyB, 0U);
}

TEST(ColladaJoint, CanHangOnANode) {
  SceneFile file;
  file.nodes += "<node id=\"hook\"><translate>0 9 0</translate><rotate>0 0 1 90</rotate></node>";
  file.models =
      "<physics_model id=\"joints\"><rigid_constraint sid=\"j\" name=\"rope\">"
      "<ref_attachment rigid_body=\"#hook\"><translate>1 0 0</translate></ref_attachment>"
      "<attachment rigid_body=\"#n\"/><technique_common><enabled>false</enabled></technique_common>"
      "</rigid_constraint></physics_model>";
  file.instances +=
      "<instance_physics_model url=\"#joints\"><instance_rigid_constraint constraint=\"j\"/>"
      "</instance_physics_model>";
  const PhysicsDocument document = parsed(file.text());
  ASSERT_THAT(document.joints, SizeIs(1));
  const DocumentJoint& rope = document.joints[0];
  EXPECT_EQ(rope.name, "rope");
  EXPECT_FALSE(rope.enabled);
  EXPECT_FALSE(rope.bodyA.has_value());
  EXPECT_EQ(rope.bodyB, 0U);
  expectNear(rope.frameA.position, {0.0F, 10.0F, 0.0F});
}

TEST(ColladaScenes, AreThoseThatTheSceneInstances) {
  SceneFile file;
  file.instances +=
      "<technique_common><gravity>1 1 1</gravity></technique_common></physics_scene>"
      "<physics_scene id=\"chosen\"><instance_physics_model url=\"#m\"><instance_rigid_body "
      "body=\"b\" target=\"#n\"/></instance_physics_model>";
  file.world = "<gravity>0 2 0</gravity>";
  file.scene = "<scene><instance_physics_scene url=\"#chosen\"/></scene>";
  EXPECT_EQ(parsed(file.text()).gravity, Vec3(0.0F, 2.0F, 0.0F));
  EXPECT_THAT(parsed(file.text()).bodies, SizeIs(1));
  file.scene = "<scene/>";
  EXPECT_EQ(parsed(file.text()).gravity, Vec3(1.0F));
  EXPECT_THAT(parsed(file.text()).warnings, Contains(HasSubstr("the first one is read")));
  file.scene = "<scene><instance_physics_scene url=\"#chosen\"/><instance_physics_scene url=\"#s\"/></scene>";
  EXPECT_EQ(parsed(file.text()).gravity, Vec3(0.0F, 2.0F, 0.0F));
  EXPECT_THAT(parsed(file.text()).bodies, SizeIs(2));
}

TEST(ColladaScenes, TurnEverythingThatHasADirection) {
  SceneFile file;
  file.asset = "<up_axis>Z_UP</up_axis>";
  file.world = "<gravity>0 0 -9.81</gravity>";
  file.instances =
      "<instance_physics_model url=\"#m\"><instance_rigid_body body=\"b\" target=\"#n\"><technique_common>"
      "<angular_velocity>0 0 180</angular_velocity><velocity>1 2 3</velocity></technique_common>"
      "</instance_rigid_body></instance_physics_model>";
  const PhysicsDocument document = parsed(file.text());
  EXPECT_EQ(document.gravity, Vec3(0.0F, -9.81F, 0.0F));
  EXPECT_EQ(document.bodies.at(0).linearVelocity, Vec3(1.0F, 3.0F, -2.0F));
  expectNear(document.bodies[0].angularVelocity, {0.0F, 3.1415926F, 0.0F});
  EXPECT_EQ(document.bodies[0].pose.position, Vec3(1.0F, 3.0F, -2.0F));
  file.asset = "<up_axis>X_UP</up_axis>";
  file.world = "<gravity>-9.81 0 0</gravity>";
  EXPECT_EQ(parsed(file.text()).gravity, Vec3(0.0F, -9.81F, 0.0F));
}

}  // namespace
}  // namespace scatter
