#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace scatter::viewer {

/// The keys that the viewer can tell apart. Letters and digits follow each other without a gap.
enum class Key : std::uint8_t {
  kNone,
  kA,
  kB,
  kC,
  kD,
  kE,
  kF,
  kG,
  kH,
  kI,
  kJ,
  kK,
  kL,
  kM,
  kN,
  kO,
  kP,
  kQ,
  kR,
  kS,
  kT,
  kU,
  kV,
  kW,
  kX,
  kY,
  kZ,
  k0,
  k1,
  k2,
  k3,
  k4,
  k5,
  k6,
  k7,
  k8,
  k9,
  kF1,
  kF2,
  kF3,
  kF4,
  kF5,
  kF6,
  kF7,
  kF8,
  kF9,
  kF10,
  kF11,
  kF12,
  kSpace,
  kEnter,
  kEscape,
  kTab,
  kBackspace,
  kDelete,
  kInsert,
  kLeft,
  kRight,
  kUp,
  kDown,
  kHome,
  kEnd,
  kPageUp,
  kPageDown,
  kShift,
  kControl,
  kAlt,
  kComma,
  kPeriod,
  kMinus,
  kPlus,
  kCount,
};

enum class MouseButton : std::uint8_t { kLeft, kRight, kMiddle };

/// Something the user did, or a script in the user's place.
struct InputEvent {
  enum class Kind : std::uint8_t {
    kKeyDown,    ///< `key`, `repeated`
    kKeyUp,      ///< `key`
    kText,       ///< `text`
    kMouseMove,  ///< `position`
    kMouseDown,  ///< `position`, `button`
    kMouseUp,    ///< `position`, `button`
    kWheel,      ///< `position`, `wheel`
    kResize,     ///< `position` is the new size
    kClose,      ///< The user wants to close the window. Comes once.
  };

  Kind kind = Kind::kMouseMove;
  Key key = Key::kNone;
  MouseButton button = MouseButton::kLeft;
  glm::vec2 position{0.0F};  ///< In pixels from the top left of the window.
  float wheel = 0.0F;        ///< Notches away from the user.
  char32_t text = 0;         ///< One character.

  // The rest is filled in by Renderer::pollInput.
  bool shift = false;
  bool control = false;
  bool alt = false;
  bool repeated = false;  ///< The key was down already.
  bool takenByPanels =
      false;  ///< The pointer is over a panel, or text is typed into one. Never for releases.
};

}  // namespace scatter::viewer
