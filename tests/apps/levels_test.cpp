#include <gmock/gmock.h>
#include <scatter/io/model_file.h>

#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/program.h"
#include "io/mesh/files.h"
#include "trials.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

class Levels : public ProgramTest {
 protected:
  /// Writes a mesh beside the test's folder, so that expectRefused() finds that one empty.
  fs::path mesh(const std::string& name, const std::string& text) const {
    writeText(inputs_.path / name, text);
    return inputs_.path / name;
  }

  [[nodiscard]] Outcome build(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"levels", "build"});
    return scatter(std::move(arguments));
  }

  void expectBuilt(std::vector<std::string> arguments, const std::string& file) const {
    const Outcome built = build(std::move(arguments));
    ASSERT_EQ(built.status, 0) << built.errors;
    const Outcome checked = scatter({"levels", "check", file});
    EXPECT_EQ(checked.status, 0) << checked.output << checked.errors;
    EXPECT_THAT(checked.output, HasSubstr("inside   mesh in level"));
    EXPECT_THAT(checked.output, Not(HasSubstr("OUTSIDE")));
  }

  nlohmann::json figures(const std::string& file) const {
    const Outcome shown = scatter({"levels", "show", file, "--json", "figures.json"});
    EXPECT_EQ(shown.status, 0) << shown.errors;
    return nlohmann::json::parse(readText(folder / "figures.json"), nullptr, false);
  }

 private:
  struct Inputs {
    Inputs() { fs::create_directories(path); }
    Inputs(const Inputs&) = delete;
    Inputs& operator=(const Inputs&) = delete;
    ~Inputs() { fs::remove_all(path); }
    fs::path path = fs::temp_directory_path() / ("scatter-meshes-" + std::to_string(getpid()));
  };
  Inputs inputs_;
};

/// Bars crossing in a corner: needs several parts.
std::string corner() {
  std::string text;
  auto bar = [&text, count = 0](int x, int y, int z) mutable {
    for (int i = 0; i < 8; ++i) {
      text += "v " + std::to_string(i % 2 * x) + " " + std::to_string(i / 2 % 2 * y) + " " +
              std::to_string(i / 4 * z) + "\n";
    }
    for (const auto& t : {"1 3 2", "2 3 4", "5 6 7", "6 8 7", "1 2 5", "2 6 5", "3 7 4", "4 7 8", "1 5 3",
                          "3 5 7", "2 4 6", "4 8 6"}) {
      std::string face = "f";
      for (const char c : std::string(t)) face += c == ' ' ? "" : " " + std::to_string(c - '0' + count);
      text += face + "\n";
    }
    count += 8;
  };
  bar(8, 1, 1);
  bar(1, 8, 1);
  bar(1, 1, 8);
  return text;
}

TEST_F(Levels, BuiltLevelsPassTheCheck) {
  const std::string input = mesh("corner.obj", corner());
  expectBuilt({input, "-o", "a.dae", "--parts", "3,2,1", "--mass", "40", "--name", "Eck"}, "a.dae");
  const auto json = figures("a.dae");
  const auto& model = json["models"][0];
  EXPECT_EQ(model["name"], "Eck");
  EXPECT_EQ(model["triangles"], 36);
  ASSERT_EQ(model["levels"].size(), 3U);
  EXPECT_EQ(model["levels"][0]["parts"], 1);
  // Three bars hold it exactly; one hull cannot.
  EXPECT_LT(model["levels"][2]["max_gap_share"].get<double>(), 0.02);
  EXPECT_GT(model["levels"][0]["max_gap_share"].get<double>(), 0.1);
}

