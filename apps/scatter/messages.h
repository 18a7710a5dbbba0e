#pragma once

#include <scatter/result.h>

#include <string>
#include <vector>

#include "command.h"

namespace scatter::app {

/// One line "scatter: MESSAGE" on standard error, whatever the message holds.
void printError(const std::string& message);

/// The same, for what is not an error.
void printNote(const std::string& message);
void printNotes(const std::vector<std::string>& messages);

/// Prints the error; the status is that of wrong input.
[[nodiscard]] ExitStatus refuse(const Error& error);

/// Prints the error; the status is that of a failed check.
[[nodiscard]] ExitStatus failed(const Error& error);

}  // namespace scatter::app
