#include "interrupt.h"

#include <csignal>

namespace scatter::app {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void mark(int signal) {
  interrupted = signal;
}

}  // namespace

void catchInterrupts() {
  struct sigaction action {};
  action.sa_handler = mark;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int interruptingSignal() {
  return interrupted;
}

void throwIfInterrupted() {
  if (interrupted != 0) {
    throw Interrupted();
  }
}

}  // namespace scatter::app
