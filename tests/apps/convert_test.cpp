#include <gmock/gmock.h>
#include <scatter/io/collada.h>
#include <scatter/io/gltf.h>

#include <fstream>

#include "apps/program.h"
#include "io/gltf/comparison.h"
#include "io/gltf/text.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Convert : public ProgramTest {
 protected:
  void put(const char* name, const std::string& content) const {
    std::ofstream(folder / name, std::ios::binary) << content;
  }

  /// A scene with two bodies and a joint.
  [[nodiscard]] static std::string scene() {
    GltfText file;
    file.materials = R"({"name":"ice"})";
    file.joints = R"({"limits":[{"linearAxes":[0,1,2],"min":0,"max":0}],"drives":[{}]})";
    file.nodes = boxNode(R"({"mass":3})", R"("name":"a","translation":[0,2,0],"children":[2])") + "," +
                 boxNode("", R"("name":"b")") + "," +
                 physicsNode(R"("joint":{"connectedNode":1,"joint":0})", R"("name":"j")");
    file.roots = "0,1";
    return file.text();
  }

  /// Refused with one line that holds `part`; only the input is there.
  void expectOnlyInput(const Outcome& outcome, const std::string& part) const {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(linesOf(outcome.errors).size(), 1U) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr(part));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  }
};

TEST_F(Convert, SaysWhatWasLeftOutAndWhatWasWritten) {
  put("a.gltf", scene());
  const Outcome outcome = scatter({"convert", "a.gltf", "b.glb"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.output, "b.glb: 2 bodies, 2 models, 1 joint, 1 material, 0 fields\n");
  const auto lines = linesOf(outcome.errors);
  ASSERT_EQ(lines.size(), 2U) << outcome.errors;
  EXPECT_THAT(lines[0], testing::StartsWith("scatter: a.gltf: the file does not say what gravity is"));
  EXPECT_THAT(lines[1], HasSubstr("physicsJoints[0].drives: drives are not supported"));
  const auto before = readGltfDocument(folder / "a.gltf");
  const auto after = readGltfDocument(folder / "b.glb");
  ASSERT_TRUE(before && after);
  EXPECT_EQ(findDifference(*before, *after), "");
}

TEST_F(Convert, AModelGoesToGltfAndBack) {
  const std::string hunter = std::string(SCATTER_TEST_MODEL_DIR) + "/hunter.dae";
  ASSERT_EQ(scatter({"convert", hunter, "hunter.glb"}).status, 0);
  const Outcome back = scatter({"convert", "hunter.glb", "hunter.dae"});
  EXPECT_EQ(back.status, 0) << back.errors;
  EXPECT_EQ(back.errors, "");
  const auto first = readColladaDocument(hunter);
  const auto middle = readGltfDocument(folder / "hunter.glb");
  const auto last = readColladaDocument(folder / "hunter.dae");
  ASSERT_TRUE(first && middle && last);
  EXPECT_EQ(findDifference(*first, *middle), "");
  EXPECT_EQ(findDifference(*first, *last), "");
}

TEST_F(Convert, BadInputIsOneLine) {
  put("bad.glb", "glTF");
  expectOnlyInput(scatter({"convert", "bad.glb", "x.gltf"}), "scatter: bad.glb: is not a GLB file");
  expectOnlyInput(scatter({"convert", "bad.glb", "x.obj"}),
                  "x.obj\"; its name should end in .dae, .gltf or .glb");
  expectOnlyInput(scatter({"convert", "bad.obj", "x.glb"}), "bad.obj\"; its name should end in");
  expectOnlyInput(scatter({"convert", "none.glb", "x.gltf"}), "none.glb: No such file");
  expectOnlyInput(scatter({"convert", "bad.glb", "bad.glb"}), "would be written over itself");
  expectOnlyInput(scatter({"convert", "bad.glb"}), "TO is required");
  expectOnlyInput(scatter({"convert", "bad.glb", "x.glb", "more"}), "unexpected argument \"more\"");
}

TEST_F(Convert, AFolderThatIsNotThereIsOneLine) {
  GltfText file;
  file.nodes = boxNode("");
  put("a.gltf", file.text());
  const Outcome outcome = scatter({"convert", "a.gltf", "none/b.glb"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(linesOf(outcome.errors).back(), HasSubstr("none/b.glb"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

}  // namespace
}  // namespace scatter::test
