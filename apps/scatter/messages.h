#pragma once

#include <string>

namespace scatter::app {

/// One line "scatter: MESSAGE" on standard error, whatever the message holds.
void printError(const std::string& message);

/// The same, for what is not an error.
void printNote(const std::string& message);

}  // namespace scatter::app