// Three bars of 8 cubic metres have one in common, which counts once: 22 cubic metres.
TEST_F(Levels, MassIsOfWhatTheMeshFillsInBothFormats) {
  for (const std::string file : {"corner.dae", "corner.glb"}) {
    const Outcome built =
        build({mesh("corner.obj", corner()), "-o", file, "--parts", "3,1", "--density", "10"});
    ASSERT_EQ(built.status, 0) << built.errors;
    const auto mass = figures(file)["models"][0]["mass_properties"];
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(mass["center_of_mass_m"][axis].get<double>(), (32.0 + 4.0 + 4.0 - 1.0) / 22.0, 0.01);
    }
    EXPECT_THAT(mass["source"].get<std::string>(), HasSubstr("22"));
    const auto model = readModelFile(folder / file);
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_NEAR(model->model.mass, 220.0F, 2.0F);
    EXPECT_NEAR(model->model.levels->mass().centerOfMass.x, 39.0F / 22.0F, 0.01F);
  }
  EXPECT_EQ(build({mesh("corner.obj", corner()), "-o", "x.dae", "--density", "0"}).status, 2);
}

TEST_F(Levels, SixLevelsAndTheOtherFormats) {
  expectBuilt({mesh("corner.obj", corner()), "-o", "six.dae", "--levels", "6"}, "six.dae");
  expectBuilt({mesh("box.stl", binaryStlBox()), "-o", "stl.dae", "--levels", "1"}, "stl.dae");
  expectBuilt({mesh("box.glb", glbBox()), "-o", "glb.glb", "--levels", "2"}, "glb.glb");
  expectBuilt({mesh("box.dae", daeBox("<unit meter=\"0.01\"/><up_axis>Z_UP</up_axis>")), "-o", "dae.dae"},
              "dae.dae");
}

TEST_F(Levels, GapGivesAsManyPartsAsItTakes) {
  expectBuilt({mesh("corner.obj", corner()), "-o", "gap.dae", "--gap", "2%", "--levels", "2"}, "gap.dae");
  const auto json = figures("gap.dae");
  EXPECT_LE(json["models"][0]["levels"][1]["max_gap_share"].get<double>(), 0.02);
}

TEST_F(Levels, CentimetresBecomeMetres) {
  expectBuilt({mesh("box.obj", objBox()), "-o", "cm.dae", "--unit", "cm", "--levels", "1"}, "cm.dae");
  // The diagonal of a box of 1 by 2 by 3.
  EXPECT_NEAR(figures("cm.dae")["models"][0]["diagonal_m"].get<double>(), 0.0374166, 1e-5);
}

TEST_F(Levels, FlatMeshesGetThickness) {
  expectBuilt({mesh("flat.obj", "v 0 0 0\nv 4 0 0\nv 4 0 3\nv 0 0 3\nf 1 2 3 4\n"), "-o", "flat.dae",
               "--levels", "2"},
              "flat.dae");
  expectBuilt({mesh("wire.obj", "v 0 0 0\nv 4 0 0\nv 2 0 0\nf 1 2 3\n"), "-o", "wire.dae", "--levels", "1"},
              "wire.dae");
}

TEST_F(Levels, TheSameMeshGivesTheSameBytes) {
  const std::string input = mesh("corner.obj", corner());
  ASSERT_EQ(build({input, "-o", "a.dae"}).status, 0);
  ASSERT_EQ(build({input, "-o", "b.dae"}).status, 0);
  EXPECT_EQ(readText(folder / "a.dae"), readText(folder / "b.dae"));
}

TEST_F(Levels, ShipsOfTheModelsFolderAreWhatTheCommandMakes) {
  if (kSanitized) GTEST_SKIP() << "the command builds levels in other tests";
  for (const std::string& ship : test::trials<std::string>({"hunter", "fighter"})) {
    const std::string command =
        "'" SCATTER_MAKE_LEVELS "' '" + folder.string() + "' '" SCATTER_PROGRAM "' " + ship + " > /dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const std::string name = ship + "_hulls.dae";
    EXPECT_TRUE(readText(folder / name) == readText(fs::path(SCATTER_TEST_MODEL_DIR) / name))
        << name << " differs; run tools/make_levels models";
  }
}

