#include "lod/solver_iterations.h"

#include <algorithm>
#include <cmath>

namespace scatter::lod {

int iterationsLeftOut(double units, double budget, double each, int usual) {
  // Four of ten still hold up what ten have held up in the step before, whose impulses they begin with.
  const int most = std::max(usual, 0) * 3 / 5;
  // A pile whose budget is out of reach is not to be solved badly for long, and for nothing.
  constexpr double kFar = 1.2;
  if (!(units > budget) || !(units - most * each <= kFar * budget) || !(each > 0.0)) return 0;
  return static_cast<int>(std::min(std::ceil((units - budget) / each), static_cast<double>(most)));
}

}  // namespace scatter::lod
