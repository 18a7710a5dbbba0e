#include "viewer/viewer_commands.h"

#include <scatter/world/scene.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "viewer/view_presets.h"
#include "viewer/window_commands.h"

namespace scatter::viewer {
namespace {

constexpr double kRateStep = 1.4142135;

void addTime(ViewerState& state) {
  Commands& commands = state.commands;
  Playback& time = state.playback;
  commands.add({"pause", "Time", "pause", "Stop the physics, or let it run on", Key::kSpace,
                [&time] { time.setPaused(!time.paused()); }, [&time] { return time.paused(); }});
  commands.add({"step",
                "Time",
                "step",
                "One step of 1/60 s, then pause",
                Key::kPeriod,
                [&time] { time.stepForward(); },
                {}});
  commands.add({"back",
                "Time",
                "back",
                "Show the frame before, and pause",
                Key::kComma,
                [&time] { time.stepBack(); },
                {}});
  commands.add({"first",
                "Time",
                "first",
                "Show the oldest frame that is kept",
                Key::kHome,
                [&time] { time.show(time.oldest()); },
                {}});
  commands.add({"now",
                "Time",
                "now",
                "Leave the past: show the newest frame",
                Key::kEnd,
                [&time] { time.showNewest(); },
                {}});
  commands.add({"slower",
                "Time",
                "slower",
                "Lower the rate of the physics, to 0.05 at least",
                Key::kMinus,
                [&time] { time.setRate(time.rate() / kRateStep); },
                {}});
  commands.add({"faster",
                "Time",
                "faster",
                "Raise the rate of the physics, to 4 at most",
                Key::kPlus,
                [&time] { time.setRate(time.rate() * kRateStep); },
                {}});
  commands.add({"normal-rate",
                "Time",
                "rate 1",
                "As fast as in life",
                Key::kBackspace,
                [&time] { time.setRate(1.0); },
                {}});
  commands.add({"restart",
                "Time",
                "restart",
                "Start the scene again",
                Key::kR,
                [&state] {
                  state.hands.reset();
                  if (const auto started = state.playback.restart(); !started)
                    state.hands.say(started.error().message);
                },
                {}});
}

/// The scene so many places further in the list than the one that is shown.
void wantScene(ViewerState& state, int further) {
  const auto scenes = SceneRegistry::instance().all();
  if (scenes.empty()) return;
  const std::string& now = state.panes.front()->experiment().options().scene;
  const auto found = std::ranges::find(scenes, now, [](const auto& scene) { return scene->name; });
  const auto count = static_cast<int>(scenes.size());
  // A scene of a file is none of the list: it stands before the first.
  const int index = found != scenes.end() ? static_cast<int>(found - scenes.begin()) : -1;
  const int next = index < 0 && further < 0 ? count - 1 : (index + further + count) % count;
  state.wantedScene = scenes[static_cast<std::size_t>(next)]->name;
}

void addScenes(ViewerState& state) {
  state.commands.add({"previous-scene",
                      "Scene",
                      "previous",
                      "Open the scene before this one in the list",
                      Key::kNone,
                      [&state] { wantScene(state, -1); },
                      {}});
  state.commands.add({"next-scene",
                      "Scene",
                      "next",
                      "Open the scene after this one in the list",
                      Key::kN,
                      [&state] { wantScene(state, 1); },
                      {}});
}

void addViews(ViewerState& state) {
  addPresets(state.views, state.commands);
  for (const DebugViewInfo& info : debugViews()) addView(info, state.views, state.commands);
  addShadows(state.shadows, state.commands);
}

void addCamera(ViewerState& state) {
  const auto addMode = [&state](const char* name, CameraMode mode, Key key, const char* help) {
    state.commands.add({name, "Camera", name, help, key, [&state, mode] { state.camera.setMode(mode); },
                        [&state, mode] { return state.camera.mode() == mode; }});
  };
  addMode("action", CameraMode::kAction, Key::kV,
          "Go where bodies move and meet; turning, moving or zooming takes the camera");
  addMode("orbit", CameraMode::kOrbit, Key::kO,
          "Right drag turns around the middle, middle drag moves it, wheel zooms");
  addMode("fly", CameraMode::kFly, Key::kF, "Right drag looks around, W A S D and Q E move");
  addMode("follow", CameraMode::kFollow, Key::kC, "Turn around the picked object, and go with it");
  state.commands.add({"frame",
                      "Camera",
                      "see all",
                      "Go where everything is in the picture",
                      Key::kB,
                      [&state] {
                        const Moment now = state.panes.front()->moment(std::nullopt, 1.0F, std::nullopt);
                        const auto all = extentOf(state.panes.front()->actors(now));
                        state.camera.frame(all.value_or(Ball{}), state.aspect);
                      },
                      {}});
}

void addHands(ViewerState& state) {
  static constexpr std::array<std::pair<Key, const char*>, kToolCount> kTools{
      {{Key::kG, "Pick an object, and drag it with a spring"},
       {Key::kP, "Push what is under the pointer away"},
       {Key::kT, "Throw a copy of the picked object at what is under the pointer"},
       {Key::kH, "Draw everything to the point under the pointer, and let go"},
       {Key::kInsert, "Put a copy of the picked object before what is under the pointer"}}};
  for (std::size_t i = 0; i < kToolCount; ++i) {
    const auto tool = static_cast<Tool>(i);
    const std::string name(toolName(tool));
    state.commands.add({name, "Hands", name, kTools[i].second, kTools[i].first,
                        [&state, tool] { state.hands.tool = tool; },
                        [&state, tool] { return state.hands.tool == tool; }});
  }
  state.commands.add({"delete",
                      "Hands",
                      "delete",
                      "Take the picked object out of the world",
                      Key::kDelete,
                      [&state] { state.hands.removePicked(); },
                      {}});
  state.commands.add({"freeze",
                      "Hands",
                      "freeze",
                      "Hold the picked object where it is, or let it go",
                      Key::kZ,
                      [&state] { state.hands.toggleFrozen(); },
                      {}});
}

void addLevels(ViewerState& state) {
  const auto addReach = [&state](const char* name, RequestReach reach, Key key, const char* help) {
    state.commands.add({name, "Levels", name, help, key, [&state, reach] { state.hands.reach = reach; },
                        [&state, reach] { return state.hands.reach == reach; }});
  };
  addReach("object", RequestReach::kObject, Key::kJ, "Ask the picked object for a level");
  addReach("group", RequestReach::kGroup, Key::kK, "Ask all objects of its kind");
  addReach("everything", RequestReach::kAll, Key::kL, "Ask everything");
  state.commands.add({"coarser",
                      "Levels",
                      "coarser",
                      "Ask for the next coarser level",
                      Key::kPageDown,
                      [&state] { state.hands.requestBy(-1); },
                      {}});
  state.commands.add({"finer",
                      "Levels",
                      "finer",
                      "Ask for the next finer level",
                      Key::kPageUp,
                      [&state] { state.hands.requestBy(1); },
                      {}});
  state.commands.add({"retract",
                      "Levels",
                      "retract",
                      "Take the request back",
                      Key::kU,
                      [&state] { state.hands.request(0); },
                      {}});
}

void addOutput(ViewerState& state) {
  addPanels(state.switches, state.commands);
  addFold("lab", Key::kF2, state.open.lab, state.commands);
  addFold("numbers", Key::kF3, state.open.numbers, state.commands);
  addFold("time", Key::kF4, state.open.time, state.commands);
  addScreenshot(state.outputs, state.commands);
  const auto isRecording = [&state] { return state.panes.front()->experiment().history().isRecording(); };
  state.commands.add(
      {"record", "Window", "record", "Store the run, from its first frame on, for scatter replay", Key::kF9,
       [&state, isRecording] { state.outputs.setRecording(state.panes, !isRecording()); }, isRecording});
  addFilm(state.outputs, state.commands);
  state.commands.add({"write",
                      "Window",
                      "write run",
                      "Write frames.csv, events.csv, summary.json and figures",
                      Key::kF10,
                      [&state] { state.outputs.writeRuns(state.panes); },
                      {}});
  addClose(state.switches, state.commands);
}

}  // namespace

void addCommands(ViewerState& state) {
  addTime(state);
  addScenes(state);
  addViews(state);
  addCamera(state);
  addHands(state);
  addLevels(state);
  addOutput(state);
}

}  // namespace scatter::viewer
