#pragma once

#include <scatter/math.h>
#include <scatter/result.h>
#include <scatter/world/body.h>
#include <scatter/world/level_event.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scatter {

/// What Hands do, as data: the methods of Hands with these names say what each does. Points are in the world
/// frame. Bodies are named by BodyId, which is the same in every run of a scene that goes the same way.
/// @{
struct DragAction {
  BodyId body{};
  Vec3 point{0.0F};
};
struct DragToAction {
  Vec3 target{0.0F};
};
struct DropAction {};
struct PushAction {
  BodyId body{};
  Vec3 impulse{0.0F};
  Vec3 point{0.0F};
};
struct ThrowAction {
  BodyId model{};
  Vec3 from{0.0F};
  Vec3 through{0.0F};
  float speed = 20.0F;
};
struct SpawnAction {
  BodyId model{};
  Transform pose{};
};
struct RemoveAction {
  BodyId body{};
};
struct GatherAction {
  Vec3 point{0.0F};
  std::vector<BodyId> bodies{};  ///< Empty: everything.
};
struct ReleaseAction {};
struct FreezeAction {
  std::vector<BodyId> bodies{};
};
struct ThawAction {
  std::vector<BodyId> bodies{};
};
struct RequestAction {
  int level = 1;
  Scope scope = Scope::kLocal;
  std::vector<BodyId> bodies{};  ///< Empty: everything.
};
struct RetractAction {
  std::vector<BodyId> bodies{};  ///< Empty: everything.
};
/// @}

using HandAction =
    std::variant<DragAction, DragToAction, DropAction, PushAction, ThrowAction, SpawnAction, RemoveAction,
                 GatherAction, ReleaseAction, FreezeAction, ThawAction, RequestAction, RetractAction>;

struct TimedHandAction {
  std::uint64_t frame = 0;  ///< World::frame() when it is done: before the step that makes the next frame.
  HandAction action;
};

/// What was done to a run, in the order in which it was done. Given to Experiment::restart(), it is done
/// again at the same frames.
class HandScript {
 public:
  /// Frames do not decrease.
  void add(std::uint64_t frame, HandAction action);

  [[nodiscard]] const std::vector<TimedHandAction>& actions() const { return actions_; }
  [[nodiscard]] bool empty() const { return actions_.empty(); }

  /// One action a line: the frame, what is done, and the members of its struct as numbers:
  ///
  ///     120 drag 17 0 1.5 0
  ///     121 drag-to 3 2 0
  ///     150 drop
  ///     160 request 1 group 17 18 19
  ///
  /// Numbers read back to the same bits.
  [[nodiscard]] std::string text() const;

  /// Empty lines and what follows a '#' mean nothing. Fails on anything else that text() does not write, and
  /// on frames that decrease; the message names `source` and the line.
  [[nodiscard]] static Result<HandScript> parse(std::string_view text, const std::string& source);

  /// What a line has after its frame. The message of a failure follows the name of the line.
  [[nodiscard]] static Result<HandAction> parseAction(std::string_view text);

  /// All that can be done.
  [[nodiscard]] static std::span<const std::string_view> actionNames();

 private:
  std::vector<TimedHandAction> actions_;
};

}  // namespace scatter
