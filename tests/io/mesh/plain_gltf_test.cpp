#include <scatter/io/mesh_file.h>

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <string>

#include "io/mesh/files.h"
#include "io/mesh/packed_gltf.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

using test::Packing;
using testing::HasSubstr;

/// A bumpy ball within -1 to 1, of triangles whose corners are shared.
SurfaceMesh bumpyBall(std::uint64_t seed) {
  constexpr std::uint32_t kRings = 14;
  constexpr std::uint32_t kPerRing = 17;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> radius(0.5F, 1.0F);
  SurfaceMesh mesh;
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t i = 0; i < kPerRing; ++i) {
      const float latitude = 3.1F * (static_cast<float>(ring) + 0.5F) / kRings;
      const float longitude = 6.2832F * static_cast<float>(i) / kPerRing;
      mesh.vertices.push_back(radius(random) * Vec3(std::sin(latitude) * std::cos(longitude),
                                                    std::cos(latitude),
                                                    std::sin(latitude) * std::sin(longitude)));
      if (ring == 0) continue;
      const std::uint32_t next = (i + 1) % kPerRing;
      const std::uint32_t below = ring * kPerRing;
      const std::uint32_t above = below - kPerRing;
      mesh.triangles.push_back({above + i, below + next, below + i});
      mesh.triangles.push_back({above + i, above + next, below + next});
    }
  }
  return mesh;
}

/// How far the corners of two triangles are apart along an axis, whichever corner comes first.
double distanceOf(const SurfaceMesh& a, const SurfaceMesh& b, std::size_t triangle) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t shift = 0; shift < 3; ++shift) {
    double most = 0.0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3 difference = glm::abs(a.vertices[a.triangles[triangle][corner]] -
                                       b.vertices[b.triangles[triangle][(corner + shift) % 3]]);
      most = std::max(most, static_cast<double>(std::max({difference.x, difference.y, difference.z})));
    }
    least = std::min(least, most);
  }
  return least;
}

void expectSame(const SurfaceMesh& read, const SurfaceMesh& mesh, double distance) {
  ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
  double most = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) most = std::max(most, distanceOf(read, mesh, i));
  EXPECT_LE(most, distance);
}

const std::vector<Packing>& packings() {
  static const std::vector<Packing> list = [] {
    std::vector<Packing> packings{{}, {.stride = 16}};
    for (const bool isNormalized : {false, true}) {
      for (const int component : {5120, 5121}) packings.push_back({component, isNormalized, 4});
      for (const int component : {5122, 5123}) packings.push_back({component, isNormalized, 8});
      packings.push_back({5123, isNormalized, 20});
    }
    for (std::size_t i = packings.size(); i-- > 0;) {
      Packing compressed = packings[i];
      compressed.isCompressed = true;
      packings.push_back(compressed);
      compressed.indices = "INDICES";
      packings.push_back(compressed);
    }
    packings.push_back({.isCompressed = true, .isExponential = true});
    return packings;
  }();
  return list;
}

class PlainGltfTest : public testing::Test {
 protected:
  Result<MeshFile> read(const char* name, const std::string& bytes) {
    test::writeText(folder_ / name, bytes);
    return readMesh(folder_ / name);
  }

  void expectRefused(const std::string& gltf, const std::string& why) {
    const auto file = read("bad.gltf", gltf);
    ASSERT_FALSE(file.has_value()) << why;
    EXPECT_THAT(file.error().message, HasSubstr(why));
    EXPECT_EQ(file.error().message.find('\n'), std::string::npos);
  }

  test::TemporaryFolder folder_;
};

TEST_F(PlainGltfTest, QuantisedAndCompressedMeshesAreWhatTheyWereToTheStep) {
  std::uint64_t seed = 1;
  for (const Packing& packing : packings()) {
    SCOPED_TRACE(testing::Message() << packing.component << (packing.isNormalized ? " normalized" : "")
                                    << ", stride " << packing.stride
                                    << (packing.isCompressed ? packing.indices : ""));
    const SurfaceMesh mesh = bumpyBall(seed++);
    const test::PackedGltf packed = test::packGltf(mesh, packing);
    const auto glb = read("ball.glb", packed.glb());
    ASSERT_TRUE(glb.has_value()) << glb.error().message;
    constexpr double kRounding = 1e-6;
    expectSame(glb->mesh, mesh, 0.5 * packed.step + kRounding);
    EXPECT_THAT(glb->warnings, testing::IsEmpty());
  }
}

