#include "viewer/replay_window.h"

#include <imgui.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <glm/geometric.hpp>
#include <utility>

#include "viewer/panels/panels.h"
#include "viewer/panels/replay_panels.h"
#include "viewer/window_commands.h"

namespace scatter::viewer {
namespace {

constexpr double kRate = 1.4142135;
constexpr int kFar = 60;  // frames
constexpr std::array kRecordedViews{DebugView::kLevels, DebugView::kShapes,   DebugView::kContacts,
                                    DebugView::kCredit, DebugView::kSleeping, DebugView::kMarks};
constexpr double kReading = 3.0;       // milliseconds of each loop, for the curves
constexpr float kPickReach = 2000.0F;  // metres
constexpr const char* kHint =
    "click a body to look at it, or a place in a curve to go there; drag to turn, wheel to zoom";
constexpr float kClick = 4.0F;  // pixels that a click may move

ObservedContact observedOf(const RecordedContact& contact) {
  ObservedContact observed;
  observed.a = contact.a;
  observed.b = contact.b;
  observed.pointA = contact.pointA;
  observed.pointB = contact.pointA - contact.distance * contact.normal;
  observed.normal = contact.normal;
  observed.distance = contact.distance;
  observed.credit = contact.credit;
  observed.impulse = contact.impulse;
  return observed;
}

}  // namespace

ReplayWindow::ReplayWindow(Renderer& renderer, const ReplayDef& def, std::unique_ptr<RunHistory> history)
    : WindowLoop(renderer, def),
      history_(std::move(history)),
      looks_(renderer),
      scene_(looks_),
      time_(history_->oldest(), history_->newest()),
      shadows_(usualShadows(renderer)),
      curves_(*history_->replayed()) {
  open_.numbers = !Layout::isNarrow(renderer.size());
  setTitle(def.recording.string());
  addTime();
  addViews();
  addCamera();
  addPicking();
  addWindow(switches_, outputs_, commands_);
}

Result<std::unique_ptr<ReplayWindow>> ReplayWindow::create(Renderer& renderer, const ReplayDef& def) {
  auto history = RunHistory::open(def.recording);
  if (!history) return tl::unexpected(history.error());
  std::unique_ptr<ReplayWindow> window(new ReplayWindow(renderer, def, std::move(*history)));
  for (const std::string& name : def.views) {
    const Command* command = window->commands_.find(name);
    if (command == nullptr || command->group != "Views") {
      return fail("no view of a recording is called \"" + name +
                  "\"; known: levels, shapes, contacts, credit, sleeping, marks");
    }
    command->run();
  }
  if (def.script && !def.script->hands().empty()) return fail("nothing in a recording can be moved by hand");
  return window->script_.check().map([&] { return std::move(window); });
}

void ReplayWindow::addTime() {
  const auto add = [this](const char* name, const char* help, Key key, std::function<void()> run,
                          std::function<bool()> isOn = {}) {
    commands_.add({name, "Time", name, help, key, std::move(run), std::move(isOn)});
  };
  add(
      "play", "Run, or stop", Key::kSpace, [this] { time_.setPlaying(!time_.isPlaying()); },
      [this] { return time_.isPlaying(); });
  add(
      "backwards", "Run the other way", Key::kR, [this] { time_.turn(); },
      [this] { return time_.isBackwards(); });
  add("step", "Stop, and show the next frame", Key::kPeriod, [this] { time_.showNext(1); });
  add("back", "Stop, and show the frame before", Key::kComma, [this] { time_.showNext(-1); });
  add("forth-far", "A second further", Key::kRight, [this] { time_.showNext(kFar); });
  add("back-far", "A second back", Key::kLeft, [this] { time_.showNext(-kFar); });
  add("first", "The first frame", Key::kHome, [this] { time_.show(time_.first()); });
  add("last", "The last frame", Key::kEnd, [this] { time_.show(time_.last()); });
  add("slower", "Down to 0.05", Key::kMinus, [this] { loop_.setPhysicsRate(loop_.physicsRate() / kRate); });
  add("faster", "Up to 4", Key::kPlus, [this] { loop_.setPhysicsRate(loop_.physicsRate() * kRate); });
}

void ReplayWindow::addViews() {
  for (const DebugViewInfo& info : debugViews()) {
    const bool isRecorded =
        std::find(kRecordedViews.begin(), kRecordedViews.end(), info.view) != kRecordedViews.end();
    if (isRecorded) addView(info, views_, commands_);
  }
  addShadows(shadows_, commands_);
}

void ReplayWindow::addCamera() {
  commands_.add({"action", "Camera", "action", "Go where bodies move and meet", Key::kV,
                 [this] { camera_.setMode(CameraMode::kAction); },
                 [this] { return camera_.mode() == CameraMode::kAction; }});
  commands_.add({"orbit", "Camera", "orbit", "Right drag turns, middle drag moves, wheel zooms", Key::kO,
                 [this] { camera_.setMode(CameraMode::kOrbit); },
                 [this] { return camera_.mode() == CameraMode::kOrbit; }});
  commands_.add(
      {"frame",
       "Camera",
       "see all",
       "Go where everything is in the picture",
       Key::kB,
       [this] { camera_.frame(extentOf(scene_.actors(moment())).value_or(Ball{}), layout().aspect()); },
       {}});
  commands_.add({"follow", "Camera", "follow", "Turn around the picked body, and go with it", Key::kC,
                 [this] { camera_.setMode(CameraMode::kFollow); },
                 [this] { return camera_.mode() == CameraMode::kFollow; }});
}

void ReplayWindow::addPicking() {
  commands_.add({"let-go",
                 "Window",
                 "let go",
                 "Pick no body any more; a click picks one",
                 Key::kDelete,
                 [this] { picked_.reset(); },
                 {}});
  addFold("numbers", Key::kF3, open_.numbers, commands_);
}

Result<void> ReplayWindow::perform(const ScriptAction& action) {
  if (const auto* input = std::get_if<DoInput>(&action)) inject(input->event);
  if (const auto* point = std::get_if<PointAt>(&action)) {
    InputEvent move;
    const auto pixel = pixelOfBody(point->object);
    if (!pixel) return fail("\"" + point->object + "\" is no body of this frame, or behind the camera");
    move.position = *pixel;
    inject(move);
  }
  if (std::holds_alternative<OpenScene>(action))
    return fail("a recording's window shows no scene but its own");
  return {};
}

void ReplayWindow::take(const InputEvent& event) {
  pointer_.take(event, renderer_.size().y);
  takeClick(event);
}

void ReplayWindow::takeClick(const InputEvent& event) {
  using Kind = InputEvent::Kind;
  if (event.kind == Kind::kMouseMove) {
    pointed_ = event.position;
    if (pressed_ && glm::distance(*pressed_, pointed_) > kClick) pressed_.reset();
  }
  const bool isLeft = event.button == MouseButton::kLeft;
  if (event.kind == Kind::kMouseDown && isLeft && !event.takenByPanels) {
    pressed_ = event.position;
    // The camera may be on its way: what is meant is what was seen there.
    pressedBody_ = bodyAt(event.position);
  }
  if (event.kind == Kind::kMouseUp && isLeft && pressed_) {
    pressed_.reset();
    picked_ = pressedBody_;
  }
}

std::optional<BodyId> ReplayWindow::bodyAt(const glm::vec2& pixel) {
  if (!layout().isPicture(pixel)) return std::nullopt;
  Ray ray = rayThrough(emptyView(), renderer_.size(), pixel);
  ray.origin += cutaway_.depthBehind(ray, scene_.obstacles(moment())) * ray.direction;
  return scene_.pick(moment(), ray, kPickReach);
}

std::optional<glm::vec2> ReplayWindow::pixelOfBody(const std::string& name) const {
  const RunHistory::Frame now = history_->frame(time_.frame());
  for (std::size_t i = 0; i < now.bodies().size(); ++i) {
    if (history_->replayed()->nameOf(now.bodies()[i]) == name)
      return pixelOf(emptyView(), renderer_.size(), now.pose(i).position);
  }
  return std::nullopt;
}

Result<ReplayReport> ReplayWindow::run() {
  return runLoops().map([this] {
    return ReplayReport{.loops = loop_.report().loops,
                        .frame = time_.frame(),
                        .picked = picked_ ? history_->replayed()->nameOf(*picked_) : "",
                        .note = history_->replayed()->damage()};
  });
}

Layout ReplayWindow::layout() const {
  return {renderer_.size(), 1, switches_.panels ? &open_ : nullptr};
}

View ReplayWindow::emptyView() const {
  View view;
  view.area = layout().area(0);
  view.camera = camera_.camera();
  return view;
}

Moment ReplayWindow::moment() const {
  Moment moment;
  moment.history = history_.get();
  moment.frame = time_.frame();
  moment.picked = picked_;
  return moment;
}

Picture ReplayWindow::picture() {
  const Moment moment = this->moment();
  const double now = clock_->now();
  const auto seconds = static_cast<float>(now - std::exchange(aimed_, now));
  const std::vector<Actor> actors = scene_.actors(moment);
  if (const auto at = picked_ ? history_->frame(time_.frame()).find(*picked_) : std::nullopt)
    camera_.follow(history_->frame(time_.frame()).pose(*at).position);
  if (!actors.empty()) camera_.watch(findAction(actors).value_or(Ball{}), layout().aspect(), seconds);
  cutaway_.update(camera_.eye(), actors, scene_.obstacles(moment), seconds);
  Picture picture;
  View& view = picture.views.emplace_back(emptyView());
  scene_.add(moment, views_, cutaway_, view);
  addContacts(view);
  finishScenery(camera_.distance(), view);
  view.scenery.shadows = shadows_;
  curves_.readFor(kReading);
  const auto hovered = switches_.panels && !pressed_ ? bodyAt(pointed_) : std::nullopt;
  hovered_ = hovered ? history_->replayed()->nameOf(*hovered) : std::string();
  return picture;
}

void ReplayWindow::addContacts(View& view) const {
  if (!views_.has(DebugView::kContacts) && !views_.has(DebugView::kCredit)) return;
  const auto frame = history_->replayed()->frame(time_.frame());
  if (!frame) return;
  std::vector<ObservedContact> contacts;
  for (const RecordedContact& contact : (*frame)->contacts) contacts.push_back(observedOf(contact));
  addContactLines(views_, contacts, view);
}

std::string ReplayWindow::label() const {
  const RecordingInfo& info = history_->replayed()->info();
  std::string text = info.scene + ", " + info.label;
  const auto channel = info.channel("physics_cpu_ms");
  const auto frame = history_->replayed()->frame(time_.frame());
  if (!channel || !frame || *channel >= (*frame)->values.size()) return text;
  char cost[32];
  std::snprintf(cost, sizeof cost, ": %.1f ms", std::bit_cast<double>((*frame)->values[*channel]));
  return text + cost;
}

void ReplayWindow::showPanels() {
  const Layout place = layout();
  const std::string text = label();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::GetBackgroundDrawList()->AddText({0.5F * (place.window().x - size.x), 8.0F * place.scale()},
                                          IM_COL32(235, 240, 245, 255), text.c_str());
  if (switches_.help) showHelpPanel(commands_, cameraHelp(), place);
  if (switches_.help || !switches_.panels) return;
  const ReplayPanels panels{*history_, curves_, time_, open_, picked_, channel_};
  showReplayNumbers(panels, place);
  showReplayInspector(panels, place);
  showTime(place);
  if (!hovered_.empty() && !ImGui::GetIO().WantCaptureMouse) ImGui::SetTooltip("%s", hovered_.c_str());
}

void ReplayWindow::showTime(const Layout& place) {
  if (beginPanel("Time", place.time(), false)) {
    int frame = static_cast<int>(time_.frame());
    char format[64];
    std::snprintf(format, sizeof format, "frame %%d of %d, %.2f s", static_cast<int>(time_.last()),
                  static_cast<double>(frame) * history_->replayed()->info().stepSeconds);
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::SliderInt("##frame", &frame, static_cast<int>(time_.first()), static_cast<int>(time_.last()),
                         format)) {
      time_.show(static_cast<std::uint64_t>(std::max(frame, 0)));
    }
    commandButtons(commands_, "Time");
    commandButtons(commands_, "Views");
    ImGui::SameLine();
    ImGui::TextUnformatted("shadows");
    ImGui::SameLine();
    commandButtons(commands_, "Shadows");
    ImGui::SameLine();
    commandButton(commands_, "help");
    const std::string& damage = history_->replayed()->damage();
    const std::string& said = outputs_.message().empty() ? damage : outputs_.message();
    const char* text = said.empty() ? kHint : said.c_str();
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(text).x) ImGui::NewLine();
    ImGui::TextUnformatted(text);
  }
  ImGui::End();
}

Result<ReplayReport> runReplay(Renderer& renderer, const ReplayDef& def) {
  return ReplayWindow::create(renderer, def).and_then([](const std::unique_ptr<ReplayWindow>& window) {
    return window->run();
  });
}

}  // namespace scatter::viewer
