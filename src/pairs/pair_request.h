#pragma once

#include "pairs/planned_body.h"
#include "scatter/lod/request.h"

namespace scatter::pairs {

/// A wish to change the level of a pair: a target that is not its level. It stands until the switch has
/// happened, or until the target is the level again.
struct PairRequest {
  bool stands = false;
  bool tried = false;
  int stepMade = 0;
};

/// Who asks for the level of a pair: a policy's name, "governor", "program", or "default"; a constant.
struct Asker {
  const char* name = "default";
  Scope scope = Scope::kLocal;
};

/// What became of a request.
struct PairEvent {
  LevelEventKind kind = LevelEventKind::kRequested;
  const PlannedBody* a = nullptr;
  const PlannedBody* b = nullptr;
  int from = 0;  ///< The pair's level before.
  int to = 0;    ///< That is asked for, or was switched to.
  bool onCredit = false;
  Asker asker{};
};

/// Hears of them, in the order in which they happen.
class PairListener {
 public:
  virtual ~PairListener() = default;
  virtual void hear(const PairEvent& event) = 0;
};

}  // namespace scatter::pairs
