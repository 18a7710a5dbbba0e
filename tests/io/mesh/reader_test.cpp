#include <scatter/io/mesh_file.h>

#include <gmock/gmock.h>
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "io/mesh/files.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Bounds boundsOf(const SurfaceMesh& mesh) {
  Bounds bounds{Vec3(std::numeric_limits<float>::max()), Vec3(-std::numeric_limits<float>::max())};
  for (const Vec3& v : mesh.vertices) {
    bounds.min = glm::min(bounds.min, v);
    bounds.max = glm::max(bounds.max, v);
  }
  return bounds;
}

/// Positive if the triangles are counter-clockwise seen from outside.
double volumeOf(const SurfaceMesh& mesh) {
  double volume = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 va(mesh.vertices[a]);
    volume += glm::dot(va, glm::cross(glm::dvec3(mesh.vertices[b]), glm::dvec3(mesh.vertices[c]))) / 6.0;
  }
  return volume;
}

/// No component differs by more than rounding.
void expectNear(const Vec3& a, const Vec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-5F) << a.x << " " << a.y << " " << a.z;
}

class MeshReader : public testing::Test {
 protected:
  Result<MeshFile> read(const char* name, const std::string& bytes, const MeshOptions& options = {}) {
    test::writeText(folder_ / name, bytes);
    return readMesh(folder_ / name, options);
  }

  void expectBox(const char* name, const std::string& bytes, const MeshOptions& options, const Vec3& min,
                 const Vec3& max) {
    const auto file = read(name, bytes, options);
    ASSERT_TRUE(file.has_value()) << file.error().message;
    EXPECT_EQ(file->mesh.triangles.size(), 12U);
    expectNear(boundsOf(file->mesh).min, min);
    expectNear(boundsOf(file->mesh).max, max);
    const Vec3 size = max - min;
    const double volume =
        static_cast<double>(size.x) * static_cast<double>(size.y) * static_cast<double>(size.z);
    EXPECT_NEAR(volumeOf(file->mesh) / volume, 1.0, 1e-5);
    EXPECT_THAT(file->warnings, IsEmpty());
  }

  void expectRefused(const char* name, const std::string& bytes, const std::string& part,
                     const MeshOptions& options = {}) {
    const auto file = read(name, bytes, options);
    ASSERT_FALSE(file.has_value());
    EXPECT_THAT(file.error().message, HasSubstr((folder_ / name).string()));
    EXPECT_THAT(file.error().message, HasSubstr(part));
    EXPECT_EQ(file.error().message.find('\n'), std::string::npos);
  }

  test::TemporaryFolder folder_;
};

TEST_F(MeshReader, ReadsEveryFormat) {
  const Vec3 min(0.0F);
  const Vec3 max(1.0F, 2.0F, 3.0F);
  expectBox("box.obj", test::objBox(), {}, min, max);
  expectBox("ascii.stl", test::asciiStlBox(), {}, min, max);
  expectBox("BINARY.STL", test::binaryStlBox(), {}, min, max);
  expectBox("box.ply", test::plyBox(), {}, min, max);
  expectBox("box.dae", test::daeBox(), {}, min, max);
  expectBox("box.gltf", test::gltfBox(), {}, min, max);
  expectBox("box.glb", test::glbBox(), {}, min, max);
  expectBox("box.off", test::offBox(), {}, min, max);
}

TEST_F(MeshReader, TakesTheNameOfTheFile) {
  const auto file = read("old chair.v2.obj", test::objBox());
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->name, "old chair.v2");
  EXPECT_EQ(file->pieces, 1);
  EXPECT_EQ(file->mesh.vertices.size(), 8U);
}

TEST_F(MeshReader, UnitScalesPlainFormats) {
  MeshOptions cm;
  cm.unit = 0.01;
  expectBox("box.obj", test::objBox(), cm, Vec3(0.0F), Vec3(0.01F, 0.02F, 0.03F));
  expectBox("box.stl", test::binaryStlBox(), cm, Vec3(0.0F), Vec3(0.01F, 0.02F, 0.03F));
}

