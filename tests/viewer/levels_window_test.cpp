#include <gmock/gmock.h>
#include <scatter/io/model_library.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "trials.h"
#include "viewer/levels_viewer.h"
#include "viewer/png_file.h"
#include "viewer/renderers.h"
#include "viewer/xvfb.h"

namespace scatter::viewer {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

class LevelsWindowTest : public testing::TestWithParam<std::string> {
 protected:
  LevelsWindowTest() {
    if (GetParam() != "null") server_.emplace();
    fs::create_directories(folder_);
  }
  ~LevelsWindowTest() override { fs::remove_all(folder_); }

  static ShownModel model(const std::string& name) {
    const std::shared_ptr<const Model> read = loadModel(name).value();
    return {name, read->levels, {read->mesh.vertices, read->mesh.triangles}};
  }

  static ShownModel bare(const std::string& name) { return {name, model(name).levels, {}}; }

  [[nodiscard]] Result<LevelsViewerReport> play(LevelsViewerDef def, const std::string& script) const {
    def.script = ViewScript::parse(script, "test").value();
    def.out = folder_ / "out";
    auto renderer = makeRenderer(GetParam(), {.size = {480, 360}});
    if (!renderer) return tl::unexpected(renderer.error());
    return runLevelsViewer(**renderer, def);
  }

  [[nodiscard]] std::string shot(int loop, const std::string& name) const {
    return std::to_string(loop) + " screenshot " + (folder_ / name).string() + "\n";
  }

  /// Where the mesh is yellow to red, as over large gaps: right of the parts, above the scale.
  [[nodiscard]] int warmPixels(const std::string& name) const {
    const Image image = test::readPng(folder_ / name);
    int count = 0;
    for (int y = 0; y < image.height * 7 / 8; ++y) {
      for (int x = image.width / 2; x < image.width; ++x) {
        const std::uint8_t* pixel = image.pixel(x, y);
        count += pixel[0] > 120 && pixel[0] > pixel[2] + 60 ? 1 : 0;
      }
    }
    return count;
  }

  std::optional<test::Xvfb> server_;
  fs::path folder_ = fs::temp_directory_path() / ("scatter-levels-window-" + std::to_string(getpid()));
};

TEST_P(LevelsWindowTest, ShowsWhereLevelsAreLoose) {
  LevelsViewerDef def{.models = {model("mug")}, .panels = false};
  const auto seen = play(def, "0 do turn\n1 key 1\n2 look 0 0.35 0 60 20 2.5\n" + shot(3, "coarse.png") +
                                  "4 key 3\n5 look 0 0.35 0 60 20 2.5\n" + shot(6, "fine.png") + "8 close\n");
  ASSERT_TRUE(seen.has_value()) << seen.error().message;
  EXPECT_EQ(seen->loops, 9U);
  if (GetParam() == "null") return;
  // The box around the mug is far from its handle; what the finest level leaves is nowhere red but on the
  // scale.
  EXPECT_GT(warmPixels("coarse.png"), 100);
}

TEST_P(LevelsWindowTest, GoesFromModelToModelAndDoesWithoutAMesh) {
  const LevelsViewerDef def{.models = {bare("crate"), bare("lamp")}};
  EXPECT_TRUE(
      play(def, "1 do next-model\n2 key 2\n3 do apart\n4 set one-scale on\n5 do previous-model\n7 close\n"));
}

TEST_P(LevelsWindowTest, RefusesWhatDoesNotExist) {
  const auto mistake = [&](LevelsViewerDef def, const std::string& script) {
    const auto seen = play(std::move(def), script);
    return seen ? "" : seen.error().message;
  };
  const LevelsViewerDef def{.models = {bare("mug")}, .loops = 3};
  EXPECT_THAT(mistake(def, "1 do level-9\n"), HasSubstr("no command is called \"level-9\""));
  EXPECT_THAT(mistake(def, "1 point mug\n"), HasSubstr("nothing can be pointed at"));
  EXPECT_THAT(mistake(def, "1 screenshot /dev/null/all.png\n"), HasSubstr("/dev/null"));
  LevelsViewerDef broken = def;
  broken.models.front().mesh = {{Vec3(0.0F)}, {{0, 1, 99'999'999}}};
  EXPECT_THAT(mistake(broken, ""), HasSubstr("mug: "));
}

/// Another renderer draws the same picture; the tests of renderers see to that.
INSTANTIATE_TEST_SUITE_P(Renderers, LevelsWindowTest,
                         testing::Values(test::kSanitized ? std::string("null") : rendererNames().front()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace scatter::viewer
