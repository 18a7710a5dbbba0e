#include "lod/solver_iterations.h"

#include <algorithm>
#include <cmath>

namespace scatter::lod {

int iterationsLeftOut(double excess, double each, int usual) {
  // Four of ten still hold up what ten have held up in the step before, whose impulses they begin with.
  const int most = std::max(usual, 0) * 3 / 5;
  if (!(excess > 0.0) || !(each > 0.0)) return 0;
  return static_cast<int>(std::min(std::ceil(excess / each), static_cast<double>(most)));
}

}  // namespace scatter::lod