TEST_F(MeshReader, KeepsColladasUnitAndUpAxis) {
  // Z up: (x, y, z) becomes (x, z, -y).
  expectBox("box.dae", test::daeBox("<unit meter=\"0.01\"/><up_axis>Z_UP</up_axis>"), {},
            Vec3(0.0F, 0.0F, -0.02F), Vec3(0.01F, 0.03F, 0.0F));
}

TEST_F(MeshReader, KeepsTheUnitAndAxesOfFbx) {
  // Without a word they are centimetres.
  expectBox("box.fbx", test::fbxBox(), {}, Vec3(0.0F), Vec3(0.01F, 0.02F, 0.03F));
  expectBox("metres.fbx", test::fbxBox("P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",100\n"), {},
            Vec3(0.0F), Vec3(1.0F, 2.0F, 3.0F));
  const std::string zUp =
      "P: \"UpAxis\", \"int\", \"Integer\", \"\",2\nP: \"UpAxisSign\", \"int\", \"Integer\", \"\",1\n"
      "P: \"FrontAxis\", \"int\", \"Integer\", \"\",1\nP: \"FrontAxisSign\", \"int\", \"Integer\", \"\",-1\n"
      "P: \"CoordAxis\", \"int\", \"Integer\", \"\",0\nP: \"CoordAxisSign\", \"int\", \"Integer\", \"\",1\n";
  expectBox("upright.fbx", test::fbxBox(zUp), {}, Vec3(0.0F, 0.0F, -0.02F), Vec3(0.01F, 0.03F, 0.0F));
  MeshOptions inches;
  inches.unit = 0.0254;
  inches.up = UpAxis::kX;  // Not asked: the file says it.
  expectBox("inches.fbx", test::fbxBox(zUp), inches, Vec3(0.0F, 0.0F, -0.0508F),
            Vec3(0.0254F, 0.0762F, 0.0F));
}

TEST_F(MeshReader, UnitReplacesColladas) {
  MeshOptions inches;
  inches.unit = 0.0254;
  expectBox("box.dae", test::daeBox("<unit meter=\"0.01\"/>"), inches, Vec3(0.0F),
            Vec3(0.0254F, 0.0508F, 0.0762F));
}

TEST_F(MeshReader, TurnsPlainFormatsUpright) {
  MeshOptions options;
  options.up = UpAxis::kZ;
  expectBox("box.obj", test::objBox(), options, Vec3(0.0F, 0.0F, -2.0F), Vec3(1.0F, 3.0F, 0.0F));
  options.up = UpAxis::kX;
  expectBox("box.ply", test::plyBox(), options, Vec3(-2.0F, 0.0F, 0.0F), Vec3(0.0F, 1.0F, 3.0F));
}

TEST_F(MeshReader, AppliesNodeTransforms) {
  expectBox("box.dae", test::daeBox("", "<translate>10 0 0</translate><scale>2 2 2</scale>"), {},
            Vec3(10.0F, 0.0F, 0.0F), Vec3(12.0F, 4.0F, 6.0F));
  expectBox("box.gltf", test::gltfBox(R"("translation":[0,5,0],)"), {}, Vec3(0.0F, 5.0F, 0.0F),
            Vec3(1.0F, 7.0F, 3.0F));
}

TEST_F(MeshReader, TurnsMirroredTrianglesBack) {
  expectBox("box.gltf", test::gltfBox(R"("scale":[1,1,-1],)"), {}, Vec3(0.0F, 0.0F, -3.0F),
            Vec3(1.0F, 2.0F, 0.0F));
}

TEST_F(MeshReader, JoinsAllMeshesOfAFile) {
  const std::string two = test::objBox() + "o other\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 9 10 11\n";
  const auto file = read("two.obj", two);
  ASSERT_TRUE(file.has_value()) << file.error().message;
  EXPECT_EQ(file->pieces, 2);
  EXPECT_EQ(file->mesh.triangles.size(), 13U);
}

/// "KIND name first-last …" of each group, kinds counted from 0.
std::vector<std::string> groupsOf(const MeshFile& file) {
  std::vector<std::string> texts;
  for (const MeshGroup& group : file.groups) {
    std::string text = std::to_string(static_cast<int>(group.kind)) + " " + group.name;
    for (const auto& [first, last] : group.runs)
      text += " " + std::to_string(first) + "-" + std::to_string(last);
    texts.push_back(text);
  }
  return texts;
}

TEST_F(MeshReader, KnowsMaterialsAndObjectsByName) {
  const auto obj = read("tool.obj", test::objTool());
  ASSERT_TRUE(obj.has_value()) << obj.error().message;
  EXPECT_THAT(groupsOf(*obj), testing::UnorderedElementsAre("0 steel 0-12", "0 rubber 12-36", "1 body 0-12",
                                                            "1 handle 12-24", "1 tip 24-36"));
  const auto gltf = read("named.gltf", test::gltfBox(R"("name":"hull",)"));
  ASSERT_TRUE(gltf.has_value()) << gltf.error().message;
  EXPECT_THAT(groupsOf(*gltf), testing::Contains("1 hull 0-12"));
  const auto dae = read("box.dae", test::daeBox());
  ASSERT_TRUE(dae.has_value());
  EXPECT_FALSE(dae->groups.empty());
  const auto nameless = read("nameless.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_TRUE(nameless.has_value());
  EXPECT_THAT(groupsOf(*nameless), testing::IsEmpty());
}

TEST_F(MeshReader, AnObjectIsAllThatIsUnderItsNode) {
  const std::string two =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)"
      R"({"name":"tank","mesh":0,"children":[1]},{"name":"turret","mesh":0,"children":[2]},)"
      R"({"name":"turret","mesh":0}],)";
  const std::string box = test::gltfBox();
  const auto file = read("tank.gltf", two + box.substr(box.find("\"meshes\"")));
  ASSERT_TRUE(file.has_value()) << file.error().message;
  EXPECT_THAT(groupsOf(*file), testing::IsSupersetOf({"1 tank 0-36", "1 turret 12-36"}));
}

TEST_F(MeshReader, VertexGroupsAreTheTrianglesThatFollowABone) {
  const auto file = read("skinned.gltf", test::gltfSkinnedBox());
  ASSERT_TRUE(file.has_value()) << file.error().message;
  const auto group = [&file](const std::string& name) {
    std::size_t count = 0;
    for (const MeshGroup& one : file->groups) {
      if (one.kind != MeshGroupKind::kVertexGroup || one.name != name) continue;
      for (const auto& [first, last] : one.runs) count += last - first;
    }
    return count;
  };
  // The two of the end, and of the eight on the sides those with two corners there.
  EXPECT_EQ(group("low"), 6U);
  EXPECT_EQ(group("high"), 6U);
}

TEST_F(MeshReader, TellsHowItsUnitAndAxesWereTurned) {
  MeshOptions options;
  options.unit = 0.01;
  options.up = UpAxis::kZ;
  const auto obj = read("box.obj", test::objBox(), options);
  ASSERT_TRUE(obj.has_value());
  expectNear(obj->fromFile * Vec3(1.0F, 2.0F, 3.0F), Vec3(0.01F, 0.03F, -0.02F));
  const auto fbx = read("box.fbx", test::fbxBox());
  ASSERT_TRUE(fbx.has_value());
  expectNear(fbx->fromFile * Vec3(1.0F, 2.0F, 3.0F), Vec3(0.01F, 0.02F, 0.03F));
  const auto dae = read("box.dae", test::daeBox("<unit meter=\"0.01\"/>"));
  ASSERT_TRUE(dae.has_value());
  EXPECT_EQ(dae->fromFile, Mat3(1.0F));
}

TEST_F(MeshReader, CutsConcavePolygons) {
  // An L of area 3 in one polygon.
  const auto file = read("l.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
  ASSERT_TRUE(file.has_value()) << file.error().message;
  ASSERT_EQ(file->mesh.triangles.size(), 4U);
  double area = 0.0;
  for (const auto& [a, b, c] : file->mesh.triangles) {
    const auto& v = file->mesh.vertices;
    area += 0.5 * static_cast<double>(glm::length(glm::cross(v[b] - v[a], v[c] - v[a])));
  }
  EXPECT_NEAR(area, 3.0, 1e-6);
}

TEST_F(MeshReader, LeavesOutPointsAndLinesWithAWarning) {
  const auto file = read("mixed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 9\nf 1 2 3\nl 1 4\n");
  ASSERT_TRUE(file.has_value()) << file.error().message;
  EXPECT_EQ(file->mesh.triangles.size(), 1U);
  EXPECT_EQ(file->mesh.vertices.size(), 3U);
  EXPECT_THAT(file->warnings, ElementsAre(HasSubstr("1 lines are left out")));
}

TEST_F(MeshReader, RefusesWhatIsNoMesh) {
  expectRefused("empty.obj", "", "is empty");
  expectRefused("text.obj", "Dear Sir or Madam\n", "");
  expectRefused("points.ply",
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n0 0 0\n",
                "");
  expectRefused("cut.ply", test::plyBox().substr(0, 60), "end_header");
  expectRefused("box.txt", test::objBox(), "known are obj, stl, ply, fbx, dae, gltf, glb, ");
  expectRefused("box.step", test::objBox(), "cannot be read");
  expectRefused("box", test::objBox(), "extension");
  expectRefused("cut.dae", test::daeBox().substr(0, 500), "");
  expectRefused("cut.stl", test::binaryStlBox().substr(0, 200), "");
  expectRefused("json.gltf", "{\"asset\":", "");
  expectRefused("fake.glb", std::string(64, '\xff'), "");
}

TEST_F(MeshReader, RefusesNumbersThatAreNotFinite) {
  expectRefused("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not finite");
  expectRefused(
      "inf.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n",
      "not finite");
  MeshOptions light;
  light.unit = 9.46e15;
  expectRefused("far.obj", "v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "fit a float", light);
}

TEST_F(MeshReader, KeepsItsLimits) {
  MeshOptions options;
  options.maxTriangles = 11;
  expectRefused("box.obj", test::objBox(), "more than 11 triangles", options);
  options.maxFileBytes = 16;
  expectRefused("box.obj", test::objBox(), "is larger than", options);
}

TEST_F(MeshReader, RefusesFilesThatAreNotThere) {
  const auto missing = readMesh(folder_ / "missing.obj");
  ASSERT_FALSE(missing.has_value());
  EXPECT_THAT(missing.error().message, HasSubstr("No such file"));
  std::filesystem::create_directory(folder_ / "folder.obj");
  const auto folder = readMesh(folder_ / "folder.obj");
  ASSERT_FALSE(folder.has_value());
  EXPECT_THAT(folder.error().message, HasSubstr("no plain file"));
}

TEST_F(MeshReader, ReadsNoFilesOutsideItsFolder) {
  std::filesystem::create_directory(folder_ / "inner");
  const std::string separate =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"URI"}]})";
  const auto withUri = [&](const std::string& uri) {
    std::string text = separate;
    return text.replace(text.find("URI"), 3, uri);
  };
  const std::string bytes = test::glbBox();
  test::writeText(folder_ / "inner/data.bin", bytes.substr(bytes.size() - 168, 36));
  test::writeText(folder_ / "outside.bin", bytes.substr(bytes.size() - 168, 36));
  EXPECT_TRUE(read("inner/own.gltf", withUri("data.bin")).has_value());
  EXPECT_FALSE(read("inner/other.gltf", withUri("../outside.bin")).has_value());
  EXPECT_FALSE(read("inner/device.gltf", withUri("/dev/zero")).has_value());
}

TEST(Unit, IsANumberOrAName) {
  EXPECT_EQ(parseUnit("cm").value_or(0.0), 0.01);
  EXPECT_EQ(parseUnit("0.3").value_or(0.0), 0.3);
  for (const char* wrong : {"", "0", "-1", "nan", "inf", "1 m", "parsec"})
    EXPECT_FALSE(parseUnit(wrong)) << wrong;
}

}  // namespace
}  // namespace scatter
