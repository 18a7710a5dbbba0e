#include "viewer/window.h"

#include <scatter/lab/summary.h>

#include <algorithm>
#include <utility>

#include "viewer/hand_lines.h"
#include "viewer/panels/panels.h"
#include "viewer/viewer_commands.h"

namespace scatter::viewer {
namespace {

constexpr float kCrowdReach = 1.15F;  // by the radius of the action
constexpr float kCrowdShade = 0.35F;
constexpr float kNamedReach = 2000.0F;  // metres, of what is named under the pointer
constexpr float kFlySpeed = 0.02F;      // of the distance to what is looked at, a loop

std::string viewNames() {
  std::string names;
  for (const DebugViewInfo& info : debugViews())
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  return names;
}

}  // namespace

Window::Window(Renderer& renderer, const ViewerDef& def)
    : WindowLoop(renderer, def), def_(def), looks_(renderer), playback_(loop_, panes_), hands_(panes_) {
  loop_.add(LoopTask::kInput, [this] {
    openWanted();
    fly();
  });
}

Result<std::unique_ptr<Window>> Window::create(Renderer& renderer, const ViewerDef& def) {
  std::unique_ptr<Window> window(new Window(renderer, def));
  return window->openWorlds().and_then([&] { return window->script_.check(); }).map([&] {
    return std::move(window);
  });
}

Result<void> Window::openWorlds() {
  for (RunOptions options : def_.worlds) {
    if (def_.script) options.hands = def_.script->hands();
    auto pane = Pane::create(options, looks_);
    if (!pane) return tl::unexpected(pane.error());
    panes_.push_back(std::move(*pane));
  }
  control_.emplace(panes_);
  state_.emplace(
      ViewerState{panes_, playback_, hands_, *control_, outputs_, camera_, views_, commands_, switches_});
  state_->shadows = usualShadows(renderer_);
  setTitle(def_.worlds.front().scene);
  const bool narrow = Layout::isNarrow(renderer_.size());
  state_->open.lab = state_->open.numbers = !narrow;
  addCommands(*state_);
  for (const std::string& name : def_.views) {
    const Command* command = commands_.find(name);
    if (command == nullptr || command->group != "Views")
      return fail("no view is called \"" + name + "\"; known: " + viewNames());
    command->run();
  }
  aim(moments());
  return {};
}

Result<ViewerReport> Window::run() {
  const auto ran = runLoops();
  outputs_.setRecording(panes_, false);
  return ran.map([this] { return report(); });
}

void Window::step() {
  playback_.step();
  checkHands();
}

// What the script's hands could not do ends the window, as other lines of it that cannot be done.
void Window::checkHands() {
  for (const auto& pane : panes_) {
    if (!pane->experiment().scriptError().empty()) close(pane->experiment().scriptError());
  }
}

Result<void> Window::perform(const ScriptAction& action) {
  if (const auto* input = std::get_if<DoInput>(&action)) inject(input->event);
  if (const auto* point = std::get_if<PointAt>(&action)) {
    const auto position = positionOf(point->object);
    if (!position) return fail("\"" + point->object + "\" is no object of the scene, or behind the camera");
    InputEvent move;
    move.position = *position;
    inject(move);
  }
  if (const auto* scene = std::get_if<OpenScene>(&action)) return openScene(scene->name);
  return {};
}

Result<void> Window::openScene(const std::string& name) {
  outputs_.setRecording(panes_, false);
  hands_.reset();
  auto opened = playback_.open(name);
  looks_.clear();
  cutaway_ = {};
  camera_ = {};
  setTitle(panes_.front()->experiment().options().scene);
  return opened;
}

// What a panel or a key has asked for, when no panel is being drawn from the old scene any more.
void Window::openWanted() {
  if (!state_->wantedScene) return;
  const std::string name = *std::exchange(state_->wantedScene, std::nullopt);
  if (const auto opened = openScene(name); !opened) hands_.say(opened.error().message);
}

void Window::take(const InputEvent& event) {
  switch (event.kind) {
    case InputEvent::Kind::kKeyDown:
      keys_[static_cast<std::size_t>(event.key)] = !event.takenByPanels;
      break;
    case InputEvent::Kind::kKeyUp:
      keys_[static_cast<std::size_t>(event.key)] = false;
      break;
    case InputEvent::Kind::kMouseMove:
    case InputEvent::Kind::kMouseDown:
    case InputEvent::Kind::kMouseUp:
    case InputEvent::Kind::kWheel:
      takePointer(event);
      break;
    case InputEvent::Kind::kClose:
    case InputEvent::Kind::kText:
    case InputEvent::Kind::kResize:
      break;
  }
}

void Window::press(const InputEvent& event) {
  buttons_[static_cast<std::size_t>(event.button)] = true;
  if (event.button != MouseButton::kLeft) return;
  playback_.showNewest();
  const Pointed pointed = pointedAt(event.position);
  Pane& pane = *panes_[pointed.pane];
  const Moment now = pane.moment(std::nullopt, 1.0F, std::nullopt);
  hands_.press(pointed.pane, pointed.ray, cutaway_.depthBehind(pointed.ray, pane.obstacles(now)));
}

void Window::takePointer(const InputEvent& event) {
  const glm::vec2 moved = (event.position - pointer_) / static_cast<float>(std::max(1, renderer_.size().y));
  pointer_ = event.position;
  if (event.kind == InputEvent::Kind::kMouseUp) {
    buttons_[static_cast<std::size_t>(event.button)] = false;
    if (event.button == MouseButton::kLeft) hands_.release();
  }
  if (event.kind == InputEvent::Kind::kMouseMove) {
    if (buttons_[0]) hands_.move(pointedAt(event.position).ray);
    if (buttons_[1]) camera_.turnByDrag(moved);
    if (buttons_[2]) camera_.pan(-moved.x, moved.y);
  }
  if (event.takenByPanels) return;
  if (event.kind == InputEvent::Kind::kMouseDown) press(event);
  if (event.kind == InputEvent::Kind::kWheel) camera_.zoomByNotches(event.wheel);
}

void Window::fly() {
  if (camera_.mode() != CameraMode::kFly) return;
  const auto axis = [&](Key plus, Key minus) {
    const auto down = [&](Key key) { return keys_[static_cast<std::size_t>(key)] ? 1.0F : 0.0F; };
    return down(plus) - down(minus);
  };
  const Vec3 way(axis(Key::kD, Key::kA), axis(Key::kE, Key::kQ), axis(Key::kW, Key::kS));
  camera_.move(kFlySpeed * camera_.distance() * way);
}

// Only at rest: what is being dragged or turned needs no name, and looking for it takes time.
std::string Window::hoveredName() const {
  const bool busy = std::ranges::any_of(buttons_, [](bool down) { return down; });
  if (busy || !switches_.panels || playback_.past() || !layout().isPicture(pointer_)) return {};
  const Pointed pointed = pointedAt(pointer_);
  const auto hit = panes_[pointed.pane]->experiment().hands().pick(
      pointed.ray.origin, pointed.ray.origin + kNamedReach * pointed.ray.direction);
  const bool moves = hit && hit->object->def().motion == Motion::kDynamic;
  return moves ? hit->object->name() : std::string();
}

Layout Window::layout() const {
  return {renderer_.size(), panes_.size(), switches_.panels ? &state_->open : nullptr};
}

View Window::emptyView(std::size_t pane) const {
  View view;
  view.area = layout().area(pane);
  view.camera = camera_.camera();
  return view;
}

Window::Pointed Window::pointedAt(const glm::vec2& position) const {
  const std::size_t pane = layout().paneAt(position);
  return {pane, rayThrough(emptyView(pane), renderer_.size(), position)};
}

std::optional<glm::vec2> Window::positionOf(const std::string& object) const {
  const WorldObject* found = panes_.front()->experiment().world().find(std::string_view(object));
  if (found == nullptr) return std::nullopt;
  return pixelOf(emptyView(0), renderer_.size(), found->state().centerOfMass);
}

ObservationParts Window::parts() const {
  ObservationParts parts = playback_.past() ? ObservationParts{false, false, false} : views_.parts();
  // The inspector tells of the present, whatever is shown.
  const bool inspected = switches_.panels && hands_.picked().has_value();
  parts.bodies = parts.bodies || inspected;
  parts.pairs = parts.pairs || inspected;
  return parts;
}

std::vector<Moment> Window::moments() {
  const ObservationParts parts = this->parts();
  std::vector<Moment> moments;
  for (const auto& pane : panes_) {
    pane->observe(parts);
    moments.push_back(pane->moment(playback_.past(), playback_.fraction(), hands_.picked()));
  }
  return moments;
}

void Window::aim(const std::vector<Moment>& moments) {
  const double now = clock_->now();
  const auto seconds = static_cast<float>(now - std::exchange(aimed_, now));
  std::vector<Actor> actors;
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    const std::vector<Actor> some = panes_[i]->actors(moments[i]);
    actors.insert(actors.end(), some.begin(), some.end());
  }
  state_->aspect = layout().aspect();
  const Ball action = findAction(actors).value_or(Ball{});
  if (!actors.empty()) camera_.watch(action, state_->aspect, seconds);
  crowd_ = {action.center, kCrowdReach * action.radius, kCrowdShade * crowding(actors)};
  camera_.follow(Pane::positionOf(moments.front()).value_or(camera_.pivot()));
  cutaway_.update(camera_.eye(), actors, panes_.front()->obstacles(moments.front()), seconds);
}

