#include <gtest/gtest.h>
#include <scatter/io/file.h>
#include <scatter/lab/run.h>
#include <scatter/recording/export.h>
#include <scatter/recording/recording.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "trials.h"
#include "viewer/bullet_world.h"
#include "viewer/renderers.h"
#include "viewer/replay.h"
#include "viewer/viewer.h"

namespace scatter::viewer {
namespace {

namespace fs = std::filesystem;

using test::bulletWorld;

constexpr int kWidth = 640;
constexpr int kHeight = 400;

/// Scenes of few bodies: with levels, that rest, that are thrown, and that break.
constexpr std::array kScenes{"duel", "quiet_hybrids", "convergence", "collapse", "tower"};

// Commands as the help panel has them, but those that close the window.
constexpr std::array kCommands{"pause",       "step",    "back",  "first",   "now",    "slower", "faster",
                               "normal-rate", "restart", "frame", "orbit",   "follow", "grab",   "push",
                               "throw",       "gather",  "spawn", "delete",  "freeze", "object", "group",
                               "everything",  "coarser", "finer", "retract", "record"};
constexpr std::array kSights{"action",         "fly",         "screenshot", "film", "shadows-all",
                             "shadows-ground", "shadows-off", "show-cost",  "help"};
constexpr std::array kPanels{"panels", "lab-panel", "numbers-panel", "time-panel", "film"};

constexpr std::array kReplayed{"play",        "play",       "backwards", "step",   "back",   "forth-far",
                               "back-far",    "first",      "last",      "slower", "faster", "action",
                               "orbit",       "frame",      "follow",    "let-go", "levels", "shapes",
                               "contacts",    "credit",     "sleeping",  "marks",  "panels", "numbers-panel",
                               "shadows-all", "screenshot", "film",      "help"};

/// What is done at random: with hands alone; with panels, too, which change worlds, and other scenes; or to a
/// recording.
enum class Use { kHands, kEverything, kReplay };

/// What somebody may do at a window who does not know what anything is for.
class RandomScript {
 public:
  RandomScript(std::uint64_t seed, Use use) : random_(seed), use_(use) {
    const int lines = upTo(20, 150);
    for (int i = 0; i < lines; ++i) {
      loop_ += static_cast<std::uint64_t>(upTo(0, 3));
      text_ << loop_ << ' ' << action() << '\n';
    }
    // So that hands have done something at the end, wherever the pointer went.
    if (use == Use::kHands)
      text_ << loop_ << " do everything\n" << loop_ << " do retract\n" << loop_ << " do coarser\n";
    // There is no frame to write of a scene that has just been started, and hands show in the step after
    // them.
    if (use != Use::kReplay) text_ << loop_ + 1 << " do now\n" << loop_ + 1 << " do step\n";
    if (use == Use::kHands) text_ << loop_ + 3 << " do write\n";
  }

  [[nodiscard]] std::string text() const { return text_.str(); }
  [[nodiscard]] std::uint64_t loops() const { return loop_ + 5; }

 private:
  [[nodiscard]] int upTo(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random_);
  }

  template <std::size_t N>
  [[nodiscard]] std::string oneOf(const std::array<const char*, N>& names) {
    return names[static_cast<std::size_t>(upTo(0, static_cast<int>(N) - 1))];
  }

  [[nodiscard]] std::string pointer() {
    // Bodies are in the middle more often than not.
    const auto within = [this](int length) {
      return std::to_string((upTo(0, length) + upTo(0, length)) / 2);
    };
    return "move " + within(kWidth) + " " + within(kHeight);
  }

  [[nodiscard]] std::string action() {
    const int kind = upTo(0, 99);
    if (kind < 30) return pointer();
    if (kind < 45) return "down " + oneOf(std::array{"left", "left", "right", "middle"});
    if (kind < 60) return "up " + oneOf(std::array{"left", "left", "right", "middle"});
    if (kind < 85) return "do " + (use_ == Use::kReplay ? oneOf(kReplayed) : oneOf(kCommands));
    if (kind < 89) return "wheel " + std::to_string(upTo(-3, 3));
    if (kind < 91)
      return "look 0 1 0 " + std::to_string(upTo(-180, 180)) + " " + std::to_string(upTo(-80, 80)) + " 15";
    if (kind < 92) return "resize " + std::to_string(upTo(1, 1500)) + " " + std::to_string(upTo(1, 900));
    if (use_ == Use::kReplay) return "do " + oneOf(kReplayed);
    const bool uses = use_ == Use::kEverything;
    if (kind < 93 && uses) return "open " + oneOf(kScenes);
    return "do " + (kind < 97 && uses ? oneOf(kPanels) : oneOf(kSights));
  }

  std::mt19937_64 random_;
  Use use_;
  std::uint64_t loop_ = 0;
  std::ostringstream text_;
};

/// A window without a picture. SCATTER_RANDOM_SCRIPTS and SCATTER_RANDOM_SCRIPT are how many, and the first.
class RandomWindow : public testing::Test {
 protected:
  RandomWindow() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~RandomWindow() override { fs::remove_all(folder_); }

  [[nodiscard]] static std::vector<std::uint64_t> seeds(int usual) {
    return test::seedsOr("SCATTER_RANDOM_SCRIPTS", "SCATTER_RANDOM_SCRIPT", usual);
  }