TEST_F(PlainGltfTest, BuffersMayStandBesideTheFileOrInIt) {
  const SurfaceMesh mesh = bumpyBall(99);
  const test::PackedGltf packed =
      test::packGltf(mesh, {.component = 5122, .stride = 8, .isCompressed = true});
  test::writeText(folder_ / "ball data.bin", packed.data);
  for (const std::string& gltf : {packed.gltf(), packed.gltf("ball%20data.bin")}) {
    const auto file = read("ball.gltf", gltf);
    ASSERT_TRUE(file.has_value()) << file.error().message;
    expectSame(file->mesh, mesh, packed.step);
  }
  std::filesystem::create_directory(folder_ / "inner");
  const auto outside = read("inner/ball.gltf", packed.gltf("../ball%20data.bin"));
  ASSERT_FALSE(outside.has_value());
  EXPECT_THAT(outside.error().message, HasSubstr("only data and files beside this one are read"));
}

TEST_F(PlainGltfTest, SparseAccessorsAreFilledIn) {
  // All corners of the triangle but the first are stored apart.
  const std::string json =
      R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_mesh_quantization"],"scene":0,"scenes":[{"nodes":[0]}],)"
      R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{)"
      R"("componentType":5121,"count":3,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":0,"componentType":5121},)"
      R"("values":{"bufferView":1}}}],"bufferViews":[{"buffer":0,"byteLength":2},{"buffer":0,"byteOffset":4,"byteLength":6}],)"
      R"("buffers":[{"byteLength":12,"uri":"data:application/octet-stream;base64,AQIAAAcAAAAFAAAA"}]})";
  const auto file = read("sparse.gltf", json);
  ASSERT_TRUE(file.has_value()) << file.error().message;
  EXPECT_THAT(file->mesh.vertices,
              testing::ElementsAre(Vec3(0.0F), Vec3(7.0F, 0.0F, 0.0F), Vec3(0.0F, 5.0F, 0.0F)));
}

TEST_F(PlainGltfTest, NamesBonesAndAnimationsAreKept) {
  std::string box = test::gltfSkinnedBox();
  box.insert(1, R"("extensionsUsed":["KHR_mesh_quantization"],"animations":[{"channels":[],"samplers":[]}],)"
                R"("materials":[{"name":"rubber","extensions":{"KHR_materials_unlit":{}}}],)");
  box = test::replaced(box, R"("indices":1)", R"("indices":1,"material":0)");
  const auto file = read("bones.gltf", box);
  ASSERT_TRUE(file.has_value()) << file.error().message;
  std::vector<std::string> groups;
  for (const MeshGroup& group : file->groups) groups.push_back(group.name);
  EXPECT_THAT(groups, testing::IsSupersetOf({"box", "rubber", "low", "high"}));
  EXPECT_THAT(file->warnings,
              testing::UnorderedElementsAre(HasSubstr("bones are ignored"), HasSubstr("animations")));
}

TEST_F(PlainGltfTest, SaysWhenOnlyBonesKnowTheSize) {
  std::string box = test::gltfSkinnedBox();
  box.insert(1, R"("extensionsUsed":["KHR_mesh_quantization"],)");
  box =
      test::replaced(box, R"("bufferView":0,"componentType":5126)", R"("bufferView":0,"componentType":5121)");
  const auto file = read("bones.gltf", box);
  ASSERT_TRUE(file.has_value()) << file.error().message;
  EXPECT_THAT(file->warnings, testing::Contains(HasSubstr("--unit")));
}

