#include "viewer/window_loop.h"

#include <chrono>
#include <utility>

namespace scatter::viewer {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

WindowLoop::WindowLoop(Renderer& renderer, const std::optional<ViewScript>& script, std::uint64_t loops,
                       const std::filesystem::path& out, bool panels)
    : renderer_(renderer),
      clock_(makeClock(script, loops)),
      loop_(*clock_),
      outputs_(out),
      script_(script, commands_, camera_, outputs_),
      switches_{.panels = panels},
      loops_(loops) {
  loop_.add(LoopTask::kInput, [this] {
    playScript();
    readInput();
  });
  loop_.add(LoopTask::kPhysics, [this] { step(); });
  loop_.add(LoopTask::kRenderer, [this] { draw(); });
}

Result<void> WindowLoop::runLoops() {
  while (!switches_.closing && (loops_ == 0 || loop_.report().loops < loops_)) {
    const Stopwatch watch;
    loop_.runOnce();
    loopMs_.push_back(watch.milliseconds());
  }
  if (!error_.empty()) return fail(error_);
  if (!outputs_.failure().empty()) return fail(outputs_.failure());
  return {};
}

void WindowLoop::close(std::string error) {
  error_ = std::move(error);
  switches_.closing = true;
}

void WindowLoop::inject(InputEvent event) {
  using Kind = InputEvent::Kind;
  if (event.kind == Kind::kMouseMove) scriptPointer_ = event.position;
  const bool isPointed =
      event.kind == Kind::kMouseDown || event.kind == Kind::kMouseUp || event.kind == Kind::kWheel;
  if (isPointed) event.position = scriptPointer_;
  renderer_.inject(event);
  if (event.kind != Kind::kKeyDown) return;
  event.kind = Kind::kKeyUp;
  renderer_.inject(event);
}

void WindowLoop::playScript() {
  const auto perform = [this](const ScriptAction& action) { return this->perform(action); };
  if (auto done = script_.play(loop_.report().loops, perform); !done) close(done.error().message);
}

void WindowLoop::readInput() {
  for (const InputEvent& event : renderer_.pollInput()) {
    if (event.kind == InputEvent::Kind::kClose) switches_.closing = true;
    if (event.kind == InputEvent::Kind::kKeyDown && !event.takenByPanels && !event.control && !event.alt) {
      if (const Command* command = commands_.find(event.key)) command->run();
    }
    take(event);
  }
}

void WindowLoop::draw() {
  if (switches_.closing) return;
  const Picture shown = picture();
  const Stopwatch watch;
  Image image;
  renderer_.draw(
      shown, [this] { showPanels(); }, outputs_.wantsPicture() ? &image : nullptr);
  drawMs_.push_back(watch.milliseconds());
  if (outputs_.wantsPicture()) outputs_.take(image);
}

}  // namespace scatter::viewer
