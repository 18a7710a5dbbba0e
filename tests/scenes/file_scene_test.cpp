// What a scene file puts into a world.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/io/file.h>
#include <scatter/io/gltf.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "io/temporary_folder.h"
#include "scenes/file_world.h"

namespace scatter::test {
namespace {

TEST(FileScene, PutsBodiesWhereTheFileSays) {
  const FileWorld scene(R"(
object = [{ name = "a", sphere = 1, at = [1, 2, 3] },
          { name = "b", sphere = 1, list = [[10, 0, 0], [20, 0, 0]] },
          { name = "c", box = [1, 1, 1], grid = { count = [1, 1, 2], spacing = [1, 1, 4], center = [0, 9, 0] } }]
)");
  EXPECT_EQ(scene.state("a").pose.position, Vec3(1, 2, 3));
  EXPECT_EQ(scene.state("b-2").pose.position, Vec3(20, 0, 0));
  EXPECT_EQ(scene.state("c-1").pose.position, Vec3(0, 9, -2));
  EXPECT_EQ(scene.world.objects().size(), 5U);
}

TEST(FileScene, AModelMayHaveFewerLevels) {
  FileWorld scene(R"(
object = [{ name = "all", model = "hunter" },
          { name = "two", model = "hunter", levels = 2, list = [[20, 0, 0], [40, 0, 0]] }]
)");
  const auto levelsOf = [&scene](const char* name) {
    return std::get<std::shared_ptr<const LevelSet>>(scene[name].def().shape);
  };
  const auto all = levelsOf("all");
  const auto two = levelsOf("two-1");
  ASSERT_EQ(all->count(), 3);
  ASSERT_EQ(two->count(), 2);
  EXPECT_EQ(two, levelsOf("two-2")) << "the bodies of an object share their levels";
  EXPECT_EQ(two->coarsest().parts.size(), all->level(2).parts.size());
  EXPECT_EQ(two->finest().parts.size(), all->finest().parts.size());
  EXPECT_EQ(two->mass().inertia, all->mass().inertia);
  EXPECT_EQ(scene["two-1"].def().mass, scene["all"].def().mass);
}

TEST(FileScene, AModelHasNoMoreLevelsThanItHas) {
  EXPECT_EQ(FileWorld::errorOf("object = [{ name = \"a\", model = \"hunter\", levels = 4 }]"),
            "test.toml:1: the model hunter has 3 levels, not 4");
}

TEST(FileScene, AStackOfAnyShapeStands) {
  for (const char* shape :
       {"box = [1, 0.5, 2]", "cylinder = { radius = 0.5, length = 0.75 }", "model = \"crate\"",
        "box = [1, 2, 0.5], orientation = { axis = [1, 0, 0], angle = 90 }"}) {
    FileWorld scene(
        std::string("scene = { gravity = [0, -9.81, 0] }\nobject = [{ name = \"floor\", plane = [0, 1, 0] "
                    "},\n{ name = \"s\", stack = { count = 3, base = [0, 0, 0] }, ") +
        shape + " }]\n");
    const float pitch = distance(scene.state("s-1").pose.position, scene.state("s-2").pose.position);
    EXPECT_GT(pitch, 0.4F) << shape;
    const float top = scene.state("s-3").pose.position.y;
    scene.step(120);
    EXPECT_NEAR(scene.state("s-3").pose.position.y, top, 0.05F) << shape;
    EXPECT_LT(scene.world.physics().maxPenetration(), 0.02) << shape;
  }
}

TEST(FileScene, AGapInAStackIsBetweenItsBodies) {
  const FileWorld scene(R"(
object = [{ name = "s", box = [1, 0.5, 1], stack = { count = 2, base = [1, 3, 1], gap = 0.25 } }]
)");
  EXPECT_EQ(scene.state("s-1").pose.position, Vec3(1, 3.25F, 1));
  EXPECT_EQ(scene.state("s-2").pose.position, Vec3(1, 4, 1));
}

const char* const kTerrain = "terrain = { size = [20, 10], cells = [20, 10], relief = 3";

TEST(FileScene, ATerrainIsTheSameSurfaceAsAMeshAndAsAHeightField) {
  const FileWorld scene(std::string("object = [{ name = \"a\", ") + kTerrain +
                        " } },\n{ name = \"b\", at = [0, 50, 0], " + kTerrain +
                        ", kind = \"height_field\" } }]");
  const auto mesh = std::get<std::shared_ptr<const TriangleMesh>>(scene["a"].def().shape);
  const auto field = std::get<std::shared_ptr<const HeightField>>(scene["b"].def().shape);
  const TriangleMesh same = trianglesOf(*field);
  EXPECT_EQ(mesh->vertices, same.vertices);
  EXPECT_EQ(mesh->triangles, same.triangles);
  EXPECT_EQ(mesh->triangles.size(), 400U);
}

TEST(FileScene, BodiesRestOnATerrain) {
  for (const char* kind : {"mesh", "height_field"}) {
    FileWorld scene(
        std::string("scene = { gravity = [0, -9.81, 0] }\nobject = [{ name = \"ground\", at = [0, "
                    "-5, 0], friction = 2, ") +
        kTerrain + ", roughness = 0, kind = \"" + kind +
        "\" } },\n{ name = \"crate\", model = \"crate\", friction = 2, at = [0, 1, 0] }]");
    scene.step(300);
    EXPECT_GT(scene.state("crate").pose.position.y, -5.0F) << kind;
    EXPECT_LT(scene.state("crate").pose.position.y, -1.0F) << kind;
    EXPECT_LT(scene.world.physics().maxPenetration(), 0.06) << kind;
  }
}

TEST(FileScene, AMeshIsReadFromItsFile) {
  const TemporaryFolder folder;
  const auto mesh = folder.path() / "ground.obj";
  ASSERT_TRUE(writeFile(mesh, "v -5 0 -5\nv 5 0 -5\nv 5 0 5\nv -5 0 5\nf 1 3 2\nf 1 4 3\n"));
  FileWorld scene("scene = { gravity = [0, -9.81, 0] }\nobject = [{ name = \"ground\", mesh = \"" +
                  mesh.string() + "\" },\n{ name = \"ball\", sphere = 0.5, at = [1, 1, 2] }]");
  scene.step(120);
  EXPECT_NEAR(scene.state("ball").pose.position.y, 0.5F, 0.02F);
}

TEST(FileScene, AMeshThatCannotBeReadIsNamedWithItsLine) {
  EXPECT_THAT(FileWorld::errorOf("object = [{ name = \"a\", mesh = \"nowhere.obj\" }]"),
              testing::AllOf(testing::StartsWith("test.toml:1: "), testing::HasSubstr("nowhere.obj")));
  EXPECT_THAT(FileWorld::errorOf("object = [{ name = \"a\", mesh = \"ground.txt\" }]"),
              testing::HasSubstr("known are obj, stl"));
}

class FileRegion : public testing::TestWithParam<const char*> {};

TEST_P(FileRegion, KeepsAllItsBodiesClearOfOneAnother) {
  const std::string text = std::string("region = [{ name = \"r\", clearance = 0.2, ") + GetParam() + R"( }]
object = [{ name = "a", sphere = [0.5, 1], in = "r", count = 30 },
          { name = "b", box = [1, 1, 1], in = "r", count = 20, orientation = "random" }]
)";
  const FileWorld scene(text);
  const auto objects = scene.world.objects();
  ASSERT_EQ(objects.size(), 50U);
  const auto radius = [](const WorldObject& object) {
    const auto* sphere = std::get_if<Sphere>(&object.def().shape);
    return sphere != nullptr ? sphere->radius : 0.5F * glm::root_three<float>();
  };
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GT(distance(objects[i]->state().pose.position, objects[k]->state().pose.position),
                radius(*objects[i]) + radius(*objects[k]) + 0.199F);
    }
  }
}

