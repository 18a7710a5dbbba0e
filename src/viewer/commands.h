#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/input.h"

namespace scatter::viewer {

/// Something that a key, a button of a panel and a line of a script can do alike.
struct Command {
  std::string name{};   ///< What scripts call it: letters, digits and dashes.
  std::string group{};  ///< The heading in the help panel.
  std::string label{};  ///< On its button.
  std::string help{};   ///< A line.
  Key key = Key::kNone;
  std::function<void()> run{};
  std::function<bool()> isOn{};  ///< Empty: it is not a switch.
};

/// Everything that can be done without pointing, in the order of the help panel.
class Commands {
 public:
  /// Name and key must be new.
  void add(Command command);

  [[nodiscard]] const std::vector<Command>& all() const { return commands_; }

  /// Null if there is none.
  [[nodiscard]] const Command* find(std::string_view name) const;
  [[nodiscard]] const Command* find(Key key) const;

 private:
  std::vector<Command> commands_;
};

/// Such as "F5" or "Space".
[[nodiscard]] std::string_view keyName(Key key);

/// The key of that name, in any case; kNone if there is none.
[[nodiscard]] Key keyNamed(std::string_view name);

}  // namespace scatter::viewer
