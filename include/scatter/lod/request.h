#pragma once

#include <cstdint>

namespace scatter {

/// Who asked for a level: one body, a cluster of bodies, or the whole world (report, section 3.4.4).
enum class Scope : std::uint8_t { kLocal, kGroup, kGlobal };

/// As files and tables have it: "local", "group", "global".
inline const char* nameOf(Scope scope) {
  switch (scope) {
    case Scope::kLocal:
      return "local";
    case Scope::kGroup:
      return "group";
    case Scope::kGlobal:
      return "global";
  }
  return "unknown";
}

/// The life of a request (report, Figure 4.3).
enum class LevelEventKind : std::uint8_t {
  kRequested,     ///< A request was made, or its target changed.
  kAcknowledged,  ///< The world has taken it and is trying.
  kBlocked,       ///< A try failed its safety condition; it will be repeated.
  kSwitched,      ///< The level of a body, or of a pair, has changed.
  kRetracted,     ///< The request was withdrawn before it was fulfilled.
};

}  // namespace scatter
