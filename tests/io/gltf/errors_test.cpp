#include <gmock/gmock.h>
#include <scatter/io/gltf.h>

#include <string>

#include "io/gltf/text.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

using test::boxNode;
using test::bufferMembers;
using test::bytesOf;
using test::GltfText;
using test::physicsNode;
using testing::HasSubstr;

void expectRefused(const std::string& bytes, const std::string& message) {
  const auto document = parseGltfDocument(bytes, "bad.gltf");
  ASSERT_FALSE(document.has_value()) << "was read, instead of: " << message;
  EXPECT_THAT(document.error().message, testing::StartsWith("bad.gltf: "));
  EXPECT_THAT(document.error().message, HasSubstr(message));
  EXPECT_EQ(document.error().message.find('\n'), std::string::npos);
  EXPECT_LT(document.error().message.size(), 400U);
}

struct Bad {
  const char* name;
  GltfText file;
  std::string message;
};

class GltfErrors : public testing::TestWithParam<Bad> {};

TEST_P(GltfErrors, NameTheFileAndThePlace) {
  expectRefused(GetParam().file.text(), GetParam().message);
}

GltfText withNodes(const std::string& nodes, const std::string& roots = "0") {
  GltfText file;
  file.nodes = nodes;
  file.roots = roots;
  return file;
}

GltfText withShape(const std::string& shape) {
  GltfText file = withNodes(boxNode(""));
  file.shapes = shape;
  return file;
}

GltfText withMotion(const std::string& motion) {
  return withNodes(boxNode(motion));
}

GltfText withMaterial(const std::string& material) {
  GltfText file = withNodes(boxNode(""));
  file.materials = material;
  return file;
}

GltfText withLimit(const std::string& limit) {
  GltfText file =
      withNodes(boxNode("{}") + "," + physicsNode(R"("joint":{"connectedNode":0,"joint":0})"), "0,1");
  file.joints = R"({"limits":[)" + limit + "]}";
  return file;
}

/// A body with a mesh of one primitive over a buffer of four points.
GltfText withMesh(const std::string& accessor, const std::string& view = R"({"buffer":0,"byteLength":48})",
                  const std::string& primitive = R"({"attributes":{"POSITION":0}})",
                  std::vector<float> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}) {
  GltfText file = withNodes(boxNode("", R"("mesh":0)"));
  file.more =
      bufferMembers(bytesOf(points), view, accessor) + R"(,"meshes":[{"primitives":[)" + primitive + "]}]";
  return file;
}

constexpr const char* kPoints = R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4})";

