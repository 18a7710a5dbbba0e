#include "viewer/level_marks.h"

#include <algorithm>

namespace scatter::viewer {
namespace {

constexpr std::uint64_t kWindow = 120;  // frames
constexpr float kPulse = 20.0F;         // frames
constexpr float kFade = 30.0F;          // frames
constexpr std::uint64_t kFlash = 10;    // frames on, as many off

float left(std::uint64_t age, float frames) {
  return std::max(0.0F, 1.0F - static_cast<float>(age) / frames);
}

/// Of events of one body, oldest first, `waiting` the frame of a request that still stands.
struct BodyEvents {
  LevelMark mark;
  bool waiting = false;
};

void take(const LevelEvent& event, std::uint64_t age, BodyEvents& body) {
  switch (event.kind) {
    case LevelEventKind::kRequested:
    case LevelEventKind::kAcknowledged:
    case LevelEventKind::kBlocked:
      body.waiting = true;
      break;
    case LevelEventKind::kSwitched:
      body.waiting = false;
      (event.to < event.from ? body.mark.coarser : body.mark.finer) = left(age, kPulse);
      break;
    case LevelEventKind::kRetracted:
      body.waiting = false;
      body.mark.retracted = left(age, kFade);
      break;
  }
}

}  // namespace

std::map<BodyId, LevelMark> levelMarks(const RunHistory& history, std::uint64_t frame) {
  std::map<BodyId, BodyEvents> bodies;
  if (history.empty() || !history.has(frame)) return {};
  const std::uint64_t first = std::max(history.oldest(), frame > kWindow ? frame - kWindow : 0);
  for (std::uint64_t number = first; number <= frame; ++number) {
    const RunHistory::Frame then = history.frame(number);
    for (const LevelEvent& event : then.events()) {
      take(event, frame - number, bodies[event.body]);
      if (event.other != BodyId{}) take(event, frame - number, bodies[event.other]);
    }
  }
  std::map<BodyId, LevelMark> marks;
  for (auto& [body, events] : bodies) {
    LevelMark& mark = events.mark;
    mark.requested = events.waiting && frame / kFlash % 2 == 0 ? 1.0F : 0.0F;
    if (events.waiting || mark.coarser > 0.0F || mark.finer > 0.0F || mark.retracted > 0.0F)
      marks.emplace(body, mark);
  }
  return marks;
}

}  // namespace scatter::viewer
