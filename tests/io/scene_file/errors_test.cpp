#include <scatter/io/scene_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/temporary_folder.h"

namespace scatter {
namespace {

std::string errorOf(const std::string& toml) {
  const auto scene = parseSceneFile(toml, "s.toml");
  return scene ? "no error" : scene.error().message;
}

TEST(SceneFileErrors, AnUnknownKeyGetsTheNearestAndTheLine) {
  EXPECT_EQ(errorOf("[[object]]\nname = \"a\"\n\nsphere = 1\nmas = 3\n"),
            "s.toml:5: unknown key \"mas\" in [[object]]; did you mean \"mass\"?");
  EXPECT_EQ(errorOf("[scene]\nframe = 3\n"),
            "s.toml:2: unknown key \"frame\" in [scene]; did you mean \"frames\"?");
  EXPECT_EQ(errorOf("[[objects]]\n"),
            "s.toml:1: unknown key \"objects\" in the file; did you mean \"object\"?");
  EXPECT_EQ(errorOf("[[object]]\nname = \"a\"\nbox = [1, 1, 1]\ngrid = { counts = [1, 1, 1] }\n"),
            "s.toml:4: unknown key \"counts\" in grid = { … }; did you mean \"count\"?");
}

TEST(SceneFileErrors, CharactersBeyondAsciiStandInTextsAndComments) {
  const std::string ball = "sphere = 1\n# Größe: 1 m ☃\n[[object]]\nsphere = 1\n";
  EXPECT_THAT(errorOf("[[object]]\nname = \"größe\"\n" + ball), testing::HasSubstr("\"größe\""));
  EXPECT_EQ(errorOf("\xEF\xBB\xBF[scene]\nsummary = \"Über 9 m²\"\n"),
            "s.toml:1: the scene has no [[object]]");
  // toml++ 3.3 itself is undefined on these.
  for (const char* letter : {"é", "ÿ", "Ж", "々", "ﻼ", "\u00A0", "\u2028"}) {
    EXPECT_THAT(errorOf("[scene]\nseed = 1 " + std::string(letter) + "\n"),
                testing::StartsWith("s.toml:2: "));
    EXPECT_THAT(errorOf("[scene]\n" + std::string(letter) + " = 1\n"), testing::StartsWith("s.toml:2: "));
  }
  EXPECT_EQ(errorOf("[scene]\nsummary = \"\xE9\"\n"), "s.toml:2: is not UTF-8; save it as that");
}

struct Mistake {
  const char* name;
  const char* toml;  ///< After a ball in lines 1 to 3; the mistake is in line 4 or as `line` says.
  const char* message;
  int line = 4;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

class SceneFileMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SceneFileMistake, IsOneLineWithThePlaceAndTheCure) {
  const std::string message =
      errorOf(std::string("[[object]]\nname = \"ball\"\nsphere = 1\n") + GetParam().toml);
  EXPECT_THAT(message, testing::StartsWith("s.toml:" + std::to_string(GetParam().line) + ": "));
  EXPECT_THAT(message, testing::HasSubstr(GetParam().message));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Files, SceneFileMistake,
    testing::Values(
        Mistake{"noToml", "mass =\n", "rror"}, Mistake{"twice", "mass = 1\nmass = 2\n", "mass", 5},
        Mistake{"text", "mass = \"1\"\n", "\"mass\" in [[object]] must be number, not a text"},
        Mistake{"date", "mass = 2020-01-01\n", "must be number, not a date"},
        Mistake{"negative", "mass = -1\n", "\"mass\" in [[object]] must be from 1e-06 to 1e+12 kg, not -1"},
        Mistake{"zero", "mass = 0\n", "not 0"}, Mistake{"infinite", "mass = inf\n", "not inf"},
        Mistake{"notANumber", "mass = nan\n", "not nan"},
        Mistake{"notANumberInAVector", "at = [0, nan, 0]\n", "\"at\" in [[object]] must be from"},
        Mistake{"far", "at = [0, 0, 1e7]\n", "must be from -1000000 to 1000000 m"},
        Mistake{"tooBouncy", "restitution = 1.5\n", "must be from 0 to 1, not 1.5"},
        Mistake{"fraction", "in = \"r\"\ncount = 1.5\n", "must be whole number, not a number", 5},
        Mistake{"shortVector", "at = [0, 0]\n", "\"at\" in [[object]] must be [x, y, z], not a list of 2"},
        Mistake{"noVector", "at = 3\n", "must be [x, y, z], not a whole number"},
        Mistake{"flag", "sensor = 1\n", "must be true or false"},
        Mistake{"twoShapes", "box = [1, 1, 1]\n", "[[object]] has both \"box\" and \"sphere\"; leave one out",
                3},
        Mistake{"twoPlaces", "at = [1, 1, 1]\nin = \"x\"\n", "has both \"at\" and \"in\"", 5},
        Mistake{"massAndDensity", "mass = 1\ndensity = 1\n", "has both \"mass\" and \"density\"", 5},
        Mistake{"badMotion", "motion = \"fixed\"\n", "must be static, kinematic or dynamic, not \"fixed\""},
        Mistake{"noMaterial", "material = \"ice\"\n", "there is no material \"ice\", nor any other"},
        Mistake{"wrongMaterial", "material = \"ise\"\n[[material]]\nname = \"ice\"\n",
                "there is no material \"ise\"; did you mean \"ice\"?"},
        Mistake{"wrongRegion", "in = \"sky\"\n", "there is no region \"sky\""},
        Mistake{"wrongGroup", "ignores = [\"bal\"]\ngroup = \"ball-s\"\n",
                "no object is in the group \"bal\"; did you mean \"ball-s\"?"},
        Mistake{"countAlone", "count = 3\n", "goes with \"in\""},
        Mistake{"emptyList", "list = []\n", "has no places"},
        Mistake{"zeroTurn", "orientation = { axis = [0, 0, 0], angle = 3 }\n", "must not be zero"},
        Mistake{"zeroQuaternion", "orientation = { quaternion = [0, 0, 0, 0] }\n", "must not be zero"},
        Mistake{"angleAlone", "orientation = { angle = 3 }\n", "needs one of axis or quaternion"},
        Mistake{"speedAlone", "velocity = { speed = 3 }\n", "needs one of random, toward or away"},
        Mistake{"rateWithToward", "velocity = { toward = [0, 0, 0], speed = 1, rate = 2 }\n",
                "\"rate\" goes with \"away\""},
        Mistake{"sphereRange", "[[object]]\nname = \"b\"\nsphere = [2, 1]\n", "the least and the most", 6},
        Mistake{"noName", "[[object]]\nsphere = 1\n", "[[object]] needs \"name\""},
        Mistake{"oddName", "[[object]]\nname = \"a b\"\nsphere = 1\n", "letters, digits", 5},
        Mistake{"duplicate", "[[object]]\nname = \"ball\"\nsphere = 1\n",
                "the name \"ball\" is already taken by the object in line 1"},
        Mistake{"nameOfABody", "[[object]]\nname = \"ball-2\"\nsphere = 1\n[[object]]\nname = \"ball\"\n",
                "[[object]] needs one of", 7},
        Mistake{"groupHasNameOfObject", "group = \"ball\"\n", "the group \"ball\" has the name of the object",
                1},
        Mistake{"noShape", "[[object]]\nname = \"b\"\n",
                "needs one of model, box, sphere, capsule, cylinder, hull, plane, mesh or terrain"},
        Mistake{"levelsOfABox", "[[object]]\nname = \"b\"\nbox = [1, 1, 1]\nlevels = 2\n",
                "\"levels\" goes with \"model\"", 7},
        Mistake{"fewPoints", "[[object]]\nname = \"b\"\nhull = [[0, 0, 0]]\n", "4 to 256 points, not 1", 6},
        Mistake{"movingPlane", "[[object]]\nname = \"b\"\nplane = [0, 1, 0]\nmotion = \"dynamic\"\n",
                "a plane can only be static", 7},
        Mistake{"stackOfPlanes", "[[object]]\nname = \"b\"\nplane = [0, 1, 0]\nstack = { count = 2 }\n",
                "a stack cannot be of planes", 7},
        Mistake{"movingMesh", "[[object]]\nname = \"b\"\nmesh = \"b.obj\"\nmotion = \"kinematic\"\n",
                "a mesh can only be static", 7},
        Mistake{"meshWithoutName", "[[object]]\nname = \"b\"\nmesh = \"\"\n",
                "\"mesh\" must be the name of a file", 6},
        Mistake{"terrainWithoutRelief",
                "[[object]]\nname = \"b\"\nterrain = { size = [9, 9], cells = [3, 3] }\n",
                "terrain = { … } needs \"relief\"", 6},
        Mistake{"flatTerrain",
                "[[object]]\nname = \"b\"\nterrain = { size = [9, 0], cells = [3, 3], relief = 1 }\n",
                "\"size\" in terrain = { … } must be from 0.001 to 100000 m, not 0", 6},
        Mistake{"sizeOfThree",
                "[[object]]\nname = \"b\"\nterrain = { size = [9, 9, 9], cells = [3, 3], relief = 1 }\n",
                "\"size\" in terrain must be two numbers", 6},
        Mistake{"halfACell",
                "[[object]]\nname = \"b\"\nterrain = { size = [9, 9], cells = [3, 2.5], relief = 1 }\n",
                "\"cells\" in terrain must be whole numbers", 6},
        Mistake{"hugeTerrain",
                "[[object]]\nname = \"b\"\nterrain = { size = [9, 9], cells = [1000, 251], relief = 1 }\n",
                "a terrain of more than 250000 cells", 6},
        Mistake{"terrainOfNoKind",
                "[[object]]\nname = \"b\"\nterrain = { size = [9, 9], cells = [3, 3], relief = 1, kind = "
                "\"voxels\" }\n",
                "must be mesh or height_field, not \"voxels\"", 6},
        Mistake{"fallingTerrain",
                "[[object]]\nname = \"b\"\nterrain = { size = [9, 9], cells = [3, 3], relief = 1 }\nmotion = "
                "\"dynamic\"\n",
                "a terrain can only be static", 7},
        Mistake{
            "denseTerrain",
            "[[object]]\nname = \"b\"\nterrain = { size = [9, 9], cells = [3, 3], relief = 1 }\ndensity = "
            "3\n",
            "a terrain has no volume", 7},
        Mistake{"hugeGrid", "grid = { count = [10000, 10000, 10000], spacing = [1, 1, 1] }\n",
                "a grid of more than 20000 bodies"},
        Mistake{"fractionalGrid", "grid = { count = [1, 1.5, 1], spacing = [1, 1, 1] }\n", "whole numbers"},
        Mistake{"hugeCount", "in = \"r\"\ncount = 999999999999\n", "must be from 1 to 20000", 5},
        Mistake{"noTable", "capsule = 3\n", "has both", 4},
        Mistake{"shellInsideOut", "[[region]]\nname = \"r\"\nkind = \"shell\"\ninner = 3\nouter = 2\n",
                "\"inner\" in [[region]] is above \"outer\"", 7},
        Mistake{"otherKindsKey", "[[region]]\nname = \"r\"\nkind = \"ball\"\nradius = 3\nouter = 2\n",
                "\"outer\" has no meaning in [[region]] with kind = \"ball\"", 8},
        Mistake{"fieldWithoutRadius", "[[field]]\nacceleration = 3\n", "[[field]] needs \"radius\", number"},
        Mistake{"jointOfNothing", "[[joint]]\nkind = \"fixed\"\na = \"bal\"\n",
                "there is no object, body or group \"bal\"; did you mean \"ball\"?", 6},
        Mistake{"jointOfItself", "[[joint]]\nkind = \"fixed\"\na = \"ball\"\nb = \"ball\"\n",
                "two different bodies", 7},
        Mistake{"jointOfStatic", "motion = \"static\"\n[[joint]]\nkind = \"fixed\"\na = \"ball\"\n",
                "must be dynamic", 7},
        Mistake{"halfLimits", "[[joint]]\nkind = \"slider\"\na = \"ball\"\naxis = [1, 0, 0]\nlower = 1\n",
                "go together", 8},
        Mistake{"hingeLimits",
                "[[joint]]\nkind = \"hinge\"\na = \"ball\"\naxis = [1, 0, 0]\nlower = -190\nupper = 1\n",
                "from -180 to 180 degrees", 8},
        Mistake{"eventWithoutTime", "[[event]]\ndo = \"remove\"\ntarget = \"ball\"\n",
                "needs one of frame or seconds"},
        Mistake{"eventWithTwoTimes",
                "[[event]]\ndo = \"remove\"\ntarget = \"ball\"\nframe = 1\nseconds = 1\n",
                "has both \"frame\" and \"seconds\"", 8},
        Mistake{"eventOnNothing", "[[event]]\ndo = \"remove\"\nframe = 1\n", "[[event]] needs \"target\""},
        Mistake{"unknownDeed", "[[event]]\ndo = \"explode\"\nframe = 1\n",
                "must be throw, knock, break, remove or field, not \"explode\"", 5},
        Mistake{"unbreakable", "[[event]]\ndo = \"break\"\nframe = 1\ntarget = \"ball\"\n", "cannot break",
                7},
        Mistake{"unknownField", "[[event]]\ndo = \"field\"\nframe = 1\nfield = \"x\"\non = true\n",
                "there is no field \"x\"", 7},
        Mistake{"manyLines", "group = \"a\\nb\"\n", "one line"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(SceneFileErrors, MemberNamesAreTaken) {
  EXPECT_EQ(errorOf("object = [{ name = \"a-2\", sphere = 1 },\n"
                    "  { name = \"a\", sphere = 1, list = [[0, 0, 0], [3, 0, 0]] }]\n"),
            "s.toml:2: the name \"a-2\" is already taken by the object in line 1");
}

TEST(SceneFileErrors, AGroupIsNotOneBody) {
  EXPECT_EQ(errorOf("[[object]]\nname = \"a\"\nsphere = 1\nlist = [[0, 0, 0], [3, 0, 0]]\n"
                    "[[joint]]\nkind = \"fixed\"\na = \"a\"\n"),
            "s.toml:7: \"a\" is several bodies; name one of them, such as \"a-1\"");
}

TEST(SceneFileErrors, TextThatTheParserDoesNotExpectHasItsLine) {
  // The TOML library asserts that a key begins with a character of a key.
  EXPECT_THAT(errorOf("[scene]\nframes = 3\n[[object]]\nname = \"a\"\n[[\x01]]\n"),
              testing::StartsWith("s.toml:5: "));
  EXPECT_THAT(errorOf("a = { !b = 1 }\n"), testing::StartsWith("s.toml:1: "));
}

TEST(SceneFileErrors, AnEmptyFileHasNoObjects) {
  EXPECT_EQ(errorOf(""), "s.toml:1: the scene has no [[object]]");
}

TEST(SceneFileErrors, AFileThatIsNotThereIsNamed) {
  const auto scene = readSceneFile("/nowhere/s.toml");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().message, "cannot read /nowhere/s.toml: No such file or directory");
}

TEST(SceneFileBombs, AreRefusedInOneLine) {
  const auto repeated = [](const std::string& part, std::size_t times) {
    std::string text;
    for (std::size_t i = 0; i < times; ++i) text += part;
    return text;
  };
  const std::string bombs[] = {
      std::string(2000000, ' '),                      // size
      "a = " + repeated("[", 100000),                 // nested lists
      "a = " + repeated("{ a = ", 20000),             // nested tables
      "a" + repeated(".a", 100000) + " = 1",          // nested keys
      "[a" + repeated(".a", 100000) + "]",            // nested headers
      repeated("[[object]]\n", 60000),                // tables
      "a = \"" + repeated("\\u0000", 100000) + "\"",  // characters that cannot be seen
      std::string("a = \"\xff\xfe\""),                // no UTF-8
  };
  for (const std::string& bomb : bombs) {
    const std::string message = errorOf(bomb);
    EXPECT_THAT(message, testing::StartsWith("s.toml:"));
    EXPECT_LT(message.size(), 300U);
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(SceneFileBombs, ManyBodiesInManyObjectsAreTooMany) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    text += "[[object]]\nname = \"o" + std::to_string(i) +
            "\"\nsphere = 1\ngrid = { count = [100, 100, 1], spacing = [2, 2, 2] }\n";
  }
  EXPECT_EQ(errorOf(text), "s.toml:9: more than 20000 bodies");
}

}  // namespace
}  // namespace scatter
