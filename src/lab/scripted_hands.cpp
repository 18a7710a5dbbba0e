#include "lab/scripted_hands.h"

#include <utility>

namespace scatter::lab {

namespace {

HandsDef tellingScene(SceneRun& run, HandsDef def) {
  def.onRemove = [&run, onRemove = std::move(def.onRemove)](WorldObject& object) {
    run.forget(object);
    if (onRemove) {
      onRemove(object);
    }
  };
  return def;
}

}  // namespace

ScriptedHands::ScriptedHands(SceneRun& run, const HandsDef& def, HandScript script)
    : run_(run), hands_(run.world(), tellingScene(run, def)), script_(std::move(script)) {}

void ScriptedHands::step() {
  play();
  run_.step([this] { hands_.beforeStep(static_cast<float>(kStepSeconds)); });
}

void ScriptedHands::play() {
  const auto& actions = script_.actions();
  for (; next_ < actions.size() && actions[next_].frame <= run_.world().frame(); ++next_) {
    const auto done = hands_.perform(actions[next_].action);
    if (!done && error_.empty()) {
      error_ = "frame " + std::to_string(actions[next_].frame) + ": " + done.error().message;
    }
  }
}

}  // namespace scatter::lab