  [[nodiscard]] ViewerReport play(const ViewerDef& def) const {
    WindowDef window;
    window.size = {kWidth, kHeight};
    auto renderer = makeRenderer("null", window);
    EXPECT_TRUE(renderer) << renderer.error().message;
    const auto report = runViewer(**renderer, def);
    EXPECT_TRUE(report) << report.error().message;
    return report.value_or(ViewerReport{});
  }

  [[nodiscard]] ViewerDef defOf(std::vector<RunOptions> worlds, const RandomScript& script) const {
    auto parsed = ViewScript::parse(script.text(), "script");
    EXPECT_TRUE(parsed) << parsed.error().message;
    ViewerDef def;
    def.worlds = std::move(worlds);
    def.script = parsed.value_or(ViewScript{});
    def.loops = script.loops();
    def.panels = false;
    def.out = folder_;
    return def;
  }

  /// What was stored can be read, and exported.
  void expectWholeFiles() const {
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      EXPECT_NE(entry.path().extension(), ".part") << entry.path();
      if (entry.path().extension() != ".rec") continue;
      const auto recording = Recording::open(entry.path());
      ASSERT_TRUE(recording) << recording.error().message;
      EXPECT_EQ((*recording)->damage(), "") << entry.path();
      const ExportRange all{.first = (*recording)->first(), .last = (*recording)->last()};
      const auto animation = writeGltfAnimation(**recording, all, folder_ / "run.glb");
      EXPECT_TRUE(animation) << animation.error().message;
      const auto messages = writeMcap(**recording, all, folder_ / "run.mcap");
      EXPECT_TRUE(messages) << messages.error().message;
    }
  }

  fs::path folder_ = fs::temp_directory_path() / ("scatter-random-window-" + std::to_string(getpid()));
};

void expectSame(const ViewerReport& a, const ViewerReport& b) {
  EXPECT_EQ(a.loops, b.loops);
  EXPECT_EQ(a.frames, b.frames);
  EXPECT_EQ(a.stateHashes, b.stateHashes);
  EXPECT_EQ(a.objects, b.objects);
  EXPECT_EQ(a.levelEvents, b.levelEvents);
  EXPECT_EQ(a.historyFrames, b.historyFrames);
}

TEST_F(RandomWindow, DoesTheSameForTheSameScript) {
  for (const std::uint64_t seed : seeds(4)) {
    SCOPED_TRACE("script " + std::to_string(seed));
    const RandomScript script(seed, Use::kEverything);
    const char* scene = kScenes[seed % kScenes.size()];
    std::vector<RunOptions> worlds{bulletWorld(scene, WorldKind::kHybrid)};
    if (seed % 3 == 0) worlds.insert(worlds.begin(), bulletWorld(scene, WorldKind::kStandard));
    const ViewerDef def = defOf(std::move(worlds), script);
    const ViewerReport report = play(def);
    expectWholeFiles();
    expectSame(report, play(def));
    if (HasFailure()) FAIL() << script.text();
  }
}

TEST_F(RandomWindow, WritesWhatHandsDidForRunsWithoutOne) {
  std::size_t actions = 0;
  for (const std::uint64_t seed : seeds(4)) {
    SCOPED_TRACE("script " + std::to_string(seed));
    const RandomScript script(seed, Use::kHands);
    RunOptions alone = bulletWorld(kScenes[seed % kScenes.size()], WorldKind::kHybrid);
    const ViewerReport report = play(defOf({alone}, script));
    const auto hands = readFile(folder_ / "hands.txt");
    alone.frames = static_cast<int>(report.frames.front());
    alone.hands = HandScript::parse(hands.value_or(""), "hands.txt").value_or(HandScript{});
    const auto run = runScene(alone);
    ASSERT_TRUE(run) << run.error().message;
    EXPECT_EQ(run->summary.stateHash, report.stateHashes.front());
    if (HasFailure()) FAIL() << script.text() << "hands:\n" << hands.value_or("");
    fs::remove_all(folder_);
    actions += alone.hands.actions().size();
  }
  EXPECT_GT(actions, 0U);
}

TEST_F(RandomWindow, ReplaysTheSameForTheSameScript) {
  ViewerDef recorded;
  recorded.worlds = {bulletWorld("collapse", WorldKind::kHybrid)};
  recorded.script = ViewScript::parse("1 do record\n", "script").value();
  recorded.loops = 200;
  recorded.out = folder_;
  (void)play(recorded);
  for (const std::uint64_t seed : seeds(8)) {
    SCOPED_TRACE("script " + std::to_string(seed));
    const RandomScript script(seed, Use::kReplay);
    const auto replay = [&] {
      ReplayDef def{.recording = folder_ / "run-1.rec", .out = folder_, .loops = script.loops()};
      def.script = ViewScript::parse(script.text(), "script").value();
      const auto report = runReplay(*makeRenderer("null", {}).value(), def);
      EXPECT_TRUE(report) << report.error().message << "\n" << script.text();
      return report.value_or(ReplayReport{});
    };
    const ReplayReport first = replay();
    const ReplayReport second = replay();
    EXPECT_EQ(first.frame, second.frame);
    EXPECT_EQ(first.picked, second.picked);
    EXPECT_EQ(first.loops, second.loops);
    EXPECT_EQ(first.note, "");
  }
}

}  // namespace
}  // namespace scatter::viewer