Picture Window::picture() {
  const std::vector<Moment> moments = this->moments();
  aim(moments);
  const Camera camera = camera_.camera();
  control_->setFocus({camera.eye, camera.target, camera.fieldOfView});
  Picture picture;
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    View view = emptyView(i);
    panes_[i]->fill(moments[i], views_, cutaway_, view);
    addSpring(panes_[i]->experiment().hands(), view.linesOnTop);
    finishScenery(camera_.distance(), view);
    if (view.scenery.stars) view.scenery.crowd = crowd_;
    view.scenery.shadows = state_->shadows;
    picture.views.push_back(std::move(view));
  }
  state_->hovered = hoveredName();
  return picture;
}

void Window::showPanels() {
  if (!drawMs_.empty()) state_->drawMilliseconds += 0.1 * (drawMs_.back() - state_->drawMilliseconds);
  viewer::showPanels(*state_, layout());
}

ViewerReport Window::report() const {
  ViewerReport report;
  report.loops = loop_.report().loops;
  report.medianDrawMs = medianOf(drawMs_);
  report.medianLoopMs = medianOf(loopMs_);
  for (const auto& pane : panes_) {
    const Experiment& experiment = pane->experiment();
    report.frames.push_back(experiment.world().frame());
    report.stateHashes.push_back(experiment.world().physics().stateHash());
    report.objects.push_back(experiment.world().objects().size());
    report.levelEvents.push_back(experiment.levelEvents());
    if (experiment.history().bytes() < report.historyBytes) continue;
    report.historyBytes = experiment.history().bytes();
    report.historyFrames = experiment.history().size();
  }
  return report;
}

Result<ViewerReport> runViewer(Renderer& renderer, const ViewerDef& def) {
  return Window::create(renderer, def).and_then([](const std::unique_ptr<Window>& window) {
    return window->run();
  });
}

}  // namespace scatter::viewer
