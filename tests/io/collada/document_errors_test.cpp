#include <scatter/io/collada.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>
#include <string>

#include "io/collada/samples.h"
#include "io/documents.h"

namespace scatter {
namespace {

using test::SceneFile;
using testing::Contains;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

/// What is wrong with a file, and the line that says so: an error or a warning.
struct Fault {
  std::string name;
  std::function<void(SceneFile&)> make;
  std::string line;
};

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.name;
}

std::function<void(SceneFile&)> common(const std::string& text) {
  return [text](SceneFile& f) { f.common = text; };
}

std::function<void(SceneFile&)> instances(const std::string& text) {
  return [text](SceneFile& f) { f.instances = text; };
}

std::function<void(SceneFile&)> node(const std::string& stack) {
  return [stack](SceneFile& f) { f.nodes = "<node id=\"n\">" + stack + "</node>"; };
}

std::function<void(SceneFile&)> world(const std::string& text) {
  return [text](SceneFile& f) { f.world = text; };
}

/// A constraint of the one body with the world.
std::function<void(SceneFile&)> limits(const std::string& text) {
  return [text](SceneFile& f) {
    f.models =
        "<physics_model id=\"j\"><rigid_constraint sid=\"c\"><ref_attachment/><attachment rigid_body=\"#n\"/>"
        "<technique_common><limits><linear>" +
        text +
        "</linear></limits></technique_common></rigid_constraint>"
        "</physics_model>";
    f.instances +=
        "<instance_physics_model url=\"#j\"><instance_rigid_constraint constraint=\"c\"/>"
        "</instance_physics_model>";
  };
}

const std::string kBox = "<shape><box><half_extents>1 1 1</half_extents></box></shape>";

std::vector<Fault> errors() {
  return {
      {"NanGravity", world("<gravity>0 nan 0</gravity>"), "11: <gravity>: \"nan\" is not a finite number"},
      {"InfiniteGravity", world("<gravity>0 INF 0</gravity>"), "11: <gravity>: \"INF\" is not a finite"},
      {"HugeGravity", world("<gravity>0 1e30 0</gravity>"), "11: <gravity>: 1e+30 is too large"},
      {"WordForTime", world("<time_step>soon</time_step>"), "11: <time_step>: \"soon\""},
      {"NegativeMass", common("<mass>-1</mass>" + kBox), "5: <mass>: -1 is not a mass"},
      {"NegativeSize", common("<shape><sphere><radius>-1</radius></sphere></shape>"),
       "5: <radius>: -1 is not a positive length"},
      {"SphereOfNothing", common("<shape><sphere><radius>0</radius></sphere></shape>"),
       "5: <radius>: 0 is not a positive length"},
      {"ConeOfNothing",
       common("<shape><tapered_cylinder><height>1</height><radius1>0</radius1><radius2>0</radius2>"
              "</tapered_cylinder></shape>"),
       "5: <tapered_cylinder>: has no radius at either end"},
      {"PlaneWithoutNormal", common("<shape><plane><equation>0 0 0 1</equation></plane></shape>"),
       "5: <equation>: the normal has no length"},
      {"NegativeInertia", common("<inertia>1 -1 1</inertia>" + kBox), "5: <inertia>: -1 kg m²"},
      {"NeitherTrueNorFalse", common("<dynamic>maybe</dynamic>" + kBox), "5: <dynamic>: \"maybe\""},
      {"FlatNode", node("<scale>1 0 1</scale>"), "8: <node>: its transform flattens"},
      {"NanMatrix", node("<matrix>1 0 0 nan 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"), "8: <matrix>: \"nan\""},
      {"ShortMatrix", node("<matrix>1 0 0</matrix>"), "8: <matrix>: should hold 16 numbers, but holds 3"},
      {"LooksAlongUp", node("<lookat>0 1 0 0 0 0 0 1 0</lookat>"), "8: <lookat>: the direction of view"},
      {"HugeScale", node("<scale>9e5 9e5 9e5</scale>"), "4: <rigid_body>: its node scales it so that"},
      {"FarNode", node("<translate>1e5 1e5 1e5</translate>"), "8: <node>: is too far"},
      {"NanLimit", limits("<min>0 nan 0</min>"), "6: <min>: \"nan\""},
      {"ShortLimit", limits("<min>0 0</min>"), "6: <min>: should hold 3 numbers, but holds 2"},
      {"NodeInItself", node("<instance_node url=\"#n\"/>"), "8: <node>: is instanced by itself"},
      {"HullOfHullOfItself",
       [](SceneFile& f) {
         f.libraries =
             "<library_geometries><geometry id=\"a\"><convex_mesh convex_hull_of=\"#b\"/></geometry>"
             "<geometry id=\"b\"><convex_mesh convex_hull_of=\"#a\"/></geometry></library_geometries>";
         f.common = "<shape><instance_geometry url=\"#a\"/></shape>";
       },
       "3: <geometry>: convex_hull_of leads back"},
      {"NoBody", common(""), "1: <COLLADA>: has no <rigid_body> that can be read"},
  };
}

std::vector<Fault> warnings() {
  const std::string model = "<instance_physics_model url=\"#m\">";
  return {
      {"MissingTarget",
       instances(model + "<instance_rigid_body body=\"b\" target=\"#x\"/></instance_physics_model>"),
       "10: <instance_rigid_body>: target \"#x\" names nothing in this file; the body stands at the origin"},
      {"NoTarget", instances(model + "<instance_rigid_body body=\"b\"/></instance_physics_model>"),
       "10: <instance_rigid_body>: has no target"},
      {"MissingBody", instances(model + "<instance_rigid_body body=\"x\"/></instance_physics_model>"),
       "10: <instance_rigid_body>: body \"x\" names no <rigid_body> of its model; it is left out"},
      {"MissingModel", instances("<instance_physics_model url=\"#x\"/>"),
       "10: <instance_physics_model>: url \"#x\" names nothing"},
      {"ModelInAnotherFile", instances("<instance_physics_model url=\"other.dae#x\"/>"),
       "10: <instance_physics_model>: url \"other.dae#x\" points outside this file"},
      {"NoInstances", instances("<instance_physics_model url=\"#m\"/>"),
       "10: <instance_physics_model>: has no <instance_rigid_body>"},
      {"Parent", instances("<instance_physics_model url=\"#m\" parent=\"#n\"/>"),
       "10: <instance_physics_model>: parent is not supported"},
      {"MissingConstraint",
       instances(model + "<instance_rigid_constraint constraint=\"x\"/></instance_physics_model>"),
       "10: <instance_rigid_constraint>: constraint \"x\" names no <rigid_constraint>"},
      {"MissingGeometry", common(kBox + "<shape><instance_geometry url=\"#x\"/></shape>"),
       "5: <instance_geometry>: url \"#x\" names nothing in this file; the shape is left out"},
      {"GeometryInAnotherFile", common(kBox + "<shape><instance_geometry url=\"other.dae#x\"/></shape>"),
       "5: <instance_geometry>: url \"other.dae#x\" points outside this file"},
      {"MissingMaterial", common("<instance_physics_material url=\"#x\"/>" + kBox),
       "5: <instance_physics_material>: url \"#x\" names nothing in this file; the default material is "
       "taken"},
      {"UnknownShape", common(kBox + "<shape><blob/></shape>"), "5: <shape>: holds no <box>"},
      {"UnknownElement", common("<wobble>1</wobble>" + kBox),
       "5: <wobble>: is not known in <technique_common> and is ignored"},
      {"Bouncy",
       common("<physics_material><technique_common><restitution>1.5</restitution></technique_common>"
              "</physics_material>" +
              kBox),
       "5: <restitution>: 1.5 is not from 0 to 1; 1 is taken"},
      {"NoTime", world("<time_step>0</time_step>"), "11: <time_step>: is no time and is ignored"},
      {"Animations", [](SceneFile& f) { f.libraries = "<library_animations/>"; },
       "3: <library_animations>: is not supported"},
      {"Shear", node("<matrix>1 0.5 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"),
       "8: <node>: its transform has a shear"},
      {"Perspective", node("<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1</matrix>"), "8: <matrix>: the last row"},
      {"OutsideTheScene",
       [](SceneFile& f) {
         f.libraries = "<library_nodes><node id=\"n\"/></library_nodes>";
         f.nodes = "";
       },
       "3: <node>: does not stand in the visual scene"},
      {"Twice",
       [](SceneFile& f) {
         f.libraries = "<library_nodes><node id=\"n\"/></library_nodes>";
         f.nodes = "<instance_node url=\"#n\"/><instance_node url=\"#n\"/>";
       },
       "3: <node>: stands in the visual scene several times"},
      {"UnusedConstraint",
       [](SceneFile& f) {
         f.models = "<physics_model id=\"j\"><rigid_constraint sid=\"latch\"/></physics_model>";
       },
       "6: <rigid_constraint>: \"latch\" is named by no <instance_rigid_constraint>; it is left out"},
      {"UnusedConstraintWithoutScene",
       [](SceneFile& f) {
         f.models =
             "<physics_model id=\"j\"><rigid_constraint "
             "sid=\"latch\"/></physics_model></library_physics_models>"
             "<library_physics_models>";
         f.scene = "";
       },
       "6: <rigid_constraint>: \"latch\" is named by no"},
      {"UnusedField",
       [](SceneFile& f) {
         f.libraries = "<library_force_fields><force_field id=\"pull\"/></library_force_fields>";
       },
       "3: <force_field>: \"pull\" is instanced by nothing that is read"},
      {"UnusedPhysicsScene",
       [](SceneFile& f) {
         f.libraries = "<library_physics_scenes><physics_scene id=\"later\"/></library_physics_scenes>";
       },
       "3: <physics_scene>: \"later\" is instanced by nothing that is read"},
      {"UnusedVisualScene",
       [](SceneFile& f) {
         f.libraries = "<library_visual_scenes><visual_scene id=\"later\"/></library_visual_scenes>";
       },
       "3: <visual_scene>: \"later\" is instanced by nothing that is read"},
      {"MeshOfNoBody",
       [](SceneFile& f) { f.nodes += "<node><node><instance_geometry url=\"#x\"/></node></node>"; },
       "8: <instance_geometry>: belongs to no rigid body and is left out"},
      {"SkinOfNoBody", [](SceneFile& f) { f.nodes += "<node><instance_controller url=\"#x\"/></node>"; },
       "8: <instance_controller>: belongs to no rigid body"},
      {"TwoGeometries",
       common(
           "<shape><sphere><radius>1</radius></sphere><box><half_extents>1 1 1</half_extents></box></shape>"),
       "5: <shape>: holds several geometries"},
      {"UnknownInShape", common("<shape><sphere><radius>1</radius><margin>1</margin></sphere></shape>"),
       "5: <margin>: is not known in <sphere>"},
      {"UnknownOfOurs",
       [](SceneFile& f) {
         f.common +=
             "</technique_common><extra><technique profile=\"SCATTER\"><levls/></technique></extra>"
             "<technique_common>";
       },
       "5: <levls>: is not known in <technique>"},
      {"LevelsUnderOtherShapes",
       [](SceneFile& f) {
         f.common += "</technique_common>" + test::coarser(test::boxLevel(1, "9 9 9")) + "<technique_common>";
         f.instances =
             "<instance_physics_model url=\"#m\"><instance_rigid_body body=\"b\" target=\"#n\">"
             "<technique_common>" +
             kBox + "</technique_common></instance_rigid_body></instance_physics_model>";
       },
       "10: <instance_rigid_body>: has shapes of its own; the levels"},
      {"Lines",
       [](SceneFile& f) {
         f.libraries = "<library_geometries>" +
                       test::geometry("wire", "mesh", 2, "0 0 0 1 1 1",
                                      "<lines><input semantic=\"VERTEX\" source=\"#wire-v\" offset=\"0\"/>"
                                      "<p>0 1</p></lines>") +
                       "</library_geometries>";
         f.nodes = "<node id=\"n\"><instance_geometry url=\"#wire\"/></node>";
       },
       "3: <lines>: has no triangles and is not shown"},
      {"Skin", node("<instance_controller url=\"#x\"/>"), "8: <instance_controller>: skins and morphs"},
  };
}

std::string faulty(const Fault& fault) {
  SceneFile file;
  fault.make(file);
  return file.text();
}

class ColladaSceneError : public testing::TestWithParam<Fault> {};

TEST_P(ColladaSceneError, IsToldOnOneLine) {
  const auto document = parseColladaDocument(faulty(GetParam()), "bad.dae");
  ASSERT_FALSE(document.has_value());
  EXPECT_THAT(document.error().message, StartsWith("bad.dae:" + GetParam().line));
  EXPECT_EQ(document.error().message.find('\n'), std::string::npos);
}

class ColladaSceneWarning : public testing::TestWithParam<Fault> {};

TEST_P(ColladaSceneWarning, IsToldOnOneLineAndTheRestIsRead) {
  const auto document = parseColladaDocument(faulty(GetParam()), "odd.dae");
  ASSERT_TRUE(document.has_value()) << document.error().message;
  EXPECT_THAT(document->warnings, Contains(StartsWith("odd.dae:" + GetParam().line)));
  EXPECT_THAT(document->models, SizeIs(1));
}

const auto kFaultName = [](const testing::TestParamInfo<Fault>& info) { return info.param.name; };

INSTANTIATE_TEST_SUITE_P(Errors, ColladaSceneError, testing::ValuesIn(errors()), kFaultName);
INSTANTIATE_TEST_SUITE_P(Warnings, ColladaSceneWarning, testing::ValuesIn(warnings()), kFaultName);

std::string messageFor(const std::string& text) {
  const auto document = parseColladaDocument(text, "bomb.dae");
  return document ? "no error" : document.error().message;
}

TEST(ColladaBombs, AreNotNestedDeeply) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) {
    deep += "<node>";
  }
  SceneFile file;
  file.nodes = deep;
  EXPECT_THAT(messageFor(file.text()), StartsWith("bomb.dae:"));
  for (int i = 0; i < 100000; ++i) {
    file.nodes += "</node>";
  }
  EXPECT_THAT(messageFor(file.text()), HasSubstr("nested deeper than 256 elements"));
}

