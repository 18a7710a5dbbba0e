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

/// Prints an error in what was asked for, or of writing a result: the status is that of wrong input, and of a
/// failure if the disk is full.
[[nodiscard]] ExitStatus refuse(const Error& error);

/// Prints an error from later on; the status is that of a failure.
[[nodiscard]] ExitStatus failed(const Error& error);

/// Prints an error of a run; the status is that of the signal if the run was interrupted, and else that of
/// wrong input if the run had not `started`.
[[nodiscard]] ExitStatus endedBy(const Error& error, bool started);

/// The status of a program that a signal has ended.
[[nodiscard]] ExitStatus signalStatus();

}  // namespace scatter::app
