#pragma once

namespace scatter::lod {

/// The last thing that a budget takes: how many iterations its solver leaves out of a step that is about to
/// take `units`, more than its `budget`, if each takes `each` units, and a step has so many of them as
/// `usual`. As many as are needed, but never more than three in five; 0 of a step that fits, and of one that
/// would exceed its budget by far all the same.
[[nodiscard]] int iterationsLeftOut(double units, double budget, double each, int usual);

}  // namespace scatter::lod
