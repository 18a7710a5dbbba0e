#include "pairs/contact_credit.h"

#include <algorithm>

namespace scatter::pairs {

void addCredit(void* manifold, float credit, Manifolds& engine, bool eases) {
  for (int i = 0; i < engine.countPoints(manifold); ++i) {
    ContactPoint point = engine.point(manifold, i);
    point.distance += credit;
    point.eased = eases;
    engine.write(manifold, i, point);
  }
}

void endCredit(void* manifold, Manifolds& engine) {
  for (int i = 0; i < engine.countPoints(manifold); ++i) {
    ContactPoint point = engine.point(manifold, i);
    if (point.distance < 0.0F || !point.eased) continue;
    point.eased = false;
    engine.write(manifold, i, point);
  }
}

float pressNow(const void* manifold, const Manifolds& engine) {
  float most = 0.0F;
  for (int i = 0; i < engine.countPoints(manifold); ++i) {
    if (engine.point(manifold, i).presses) most = std::max(most, -engine.distanceNow(manifold, i));
  }
  return most;
}

}  // namespace scatter::pairs
