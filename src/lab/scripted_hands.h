#pragma once

#include <scatter/lab/hands.h>

#include "lab/scene_run.h"

#include <cstddef>
#include <string>

namespace scatter::lab {

/// The hands on a run: what somebody does with them, and what a script says for each frame.
class ScriptedHands {
 public:
  /// The run must outlive it.
  ScriptedHands(SceneRun& run, const HandsDef& def, HandScript script);

  [[nodiscard]] Hands& hands() { return hands_; }
  [[nodiscard]] const Hands& hands() const { return hands_; }

  /// Does what the script says for the next frame, then makes it.
  void step();

  /// What the script could not do, first of all; empty if there is nothing.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  void play();

  SceneRun& run_;
  Hands hands_;
  HandScript script_;
  std::size_t next_ = 0;
  std::string error_;
};

}  // namespace scatter::lab
