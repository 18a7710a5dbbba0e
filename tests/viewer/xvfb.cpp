#include "viewer/xvfb.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace scatter::test {

namespace {

/// What Xvfb writes once it is ready: the number of its display.
std::string readNumber(int file) {
  std::string number;
  char letter = 0;
  while (read(file, &letter, 1) == 1 && letter != '\n') number += letter;
  return number;
}

[[noreturn]] void become(int readyFile) {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDERR_FILENO);
  const std::string file = std::to_string(readyFile);
  execlp("Xvfb", "Xvfb", "-displayfd", file.c_str(), "-screen", "0", "2560x1440x24", "-nolisten", "tcp",
         "-noreset", nullptr);
  _exit(127);
}

}  // namespace

Xvfb::Xvfb() {
  std::array<int, 2> ready{};
  if (pipe(ready.data()) != 0) throw std::runtime_error("no pipe for Xvfb");
  process_ = fork();
  if (process_ == 0) {
    close(ready[0]);
    become(ready[1]);
  }
  close(ready[1]);
  const std::string number = readNumber(ready[0]);
  close(ready[0]);
  if (number.empty()) {
    waitpid(process_, nullptr, 0);
    throw std::runtime_error("Xvfb does not start; install xvfb");
  }
  const char* display = std::getenv("DISPLAY");
  before_ = display == nullptr ? "" : display;
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

Xvfb::~Xvfb() {
  setenv("DISPLAY", before_.c_str(), 1);
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
}

}  // namespace scatter::test