INSTANTIATE_TEST_SUITE_P(
    Nodes, GltfErrors,
    testing::Values(
        Bad{"childTwice", withNodes(R"({"children":[1,1]},{})"),
            "nodes[0].children[1]: node 1 is already a child"},
        Bad{"ownChild", withNodes(R"({"children":[0]})"), "nodes[0].children[0]: "},
        Bad{"cycle", withNodes(R"({"children":[1]},{"children":[2]},{"children":[0]})"),
            "nodes[0]: is its own ancestor"},
        Bad{"noSuchChild", withNodes(R"({"children":[7]})"),
            "nodes[0].children[0]: there is no node 7; the file has 1"},
        Bad{"noSuchRoot", withNodes("{}", "4"), "scenes[0].nodes[0]: there is no node 4"},
        Bad{"negativeIndex", withNodes(R"({"mesh":-1})"), "nodes[0].mesh: should be a whole number"},
        Bad{"fractionalIndex", withNodes(R"({"mesh":0.5})"), "nodes[0].mesh: should be a whole number"},
        Bad{"hugeIndex", withNodes(R"({"mesh":18446744073709551615})"), "nodes[0].mesh: there is no mesh"},
        Bad{"zeroRotation", withNodes(R"({"rotation":[0,0,0,0]})"),
            "nodes[0].rotation: should be a quaternion"},
        Bad{"shortRotation", withNodes(R"({"rotation":[0,0,1]})"),
            "nodes[0].rotation: should hold 4 numbers"},
        Bad{"farAway", withNodes(R"({"translation":[0,1e30,0]})"),
            "nodes[0].translation[1]: 1e+30 is larger"},
        Bad{"textForNumber", withNodes(R"({"translation":[0,"a",0]})"),
            "nodes[0].translation[1]: should be a number"},
        Bad{"scalesPileUp",
            withNodes(R"({"scale":[1e5,1,1],"children":[1]},{"scale":[1e5,1,1],"children":[2]},{})"),
            "nodes[1]: lies too far from the origin or is scaled too much"},
        Bad{"nodesAreNoArray",
            [] {
              GltfText f;
              f.nodes = R"({}],"nodes":{"a":[1)";
              f.more = "}";
              return f;
            }(),
            "nodes: should be an array"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Bodies, GltfErrors,
    testing::Values(
        Bad{"negativeMass", withMotion(R"({"mass":-2})"),
            "nodes[0].extensions.KHR_physics_rigid_bodies.motion.mass: -2 is not from 0"},
        Bad{"massInText", withMotion(R"({"mass":"1"})"), "motion.mass: should be a number"},
        Bad{"hugeMass", withMotion(R"({"mass":1e300})"), "motion.mass: 1e+300 is not from"},
        Bad{"negativeInertia", withMotion(R"({"inertiaDiagonal":[1,-1,1]})"),
            "motion.inertiaDiagonal: should be three"},
        Bad{"kinematicNumber", withMotion(R"({"isKinematic":1})"),
            "motion.isKinematic: should be true or false"},
        Bad{"tooFast", withMotion(R"({"linearVelocity":[1e9,0,0]})"),
            "motion.linearVelocity[0]: 1e+09 is larger than 2e+06"},
        Bad{"noSuchShape", withNodes(physicsNode(R"("collider":{"geometry":{"shape":3}})")),
            "collider.geometry.shape: there is no shape 3"},
        Bad{"shapeAndNode", withNodes(physicsNode(R"("collider":{"geometry":{"shape":0,"node":0}})")),
            "collider.geometry: should have either \"shape\" or \"node\""},
        Bad{"noSuchMaterial",
            withNodes(physicsNode(R"("collider":{"geometry":{"shape":0},"physicsMaterial":0})")),
            "collider.physicsMaterial: there is no physics material 0; the file has 0"},
        Bad{"negativeFriction", withMaterial(R"({"staticFriction":-1})"),
            "extensions.KHR_physics_rigid_bodies.physicsMaterials[0].staticFriction: -1 is not from 0"},
        Bad{"bouncesTooMuch", withMaterial(R"({"restitution":1.5})"),
            "physicsMaterials[0].restitution: 1.5 is not"},
        Bad{"negativeRadius", withShape(R"({"type":"sphere","sphere":{"radius":-1}})"),
            "extensions.KHR_implicit_shapes.shapes[0].sphere.radius: -1 is not from 0"},
        Bad{"zeroRadius", withShape(R"({"type":"sphere","sphere":{"radius":0}})"),
            "shapes[0].sphere.radius: should be positive"},
        Bad{"flatBox", withShape(R"({"type":"box","box":{"size":[1,0,1]}})"),
            "shapes[0].box.size: should be three positive"},
        Bad{"noRadii", withShape(R"({"type":"cylinder","cylinder":{"radiusTop":0,"radiusBottom":0}})"),
            "shapes[0]: both radii are zero"},
        Bad{"noType", withShape(R"({"box":{}})"), "shapes[0]: \"type\" is missing"},
        Bad{"noConnectedNode", withNodes(physicsNode(R"("joint":{"joint":0})")),
            "joint: \"connectedNode\" is missing"},
        Bad{"noSuchJoint",
            withNodes(boxNode("{}", R"("children":[1])") + "," +
                      physicsNode(R"("joint":{"connectedNode":2,"joint":0})") + ",{}"),
            "joint.joint: there is no joint 0"},
        Bad{"limitOfNoAxis", withLimit(R"({"min":0})"), "physicsJoints[0].limits[0]: should have either"},
        Bad{"limitOfAxis3", withLimit(R"({"linearAxes":[3],"min":0})"),
            "limits[0].linearAxes[0]: there is no axis 3"},
        Bad{"limitsTurned", withLimit(R"({"linearAxes":[0],"min":1,"max":0})"),
            "limits[0]: \"min\" is larger"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Meshes, GltfErrors,
    testing::Values(
        Bad{"countTooLarge", withMesh(R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":5})"),
            "accessors[0]: reaches beyond the end of its buffer view"},
        Bad{"countHuge", withMesh(R"({"componentType":5126,"type":"VEC3","count":4000000000})"),
            "accessors[0].count: is too much: the file has more than thirty million"},
        Bad{"countOverflows",
            withMesh(R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":18446744073709551615})"),
            "accessors[0].count: "},
        Bad{"strideZero", withMesh(kPoints, R"({"buffer":0,"byteLength":48,"byteStride":0})"),
            "accessors[0]: reaches beyond"},
        Bad{"strideHuge",
            withMesh(kPoints, R"({"buffer":0,"byteLength":48,"byteStride":18446744073709551615})"),
            "accessors[0]: reaches beyond"},
        Bad{"offsetHuge",
            withMesh(
                R"({"bufferView":0,"byteOffset":18446744073709551612,"componentType":5126,"type":"VEC3","count":4})"),
            "accessors[0]: reaches beyond"},
        Bad{"viewTooLong", withMesh(kPoints, R"({"buffer":0,"byteOffset":1,"byteLength":48})"),
            "bufferViews[0]: reaches beyond the end of its buffer"},
        Bad{"noSuchBuffer", withMesh(kPoints, R"({"buffer":3,"byteLength":48})"),
            "bufferViews[0].buffer: there is no buffer 3"},
        Bad{"noSuchComponent", withMesh(R"({"bufferView":0,"componentType":5124,"type":"VEC3","count":4})"),
            "accessors[0].componentType: there is no component type 5124"},
        Bad{"wrongType", withMesh(R"({"bufferView":0,"componentType":5126,"type":"VEC2","count":4})"),
            "accessors[0].type: should be \"VEC3\""},
        Bad{"notANumber",
            withMesh(kPoints, R"({"buffer":0,"byteLength":48})", R"({"attributes":{"POSITION":0}})",
                     {0, 0, 0, 1, 0, 0, 0, NAN, 0, 1, 1, 0}),
            "accessors[0]: element 2 is not finite"},
        Bad{"infinite",
            withMesh(kPoints, R"({"buffer":0,"byteLength":48})", R"({"attributes":{"POSITION":0}})",
                     {0, 0, 0, 1, 0, 0, 0, INFINITY, 0, 1, 1, 0}),
            "accessors[0]: element 2 is not finite"},
        Bad{"indexBeyond",
            withMesh(std::string(kPoints) +
                         R"(,{"bufferView":0,"componentType":5125,"type":"SCALAR","count":12})",
                     R"({"buffer":0,"byteLength":48})", R"({"attributes":{"POSITION":0},"indices":1})"),
            "meshes[0].primitives[0].indices: names vertex 1065353216 of 4"},
        Bad{"indicesAsFloats",
            withMesh(std::string(kPoints) +
                         R"(,{"bufferView":0,"componentType":5126,"type":"SCALAR","count":3})",
                     R"({"buffer":0,"byteLength":48})", R"({"attributes":{"POSITION":0},"indices":1})"),
            "accessors[1].componentType: indices should be unsigned"},
        Bad{"sparseBeyond",
            withMesh(
                R"({"componentType":5126,"type":"VEC3","count":2,"sparse":{"count":1,)"
                R"("indices":{"bufferView":0,"byteOffset":12,"componentType":5125},"values":{"bufferView":0}}})"),
            "accessors[0].sparse.indices: names an element that does not exist"},
        Bad{"primitivesMissing",
            [] {
              GltfText f = withNodes(boxNode("", R"("mesh":0)"));
              f.more = R"(,"meshes":[{}])";
              return f;
            }(),
            "meshes[0]: \"primitives\" is missing"},
        Bad{"damagedBase64",
            [] {
              GltfText f = withMesh(kPoints);
              f.more.replace(f.more.find("base64,") + 7, 4, "A*BC");
              return f;
            }(),
            "buffers[0].uri: holds damaged base64 data"}),
    [](const auto& test) { return std::string(test.param.name); });

GltfText withSceneNotes(const std::string& notes, const std::string& nodeExtras) {
  GltfText file = withNodes(boxNode("{}", R"("extras":)" + nodeExtras),
                            R"(0],"extras":{"scatter_scene":)" + notes + R"(},"x":[)");
  return file;
}

constexpr const char* kNotes = R"({"gravity":[0,0,0],"models":[{"name":"a","motion":"dynamic"}]})";

INSTANTIATE_TEST_SUITE_P(
    Extras, GltfErrors,
    testing::Values(
        Bad{"noSuchMotion",
            withSceneNotes(R"({"gravity":[0,0,0],"models":[{"name":"a","motion":"still"}]})", "{}"),
            "scenes[0].extras.scatter_scene.models[0].motion: should be"},
        Bad{"noGravity", withSceneNotes("{}", "{}"), "scatter_scene: \"gravity\" is missing"},
        Bad{"noSuchModel", withSceneNotes(kNotes, R"({"scatter_body":{"model":1}})"),
            "nodes[0].extras.scatter_body.model: there is no model 1; the file has 1"},
        Bad{"notNested",
            withSceneNotes(kNotes, R"({"scatter_body":{"model":0},"scatter_levels":{"hullMargin":0,)"
                                   R"("levels":[[{"type":"box","box":{"size":[1,1,1]}}]]}})"),
            "nodes[0].extras.scatter_levels: model \"a\": level 2, part 1 sticks out of level 1"},
        Bad{"emptyLevel",
            withSceneNotes(kNotes,
                           R"({"scatter_body":{"model":0},"scatter_levels":{"hullMargin":0,"levels":[[]]}})"),
            "nodes[0].extras.scatter_levels: model \"a\": level 1 has no parts"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(GltfContainer, TextThatIsNoJsonIsRefused) {
  expectRefused("", "is not valid JSON at byte 1");
  expectRefused("{\"asset\":", "is not valid JSON at byte");
  expectRefused("[1,2]", "its JSON is no object");
  expectRefused(R"({"asset":{"version":"2.0"},"a":1e999})", "is not valid JSON at byte");
  expectRefused(R"({"asset":{"version":"2.0"},"a":NaN})", "is not valid JSON at byte");
  expectRefused(R"({"asset":{"version":"1.0"}})", "asset.version: only glTF 2 is supported");
  expectRefused("{}", "\"asset\" is missing");
}

TEST(GltfContainer, DeepAndLargeJsonIsRefused) {
  expectRefused(R"({"asset":{"version":"2.0"},"extras":)" + std::string(1'000'000, '['),
                "nested deeper than 100");
  std::string nested = R"({"asset":{"version":"2.0"})";
  for (int i = 0; i < 100'000; ++i) {
    nested += R"(,"a":{)";
    nested += R"("b":1)";
  }
  expectRefused(nested, "nested deeper than 100");
  std::string many = R"({"asset":{"version":"2.0"},"extras":[0)";
  for (int i = 0; i < 5'000'000; ++i) {
    many += ",0";
  }
  expectRefused(many + "]}", "more than 5000000 values");
}

TEST(GltfContainer, NodesThatMultiplyGeometryAreRefused) {
  // Each of many bodies shows a mesh with the same million vertices at another place.
  GltfText file;
  file.roots = "0";
  file.nodes = test::boxNode("", R"("mesh":0)");
  for (int i = 1; i < 200; ++i) {
    file.roots += "," + std::to_string(i);
    file.nodes += "," + test::boxNode("", R"("mesh":0,"scale":[1,1,)" + std::to_string(i + 1) + "]");
  }
  file.more = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":0}]}],)"
              R"("accessors":[{"componentType":5126,"type":"VEC3","count":1000000}])";
  expectRefused(file.text(), "mesh: is too much: the file has more");
}

TEST(GltfContainer, LevelsOfTooManyPartsAreRefused) {
  std::string parts = R"({"type":"box"})";
  for (int i = 1; i < 3000; ++i) {
    parts += R"(,{"type":"box"})";
  }
  expectRefused(withNodes(boxNode("{}", R"("extras":{"scatter_levels":{"hullMargin":0,"levels":[[)" + parts +
                                            "],[" + parts + "]]}}"))
                    .text(),
                "nodes[0].extras.scatter_levels: is too much");
}

TEST(GltfContainer, LongChainsOfNodesAreRead) {
  GltfText file;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    file.nodes += R"({"children":[)" + std::to_string(i + 1) + "]},";
  }
  file.nodes += boxNode("{}");
  EXPECT_EQ(test::readGltf(file.text()).bodies.size(), 1U);
}

TEST(GltfContainer, GlbChunksAreRead) {
  GltfText file;
  file.nodes = boxNode("{}", R"("mesh":0)");
  file.more =
      R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":0}]}],"buffers":[{"byteLength":12}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":12}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":1}])";
  const std::string binary = bytesOf(std::vector<float>{1, 2, 3});
  const PhysicsDocument document = test::readGltf(test::glb(file.text(), binary));
  EXPECT_THAT(document.models.at(0).mesh.vertices, testing::ElementsAre(Vec3(1, 2, 3)));
  expectRefused(test::glb(file.text(), ""), "buffers[0]: has no \"uri\", and the file has no binary chunk");
  expectRefused(test::glb(file.text(), binary.substr(0, 8)), "buffers[0]: should have 12 bytes, but has 8");
}

TEST(GltfContainer, DamagedGlbFilesAreRefused) {
  const std::string good = test::glb(R"({"asset":{"version":"2.0"}})", "");
  expectRefused("glTF", "is not a GLB file of version 2");
  expectRefused(good.substr(0, 12), "the file ends early");
  std::string version = good;
  version[4] = 1;
  expectRefused(version, "is not a GLB file of version 2");
  std::string chunk = good;
  chunk[14] = 9;
  expectRefused(chunk, "a chunk of the GLB file is longer than the file");
  std::string kind = good;
  kind[16] = 'X';
  expectRefused(kind, "the GLB file has no JSON chunk");
}

TEST(GltfContainer, OtherFilesAreNotReadFromAnywhere) {
  for (const char* uri : {"/etc/passwd", "http://localhost/x", "data:text/plain,x", "data:", "a\\u0000b"}) {
    GltfText file = withMesh(kPoints);
    file.more =
        R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"byteLength":48,"uri":")" +
        std::string(uri) + R"("}],"bufferViews":[{"buffer":0,"byteLength":48}],"accessors":[)" + kPoints +
        "]";
    expectRefused(file.text(), "buffers[0].uri: only ");
  }
}

TEST(GltfContainer, AMissingFileIsNamed) {
  const test::TemporaryFolder folder;
  const auto document = readGltfDocument(folder / "none.glb");
  ASSERT_FALSE(document.has_value());
  EXPECT_THAT(document.error().message, HasSubstr("none.glb: No such file"));
}

}  // namespace
}  // namespace scatter
