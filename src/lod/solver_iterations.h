#pragma once

namespace scatter::lod {

/// The last thing that a budget takes: how many iterations its solver leaves out of a step that is about to
/// exceed the budget by `excess` units, if each takes `each` units, and a step has so many of them as
/// `usual`. As many as are needed, but never more than three in five; 0 of a step that
/// fits.
[[nodiscard]] int iterationsLeftOut(double excess, double each, int usual);

}  // namespace scatter::lod
