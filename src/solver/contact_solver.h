#pragma once

#include <span>
#include <vector>

#include "solver/colouring.h"
#include "solver/contact_problem.h"
#include "solver/contact_rows.h"

namespace scatter::solver {

/// Solves contacts with projected Gauss-Seidel as Bullet's solver does, four pairs of bodies at a time:
/// in every iteration all normals, then all friction, and of a pair that has many, a share at a turn. In
/// memory that it keeps from step to step. The same problem gives the same bits. Not for use by two threads
/// at once.
class ContactSolver {
 public:
  struct Impulse {
    float normal;
    float friction[2];
    Quad directions[2];  ///< Of friction, on body a.
  };

  /// Makes rows and starts with the impulses that the points come with. Threads that share the work make no
  /// difference to the bits.
  void begin(const ContactProblem& problem, const ContactSettings& settings,
             const Share& share = shareWithNobody);

  /// One iteration. Returns the square of the most that it has changed any row's speed by, as Bullet's
  /// residual: (metres per second)².
  float solveVelocities();

  /// One iteration of what moves bodies apart and leaves their velocities alone; returns the same of it.
  float solvePushes();

  /// Whether any contact is that deep.
  [[nodiscard]] bool pushes() const { return pushes_; }

  /// What has been added to the bodies' velocities so far, by the bodies' indices; may be changed between
  /// iterations, by who solves other constraints of the same bodies.
  [[nodiscard]] std::span<BodyVelocity> velocities();
  [[nodiscard]] std::span<BodyVelocity> pushVelocities();

  /// Where the rows of a point are.
  struct Place {
    std::size_t row;
    int lane;
  };

  /// Calls `use(point, place)` for every point of the problem that begin() was given, in a batch of pairs.
  template <class Use>
  void forEachPoint(const ContactProblem& problem, std::size_t batch, Use use) const;
  [[nodiscard]] std::size_t countBatches() const { return rows_.batches.size(); }

  [[nodiscard]] Impulse impulseAt(const Place& place) const;

  [[nodiscard]] const Colouring& colouring() const { return colouring_; }

 private:
  /// A share of a batch's rows: the one at `first`, and every `step`-th from there.
  struct Turn {
    int batch;
    int first;
    int step;
  };
  void takeTurns();

  Colouring colouring_;
  ContactRows rows_;
  std::vector<Turn> turns_;  ///< In the order in which they are solved.
  bool clampsFriction_ = true;
  bool pushes_ = false;
};

// In the header, so that what it finds stays in registers.
inline ContactSolver::Impulse ContactSolver::impulseAt(const Place& place) const {
  const auto [row, lane] = place;
  Impulse impulse{rows_.normals[row].impulse[lane], {0.0F, 0.0F}, {}};
  const auto directions = static_cast<std::size_t>(rows_.frictionDirections);
  for (std::size_t i = 0; i < directions; ++i) {
    const Row& friction = rows_.frictions[row * directions + i];
    impulse.friction[i] = friction.impulse[lane];
    impulse.directions[i] = {friction.direction.x[lane], friction.direction.y[lane],
                             friction.direction.z[lane], 0.0F};
  }
  return impulse;
}

template <class Use>
void ContactSolver::forEachPoint(const ContactProblem& problem, std::size_t batch, Use use) const {
  for (int lane = 0; lane < kLanes; ++lane) {
    const int index = colouring_.batches()[batch].pairs[static_cast<std::size_t>(lane)];
    if (index == PairBatch::kNoPair) continue;
    const ContactPair& pair = problem.pairs[static_cast<std::size_t>(index)];
    for (int k = 0; k < pair.count; ++k)
      use(problem.order[static_cast<std::size_t>(pair.first) + static_cast<std::size_t>(k)],
          Place{rows_.batches[batch].first + static_cast<std::size_t>(k), lane});
  }
}

}  // namespace scatter::solver
