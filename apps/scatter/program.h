#pragma once

namespace scatter::app {

/// Does what the command line says; the result is the exit status.
int runProgram(int argc, char** argv);

}  // namespace scatter::app
