#pragma once

namespace scatter::app {

/// Thrown between frames, never within a step, by commands that write nothing before their end.
struct Interrupted {};

/// From now on the first SIGINT or SIGTERM only sets a mark; a second one ends the program at once.
void catchInterrupts();

/// The signal that set the mark; 0 if none did.
[[nodiscard]] int interruptingSignal();

/// Throws Interrupted if the mark is set.
void throwIfInterrupted();

}  // namespace scatter::app
