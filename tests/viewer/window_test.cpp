#include <gmock/gmock.h>
#include <scatter/io/file.h>
#include <scatter/recording/recording.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "trials.h"
#include "viewer/bullet_world.h"
#include "viewer/debug_views.h"
#include "viewer/png_file.h"
#include "viewer/renderers.h"
#include "viewer/replay.h"
#include "viewer/view_presets.h"
#include "viewer/viewer.h"
#include "viewer/x11_user.h"
#include "viewer/xvfb.h"

namespace scatter::viewer {
namespace {

namespace fs = std::filesystem;

using test::bulletWorld;
using test::kSanitized;
using test::readPng;
using testing::HasSubstr;

/// Pixels that differ by more than what rounding does.
int differentPixels(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return a.width * a.height + b.width * b.height;
  int count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    int most = 0;
    for (std::size_t c = i; c < i + 3; ++c) most = std::max(most, std::abs(int{a.rgb[c]} - int{b.rgb[c]}));
    count += most > 8 ? 1 : 0;
  }
  return count;
}

/// A window on an X server of its own, of 640 by 400 pixels, driven by scripts.
class WindowTest : public testing::TestWithParam<std::string> {
 protected:
  WindowTest() {
    if (GetParam() != "null") server_.emplace();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~WindowTest() override { fs::remove_all(folder_); }

  [[nodiscard]] Result<ViewerReport> play(ViewerDef def, const std::string& script) const {
    auto parsed = ViewScript::parse(script, "test");
    if (!parsed) return tl::unexpected(parsed.error());
    def.script = std::move(*parsed);
    def.out = folder_ / "out";
    WindowDef window;
    window.size = {640, 400};
    auto renderer = makeRenderer(GetParam(), window);
    if (!renderer) return tl::unexpected(renderer.error());
    return runViewer(**renderer, def);
  }

  [[nodiscard]] ViewerReport played(const std::string& scene, std::uint64_t loops,
                                    const std::string& script) const {
    ViewerDef def;
    def.worlds = {bulletWorld(scene)};
    def.loops = loops;
    def.panels = false;
    const auto report = play(def, script);
    EXPECT_TRUE(report.has_value()) << report.error().message;
    return report.value_or(ViewerReport{});
  }

  /// "LOOP screenshot FILE\n".
  [[nodiscard]] std::string shot(int loop, const std::string& name) const {
    return std::to_string(loop) + " screenshot " + (folder_ / name).string() + "\n";
  }
  [[nodiscard]] Image picture(const std::string& name) const { return readPng(folder_ / name); }

  /// Without a display there is nothing to be seen.
  [[nodiscard]] static bool shows() { return GetParam() != "null"; }

  std::optional<test::Xvfb> server_;
  fs::path folder_ = fs::temp_directory_path() / ("scatter-window-" + std::to_string(getpid()));
};

TEST_P(WindowTest, EverySceneOpens) {
  auto renderer = makeRenderer(GetParam(), {});
  ASSERT_TRUE(renderer.has_value()) << renderer.error().message;
  const auto& scenes = SceneRegistry::instance().all();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    // All of them run under sanitizers in other tests.
    if (test::kSanitized && i % 4 != 0) continue;
    const auto& scene = scenes[i];
    ViewerDef def;
    def.worlds = {bulletWorld(scene->name)};
    def.loops = 3;
    const auto report = runViewer(**renderer, def);
    ASSERT_TRUE(report.has_value()) << scene->name << ": " << report.error().message;
    EXPECT_EQ(report->frames.front(), 2U) << scene->name;
    if (shows()) {
      EXPECT_GT((*renderer)->statistics().triangles, 0U) << scene->name;
    }
  }
}

TEST_P(WindowTest, AClickInACurveStopsAndShowsThatFrame) {
  if (!shows()) GTEST_SKIP() << "nothing is drawn";
  ViewerDef def;
  def.worlds = {bulletWorld("duel")};
  def.loops = 60;
  const std::string open = "1 key F3\n30 move 512 70\n";
  const auto clicked = play(
      def, open + "31 down left\n32 up left\n" + shot(40, "then.png") + "41 key End\n" + shot(43, "now.png"));
  ASSERT_TRUE(clicked) << clicked.error().message;
  EXPECT_GE(clicked->frames.front(), 28U);
  EXPECT_LE(clicked->frames.front(), 33U);
  EXPECT_GT(differentPixels(picture("then.png"), picture("now.png")), 100);
}

TEST_P(WindowTest, CostsThePhysicsNothing) {
  RunOptions alone = bulletWorld("duel");
  alone.frames = 249;
  const auto run = runScene(alone);
  ASSERT_TRUE(run.has_value());
  std::string everything;
  for (const DebugViewInfo& view : debugViews()) {
    everything += "1 set " + std::string(view.name) + " on\n";
  }
  const ViewerReport report = played("duel", 250, everything);
  ASSERT_EQ(report.frames.front(), 249U);
  EXPECT_EQ(report.stateHashes.front(), run->summary.stateHash);
}

TEST_P(WindowTest, EveryViewShowsSomethingElse) {
  if (!shows()) GTEST_SKIP() << "needs pictures";
  // Resting stacks: contacts, islands, pairs; pushed a little, so that there are velocities; a request that
  // waits.
  std::string script =
      "1 look 0 2 0 30 20 14\n2 set marks off\n39 do pause\n40 do everything\n" + shot(41, "plain.png");
  int loop = 42;
  const std::vector<std::string> views{"bounds",   "shapes",  "levels", "pair-levels",
                                       "contacts", "islands", "pairs"};
  for (const std::string& view : views) {
    script += std::to_string(loop) + " set " + view + " on\n" + shot(loop + 1, view + ".png") +
              std::to_string(loop + 2) + " set " + view + " off\n";
    loop += 3;
  }
  script += shot(loop, "after.png");
  (void)played("quiet_hybrids", static_cast<std::uint64_t>(loop) + 1, script);
  const Image plain = picture("plain.png");
  ASSERT_EQ(plain.width, 640);
  for (const std::string& view : views) {
    EXPECT_GT(differentPixels(plain, picture(view + ".png")), 100) << view;
  }
  EXPECT_EQ(differentPixels(plain, picture("after.png")), 0);
}

TEST_P(WindowTest, PausesStepsAndGoesOn) {
  EXPECT_EQ(played("duel", 100, "20 key Space\n").frames.front(), 20U);
  EXPECT_EQ(played("duel", 100, "20 key Space\n30 key .\n40 key .\n50 do step\n").frames.front(), 23U);
  EXPECT_EQ(played("duel", 100, "20 key Space\n60 key Space\n").frames.front(), 59U);
}

TEST_P(WindowTest, RateOfTimeIsThatOfThePhysics) {
  const ViewerReport report = played("duel", 101, "1 do faster\n1 do faster\n");
  EXPECT_NEAR(static_cast<double>(report.frames.front()), 200.0, 4.0);
}

TEST_P(WindowTest, RestartBeginsAgain) {
  EXPECT_EQ(played("duel", 100, "60 key R\n").stateHashes.front(),
            played("duel", 41, "").stateHashes.front());
}

TEST_P(WindowTest, AnotherSceneOpensWithoutLeaving) {
  const ViewerReport alone = played("duel", 41, "");
  EXPECT_EQ(played("convergence", 100, "60 open duel\n").stateHashes, alone.stateHashes);
  if (shows()) return;
  // Back again, and what is picked and shown of the first one is gone.
  const ViewerReport twice = played("duel", 100,
                                    "1 look 0 0 0 30 10 30\n10 point hunter\n11 down left\n12 up left\n30 "
                                    "open convergence\n60 open duel\n");
  EXPECT_EQ(twice.stateHashes, alone.stateHashes);
  EXPECT_EQ(twice.objects, alone.objects);
  EXPECT_NE(played("duel", 60, "20 key N\n").objects, alone.objects);
  EXPECT_EQ(played("duel", 60, "20 key N\n25 do previous-scene\n").objects, alone.objects);
}

TEST_P(WindowTest, TheTitleIsThatOfThePresentScene) {
  if (!shows()) GTEST_SKIP() << "needs a window";
  auto renderer = makeRenderer(GetParam(), {.size = {640, 400}});
  ViewerDef def;
  def.worlds = {bulletWorld("duel")};
  def.loops = 8;
  def.script = ViewScript::parse("4 open convergence\n", "test").value();
  ASSERT_TRUE(runViewer(**renderer, def));
  EXPECT_EQ(test::X11User().title(), "Scatter: convergence");
}

TEST_P(WindowTest, PresetsShowTheirViewsAlone) {
  std::string script = "1 look 0 2 0 30 20 14\n40 do pause\n";
  int loop = 41;
  for (const ViewPreset& preset : viewPresets()) {
    const std::string name(preset.name);
    script += std::to_string(loop) + " do " + name + "\n" + shot(loop + 1, name + ".png");
    loop += 2;
  }
  script += std::to_string(loop) + " key F5\n" + shot(loop + 1, "plain.png");
  (void)played("quiet_stacks", static_cast<std::uint64_t>(loop) + 2, script);
  if (!shows()) return;
  const Image plain = picture("show-plain.png");
  EXPECT_EQ(differentPixels(plain, picture("plain.png")), 0);
  EXPECT_GT(differentPixels(plain, picture("show-contacts.png")), 100);
  EXPECT_GT(differentPixels(plain, picture("show-cost.png")), 1000);
  EXPECT_GT(differentPixels(picture("show-contacts.png"), picture("show-cost.png")), 1000);
}

TEST_P(WindowTest, ShadowsFallWhereTheyAreWanted) {
  if (!shows()) GTEST_SKIP() << "needs pictures";
  std::string script = "1 look 0 1 0 30 30 12\n2 do pause\n" + shot(3, "first.png");
  int loop = 4;
  for (const std::string where : {"off", "ground", "all"}) {
    script += std::to_string(loop) + " set shadows-" + where + " on\n" + shot(loop + 1, where + ".png");
    loop += 2;
  }
  (void)played("tower", static_cast<std::uint64_t>(loop) + 1, script);
  EXPECT_GT(differentPixels(picture("off.png"), picture("ground.png")), 200);
  EXPECT_GT(differentPixels(picture("ground.png"), picture("all.png")), 200);
  EXPECT_EQ(differentPixels(picture("first.png"), picture("ground.png")), 0) << "where a processor draws";
}

TEST_P(WindowTest, TheCameraFollowsUntilItIsTakenAndTheSameWayEveryTime) {
  if (!shows()) GTEST_SKIP() << "needs pictures";
  const std::string pause = "60 do pause\n";
  (void)played("duel", 90, pause + shot(89, "one.png"));
  (void)played("duel", 90, pause + shot(89, "again.png"));
  (void)played("duel", 90, "1 wheel 0\n" + pause + shot(89, "taken.png"));
  (void)played("duel", 90, "1 wheel 0\n58 key V\n" + pause + shot(89, "given.png"));
  // The label says what a step cost, which is never the same.
  EXPECT_LT(differentPixels(picture("one.png"), picture("again.png")), 100);
  EXPECT_GT(differentPixels(picture("one.png"), picture("taken.png")), 500);
  EXPECT_LT(differentPixels(picture("one.png"), picture("given.png")), 500);
}

TEST_P(WindowTest, RoomsAreSeenFromOutside) {
  if (!shows()) GTEST_SKIP() << "needs pictures";
  // What the scene pours, and the same picture without it.
  std::string script = "28 do pause\n29 do orbit\n" + shot(30, "poured.png");
  int loop = 31;
  for (const std::string name : {"lamp-1", "mug-1", "mug-2", "mug-3"}) {
    script += std::to_string(loop) + " point " + name + "\n" + std::to_string(loop + 1) + " down left\n" +
              std::to_string(loop + 2) + " up left\n" + std::to_string(loop + 3) + " key Del\n";
    loop += 4;
  }
  script += std::to_string(loop) + " do step\n" + shot(loop + 1, "gone.png");
  const ViewerReport report = played("mugs", static_cast<std::uint64_t>(loop) + 2, script);
  ASSERT_FALSE(report.objects.empty());
  EXPECT_EQ(report.objects.front(), 5U) << "hands reach behind the walls";
  EXPECT_GT(differentPixels(picture("poured.png"), picture("gone.png")), 2000);
}

TEST_P(WindowTest, ThePastLooksAsItDid) {
  if (!shows()) GTEST_SKIP() << "needs pictures";
  const std::string script = "1 look 0 0 0 30 10 30\n" + shot(100, "then.png") + shot(250, "later.png") +
                             "251 do back\n" +
                             [] {
                               std::string steps;
                               for (int i = 0; i < 149; ++i) steps += "252 do back\n";
                               return steps;
                             }() +
                             shot(253, "past.png") + "254 do now\n" + shot(255, "now.png");
  const ViewerReport report = played("duel", 256, script);
  EXPECT_GT(differentPixels(picture("then.png"), picture("later.png")), 200);
  EXPECT_EQ(differentPixels(picture("then.png"), picture("past.png")), 0);
  EXPECT_EQ(differentPixels(picture("later.png"), picture("now.png")), 0);
  EXPECT_EQ(report.frames.front(), 250U);
}

TEST_P(WindowTest, DraggingChangesThePath) {
  const std::string drag = "1 look 0 0 0 30 10 30\n10 point hunter\n11 down left\n";
  const ViewerReport alone = played("duel", 100, "1 look 0 0 0 30 10 30\n");
  const ViewerReport dragged = played("duel", 100, drag + "12 move 320 60\n60 up left\n");
  EXPECT_EQ(dragged.frames, alone.frames);
  EXPECT_NE(dragged.stateHashes, alone.stateHashes);
  EXPECT_EQ(dragged.stateHashes, played("duel", 100, drag + "12 move 320 60\n60 up left\n").stateHashes);
}

TEST_P(WindowTest, WhatHandsDidIsDoneAgainByAScript) {
  if (shows()) GTEST_SKIP() << "is the same with pictures";
  const ViewerReport dragged = played(
      "duel", 100,
      "1 look 0 0 0 30 10 30\n10 point hunter\n11 down left\n12 move 320 60\n60 up left\n70 do write\n");
  const std::string hands = readFile(folder_ / "out" / "hands.txt").value_or("");
  EXPECT_THAT(hands, HasSubstr("drag-to"));
  EXPECT_EQ(played("duel", 100, hands).stateHashes, dragged.stateHashes);
  // Also without a window, and again where the scene is started again.
  RunOptions alone = bulletWorld("duel");
  alone.frames = 99;
  alone.hands = HandScript::parse(hands, "hands.txt").value();
  const auto run = runScene(alone);
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_EQ(run->summary.stateHash, dragged.stateHashes.front());
  EXPECT_EQ(played("duel", 139, hands + "40 key R\n").stateHashes, dragged.stateHashes);
}

TEST_P(WindowTest, HandsSpawnThrowFreezeAndDelete) {
  const std::string pick = "1 look 0 0 0 30 10 30\n10 point hunter\n11 down left\n12 up left\n";
  const ViewerReport picked = played("duel", 40, pick);
  EXPECT_EQ(picked.objects.front(), 2U);
  EXPECT_EQ(
      played("duel", 40, pick + "20 key T\n21 move 100 100\n22 down left\n23 up left\n").objects.front(), 3U);
  EXPECT_EQ(
      played("duel", 40, pick + "20 key Ins\n21 move 100 100\n22 down left\n23 up left\n").objects.front(),
      3U);
  EXPECT_EQ(played("duel", 40, pick + "20 key Del\n").objects.front(), 1U);
  EXPECT_NE(played("duel", 40, pick + "20 key Z\n").stateHashes, picked.stateHashes);
}

TEST_P(WindowTest, GatheringPullsEverything) {
  const std::string gather = "5 key H\n6 move 320 200\n7 down left\n";
  EXPECT_NE(played("duel", 60, gather + "50 up left\n").stateHashes, played("duel", 60, "").stateHashes);
}

TEST_P(WindowTest, LevelsAreAskedForAndTakenBack) {
  ViewerDef def;
  def.worlds = {bulletWorld("quiet_hybrids")};
  def.worlds.front().physics.switching.credit = false;  // what rests cannot go coarser, and the request waits
  def.loops = 40;
  const auto expectCounts = [&](const std::string& script, const auto& requested, const auto& retracted) {
    const auto report = play(def, script);
    ASSERT_TRUE(report.has_value()) << report.error().message;
    const auto& counts = report->levelEvents.front();
    EXPECT_THAT(counts[static_cast<std::size_t>(LevelEventKind::kRequested)], requested);
    EXPECT_THAT(counts[static_cast<std::size_t>(LevelEventKind::kRetracted)], retracted);
  };
  expectCounts("", testing::Eq(0U), testing::Eq(0U));
  expectCounts("20 key L\n21 key PgDn\n", testing::Gt(1U), testing::Eq(0U));
  expectCounts("20 key L\n21 key PgDn\n30 key U\n", testing::Gt(1U), testing::Gt(1U));
}

TEST_P(WindowTest, TwoWorldsHaveOneClock) {
  ViewerDef def;
  def.worlds = {bulletWorld("duel", WorldKind::kStandard), bulletWorld("duel")};
  def.loops = 50;
  const auto report = play(def, "30 key Space\n" + shot(49, "both.png"));
  ASSERT_TRUE(report.has_value()) << report.error().message;
  EXPECT_THAT(report->frames, testing::ElementsAre(30U, 30U));
}

TEST_P(WindowTest, ResizesAndCloses) {
  const ViewerReport report =
      played("duel", 200, "5 resize 900 500\n" + shot(60, "large.png") + "80 key Esc\n");
  EXPECT_LT(report.loops, 90U);
  if (shows()) {
    EXPECT_EQ(picture("large.png").width, 900);
    EXPECT_EQ(picture("large.png").height, 500);
  }
  EXPECT_LT(played("duel", 200, "30 close\n").loops, 40U);
}

TEST_P(WindowTest, PanelsHideAndHelpNamesEveryCommand) {
  if (!shows()) GTEST_SKIP() << "needs pictures";
  (void)played("duel", 40,
               "1 do pause\n" + shot(10, "without.png") + "11 key Tab\n" + shot(15, "with.png") +
                   "16 key Tab\n17 key F1\n" + shot(20, "help.png"));
  EXPECT_GT(differentPixels(picture("without.png"), picture("with.png")), 5000);
  EXPECT_GT(differentPixels(picture("without.png"), picture("help.png")), 5000);
}

TEST_P(WindowTest, PanelsFoldByClickAndByKey) {
  if (!shows()) GTEST_SKIP() << "needs pictures";
  // So narrow a window begins with folded panels.
  (void)played("duel", 40,
               "1 do pause\n2 do orbit\n3 key Tab\n" + shot(8, "folded.png") +
                   "9 move 10 9\n10 down left\n12 up left\n" + shot(16, "open.png") +
                   "17 key F2\n18 move 320 200\n" + shot(22, "again.png"));
  EXPECT_GT(differentPixels(picture("folded.png"), picture("open.png")), 5000);
  EXPECT_LT(differentPixels(picture("folded.png"), picture("again.png")), 3000);
}

TEST_P(WindowTest, RecordsPicturesAndWritesTheRun) {
  (void)played("duel", 40, "10 key F11\n15 key F11\n20 do write\n");
  EXPECT_TRUE(fs::exists(folder_ / "out" / "frames-1" / "000000.png"));
  EXPECT_TRUE(fs::exists(folder_ / "out" / "frames-1" / "000004.png"));
  EXPECT_TRUE(fs::exists(folder_ / "out" / "frames.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "out" / "summary.json"));
}

TEST_P(WindowTest, StoresTheRunFromItsFirstFrameOnAndReplaysItBothWays) {
  (void)played("duel", 60, "20 key F9\n40 key F9\n50 key F9\n");
  const auto first = Recording::open(folder_ / "out" / "run-1.rec");
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ((*first)->first(), 0U);
  EXPECT_GE((*first)->last(), 39U);
  EXPECT_LE((*first)->last(), 42U);
  EXPECT_EQ((*first)->damage(), "");
  // What still runs when the window closes is ended then.
  const auto second = Recording::open(folder_ / "out" / "run-2.rec");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_GE((*second)->last(), 58U);
  EXPECT_EQ((*second)->damage(), "");

  const auto replay = [&](const std::string& script, const glm::ivec2& size = {640, 400}) {
    ReplayDef def{.recording = folder_ / "out" / "run-2.rec", .out = folder_ / "out", .loops = 40};
    def.script = ViewScript::parse(script, "script").value();
    auto renderer = makeRenderer(GetParam(), {.size = size});
    EXPECT_TRUE(renderer) << renderer.error().message;
    return runReplay(**renderer, def);
  };
  // The help lies over everything, as in the window of a scene.
  const auto helped =
      replay("1 set panels off\n" + shot(3, "replay.png") + "4 key F1\n" + shot(6, "replay_help.png"));
  ASSERT_TRUE(helped) << helped.error().message;
  if (shows()) {
    EXPECT_GT(differentPixels(picture("replay.png"), picture("replay_help.png")), 5000);
  }
  EXPECT_THAT(replay("0 do pause\n").error().message,
              HasSubstr("no command is called \"pause\"; known: play, "));
  EXPECT_EQ(replay("0 gather 0 0 0\n").error().message, "nothing in a recording can be moved by hand");
  const auto forwards = replay("20 key Space\n");
  ASSERT_TRUE(forwards) << forwards.error().message;
  EXPECT_GE(forwards->frame, 18U);
  EXPECT_LE(forwards->frame, 22U);
  const auto backwards = replay("0 key End\n1 key R\n2 key Space\n20 key Space\n25 key ,\n");
  ASSERT_TRUE(backwards) << backwards.error().message;
  EXPECT_LT(backwards->frame, (*second)->last() - 15);
  EXPECT_GT(backwards->frame, (*second)->last() - 25);

  // A click picks what is under the pointer, a drag turns, and beside all bodies none is picked.
  const std::string click = "2 point hunter\n3 down left\n4 up left\n";
  EXPECT_EQ(replay("0 do play\n" + click)->picked, "hunter");
  EXPECT_EQ(replay("0 do play\n" + click + "5 down left\n6 move 500 300\n7 up left\n")->picked, "hunter");
  EXPECT_EQ(replay("0 do play\n" + click + "5 move 2 300\n6 down left\n7 up left\n")->picked, "");
  EXPECT_EQ(replay("0 do play\n" + click + "5 do let-go\n")->picked, "");
  EXPECT_EQ(replay("2 point nobody\n").error().message,
            "\"nobody\" is no body of this frame, or behind the camera");
  if (!shows()) return;
  // In the middle of the curve of the physics' time.
  const auto sought = replay("0 do play\n2 move 1147 100\n3 down left\n4 up left\n", {1280, 720});
  ASSERT_TRUE(sought) << sought.error().message;
  EXPECT_NEAR(static_cast<double>(sought->frame), 0.5 * static_cast<double>((*second)->last()), 2.0);
}

TEST_P(WindowTest, RefusesWhatDoesNotExist) {
  ViewerDef def;
  def.worlds = {bulletWorld("duel")};
  def.loops = 10;
  const auto mistake = [&](const std::string& script) {
    const auto report = play(def, script);
    return report ? "" : report.error().message;
  };
  EXPECT_THAT(mistake("1 do dance\n"), HasSubstr("no command is called \"dance\"; known: pause, step, "));
  EXPECT_THAT(mistake("1 point nobody\n"), HasSubstr("\"nobody\" is no object"));
  EXPECT_THAT(mistake("1 set step on\n"), HasSubstr("is no switch"));
  EXPECT_THAT(mistake("1 open nowhere\n"), HasSubstr("nowhere"));
  EXPECT_THAT(mistake("1 drag 99 0 0 0\n"), HasSubstr("frame 1: "));
  EXPECT_THAT(mistake("1 screenshot /dev/null/all.png\n"), HasSubstr("/dev/null"));
  def.views = {"xray"};
  EXPECT_THAT(mistake(""), HasSubstr("no view is called \"xray\"; known: bounds, "));
}

/// Under sanitizers without a picture, which most of the time would go into: what is drawn is in the tests of
/// renderers.
std::vector<std::string> testedRenderers() {
  if (kSanitized) return {"null"};
  return rendererNames();
}

INSTANTIATE_TEST_SUITE_P(Renderers, WindowTest, testing::ValuesIn(testedRenderers()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace scatter::viewer