TEST_F(Levels, OfSymmetricMeshesAreSymmetricIfAskedFor) {
  const std::string three = mesh("three.obj", objTool());
  const Outcome unasked = build({three, "-o", "any.dae", "--parts", "2,1"});
  EXPECT_THAT(
      unasked.errors,
      HasSubstr("symmetric about the plane x = 2.5, its levels are not symmetric about it; --symmetric on"));
  EXPECT_THAT(unasked.output, Not(HasSubstr("plane x")));
  for (const std::string file : {"three.dae", "three.glb"}) {
    const Outcome built = build({three, "-o", file, "--parts", "3,1", "--symmetric", "on"});
    ASSERT_EQ(built.status, 0) << built.errors;
    EXPECT_THAT(built.errors, Not(HasSubstr("symmetric")));
    const std::string line =
        "symmetric about the plane x = 2.5: level 1: 0 pairs of parts and 1 symmetric; level 2: 1 pair of "
        "parts and 1 "
        "symmetric\n";
    EXPECT_THAT(built.output, HasSubstr(line));
    EXPECT_THAT(scatter({"levels", "show", file}).output, HasSubstr(line));
    const nlohmann::json symmetry = figures(file)["models"][0]["symmetry"];
    EXPECT_EQ(symmetry["axis"], "x");
    EXPECT_EQ(symmetry["offset_m"], 2.5);
    EXPECT_EQ(symmetry["levels"][1]["pairs"], 1);
  }
}

TEST_F(Levels, SeveralMeshesGoIntoAFolderAndOnlyChangedOnesAgain) {
  const std::string box = mesh("box.obj", objBox());
  const std::string other = mesh("other.stl", asciiStlBox());
  const std::vector<std::string> both{box, other, "--folder", "levels", "--format", "glb"};
  const Outcome first = build(both);
  ASSERT_EQ(first.status, 0) << first.errors;
  EXPECT_THAT(first.output, HasSubstr("2 of 2 meshes written, 0 unchanged, 0 failed"));
  EXPECT_EQ(scatter({"levels", "check", "levels/box.glb"}).status, 0);
  const std::string bytes = readText(folder / "levels" / "other.glb");

  EXPECT_THAT(build(both).output, HasSubstr("0 of 2 meshes written, 2 unchanged, 0 failed"));
  mesh("other.stl", binaryStlBox());
  EXPECT_THAT(build(both).output, HasSubstr("1 of 2 meshes written, 1 unchanged, 0 failed"));
  // The same box in other bytes; what was made by hand is made again.
  EXPECT_EQ(readText(folder / "levels" / "other.glb"), bytes);
  writeText(folder / "levels" / "box.glb", "edited");
  EXPECT_THAT(build(both).output, HasSubstr("1 of 2 meshes written, 1 unchanged, 0 failed"));
  EXPECT_EQ(scatter({"levels", "check", "levels/box.glb"}).status, 0);
  EXPECT_THAT(build({box, other, "--folder", "levels", "--format", "glb", "--mass", "3"}).output,
              HasSubstr("2 of 2 meshes written"));
  EXPECT_THAT(build({box, "--folder", "levels", "--format", "glb", "--mass", "3", "--anew"}).output,
              HasSubstr("1 of 1 meshes written"));
}

TEST_F(Levels, RegionsAreKeptApartByNameAndReported) {
  const std::string tool = mesh("tool.obj", objTool());
  expectBuilt({tool, "-o", "a.dae", "--parts", "2,1", "--keep", "handle"}, "a.dae");
  const Outcome built = build({tool, "-o", "a.dae", "--parts", "2,1", "--keep", "handle"});
  EXPECT_THAT(built.output, HasSubstr("handle (weight 8), kept apart"));
  EXPECT_THAT(built.output, HasSubstr("elsewhere"));
  // The handle has a part of its own; the other part swallows it, so that gaps there are those of the rest.
  const Outcome shown = scatter({"levels", "show", "a.dae", "--mesh", tool, "--region", "object:handle",
                                 "--region", "box:-9,-9,-9,1.5,9,9", "--json", "regions.json"});
  ASSERT_EQ(shown.status, 0) << shown.errors;
  EXPECT_THAT(shown.output, HasSubstr("object:handle"));
  const auto json = nlohmann::json::parse(readText(folder / "regions.json"), nullptr, false);
  const auto& finest = json["models"][0]["levels"][1];
  EXPECT_EQ(finest["parts"], 2);
  ASSERT_EQ(finest["regions"].size(), 3U);
  EXPECT_EQ(finest["regions"][2]["region"], "elsewhere");

  // A box needs no names, is in the file's unit and axes, and the material is two of the three cubes.
  expectBuilt({tool, "-o", "b.dae", "--parts", "2,1", "--keep", "box:-1,-1,-1,1.5,2,2"}, "b.dae");
  expectBuilt({tool, "-o", "c.dae", "--parts", "2,1", "--keep", "rubber"}, "c.dae");
  for (const std::string file : {"b.dae", "c.dae"})
    EXPECT_NEAR(figures(file)["models"][0]["levels"][1]["union_volume_m3"].get<double>(), 1.0 + 3.0, 0.1);
  expectBuilt({tool, "-o", "d.dae", "--parts", "2,1", "--unit", "cm", "--up", "z", "--importance",
               "box:-1,-1,-1,1.5,2,2=9"},
              "d.dae");
}

