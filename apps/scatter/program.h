#pragma once

#include <functional>
#include <string>
#include <vector>

#include "command.h"

namespace scatter::app {

/// Adds a program's commands to it. `commandLine` is what the user typed, for reports.
using AddCommands = std::function<std::vector<Command>(CLI::App& program, const std::string& commandLine)>;

/// Does what the command line of `scatter` says, which may name these commands; the result is the exit
/// status.
int runProgram(int argc, const char* const* argv, const AddCommands& addCommands);

}  // namespace scatter::app
