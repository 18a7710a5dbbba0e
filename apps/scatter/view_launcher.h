#pragma once

#include <string>
#include <vector>

#include "command.h"

namespace scatter::app {

/// Becomes the window's program, with these words after "view"; comes back only if that cannot be started.
[[nodiscard]] ExitStatus becomeWindow(std::vector<std::string> words);

}  // namespace scatter::app
