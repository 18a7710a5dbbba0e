#pragma once

#include <scatter/world/body.h>

#include <cstdint>
#include <string_view>

namespace scatter {

/// Who asked for a level (report, section 3.4.4).
enum class Scope : std::uint8_t { kLocal, kGroup, kGlobal };

/// The life of a request (report, Figure 4.3).
enum class LevelEventKind : std::uint8_t {
  kRequested,     ///< A request was made, or its target changed.
  kAcknowledged,  ///< The world has taken it and is trying.
  kBlocked,       ///< A try failed its safety condition; it will be repeated.
  kSwitched,      ///< The body's level changed from `from` to `to`.
  kRetracted,     ///< The request was withdrawn before it was fulfilled.
};

struct LevelEvent {
  LevelEventKind kind = LevelEventKind::kRequested;
  Scope scope = Scope::kLocal;
  BodyId body{};
  int from = 0;  ///< The body's level before the event.
  int to = 0;    ///< The level switched to, or the target of the request.

  BodyId other{};             ///< Pair switching: the other body; 0 when a body switches for all its pairs.
  bool onCredit = false;      ///< Switched while in contact, on penetration credit.
  std::string_view policy{};  ///< Who asked: a policy's name, "governor", "program"; never dangles.
};

}  // namespace scatter