TEST(ColladaBombs, ExpandNoEntities) {
  SceneFile file;
  file.nodes = "<node id=\"n\" name=\"&a;\"/>";
  const std::string text =
      "<?xml version=\"1.0\"?><!DOCTYPE b [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;\">]>" +
      file.text();
  const auto document = parseColladaDocument(text, "bomb.dae");
  ASSERT_TRUE(document.has_value()) << document.error().message;
  EXPECT_EQ(document->bodies.at(0).name, "&a;");
}

/// Each of `count` elements holds the next one several times, through instances.
std::string fanOut(int count, const std::function<std::string(int)>& element) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += element(i);
  }
  return text;
}

TEST(ColladaBombs, DoNotMultiplyNodes) {
  SceneFile file;
  file.libraries =
      "<library_nodes>" +
      fanOut(60,
             [](int i) {
               const std::string next = "<instance_node url=\"#x" + std::to_string(i + 1) + "\"/>";
               return "<node id=\"x" + std::to_string(i) + "\">" + next + next + next + "</node>";
             }) +
      "<node id=\"x60\"/></library_nodes>";
  file.nodes = "<node id=\"n\"><instance_node url=\"#x0\"/></node>";
  EXPECT_THAT(messageFor(file.text()), HasSubstr("use fewer instances or simpler meshes"));
}

