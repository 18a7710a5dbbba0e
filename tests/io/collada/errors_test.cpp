#include <scatter/io/collada.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>
#include <string>

#include "io/documents.h"

namespace scatter {
namespace {

using test::boxLevel;
using test::coarser;
using test::Document;

/// A mistake in a file, where the message must place it and what it must mention.
struct Mistake {
  std::string name;
  std::function<void(Document&)> make;
  std::string place;
  std::string words;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

std::function<void(Document&)> finest(const std::string& geometry) {
  return [geometry](Document& d) { d.finest = "<shape>" + geometry + "</shape>"; };
}

std::function<void(Document&)> mass(const std::string& text) {
  return [text](Document& d) { d.mass = text; };
}

std::function<void(Document&)> extra(const std::string& text) {
  return [text](Document& d) { d.extra = text; };
}

std::function<void(Document&)> asset(const std::string& text) {
  return [text](Document& d) { d.asset = text; };
}

std::function<void(Document&)> libraries(const std::string& text, const std::string& finestShape) {
  return [text, finestShape](Document& d) {
    d.libraries = "<library_geometries>" + text + "</library_geometries>";
    if (!finestShape.empty()) {
      d.finest = "<shape>" + finestShape + "</shape>";
    }
  };
}

const std::string kHullShape = "<instance_geometry url=\"#h\"/>";
const std::string kTetrahedron = "0 0 0 1 0 0 0 1 0 0 0 1";

std::string triangles(const std::string& corners) {
  return test::geometry("m", "mesh", 4, kTetrahedron,
                        "<triangles><input semantic=\"VERTEX\" source=\"#m-v\" offset=\"0\"/><p>" + corners +
                            "</p></triangles>");
}

std::vector<Mistake> shapeMistakes() {
  return {
      {"MissingHalfExtents", finest("<box/>"), "7: <box>", "has no <half_extents>"},
      {"TooFewNumbers", finest("<box><half_extents>1 2</half_extents></box>"), "7: <half_extents>",
       "3 numbers, but holds 2"},
      {"TooManyNumbers", finest("<box><half_extents>1 2 3 4</half_extents></box>"), "7: <half_extents>",
       "holds 4"},
      {"NotANumber", finest("<box><half_extents>1 NaN 3</half_extents></box>"), "7: <half_extents>",
       "\"NaN\""},
      {"Infinite", finest("<box><half_extents>1 INF 3</half_extents></box>"), "7: <half_extents>", "\"INF\""},
      {"Word", finest("<box><half_extents>1 2x 3</half_extents></box>"), "7: <half_extents>", "\"2x\""},
      {"BeyondDouble", finest("<box><half_extents>1 1e999 3</half_extents></box>"), "7: <half_extents>",
       "1e999"},
      {"TooLarge", finest("<box><half_extents>1 1e9 3</half_extents></box>"), "7: <half_extents>",
       "too large"},
      {"ZeroSize", finest("<box><half_extents>1 0 3</half_extents></box>"), "7: <half_extents>",
       "0 is not a positive"},
      {"NegativeRadius", finest("<sphere><radius>-1</radius></sphere>"), "7: <radius>",
       "-1 is not a positive"},
      {"NoRadius", finest("<sphere/>"), "7: <sphere>", "<radius>"},
      {"ThreeRadii", finest("<capsule><height>1</height><radius>1 1 1</radius></capsule>"), "7: <radius>",
       "1 or 2"},
      {"Elliptic", finest("<cylinder><height>1</height><radius>1 2</radius></cylinder>"), "7: <radius>",
       "elliptic"},
      {"NoHeight", finest("<cylinder><radius>1 1</radius></cylinder>"), "7: <cylinder>", "<height>"},
      {"UnknownShape", finest("<plane/>"), "7: <shape>", "holds no <box>"},
      {"NoShapes", [](Document& d) { d.finest.clear(); }, "4: <technique_common>", "has no <shape>"},
      {"ShortRotation", finest("<sphere><radius>1</radius></sphere><rotate>1 0 0</rotate>"), "7: <rotate>",
       "4 numbers"},
      {"NoAxis", finest("<sphere><radius>1</radius></sphere><rotate>0 0 0 30</rotate>"), "7: <rotate>",
       "axis"},
      {"ShortTranslation", finest("<sphere><radius>1</radius></sphere><translate>1</translate>"),
       "7: <translate>", "3 numbers"},
  };
}

std::vector<Mistake> geometryMistakes() {
  return {
      {"DanglingUrl", finest("<instance_geometry url=\"#nothing\"/>"), "7: <instance_geometry>",
       "\"#nothing\" names nothing"},
      {"ForeignUrl", finest("<instance_geometry url=\"other.dae#h\"/>"), "7: <instance_geometry>",
       "outside this file"},
      {"NoUrl", finest("<instance_geometry/>"), "7: <instance_geometry>", "has no url"},
      {"WrongTarget", libraries("<source id=\"h\"/>", kHullShape), "7: <instance_geometry>", "a <source>"},
      {"ConcaveShape", libraries(test::geometry("h", "mesh", 4, kTetrahedron), kHullShape), "3: <geometry>",
       "<convex_mesh>"},
      {"HullOfItself",
       libraries("<geometry id=\"h\"><convex_mesh convex_hull_of=\"#h\"/></geometry>", kHullShape),
       "3: <geometry>", "<mesh>"},
      {"WrongArrayCount", libraries(test::geometry("h", "convex_mesh", 5, kTetrahedron), kHullShape),
       "3: <float_array>", "15 numbers, but holds 12"},
      {"NanVertex", libraries(test::geometry("h", "convex_mesh", 4, "0 0 0 1 nan 0 0 1 0 0 0 1"), kHullShape),
       "3: <float_array>", "\"nan\""},
      {"IndexBeyondVertices", libraries(triangles("0 1 4"), ""), "3: <triangles>", "index 4 is beyond"},
      {"NegativeIndex", libraries(triangles("0 1 -2"), ""), "3: <p>", "\"-2\" is not an index"},
      {"IncompleteTriangle", libraries(triangles("0 1 2 3"), ""), "3: <triangles>", "holds 4 corners"},
      {"TriangleStrips", libraries(test::geometry("m", "mesh", 4, kTetrahedron, "<tristrips/>"), ""),
       "3: <tristrips>", "export the mesh as triangles"},
      {"FlatHull", libraries(test::geometry("h", "convex_mesh", 4, "0 0 0 1 0 0 0 1 0 1 1 0"), kHullShape),
       "4: <rigid_body>", "brick"},
  };
}

std::vector<Mistake> levelMistakes() {
  return {
      {"EmptyLevels", extra(coarser("")), "8: <levels>", "has no <level>"},
      {"EmptyLevel", extra(coarser("<level index=\"1\"/>")), "8: <level>", "has no <shape>"},
      {"LevelsOutOfOrder", extra(coarser(boxLevel(2, "1 1 1") + boxLevel(1, "2 2 2"))), "8: <level>",
       "index=\"1\""},
      {"LevelMissing", extra(coarser(boxLevel(1, "2 2 2") + boxLevel(3, "1 1 1"))), "8: <level>",
       "index=\"2\""},
      {"LevelWithoutIndex", extra(coarser("<level/>")), "8: <level>", "index=\"1\""},
      {"BadIndex", extra(coarser("<level index=\"one\"/>")), "8: <level>", "\"one\""},
      {"WrongLevelCount", extra(coarser(boxLevel(1, "2 2 2"), "count=\"3\"")), "8: <levels>", "3 levels"},
      {"NegativeMargin", extra(coarser(boxLevel(1, "2 2 2"), "margin=\"-0.1\"")), "8: <levels>", "-0.1"},
      {"MarginNotANumber", extra(coarser(boxLevel(1, "2 2 2"), "margin=\"nan\"")), "8: <levels>", "nan"},
      // Half extents of 0.5 in a box of 0.45.
      {"NotNested", extra(coarser(boxLevel(1, "0.45 2 2"))), "8: <levels>", "0.05"},
  };
}

std::vector<Mistake> bodyMistakes() {
  return {
      {"NegativeMass", mass("<mass>-2</mass>"), "5: <mass>", "-2 is not a mass"},
      {"ZeroMass", mass("<mass>0</mass>"), "5: <mass>", "0 is not a mass"},
      {"NanMass", mass("<mass>nan</mass>"), "5: <mass>", "\"nan\""},
      {"EmptyMass", mass("<mass/>"), "5: <mass>", "1 number, but holds 0"},
      {"NoMass", mass(""), "4: <technique_common>", "has no <mass>"},
      {"DanglingMaterial", [](Document& d) { d.material = "<instance_physics_material url=\"#m\"/>"; },
       "6: <instance_physics_material>", "\"#m\" names nothing"},
      {"NegativeFriction",
       [](Document& d) {
         d.material =
             "<physics_material><technique_common><dynamic_friction>-1</dynamic_friction>"
             "</technique_common></physics_material>";
       },
       "6: <dynamic_friction>", "-1 is not from 0"},
      {"Bouncier",
       [](Document& d) {
         d.material =
             "<physics_material><technique_common><restitution>1.5</restitution></technique_common>"
             "</physics_material>";
       },
       "6: <restitution>", "1.5 is not from 0 to 1"},
      {"ZeroUnit", asset("<unit meter=\"0\"/>"), "2: <unit>", "\"0\""},
      {"UnknownUpAxis", asset("<up_axis>UP</up_axis>"), "2: <up_axis>", "\"UP\""},
  };
}

class ColladaMistake : public testing::TestWithParam<Mistake> {};

TEST_P(ColladaMistake, IsReportedOnOneLineWithFileLineAndElement) {
  Document document;
  GetParam().make(document);
  const auto model = parseCollada(document.text(), "folder/bad.dae");
  ASSERT_FALSE(model.has_value());
  const std::string& message = model.error().message;
  EXPECT_THAT(message, testing::StartsWith("folder/bad.dae:" + GetParam().place + ":"));
  EXPECT_THAT(message, testing::HasSubstr(GetParam().words));
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0);
}

const auto kMistakeName = [](const testing::TestParamInfo<Mistake>& info) { return info.param.name; };

INSTANTIATE_TEST_SUITE_P(Shape, ColladaMistake, testing::ValuesIn(shapeMistakes()), kMistakeName);
INSTANTIATE_TEST_SUITE_P(Geometry, ColladaMistake, testing::ValuesIn(geometryMistakes()), kMistakeName);
INSTANTIATE_TEST_SUITE_P(Level, ColladaMistake, testing::ValuesIn(levelMistakes()), kMistakeName);
INSTANTIATE_TEST_SUITE_P(Body, ColladaMistake, testing::ValuesIn(bodyMistakes()), kMistakeName);

std::string messageFor(const std::string& text) {
  const auto model = parseCollada(text, "bad.dae");
  return model ? "no error" : model.error().message;
}

TEST(ColladaErrors, RefusesTextThatIsNotXml) {
  EXPECT_THAT(messageFor("solid cube"), testing::StartsWith("bad.dae:1: not a well-formed XML file"));
  EXPECT_THAT(messageFor(""), testing::StartsWith("bad.dae:1: not a well-formed XML file"));
  EXPECT_THAT(messageFor("<COLLADA>\n<asset>\n</COLLADA>"),
              testing::StartsWith("bad.dae:3: not a well-formed"));
}

TEST(ColladaErrors, RefusesOtherXml) {
  EXPECT_EQ(messageFor("<svg/>"), "bad.dae:1: <svg>: is not a COLLADA document");
}

TEST(ColladaErrors, RefusesAFileWithoutPhysics) {
  EXPECT_THAT(
      messageFor("\n<COLLADA><library_geometries/></COLLADA>"),
      testing::AllOf(testing::StartsWith("bad.dae:2: <COLLADA>"), testing::HasSubstr("<physics_model>")));
}

TEST(ColladaErrors, RefusesSeveralBodies) {
  std::string text = Document{}.text();
  text.insert(text.find("</physics_model>"), "<rigid_body/>");
  EXPECT_THAT(messageFor(text), testing::HasSubstr("should hold one <rigid_body>, but holds 2"));
}

TEST(ColladaErrors, KeepsControlCharactersOutOfMessages) {
  Document document;
  document.finest =
      "<shape><instance_geometry url=\"#a&#10;b&#27;[31m" + std::string(500, 'x') + "\"/></shape>";
  const std::string message = messageFor(document.text());
  EXPECT_THAT(message, testing::HasSubstr("#a?b?[31m"));
  EXPECT_LT(message.size(), 200U);
}

TEST(ColladaErrors, NamesAFileThatCannotBeRead) {
  const auto missing = readCollada("/nowhere/ship.dae");
  ASSERT_FALSE(missing.has_value());
  EXPECT_THAT(missing.error().message, testing::StartsWith("cannot read /nowhere/ship.dae: "));
  const auto folder = readCollada("/tmp");
  ASSERT_FALSE(folder.has_value());
  EXPECT_THAT(folder.error().message, testing::StartsWith("cannot read /tmp: "));
}

}  // namespace
}  // namespace scatter
