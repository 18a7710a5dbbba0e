#pragma once

#include <scatter/lod/request.h>
#include <scatter/world/body.h>

#include <string_view>

namespace scatter {

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