TEST_P(FileRegion, IsTheSameForTheSameSeedAlone) {
  const std::string text = std::string("region = [{ name = \"r\", ") + GetParam() +
                           " }]\nobject = [{ name = \"a\", sphere = 1, in = \"r\", count = 9 }]\n";
  const FileWorld first(text, 3);
  const FileWorld second(text, 3);
  const FileWorld other(text, 4);
  EXPECT_EQ(first.world.physics().stateHash(), second.world.physics().stateHash());
  EXPECT_NE(first.world.physics().stateHash(), other.world.physics().stateHash());
}

INSTANTIATE_TEST_SUITE_P(Kinds, FileRegion,
                         testing::Values("kind = \"shell\", inner = 10, outer = 20",
                                         "kind = \"ball\", radius = 2",
                                         "kind = \"box\", size = [40, 1, 40]"));

TEST(FileScene, RegionsAreWhereTheyShouldBe) {
  const FileWorld scene(R"(
region = [{ name = "shell", kind = "shell", inner = 10, outer = 20, center = [100, 0, 0] },
          { name = "box", kind = "box", size = [40, 2, 10], center = [0, 100, 0] }]
object = [{ name = "a", sphere = 0.1, in = "shell", count = 100 },
          { name = "b", sphere = 0.1, in = "box", count = 100 }]
)");
  Vec3 furthest(0.0F);
  for (const auto& object : scene.world.objects()) {
    const Vec3 place = object->state().pose.position;
    if (object->name().front() == 'a') {
      EXPECT_GE(distance(place, Vec3(100, 0, 0)), 9.999F);
      EXPECT_LE(distance(place, Vec3(100, 0, 0)), 20.001F);
    } else {
      furthest = glm::max(furthest, glm::abs(place - Vec3(0, 100, 0)));
    }
  }
  EXPECT_TRUE(glm::all(glm::lessThanEqual(furthest, Vec3(20, 1, 5)))) << "inside";
  EXPECT_TRUE(glm::all(glm::greaterThan(furthest, Vec3(16, 0.8F, 4)))) << "all of it is used";
}

