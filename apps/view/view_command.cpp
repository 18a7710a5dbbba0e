#include <scatter/io/file.h>
#include <scatter/recording/recording.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "level_file.h"
#include "messages.h"
#include "run_arguments.h"
#include "view_summary.h"
#include "viewer/levels_viewer.h"
#include "viewer/renderers.h"
#include "viewer/replay.h"
#include "viewer/viewer.h"

namespace scatter::app {

namespace {

/// Of each pixel, where a graphics card draws.
constexpr int kSamples = 4;
constexpr std::array<const char*, 3> kShowChoices{"automatic", "scene", "levels"};

struct Arguments {
  RunArguments run;
  std::string show = kShowChoices.front();
  std::vector<std::string> worlds{worldChoices().front().name};
  std::string renderer = viewer::rendererNames().front();
  std::string size = "1280x720";
  std::optional<int> samples;
  std::uint64_t loops = 0;
  std::optional<std::string> script;
  std::optional<std::string> screenshot;
  std::vector<std::string> views{"marks"};
  std::string out = "out/view";
  bool noPanels = false;
};

Result<glm::ivec2> parseSize(const std::string& text) {
  glm::ivec2 size(0);
  char end = 0;
  const bool numbers = std::sscanf(text.c_str(), "%dx%d%c", &size.x, &size.y, &end) == 2;
  constexpr int kLeast = 320;
  constexpr int kMost = 8192;
  if (!numbers || size.x < kLeast || size.y < kLeast / 2 || size.x > kMost || size.y > kMost) {
    return fail("--size " + text + ": write WIDTHxHEIGHT in pixels, 320x160 to 8192x8192, such as 1280x720");
  }
  return size;
}

Result<std::optional<viewer::ViewScript>> readScript(const Arguments& arguments) {
  viewer::ViewScript script;
  if (arguments.script) {
    const auto text = readFile(*arguments.script);
    if (!text) return tl::unexpected(text.error());
    auto parsed = viewer::ViewScript::parse(*text, *arguments.script);
    if (!parsed) return tl::unexpected(parsed.error());
    script = std::move(*parsed);
  }
  if (arguments.screenshot && arguments.loops == 0) {
    return fail("--screenshot is taken in the last loop; say which with --loops N");
  }
  if (arguments.screenshot) script.add({arguments.loops - 1, viewer::TakeScreenshot{*arguments.screenshot}});
  if (script.lines().empty() && script.hands().empty()) return std::optional<viewer::ViewScript>();
  return std::optional(std::move(script));
}

Result<viewer::ViewerDef> makeDef(const Arguments& arguments) {
  viewer::ViewerDef def;
  if (arguments.worlds.size() > 2) return fail("--worlds: one world, or two side by side");
  auto worlds = makeRuns(arguments.run, arguments.worlds);
  if (!worlds) return tl::unexpected(worlds.error());
  def.worlds = std::move(*worlds);
  auto script = readScript(arguments);
  if (!script) return tl::unexpected(script.error());
  def.script = std::move(*script);
  def.out = arguments.out;
  def.loops = arguments.loops;
  def.views = arguments.views;
  def.panels = !arguments.noPanels;
  return def;
}

Result<std::unique_ptr<viewer::Renderer>> openWindow(const Arguments& arguments) {
  const auto size = parseSize(arguments.size);
  if (!size) return tl::unexpected(size.error());
  viewer::WindowDef window;
  window.size = *size;
  window.samples = arguments.samples.value_or(kSamples);
  auto renderer = viewer::makeRenderer(arguments.renderer, window);
  if (!renderer || arguments.samples || !(*renderer)->isSoftware()) return renderer;
  // There may be one renderer at a time.
  renderer->reset();
  window.samples = 0;
  return viewer::makeRenderer(arguments.renderer, window);
}

ExitStatus replay(const Arguments& arguments) {
  auto script = readScript(arguments);
  if (!script) return refuse(script.error());
  const viewer::ReplayDef def{.recording = arguments.run.scene,
                              .out = arguments.out,
                              .loops = arguments.loops,
                              .script = std::move(*script),
                              .views = arguments.views,
                              .panels = !arguments.noPanels};
  // Before a window opens for nothing.
  if (const auto readable = Recording::open(def.recording); !readable) return refuse(readable.error());
  const auto renderer = openWindow(arguments);
  if (!renderer) return refuse(renderer.error());
  const auto seen = viewer::runReplay(**renderer, def);
  if (!seen) return failed(seen.error());
  if (!seen->note.empty()) printNote(arguments.run.scene + ": " + seen->note);
  fmt::print("{} loops; the last frame that was shown is {}\n", seen->loops, seen->frame);
  return ExitStatus::kOk;
}

ExitStatus viewLevels(const Arguments& arguments) {
  auto script = readScript(arguments);
  if (!script) return refuse(script.error());
  auto models = readLevelFile(arguments.run.scene);
  if (!models) return refuse(models.error());
  viewer::LevelsViewerDef def{.models = {},
                              .out = arguments.out,
                              .loops = arguments.loops,
                              .script = std::move(*script),
                              .panels = !arguments.noPanels};
  for (LevelModel& model : *models) {
    if (model.mesh.triangles.empty())
      printNote(arguments.run.scene + ": " + model.name + " has no mesh, so that no gaps are shown");
    def.models.push_back({model.name, std::move(model.levels), std::move(model.mesh)});
  }
  const auto renderer = openWindow(arguments);
  if (!renderer) return refuse(renderer.error());
  const auto seen = viewer::runLevelsViewer(**renderer, def);
  if (!seen) return failed(seen.error());
  fmt::print("{} loops\n", seen->loops);
  return ExitStatus::kOk;
}

bool wantsLevels(const Arguments& arguments) {
  return arguments.show == "levels" || (arguments.show != "scene" && isLevelFile(arguments.run.scene));
}

ExitStatus view(const Arguments& arguments) {
  if (Recording::isOne(arguments.run.scene)) return replay(arguments);
  if (wantsLevels(arguments)) return viewLevels(arguments);
  const auto def = makeDef(arguments);
  if (!def) return refuse(def.error());
  const auto renderer = openWindow(arguments);
  if (!renderer) return refuse(renderer.error());
  const auto seen = viewer::runViewer(**renderer, *def);
  if (!seen) {
    printError(seen.error().message);
    return ExitStatus::kFailed;
  }
  for (std::size_t i = 0; i < seen->frames.size(); ++i) {
    fmt::print("{}: {} frames, state hash {:016x}\n", def->worlds[i].label, seen->frames[i],
               seen->stateHashes[i]);
  }
  fmt::print(
      "{} loops, median {:.1f} ms, of which {:.1f} ms draw; the last {} frames are kept in {:.1f} MB of "
      "disk\n",
      seen->loops, seen->medianLoopMs, seen->medianDrawMs, seen->historyFrames,
      static_cast<double>(seen->historyBytes) / 1e6);
  return ExitStatus::kOk;
}

}  // namespace

Command addViewCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(kViewName, kViewSummary);
  auto arguments = std::make_shared<Arguments>();
  addRunArguments(*command, arguments->run);
  command
      ->add_option("--show", arguments->show,
                   "Of a physics file: what happens in it (scene) or the levels of its models (levels); "
                   "automatically levels if it has one body with levels and nothing happens")
      ->check(CLI::IsMember(std::vector<std::string>(kShowChoices.begin(), kShowChoices.end())))
      ->capture_default_str();
  command->add_option("--worlds", arguments->worlds, "One world, or two side by side; see `scatter list`")
      ->delimiter(',')
      ->type_name("NAME,NAME")
      ->capture_default_str();
  command
      ->add_option("--renderer", arguments->renderer,
                   "What draws: " + fmt::format("{}", fmt::join(viewer::rendererNames(), ", ")))
      ->type_name("NAME")
      ->capture_default_str();
  command->add_option("--size", arguments->size, "Of the window, pixels")
      ->type_name("WIDTHxHEIGHT")
      ->capture_default_str();
  command
      ->add_option(
          "--samples", arguments->samples,
          "Of each pixel, for smooth edges: 0, 2, 4 or 8 [4; 0 without a graphics processor, where they are "
          "slow]")
      ->check(CLI::IsMember({0, 2, 4, 8}));
  command
      ->add_option("--views", arguments->views,
                   "Debug views that are on from the start, such as levels,contacts")
      ->delimiter(',')
      ->type_name("NAME,NAME…")
      ->capture_default_str();
  command->add_flag("--no-panels", arguments->noPanels, "Begin without panels");
  command
      ->add_option("--loops", arguments->loops,
                   "Close after so many loops of one step each, as fast as they go")
      ->type_name("N");
  command
      ->add_option("--script", arguments->script,
                   "Keys, pointer and pictures at given loops; see docs/window.md")
      ->type_name("FILE");
  command->add_option("--screenshot", arguments->screenshot, "With --loops: write the last picture as PNG")
      ->type_name("FILE");
  command->add_option("--out", arguments->out, "The folder for pictures, recordings and runs")
      ->type_name("DIR")
      ->capture_default_str();
  return {command, [arguments] { return view(*arguments); }};
}

}  // namespace scatter::app