TEST_F(Levels, WrongRegionsAreRefusedInOneLine) {
  const std::string tool = mesh("tool.obj", objTool());
  const auto refused = [&](const std::vector<std::string>& options, const std::string& part) {
    std::vector<std::string> arguments{tool, "-o", "a.dae"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expectRefused(build(arguments), part);
  };
  refused({"--keep", "handel"}, R"(unknown region "handel"; did you mean "handle"? Known: body, handle, )");
  refused({"--keep", "material:handle"}, "Known: ");
  refused({"--keep", "box:1,2,3"}, "box:X0,Y0,Z0,X1,Y1,Z1");
  refused({"--keep", "box:1,2,3,4,5,6,7"}, "box:X0,Y0,Z0,X1,Y1,Z1");
  refused({"--keep", "box:50,0,0,60,1,1"}, "has nothing of the mesh");
  refused({"--importance", "handle"}, "--importance");
  refused({"--importance", "handle=0"}, "0.01 to 100");
  refused({"--importance", "handle=many"}, "0.01 to 100");
  refused({"--importance", "handle=2", "--importance", "handle=3"}, "twice");
  refused({"--importance", "shaft=2"}, R"(unknown region "shaft")");
  std::string twice = objTool();
  for (std::size_t at = twice.find("steel"); at != std::string::npos; at = twice.find("steel"))
    twice.replace(at, 5, "tip");
  expectRefused(build({mesh("twice.obj", twice), "-o", "a.dae", "--keep", "tip"}),
                "material:tip and object:tip; say which");
  expectRefused(build({mesh("box.stl", binaryStlBox()), "-o", "a.dae", "--keep", "x"}),
                "box:X0,Y0,Z0,X1,Y1,Z1");
  ASSERT_EQ(build({tool, "-o", "a.dae"}).status, 0);
  const Outcome shown = scatter({"levels", "show", "a.dae", "--region", "handle"});
  EXPECT_EQ(shown.status, 2);
  EXPECT_THAT(shown.errors, HasSubstr("with --mesh"));
}

TEST_F(Levels, FilesInAFolderAreMadeAgainWithOtherRegions) {
  const std::string tool = mesh("tool.obj", objTool());
  const auto made = [&](const std::string& option, const std::string& value) {
    return build({tool, "--folder", "levels", "--parts", "2,1", option, value}).output;
  };
  EXPECT_THAT(made("--keep", "tip"), HasSubstr("1 of 1 meshes written"));
  EXPECT_THAT(made("--keep", "tip"), HasSubstr("1 unchanged"));
  EXPECT_THAT(made("--keep", "body"), HasSubstr("1 of 1 meshes written"));
  EXPECT_THAT(made("--importance", "body=2"), HasSubstr("1 of 1 meshes written"));
}

TEST_F(Levels, OneBadMeshOfSeveralDoesNotStopTheOthers) {
  const Outcome built = build({mesh("bad.obj", "nonsense"), mesh("box.obj", objBox()), "--folder", "levels"});
  EXPECT_EQ(built.status, 2);
  EXPECT_THAT(built.errors, HasSubstr("bad.obj"));
  EXPECT_THAT(built.output, HasSubstr("1 of 2 meshes written, 0 unchanged, 1 failed"));
  EXPECT_TRUE(fs::exists(folder / "levels" / "box.dae"));
  EXPECT_FALSE(fs::exists(folder / "levels" / "bad.dae"));
}

TEST_F(Levels, AGltfIsMadeAgainWhenAFileThatItNamesChanges) {
  const std::string outer = mesh("outer.gltf", gltfBox(R"("extras":{"from":"outer.bin"},)"));
  mesh("outer.bin", "first");
  EXPECT_THAT(build({outer, "--folder", "levels"}).output, HasSubstr("1 of 1 meshes written"));
  EXPECT_THAT(build({outer, "--folder", "levels"}).output, HasSubstr("1 unchanged"));
  mesh("outer.bin", "other");
  EXPECT_THAT(build({outer, "--folder", "levels"}).output, HasSubstr("1 of 1 meshes written"));
}

TEST_F(Levels, ExportsALevelForOtherPrograms) {
  const std::string table = fs::path(SCATTER_TEST_MODEL_DIR) / "table.dae";
  const Outcome urdf = scatter({"levels", "export", table, "-o", "table.urdf"});
  ASSERT_EQ(urdf.status, 0) << urdf.errors;
  EXPECT_THAT(urdf.output, HasSubstr("level 3 of table, 25 parts, 25 kg"));
  EXPECT_THAT(readText(folder / "table.urdf"), HasSubstr("<mass value=\"25\""));
  EXPECT_TRUE(fs::exists(folder / "table_meshes" / "visual.obj"));
  EXPECT_THAT(scatter({"levels", "export", table, "-o", "table.xml", "--level", "1"}).output,
              HasSubstr("1 parts"));
  // What is written as OBJ is a mesh again.
  ASSERT_EQ(scatter({"levels", "export", table, "-o", "parts.obj"}).status, 0);
  expectBuilt({"parts.obj", "-o", "again.dae", "--parts", "1,25"}, "again.dae");
  EXPECT_THAT(scatter({"levels", "export", table, "-o", "table.txt"}).errors, HasSubstr("tells no format"));
  const Outcome none = scatter({"levels", "export", table, "-o", "none.obj", "--level", "4"});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.errors, HasSubstr("levels 1 to 3, and none 4"));
}