TEST(FileScene, SetsVelocities) {
  const FileWorld scene(R"(
object = [{ name = "given", sphere = 1, velocity = [1, 2, 3], spin = [0, 4, 0] },
          { name = "toward", sphere = 1, at = [0, 10, 0], velocity = { toward = [0, 0, 0], speed = 5 } },
          { name = "away", sphere = 1, at = [8, 1, 0], velocity = { away = [0, 1, 0], rate = 0.5 } },
          { name = "random", sphere = 1, list = [[20, 0, 0], [30, 0, 0]], velocity = { random = 2 }, spin = { random = 3 } }]
)");
  EXPECT_EQ(scene.state("given").linearVelocity, Vec3(1, 2, 3));
  EXPECT_EQ(scene.state("given").angularVelocity, Vec3(0, 4, 0));
  EXPECT_LT(distance(scene.state("toward").linearVelocity, Vec3(0, -5, 0)), 1e-6F);
  EXPECT_EQ(scene.state("away").linearVelocity, Vec3(4, 0, 0));
  EXPECT_LE(glm::length(scene.state("random-1").linearVelocity), 2.0F);
  EXPECT_LE(glm::length(scene.state("random-1").angularVelocity), 3.0F);
  EXPECT_NE(scene.state("random-1").linearVelocity, scene.state("random-2").linearVelocity);
}

TEST(FileScene, UprightThingsTurnAboutTheVerticalAxisOnly) {
  const FileWorld scene(R"(
object = [{ name = "a", box = [1, 2, 1], orientation = "upright", list = [[0, 0, 0], [9, 0, 0]] }]
)");
  for (const char* name : {"a-1", "a-2"}) {
    const Vec3 up = scene.state(name).pose.rotation * Vec3(0, 1, 0);
    EXPECT_LT(distance(up, Vec3(0, 1, 0)), 1e-6F);
  }
  EXPECT_NE(scene.state("a-1").pose.rotation, scene.state("a-2").pose.rotation);
}

TEST(FileScene, DensityIsTimesTheVolume) {
  const FileWorld scene(R"(
object = [{ name = "ball", sphere = 2, density = 3 },
          { name = "box", box = [1, 2, 3], density = 10, at = [9, 0, 0] },
          { name = "heavy", box = [1, 2, 3], mass = 7, at = [19, 0, 0] },
          { name = "plain", box = [1, 2, 3], at = [29, 0, 0] }]
)");
  EXPECT_FLOAT_EQ(scene["ball"].def().mass, 3.0F * 4.0F / 3.0F * glm::pi<float>() * 8.0F);
  EXPECT_FLOAT_EQ(scene["box"].def().mass, 60.0F);
  EXPECT_EQ(scene["heavy"].def().mass, 7.0F);
  EXPECT_EQ(scene["plain"].def().mass, 1.0F);
}

