#pragma once

#include <scatter/lab/comparison.h>

#include <string>

namespace scatter::lab {

/// What was compared and what came out, in a line, such as "fleet in 2 worlds: the physics of finest took
/// 0.18 of the processor time of standard".
[[nodiscard]] std::string verdict(const Comparison& comparison);

/// The dearest frames, and how many were dearer than a picture can wait for; whole sentences.
[[nodiscard]] std::string verdictDetails(const Comparison& comparison);

}  // namespace scatter::lab
