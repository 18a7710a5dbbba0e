#include "viewer/script_player.h"

#include <string>
#include <variant>

namespace scatter::viewer {
namespace {

std::string namesOf(const Commands& commands) {
  std::string names;
  for (const Command& command : commands.all()) names += (names.empty() ? "" : ", ") + command.name;
  return names;
}

}  // namespace

Result<void> ScriptPlayer::check() const {
  if (!script_) return {};
  for (const ScriptLine& line : script_->lines()) {
    const auto* run = std::get_if<DoCommand>(&line.action);
    const auto* set = std::get_if<SetCommand>(&line.action);
    if (run == nullptr && set == nullptr) continue;
    const std::string& name = run != nullptr ? run->name : set->name;
    const Command* command = commands_.find(name);
    if (command == nullptr)
      return fail("no command is called \"" + name + "\"; known: " + namesOf(commands_));
    if (set != nullptr && !command->isOn)
      return fail("\"" + name + "\" is no switch; write \"do " + name + "\"");
  }
  return {};
}

Result<void> ScriptPlayer::play(std::uint64_t loop, const Other& other) {
  if (!script_) return {};
  const auto& lines = script_->lines();
  for (; next_ < lines.size() && lines[next_].loop <= loop; ++next_) {
    if (auto done = perform(lines[next_].action, other); !done) return done;
  }
  return {};
}

Result<void> ScriptPlayer::perform(const ScriptAction& action, const Other& other) {
  if (const auto* run = std::get_if<DoCommand>(&action)) {
    commands_.find(run->name)->run();
  } else if (const auto* set = std::get_if<SetCommand>(&action)) {
    const Command& command = *commands_.find(set->name);
    if (command.isOn() != set->on) command.run();
  } else if (const auto* shot = std::get_if<TakeScreenshot>(&action)) {
    outputs_.askForScreenshot(shot->file);
  } else if (const auto* look = std::get_if<LookFrom>(&action)) {
    camera_.look(look->at, look->right, look->up, look->distance);
  } else {
    return other(action);
  }
  return {};
}

std::unique_ptr<Clock> makeClock(const std::optional<ViewScript>& script, std::uint64_t loops) {
  if (script || loops > 0) return std::make_unique<ManualClock>();
  return std::make_unique<SystemClock>();
}

}  // namespace scatter::viewer