TEST(FileScene, AModelBringsItsMassAndMaterial) {
  const FileWorld scene(R"(
object = [{ name = "own", model = "crate" },
          { name = "set", model = "crate", at = [9, 0, 0], mass = 5, friction = 0.125 }]
)");
  const BodyDef& own = scene["own"].def();
  const BodyDef& set = scene["set"].def();
  EXPECT_EQ(own.mass, 30.0F);
  EXPECT_EQ(set.mass, 5.0F);
  EXPECT_EQ(set.material.friction, 0.125F);
  EXPECT_NE(own.material.friction, 0.125F);
  EXPECT_EQ(set.material.restitution, own.material.restitution);
  EXPECT_EQ(std::get<std::shared_ptr<const LevelSet>>(own.shape),
            std::get<std::shared_ptr<const LevelSet>>(set.shape))
      << "read once";
}

TEST(FileScene, GroupsThatIgnoreEachOtherDoNotTouch) {
  const std::string text = R"(
object = [{ name = "a", sphere = 1, group = "red", ignores = ["blue"] },
          { name = "b", sphere = 1, at = [1, 0, 0], group = "COLOUR" }]
)";
  const auto contacts = [&text](const std::string& colour) {
    std::string own = text;
    own.replace(own.find("COLOUR"), 6, colour);
    if (colour != "blue") own.replace(own.find("[\"blue\"]"), 8, "[]");
    FileWorld scene(own);
    scene.step();
    return scene.world.physics().counters().contacts;
  };
  EXPECT_EQ(contacts("blue"), 0U);
  EXPECT_GT(contacts("red"), 0U);
}

TEST(FileScene, GravityAndSolverIterationsReachThePhysics) {
  FileWorld scene(
      "scene = { gravity = [0, -6, 0], solver_iterations = 33 }\nobject = [{ name = \"a\", sphere = 1 }]\n");
  PhysicsDef def;
  FileScene(scene.file).configure(def);
  EXPECT_EQ(def.gravity, Vec3(0, -6, 0));
  EXPECT_EQ(def.solverIterations, 33);
  scene.step(60);
  EXPECT_NEAR(scene.state("a").linearVelocity.y, -6.0F, 1e-3F);
}

TEST(FileScene, FieldsPullWhatIsInThem) {
  FileWorld scene(R"(
field = [{ center = [10, 0, 0], acceleration = 3, radius = 20 },
         { kind = "uniform", direction = [0, 2, 0], acceleration = 1 },
         { kind = "uniform", direction = [0, 0, 1], acceleration = 9, on = false }]
object = [{ name = "in", sphere = 1 }, { name = "out", sphere = 1, at = [-50, 0, 0] },
          { name = "apart", sphere = 1, at = [0, 9, 0], in_fields = false }]
)");
  scene.step(60);
  EXPECT_LT(distance(scene.state("in").linearVelocity, Vec3(3, 1, 0)), 0.1F);
  EXPECT_LT(distance(scene.state("out").linearVelocity, Vec3(0, 1, 0)), 1e-3F);
  EXPECT_EQ(scene.state("apart").linearVelocity, Vec3(0.0F));
}

