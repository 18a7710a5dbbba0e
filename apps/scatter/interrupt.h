#pragma once

namespace scatter::app {

/// Thrown between frames, never within a step, so that unfinished files are removed on the way out.
struct Interrupted {};

/// From now on the first SIGINT or SIGTERM only sets a mark; a second one ends the program at once.
void catchInterrupts();

/// Throws Interrupted if the mark is set.
void throwIfInterrupted();

}  // namespace scatter::app
