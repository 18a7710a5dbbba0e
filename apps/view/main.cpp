// The window, a program of its own, so that `scatter` is built without a window's libraries: `scatter view
// ARGS` starts `scatter-view ARGS`, which reads them as that.
#include <vector>

#include "program.h"
#include "view_summary.h"

int main(int argc, char** argv) {
  using namespace scatter::app;
  std::vector<const char*> words(argv, argv + argc);
  words.insert(words.begin() + 1, kViewName);
  return runProgram(static_cast<int>(words.size()), words.data(),
                    [](CLI::App& program, const std::string& /*commandLine*/) {
                      return std::vector<Command>{addViewCommand(program)};
                    });
}