TEST_F(Levels, CheckFindsAMovedVertexOfTheMesh) {
  ASSERT_EQ(build({mesh("corner.obj", corner()), "-o", "a.dae"}).status, 0);
  // 0.1 % of the diagonal of 8 by 8 by 8: out of the end of the first bar.
  std::string moved = corner();
  const std::size_t at = moved.find("v 8 1 1");
  ASSERT_NE(at, std::string::npos);
  moved.replace(at, 7, "v 8.01386 1 1");
  const Outcome checked = scatter({"levels", "check", "a.dae", "--mesh", mesh("moved.obj", moved)});
  EXPECT_EQ(checked.status, 1);
  EXPECT_THAT(checked.output, HasSubstr("OUTSIDE  mesh in level 3"));
  EXPECT_THAT(checked.output, HasSubstr("13.9 mm at (8.0138"));
  EXPECT_THAT(checked.errors, HasSubstr("a.dae"));
  EXPECT_EQ(scatter({"levels", "check", "a.dae", "--mesh", mesh("same.obj", corner())}).status, 0);
}

TEST_F(Levels, CheckFindsLevelsThatAreNotNested) {
  // Level 1 of a model that was sound, made smaller by hand.
  std::string text = readText(fs::path(SCATTER_TEST_MODEL_DIR) / "hunter.dae");
  const std::size_t level = text.find("<level index=\"1\">");
  const std::size_t extents = text.find("<half_extents>", level) + 14;
  ASSERT_NE(level, std::string::npos);
  text.replace(extents, text.find(' ', extents) - extents, "1");
  const Outcome checked = scatter({"levels", "check", mesh("broken.dae", text)});
  EXPECT_EQ(checked.status, 1) << checked.errors;
  EXPECT_THAT(checked.output, HasSubstr("OUTSIDE  level 2 in level 1"));
  EXPECT_THAT(checked.output, HasSubstr("inside   level 3 in level 2"));
}

