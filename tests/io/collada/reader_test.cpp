#include <scatter/io/collada.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "io/documents.h"

namespace scatter {
namespace {

using test::Document;

Model parsed(const Document& document) {
  auto model = parseCollada(document.text(), "test.dae");
  EXPECT_TRUE(model.has_value()) << model.error().message;
  return model ? *model : Model{};
}

/// The only part of a file with this one shape.
ConvexPart parsedPart(const std::string& shape, const std::string& asset = "") {
  Document document;
  document.asset = asset;
  document.finest = "<shape>" + shape + "</shape>";
  return parsed(document).levels->finest().parts.at(0);
}

void expectNear(const Vec3& actual, const Vec3& expected) {
  EXPECT_LT(glm::length(actual - expected), 1e-5F)
      << actual.x << " " << actual.y << " " << actual.z << " instead of " << expected.x << " " << expected.y
      << " " << expected.z;
}

TEST(ColladaReader, ReadsAPlainRigidBodyAsOneLevel) {
  const Model model = parsed(Document{});
  EXPECT_EQ(model.name, "brick");
  EXPECT_EQ(model.mass, 12.5F);
  EXPECT_EQ(model.levels->count(), 1);
  EXPECT_TRUE(model.mesh.vertices.empty());
  expectNear(std::get<Box>(model.levels->finest().parts.at(0).shape).halfExtents, {0.5F, 0.4F, 0.3F});
}

TEST(ColladaReader, ReadsEveryKindOfShapeLevelAndMaterial) {
  const Model model = parsed(test::richDocument());
  EXPECT_EQ(model.friction, 0.7F);
  EXPECT_EQ(model.restitution, 0.2F);
  EXPECT_EQ(model.levels->count(), 3);
  EXPECT_EQ(model.levels->hullMargin(), 0.01F);
  EXPECT_EQ(std::get<Box>(model.levels->level(1).parts.at(0).shape).halfExtents, Vec3(2.0F));
  EXPECT_EQ(std::get<Box>(model.levels->level(2).parts.at(0).shape).halfExtents, Vec3(1.0F));
  const auto& parts = model.levels->finest().parts;
  ASSERT_EQ(parts.size(), 6U);
  EXPECT_EQ(std::get<Sphere>(parts[1].shape).radius, 0.3F);
  // A capsule's height in COLLADA is that of its cylindrical part.
  EXPECT_EQ(std::get<Capsule>(parts[2].shape).halfHeight, 0.2F);
  EXPECT_EQ(std::get<Capsule>(parts[2].shape).radius, 0.1F);
  EXPECT_EQ(std::get<Cylinder>(parts[3].shape).halfHeight, 0.2F);
  EXPECT_EQ(std::get<ConvexHull>(parts[4].shape).vertices.size(), 4U);
  EXPECT_EQ(std::get<ConvexHull>(parts[5].shape).vertices, model.mesh.vertices);
}

TEST(ColladaReader, ReadsTrianglesAndPolygons) {
  const Model model = parsed(test::richDocument());
  using Triangle = std::array<std::uint32_t, 3>;
  EXPECT_EQ(model.mesh.vertices.size(), 4U);
  EXPECT_THAT(model.mesh.triangles, testing::ElementsAre(Triangle{0, 2, 1}, Triangle{0, 1, 3}));
}

TEST(ColladaReader, TakesPositionsFromInputsWithSeveralOffsets) {
  Document document;
  document.libraries =
      "<library_geometries>" +
      test::geometry("m", "mesh", 3, "0 0 0 1 0 0 0 1 0",
                     "<triangles count=\"1\"><input semantic=\"NORMAL\" source=\"#m-p\" offset=\"0\"/>"
                     "<input semantic=\"VERTEX\" source=\"#m-v\" offset=\"1\"/><p>9 0 9 1 9 2</p></triangles>"
                     "<lines count=\"1\"/>") +
      "</library_geometries>";
  const Model model = parsed(document);
  using Triangle = std::array<std::uint32_t, 3>;
  EXPECT_THAT(model.mesh.triangles, testing::ElementsAre(Triangle{0, 1, 2}));
}

TEST(ColladaReader, AppliesTransformsInTheOrderInWhichTheyStand) {
  const std::string box = "<box><half_extents>1 1 1</half_extents></box>";
  const auto moved = parsedPart(box + "<translate>1 0 0</translate><rotate>0 0 1 90</rotate>");
  expectNear(moved.pose({1.0F, 0.0F, 0.0F}), {1.0F, 1.0F, 0.0F});
  const auto turned = parsedPart(box + "<rotate>0 0 1 90</rotate><translate>1 0 0</translate>");
  expectNear(turned.pose({1.0F, 0.0F, 0.0F}), {0.0F, 2.0F, 0.0F});
  const auto twice = parsedPart(box + "<rotate>0 0 1 90</rotate><rotate>1 0 0 90</rotate>");
  expectNear(twice.pose({0.0F, 1.0F, 0.0F}), {0.0F, 0.0F, 1.0F});
}

TEST(ColladaReader, MultipliesLengthsByTheUnit) {
  Document document = test::richDocument();
  document.asset = "<unit name=\"centimeter\" meter=\"0.01\"/>";
  const Model model = parsed(document);
  const auto& parts = model.levels->finest().parts;
  expectNear(std::get<Box>(parts[0].shape).halfExtents, {0.003F, 0.002F, 0.001F});
  expectNear(parts[0].pose.position, {0.001F, 0.0F, 0.0F});
  EXPECT_FLOAT_EQ(std::get<Capsule>(parts[2].shape).halfHeight, 0.002F);
  expectNear(std::get<ConvexHull>(parts[4].shape).vertices[1], {0.002F, 0.0F, 0.0F});
  expectNear(model.mesh.vertices[1], {0.002F, 0.0F, 0.0F});
  EXPECT_FLOAT_EQ(model.levels->hullMargin(), 0.0001F);
  EXPECT_EQ(model.mass, 12.5F);
}

/// A body of one box at (1, 2, 3), long along x, and the mesh vertex (0.2, 0, 0).
Document axisDocument(const std::string& axis) {
  Document document = test::richDocument();
  document.asset = "<up_axis>" + axis + "</up_axis>";
  document.finest =
      "<shape><box><half_extents>0.3 0.2 0.1</half_extents></box><translate>1 2 3</translate></shape>";
  document.extra.clear();
  return document;
}

TEST(ColladaReader, TurnsZUpIntoYUp) {
  const Model model = parsed(axisDocument("Z_UP"));
  const ConvexPart& part = model.levels->finest().parts.at(0);
  expectNear(part.pose.position, {1.0F, 3.0F, -2.0F});
  expectNear(part.pose.rotation * Vec3(0.0F, 0.0F, 1.0F), {0.0F, 1.0F, 0.0F});
  expectNear(model.mesh.vertices[3], {0.0F, 0.2F, 0.0F});
}

TEST(ColladaReader, TurnsXUpIntoYUp) {
  const Model model = parsed(axisDocument("X_UP"));
  const ConvexPart& part = model.levels->finest().parts.at(0);
  expectNear(part.pose.position, {-2.0F, 1.0F, 3.0F});
  expectNear(model.mesh.vertices[1], {0.0F, 0.2F, 0.0F});
}

TEST(ColladaReader, IgnoresElementsItDoesNotKnow) {
  Document document;
  document.libraries = "<library_lights><light id=\"l\"/></library_lights><whatever/>";
  document.extra = "<extra><technique profile=\"OTHER\"><levels><nonsense/></levels></technique></extra>";
  document.finest =
      "<shape><hollow>false</hollow><box><half_extents>1 1 1</half_extents></box><extra/></shape><velocity/>";
  EXPECT_EQ(parsed(document).levels->count(), 1);
}

TEST(ColladaReader, AcceptsNumbersAsXmlSchemaWritesThem) {
  const ConvexPart part =
      parsedPart("<box><half_extents>\n +1.5\t2e-1 <!-- thin --> .25 </half_extents></box>");
  EXPECT_EQ(std::get<Box>(part.shape).halfExtents, Vec3(1.5F, 0.2F, 0.25F));
}

TEST(ColladaReader, AcceptsOneRadiusForRoundShapes) {
  const ConvexPart part = parsedPart("<cylinder><height>2</height><radius>0.5</radius></cylinder>");
  EXPECT_EQ(std::get<Cylinder>(part.shape).radius, 0.5F);
}

TEST(ColladaReader, NamesAModelAfterItsFileIfItHasNoName) {
  Document document;
  document.modelAttributes.clear();
  std::string text = document.text();
  text.replace(text.find(" sid=\"body\""), 11, "");
  const auto model = parseCollada(text, "models/crate.dae");
  ASSERT_TRUE(model.has_value()) << model.error().message;
  EXPECT_EQ(model->name, "crate");
}

TEST(ColladaReader, UsesTheMeshThatTheVisualSceneShows) {
  Document document = test::richDocument();
  document.libraries +=
      "<library_geometries>" + test::geometry("other", "mesh", 1, "9 9 9") +
      "</library_geometries><library_visual_scenes><visual_scene><node><node>"
      "<instance_geometry url=\"#other\"/></node></node></visual_scene></library_visual_scenes>";
  EXPECT_EQ(parsed(document).mesh.vertices.size(), 1U);
}

}  // namespace
}  // namespace scatter
