#include <gmock/gmock.h>
#include <scatter/io/gltf.h>

#include <string>

#include "io/gltf/text.h"

namespace scatter {
namespace {

using test::bufferMembers;
using test::bytesOf;
using test::GltfText;
using test::physicsNode;
using testing::ElementsAre;

/// The mesh that is drawn with a body: one primitive of the members given, over a buffer.
VisualMesh readMesh(const std::string& bytes, const std::string& views, const std::string& accessors,
                    const std::string& primitive, const std::string& nodeMembers = "") {
  GltfText file;
  file.nodes = test::boxNode("", "\"mesh\":0" + nodeMembers);
  file.more = bufferMembers(bytes, views, accessors) + R"(,"meshes":[{"primitives":[{)" + primitive + "}]}]";
  const PhysicsDocument document = test::readGltf(file.text());
  return document.models.empty() ? VisualMesh{} : document.models[0].mesh;
}

const std::vector<float> kSquare{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
constexpr const char* kFloatView = R"({"buffer":0,"byteLength":48})";
constexpr const char* kFloats = R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4})";

using Triangle = std::array<std::uint32_t, 3>;

TEST(GltfMesh, StripsAndFansBecomeTriangles) {
  const auto strip =
      readMesh(bytesOf(kSquare), kFloatView, kFloats, R"("attributes":{"POSITION":0},"mode":5)");
  EXPECT_THAT(strip.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}));
  const auto fan = readMesh(bytesOf(kSquare), kFloatView, kFloats, R"("attributes":{"POSITION":0},"mode":6)");
  EXPECT_THAT(fan.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(GltfMesh, IndicesOfAllSizesAreRead) {
  const auto read = [](const std::string& indices, int component) {
    const std::string views = R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":)" +
                              std::to_string(indices.size()) + "}";
    const std::string accessors = std::string(kFloats) + R"(,{"bufferView":1,"type":"SCALAR","count":3,)" +
                                  R"("componentType":)" + std::to_string(component) + "}";
    return readMesh(bytesOf(kSquare) + indices, views, accessors,
                    R"("attributes":{"POSITION":0},"indices":1)");
  };
  for (const VisualMesh& mesh : {read(bytesOf(std::vector<std::uint8_t>{3, 2, 1}), 5121),
                                 read(bytesOf(std::vector<std::uint16_t>{3, 2, 1}), 5123),
                                 read(bytesOf(std::vector<std::uint32_t>{3, 2, 1}), 5125)}) {
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{3, 2, 1}));
    EXPECT_EQ(mesh.vertices.size(), 4U);
  }
}

TEST(GltfMesh, StrideAndNormalizedIntegersAreRead) {
  const std::vector<std::int8_t> bytes{127, 0, -127, 99, -128, 64, 0, 99};
  const auto mesh =
      readMesh(bytesOf(bytes), R"({"buffer":0,"byteLength":8,"byteStride":4})",
               R"({"bufferView":0,"componentType":5120,"normalized":true,"type":"VEC3","count":2})",
               R"("attributes":{"POSITION":0},"mode":0)");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vec3(1, 0, -1), Vec3(-1, 64.0F / 127.0F, 0)));
}

TEST(GltfMesh, PlainIntegersAreRead) {
  const std::vector<std::int16_t> numbers{1, -2, 300};
  const auto mesh = readMesh(bytesOf(numbers), R"({"buffer":0,"byteLength":6})",
                             R"({"bufferView":0,"componentType":5122,"type":"VEC3","count":1})",
                             R"("attributes":{"POSITION":0},"mode":0)");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vec3(1, -2, 300)));
}

TEST(GltfMesh, SparseAccessorsReplaceElements) {
  const std::string bytes =
      bytesOf(kSquare) + bytesOf(std::vector<std::uint16_t>{2, 0}) + bytesOf(std::vector<float>{7, 8, 9});
  const std::string views = R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":4},)"
                            R"({"buffer":0,"byteOffset":52,"byteLength":12})";
  const std::string sparse = R"("sparse":{"count":1,"indices":{"bufferView":1,"componentType":5123},)"
                             R"("values":{"bufferView":2}})";
  const auto based = readMesh(
      bytes, views, R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4,)" + sparse + "}",
      R"("attributes":{"POSITION":0},"mode":0)");
  EXPECT_THAT(based.vertices, ElementsAre(Vec3(0), Vec3(1, 0, 0), Vec3(7, 8, 9), Vec3(1, 1, 0)));
  const auto zeros =
      readMesh(bytes, views, R"({"componentType":5126,"type":"VEC3","count":3,)" + sparse + "}",
               R"("attributes":{"POSITION":0},"mode":0)");
  EXPECT_THAT(zeros.vertices, ElementsAre(Vec3(0), Vec3(0), Vec3(7, 8, 9)));
}

TEST(GltfMesh, AMirroredNodeKeepsTheOutsideOut) {
  const auto mesh = readMesh(bytesOf(kSquare), kFloatView, kFloats, R"("attributes":{"POSITION":0},"mode":5)",
                             R"(,"scale":[-2,1,1])");
  EXPECT_EQ(mesh.vertices.at(1), Vec3(-2, 0, 0));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 2, 1}, Triangle{2, 3, 1}));
}

TEST(GltfMesh, ColliderMeshesIncludeTheNodesBelow) {
  GltfText file;
  // The place of node 1 itself does not count, that of the node below it does.
  file.nodes = physicsNode(R"("collider":{"geometry":{"node":1}})") +
               R"(,{"mesh":0,"translation":[9,9,9],"children":[2]},{"mesh":0,"translation":[0,0,5]})";
  file.more = bufferMembers(bytesOf(kSquare), kFloatView, kFloats) +
              R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}])";
  const PhysicsDocument document = test::readGltf(file.text());
  const auto& mesh = std::get<VisualMesh>(document.models.at(0).shapes.at(0).geometry);
  ASSERT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.vertices[1], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.vertices[5], Vec3(1, 0, 5));
  EXPECT_EQ(mesh.triangles.size(), 4U);
}

TEST(GltfMesh, HullsKeepOnlyTheirCorners) {
  GltfText file;
  const std::vector<float> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1F, 0.1F, 0.1F, 0, 0, 0};
  file.nodes = physicsNode(R"("collider":{"geometry":{"node":1,"convexHull":true}})") + R"(,{"mesh":0})";
  file.more = bufferMembers(bytesOf(points), R"({"buffer":0,"byteLength":72})",
                            R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":6})") +
              R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";
  const PhysicsDocument document = test::readGltf(file.text());
  const auto& hull = std::get<ConvexHull>(std::get<ConvexShape>(document.models.at(0).shapes.at(0).geometry));
  EXPECT_THAT(hull.vertices, ElementsAre(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)));
}

TEST(GltfMesh, AFlatHullIsLeftOutAndNamed) {
  GltfText file;
  file.nodes = physicsNode(R"("collider":{"geometry":{"node":1,"convexHull":true}})") + R"(,{"mesh":0})";
  file.more = bufferMembers(bytesOf(kSquare), kFloatView, kFloats) +
              R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";
  const PhysicsDocument document = test::readGltf(file.text());
  EXPECT_TRUE(document.bodies.empty());
  EXPECT_THAT(document.warnings, testing::Contains(testing::HasSubstr("no convex hull with a volume")));
}

}  // namespace
}  // namespace scatter
