#pragma once

#include <scatter/lab/hands.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/drawing/projection.h"
#include "viewer/pane.h"

namespace scatter::viewer {

/// What the left button does.
enum class Tool : std::uint8_t {
  kGrab,    ///< Picks an object, and drags it with a spring while the button is down.
  kPush,    ///< Pushes what is under the pointer away from the camera.
  kThrow,   ///< Throws a copy of the picked object, or of what is under the pointer, at that point.
  kGather,  ///< Draws everything to the point under the pointer until the button is up.
  kSpawn,   ///< Puts a copy of the picked object before the point under the pointer.
};
inline constexpr std::size_t kToolCount = 5;
[[nodiscard]] std::string_view toolName(Tool tool);  ///< What commands call it, such as "grab".

/// Whom a level is asked of.
enum class RequestReach : std::uint8_t { kObject, kGroup, kAll };

/// The user's hands in a window: they do in all its worlds what they do in the one under the pointer. Actions
/// that are refused leave a line in message().
class HandTools {
 public:
  /// The panes must outlive it.
  explicit HandTools(std::vector<std::unique_ptr<Pane>>& panes) : panes_(panes) {}

  Tool tool = Tool::kGrab;
  RequestReach reach = RequestReach::kObject;
  float impulse = 2.0F;      ///< Of a push: the change of speed in metres a second.
  float throwSpeed = 20.0F;  ///< Metres a second.

  /// The left button went down, moved or went up at this point of a pane, with these rays through it. What is
  /// nearer than `clear` metres is not touched.
  void press(std::size_t pane, const Ray& ray, float clear);
  void move(const Ray& ray);
  void release();

  void pick(std::optional<BodyId> body) { picked_ = body; }
  [[nodiscard]] std::optional<BodyId> picked() const { return picked_; }

  /// To the picked object, if there is one.
  void removePicked();
  void toggleFrozen();

  /// Asks for the level of those that `reach` says; 0 takes requests back.
  void request(int level);

  /// Asks for the level that is so many finer than the one in use, as far as there are any.
  void requestBy(int finer);

  /// Forgets what is picked and held; for worlds that were started again.
  void reset();

  /// What went wrong last; empty if nothing did.
  [[nodiscard]] const std::string& message() const { return message_; }
  void say(std::string message) { message_ = std::move(message); }

 private:
  [[nodiscard]] WorldObject* pickedObject() const;
  [[nodiscard]] std::vector<BodyId> reached() const;
  void perform(const HandAction& action);
  void act(const std::optional<Pick>& hit, const Ray& ray, float clear);

  std::vector<std::unique_ptr<Pane>>& panes_;
  std::optional<BodyId> picked_;
  float depth_ = 0.0F;  ///< Of what is dragged or gathered, along the ray, metres.
  bool dragging_ = false;
  bool gathering_ = false;
  std::string message_;
};

}  // namespace scatter::viewer
