#pragma once

#include <scatter/world/world.h>

#include <memory>

namespace scatter::bench {

/// How tightly the bodies of a world lie together, measured in the same way whatever engine moved them.
struct Pile {
  double radius = 0.0;     ///< Of the ball around the origin that holds nine tenths of the bodies, metres.
  int touchingBodies = 0;  ///< That are within 2 cm of another one.
  int touchingPairs = 0;   ///< Pairs of such bodies.
  int deepPairs = 0;       ///< Pairs that overlap by more than 5 cm.
  double deepest = 0.0;    ///< Overlap, metres.
};

/// Finds every contact of a world's finest shapes afresh with Bullet's detector.
class PileProbe {
 public:
  /// `hasMargins`: the measured engine's solids reach beyond hulls by their levels' margin. Overlaps are
  /// those of the solids that the engine itself keeps apart.
  explicit PileProbe(bool hasMargins);
  ~PileProbe();

  /// Of the dynamic bodies, which must be spheres, boxes or have levels of spheres, boxes and hulls.
  [[nodiscard]] Pile measure(const World& world);

 private:
  class Shapes;

  std::unique_ptr<Shapes> shapes_;
};

}  // namespace scatter::bench