TEST_F(PlainGltfTest, RefusesWhatCannotBe) {
  const test::PackedGltf packed = test::packGltf(
      bumpyBall(5), {.component = 5123, .isNormalized = true, .stride = 8, .isCompressed = true});
  const std::string sound = packed.gltf();
  ASSERT_TRUE(read("sound.gltf", sound).has_value());
  const auto expectRefusedWith = [&](const std::string& from, const std::string& to, const std::string& why) {
    expectRefused(test::replaced(sound, from, to), why);
  };
  expectRefusedWith(R"("count":238,"mode")", R"("count":4000000000,"mode")",
                    "4000000000 elements cannot be in");
  expectRefusedWith(R"("count":238,"mode")", R"("count":9007199254740991,"mode")", "elements cannot be in");
  expectRefusedWith(R"("count":238,"mode")", R"("count":500,"mode")",
                    "EXT_meshopt_compression: its data is damaged");
  expectRefusedWith(R"("count":238,"mode")", R"("count":200,"mode")", "");
  expectRefusedWith(R"("count":238,"type")", R"("count":239,"type")",
                    "reaches beyond the end of its buffer view");
  expectRefusedWith(R"("mode":"TRIANGLES")", R"("mode":"INDICES")", "its data is damaged");
  expectRefusedWith(R"("mode":"TRIANGLES")", R"("mode":"SQUARES")", "do not go together");
  expectRefusedWith(R"("mode":"ATTRIBUTES")", R"("mode":"ATTRIBUTES","filter":"OCTAHEDRON")",
                    "do not go together");
  expectRefusedWith(R"("byteStride":4,"count")", R"("byteStride":3,"count")", "do not go together");
  expectRefusedWith(R"("byteStride":4,"count")", R"("byteStride":0,"count")", "do not go together");
  expectRefusedWith(R"("buffer":0)", R"("buffer":1)", "has no \"uri\"");
  expectRefusedWith(R"("POSITION":0)", R"("POSITION":7)", "there is no accessor 7");
  expectRefusedWith(R"("POSITION":0)", R"("POSITION":1)", "should be \"VEC3\"");
  expectRefusedWith(R"("indices":1)", R"("indices":1,"extensions":{"KHR_draco_mesh_compression":{}})",
                    "leave one of them out");
  expectRefusedWith("EXT_meshopt_compression", "KHR_meshopt_compression", "KHR_meshopt_compression");
}

TEST_F(PlainGltfTest, RefusesIndicesOfVerticesThatAreNotThere) {
  SurfaceMesh mesh = bumpyBall(6);
  mesh.triangles[40][1] = 100000;
  expectRefused(test::packGltf(mesh, {.component = 5122, .stride = 8, .isCompressed = true}).gltf(),
                "indices: names vertex 100000 of 238");
}

TEST_F(PlainGltfTest, DracoIsReadByAssimp) {
  // The cube from (0, 0, 0) to (1, 2, 3) as Draco's own encoder writes it, positions in 14 bits.
  const std::string draco =
      R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_draco_mesh_compression"],)"
      R"("extensionsRequired":["KHR_draco_mesh_compression"],"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"extensions":{"KHR_draco_mesh_compression":)"
      R"({"bufferView":0,"attributes":{"POSITION":0}}}}]}],"accessors":[{"componentType":5126,"count":8,"type":"VEC3",)"
      R"("min":[0,0,0],"max":[1,2,3]},{"componentType":5123,"count":36,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":102}],"buffers":[{"byteLength":102,"uri":"data:application/octet-stream;base64,)"
      "RFJBQ08CAgEBAAAACAwACwEAA68+CgEBEAH/"
      "AAABAAkDAAACAQEBAA8DARgBCCsBIAQAig6CquqqGgCAqSoAEAAAAGBVAYBUFQAIAAAAAAAA/z8AAA"
      "AAAAAAAAAAAAAAAAAAQEAO\"}]}";
  const auto file = read("draco.gltf", draco);
  ASSERT_TRUE(file.has_value()) << file.error().message;
  EXPECT_EQ(file->mesh.triangles.size(), 12U);
  ASSERT_EQ(file->mesh.vertices.size(), 8U);
  for (const Vec3& vertex : file->mesh.vertices) {
    const Vec3 corner = glm::round(vertex);
    EXPECT_LT(glm::length(vertex - corner), 3.0F / 16384.0F);
    EXPECT_TRUE((corner.x == 0.0F || corner.x == 1.0F) && (corner.y == 0.0F || corner.y == 2.0F) &&
                (corner.z == 0.0F || corner.z == 3.0F));
  }
}

}  // namespace
}  // namespace scatter
