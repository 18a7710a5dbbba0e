#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "apps/program.h"

namespace scatter::test {

/// What a called command has left.
struct Called {
  Outcome outcome;
  std::filesystem::path folder;  ///< Where it ran; empty before.
};

/// A command of the documentation, how the test calls it, and what it must show.
struct PageCommand {
  std::string command;  ///< As it stands on the page.

  /// Its arguments, and how they are cut short; placeholders are filled in. Empty: as on the page. The first
  /// word is
  /// "./run" or "./test" for these two; else it is the one after "scatter".
  std::string call{};

  /// Expectations beyond exit status 0.
  std::function<void(const Called&)> check{};

  [[nodiscard]] bool needsWindow() const { return command.find(" view") != std::string::npos; }
};

/// For messages of tests.
std::ostream& operator<<(std::ostream& stream, const PageCommand& command);

/// All commands of all pages. A command that a page gains must be added here, with a check of what the page
/// says of it.
[[nodiscard]] const std::vector<PageCommand>& pageCommands();

}  // namespace scatter::test
