#pragma once

#include <vector>

#include "solver/colouring.h"
#include "solver/contact_problem.h"
#include "solver/share.h"

namespace scatter::solver {

/// Velocities of a body, or changes of them.
struct alignas(32) BodyVelocity {
  Quad linear{};
  Quad angular{};
};

/// One direction in which contacts of four pairs are solved: an impulse along `direction` on body a, its
/// opposite on body b.
struct Row {
  LaneVector direction;
  LaneVector leverA;  ///< Arm × direction: what a spin adds to the speed along the direction.
  LaneVector leverB;  ///< The same for b, with its sign.
  LaneVector spinA;   ///< What an impulse of 1 adds to the spin of a.
  LaneVector spinB;
  Lanes inverse;  ///< Impulse that changes the speed by 1; 0 in lanes without a contact.
  Lanes target;   ///< Impulse that would do without any other row.
  Lanes impulse;  ///< So far.
};

/// Contacts of four pairs, one of each.
struct NormalRow : Row {
  Lanes softness;
  Lanes friction;
  Lanes pushTarget;  ///< As target, of what moves bodies apart and leaves their velocities alone.
  Lanes push;        ///< So far.
};

/// The rows of a batch of pairs, and its bodies.
struct BatchRows {
  LaneVector massA{};  ///< What an impulse of 1 adds to the velocity of a.
  LaneVector massB{};
  std::array<int, kLanes> a{};  ///< Of the velocities.
  std::array<int, kLanes> b{};
  std::size_t first = 0;  ///< Of the normal rows, and, times the directions, of those of friction.
  int count = 0;
  bool bothMove = false;
  bool pushes = false;  ///< Some row has a push target.
};

/// All rows of a problem, and the velocities that they change.
struct ContactRows {
  std::vector<BatchRows> batches;
  std::vector<NormalRow> normals;
  std::vector<Row> frictions;
  int frictionDirections = 1;

  /// Changes since the step began, and what moves bodies apart without being velocity. In front of the bodies
  /// there is one for each lane that nothing is to be made of.
  std::vector<BodyVelocity> velocities;
  std::vector<BodyVelocity> pushes;

  static constexpr std::size_t kIdle = kLanes;  ///< Velocities in front of the bodies'.

  /// Makes rows of contacts: [Catto 2005, "Iterative Dynamics with Temporal Coherence"], and in all choices
  /// (restitution, error reduction, split impulses, friction directions) as Bullet makes them.
  void build(const ContactProblem& problem, const Colouring& colouring, const ContactSettings& settings,
             const Share& share);

 private:
  void place(const Colouring& colouring);
};

}  // namespace scatter::solver