TEST(FileScene, JointsHoldWhatTheySay) {
  FileWorld scene(R"(
scene = { gravity = [0, -9.81, 0] }
object = [{ name = "bob", sphere = 0.5, at = [2, 10, 0] }, { name = "door", box = [2, 2, 0.1], at = [11, 5, 0] },
          { name = "lift", box = [1, 1, 1], at = [20, 5, 0] }, { name = "sign", box = [1, 1, 1], at = [30, 5, 0] },
          { name = "post", box = [1, 1, 1], at = [31.5, 5, 0], motion = "static" }]
joint = [{ kind = "point", a = "bob", at = [0, 10, 0] }, { kind = "hinge", a = "door", at = [10, 5, 0], axis = [0, 1, 0] },
         { kind = "slider", a = "lift", at = [20, 5, 0], axis = [0, 1, 0], lower = -3, upper = 3 },
         { kind = "fixed", a = "sign", b = "post", at = [31, 5, 0] }]
event = [{ do = "knock", frame = 0, target = "door", direction = [0, 0, 1], impulse = 2 }]
)");
  EXPECT_TRUE(scene.has("world"));
  for (int i = 0; i < 60; ++i) {
    scene.step();
    EXPECT_NEAR(distance(scene.state("bob").pose.position, Vec3(0, 10, 0)), 2.0F, 0.05F);
    EXPECT_NEAR(distance(scene.state("door").pose.position, Vec3(10, 5, 0)), 1.0F, 0.05F);
  }
  EXPECT_LT(scene.state("bob").pose.position.y, 9.5F) << "it swings";
  EXPECT_GT(std::abs(scene.state("door").pose.position.z), 0.3F) << "it turns";
  EXPECT_NEAR(scene.state("lift").pose.position.x, 20.0F, 0.05F);
  EXPECT_NEAR(scene.state("lift").pose.position.y, 2.0F, 0.2F) << "its limit";
  EXPECT_LT(distance(scene.state("sign").pose.position, Vec3(30, 5, 0)), 0.1F);
}

TEST(FileScene, NamesFileAndLineOfWhatCannotBeMade) {
  EXPECT_THAT(FileWorld::errorOf("\n[[object]]\nname = \"a\"\nmodel = \"hunte\"\n"),
              testing::StartsWith("test.toml:2: unknown model \"hunte\"; known are"));
  EXPECT_THAT(FileWorld::errorOf("object = [{ name = \"a\", model = \"nowhere/x.dae\" }]\n"),
              testing::StartsWith("test.toml:1: cannot read nowhere/x.dae"));
  EXPECT_THAT(FileWorld::errorOf(
                  "object = [{ name = \"a\", hull = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]] }]\n"),
              testing::StartsWith("test.toml:1: "));
}

TEST(FileScene, FindsModelsNextToTheFile) {
  const std::filesystem::path beside = std::filesystem::path(SCATTER_TEST_MODEL_DIR) / "scene.toml";
  const auto file = parseSceneFile("object = [{ name = \"a\", model = \"./mug.dae\" }]\n", beside);
  ASSERT_TRUE(file);
  FileScene scene(std::make_shared<const SceneFile>(*file));
  World world(makeBulletPhysics({}));
  const auto built = scene.build(world, {});
  EXPECT_TRUE(built) << built.error().message;
}

TEST(FileScene, TakesAModelFromGltf) {
  const TemporaryFolder folder;
  PhysicsDocument document;
  document.materials = {{"ice", 0.25F, 0.25F, 0.5F}};
  DocumentModel model;
  model.name = "brick";
  model.shapes = {{.geometry = ConvexShape(Box{{1.0F, 0.5F, 0.25F}}), .material = 0}};
  model.mass = 6.0F;
  model.massFrame = DocumentMassFrame{.pose = {{0.25F, 0.0F, 0.0F}}};
  document.models = {model};
  document.bodies = {{.name = "brick"}};
  const auto written = writeGltfDocument(document, folder / "brick.glb");
  ASSERT_TRUE(written) << written.error().message;
  const auto file = parseSceneFile("object = [{ name = \"a\", model = \"brick.glb\", at = [1, 2, 3] }]\n",
                                   folder / "scene.toml");
  FileScene scene(std::make_shared<const SceneFile>(file.value()));
  World world(makeBulletPhysics({}));
  const auto built = scene.build(world, {});
  ASSERT_TRUE(built) << built.error().message;
  const BodyDef& brick = world.find("a")->def();
  EXPECT_EQ(brick.mass, 6.0F);
  EXPECT_EQ(brick.material.friction, 0.25F);
  const MassProperties& mass = std::get<std::shared_ptr<const LevelSet>>(brick.shape)->mass();
  EXPECT_NEAR(mass.volume, 1.0F, 1e-5F);
  EXPECT_EQ(mass.centerOfMass, Vec3(0.25F, 0.0F, 0.0F));
}

}  // namespace
}  // namespace scatter::test
