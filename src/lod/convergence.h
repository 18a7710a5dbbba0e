#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "collision/frame.h"
#include "lod/situation.h"

namespace scatter::lod {

/// Pairs of bodies that are going to come near each other within Convergence::kHorizon steps.
struct PairsToCome {
  double foreseen = 0.0;  ///< As bodies move now.
  double expected = 0.0;  ///< The same, if as many come of them as did of those that were foreseen before.
};

/// Foresees how many pairs a pile is going to have, from which bodies are on their way to each other: that of
/// an implosion, of a heap that something falls into. Clock-free, deterministic.
class Convergence {
 public:
  /// Steps that are looked ahead: two seconds of sixtieths, about what bodies take from the distance at which
  /// nothing overlaps yet to a pile that has all its pairs.
  static constexpr int kHorizon = 120;

  /// Whether the next advance() is to be given bodies, as it is every kInterval steps. What is foreseen from
  /// them is known after the last of these, as each has its share of the work.
  [[nodiscard]] bool isDue() const { return step_ == 0; }

  /// Once a step. `bodies`: all of them, if isDue(). `timeStep`: seconds.
  void advance(std::span<const BodyView> bodies, float timeStep);

  [[nodiscard]] const PairsToCome& pairsToCome() const { return toCome_; }

 private:
  static constexpr int kInterval = 8;
  static constexpr std::size_t kLooks = kHorizon / kInterval;

  /// A body as a ball.
  struct Ball {
    Vec3 center;
    Vec3 velocity;
    float radius;
    bool isMoving;
  };

  /// Pairs of which at least one body moves: those that are near each other, and those that are going to be.
  struct Look {
    double near = 0.0;
    double foreseen = 0.0;
  };

  void begin(std::span<const BodyView> bodies, float seconds);
  void follow();
  [[nodiscard]] Look lookFrom(std::size_t ball) const;
  void learn();

  int step_ = 0;                     ///< Of the look that is made.
  float seconds_ = 0.0F;             ///< What it looks ahead.
  std::vector<Ball> balls_;          ///< Of the bodies that can be moved, as they were when it began.
  std::vector<std::size_t> moving_;  ///< Those of them that move.
  Look look_;                        ///< From those that it has followed.
  std::array<Look, kLooks> looks_{};
  std::size_t numLooks_ = 0;  ///< Ever.
  double foreseen_ = 0.0;  ///< Pairs, of looks that are as long ago as they look ahead, the late ones most;
  double came_ = 0.0;      ///< and by how many there were more in the end.
  PairsToCome toCome_;
};

}  // namespace scatter::lod