TEST(ColladaBombs, DoNotMultiplyModels) {
  SceneFile file;
  file.models = fanOut(60, [](int i) {
    const std::string next = "<instance_physics_model url=\"#x" + std::to_string(i + 1) + "\"/>";
    return "<physics_model id=\"x" + std::to_string(i) + "\">" + next + next + next + "</physics_model>";
  });
  file.models += "<physics_model id=\"x60\"/>";
  file.instances = "<instance_physics_model url=\"#x0\"/>";
  EXPECT_THAT(messageFor(file.text()), HasSubstr("use fewer instances or simpler meshes"));
}

TEST(ColladaBombs, DoNotMultiplyMeshes) {
  std::string positions;
  for (int i = 0; i < 3 * 30000; ++i) {
    positions += "1 ";
  }
  std::string shapes;
  for (int i = 0; i < 2000; ++i) {
    shapes += "<shape><instance_geometry url=\"#g\"/></shape>";
  }
  SceneFile file;
  file.libraries =
      "<library_geometries>" + test::geometry("g", "convex_mesh", 30000, positions) + "</library_geometries>";
  file.common = shapes;
  EXPECT_THAT(messageFor(file.text()), HasSubstr("use fewer instances or simpler meshes"));
}

TEST(ColladaBombs, TellAtMostSomeHundredWarnings) {
  SceneFile file;
  for (int i = 0; i < 2000; ++i) {
    file.common += "<odd" + std::to_string(i) + "/>";
  }
  const auto document = parseColladaDocument(file.text(), "bomb.dae");
  ASSERT_TRUE(document.has_value());
  EXPECT_THAT(document->warnings, SizeIs(501));
  EXPECT_EQ(document->warnings.back(), "and 1500 more warnings of other kinds");
}

}  // namespace
}  // namespace scatter