TEST_F(Levels, TheProjectsModelsPass) {
  for (const auto& entry : fs::directory_iterator(SCATTER_TEST_MODEL_DIR)) {
    if (entry.path().extension() != ".dae") continue;
    const Outcome checked = scatter({"levels", "check", entry.path()});
    EXPECT_EQ(checked.status, 0) << checked.output << checked.errors;
  }
}

TEST_F(Levels, DrawsPictures) {
  ASSERT_EQ(build({mesh("corner.obj", corner()), "-o", "a.dae"}).status, 0);
  EXPECT_EQ(scatter({"levels", "show", "a.dae", "--picture", "a.png"}).status, 0);
  EXPECT_EQ(scatter({"levels", "show", "a.dae", "--picture", "a.svg"}).status, 0);
  EXPECT_EQ(readText(folder / "a.png").substr(1, 3), "PNG");
  EXPECT_THAT(readText(folder / "a.svg"), HasSubstr("level 1: 1 part"));
}

TEST_F(Levels, WrongUseIsRefusedInOneLine) {
  const std::string box = mesh("box.obj", objBox());
  expectRefused(scatter({"levels"}), "build, check, show or export");
  expectRefused(scatter({"levels", "bild"}), "did you mean \"build\"?");
  expectRefused(build({box}), "--output");
  expectRefused(build({box, "-o", "out.txt"}), ".dae");
  expectRefused(build({box, box, "-o", "out.dae"}), "--folder");
  expectRefused(build({box, box, "--folder", "."}), "would both become box.dae");
  expectRefused(build({box, "-o", "out.dae", "--folder", "."}), "--folder");
  expectRefused(build({box, "-o", "a.dae", "--gap", "1%", "--margin", "1"}), "hull margin of 1 m");
  expectRefused(build({box, "-o", "a.dae", "--parts", "8,x"}), "--parts");
  expectRefused(build({box, "-o", "a.dae", "--parts", "8,8"}), "same number");
  expectRefused(build({box, "-o", "a.dae", "--parts", "8,1", "--levels", "2"}), "--parts");
  expectRefused(build({box, "-o", "a.dae", "--gap", "5"}), "--gap");
  expectRefused(build({box, "-o", "a.dae", "--gap", "-1%"}), "--gap");
  expectRefused(build({box, "-o", "a.dae", "--levels", "0"}), "--levels");
  expectRefused(build({box, "-o", "a.dae", "--max-vertices", "3"}), "--max-vertices");
  expectRefused(build({box, "-o", "a.dae", "--unit", "ell"}), "--unit");
  expectRefused(build({box, "-o", "a.dae", "--up", "w"}), "--up");
  expectRefused(build({box, "-o", "a.dae", "--interior", "full"}), "--interior");
  expectRefused(build({box, "-o", "a.dae", "--symmetric", "maybe"}), "give on, auto or off");
  expectRefused(
      build({mesh("one.obj", "v 0 0 0\nv 1 2 0\nv 0 1 3\nf 1 2 3\n"), "-o", "a.dae", "--symmetric", "on"}),
      "not symmetric");
  expectRefused(build({box, "-o", "a.dae", "--mass", "0"}), "--mass");
  expectRefused(build({box, "-o", "missing/a.dae"}), "no folder missing");
}

TEST_F(Levels, BrokenFilesAreRefusedInOneLine) {
  expectRefused(build({"missing.obj", "-o", "a.dae"}), "No such file");
  expectRefused(build({mesh("empty.stl", ""), "-o", "a.dae"}), "is empty");
  expectRefused(build({mesh("points.obj", "v 0 0 0\n"), "-o", "a.dae"}), "points.obj");
  expectRefused(build({mesh("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "-o", "a.dae"}),
                "not finite");
  expectRefused(build({mesh("dot.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"), "-o", "a.dae"}), "dot.obj");
  expectRefused(scatter({"levels", "check", "missing.dae"}), "missing.dae");
  expectRefused(scatter({"levels", "check", mesh("no.dae", "<COLLADA/>")}), "no.dae");
  expectRefused(scatter({"levels", "show", mesh("no2.dae", daeBox())}), "no2.dae");
}

}  // namespace
}  // namespace scatter::test
