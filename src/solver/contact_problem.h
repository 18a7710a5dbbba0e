#pragma once

#include <span>
#include <vector>

#include "solver/lanes.h"

namespace scatter::solver {

/// A body as a solver of contacts needs it. In metres, seconds, kilograms, in the world's frame.
struct ContactBody {
  Quad center{};       ///< Of mass; w: inverse mass.
  Quad velocity{};     ///< Before this step's forces.
  Quad spin{};         ///< The same, radians per second.
  Quad force{};        ///< What this step's forces add to the velocity.
  Quad torque{};       ///< What they add to the spin.
  Quad inertia[3]{};   ///< Rows of the inverse inertia.
  Quad linear{};       ///< What an impulse is multiplied by: inverse mass, and the factors of locked axes.
  Quad angular{};      ///< Factors of locked axes of rotation.
  bool moves = false;  ///< Impulses change its velocity.
};

/// A contact of bodies a and b.
struct ProblemPoint {
  Quad onA{};     ///< Place on a; w: distance, less than 0 in each other, metres.
  Quad onB{};     ///< Place on b; w: combined friction.
  Quad normal{};  ///< From b to a; w: combined restitution.
  Quad law{};     ///< Impulse to begin with, newton seconds; softness (Bullet's cfm); error reduction; 1.
};

/// All contacts of two bodies.
struct ContactPair {
  int a;  ///< Moves.
  int b;
  int first;  ///< Of ContactProblem::order.
  int count;  ///< More than 0.
};

/// What is to be solved, in plain numbers: an engine fills it in each step.
struct ContactProblem {
  std::vector<ContactBody> bodies;
  std::span<ProblemPoint> points;  ///< In any order; those of other problems may be among them. Not owned.
  std::vector<ContactPair> pairs;  ///< No two of the same bodies.
  std::vector<int> order;          ///< The points of the pairs, one pair's after another's.

  void clear();
};

/// As Bullet's btContactSolverInfo has them.
struct ContactSettings {
  float timeStep = 1.0F / 60;
  float relaxation = 1.0F;            ///< Of all rows.
  float restitutionThreshold = 0.2F;  ///< Metres per second: slower contacts do not bounce.
  float slop = 0.0F;                  ///< Added to distances, metres.
  bool splits = true;                 ///< Error reduction moves bodies and leaves their velocities alone…
  float splitDepth = -0.04F;          ///< …where they are deeper in each other than this distance, metres.
  int frictionDirections = 1;         ///< 1 or 2.
  bool followsVelocity = true;        ///< The first is that of the contact's velocity.

  /// Friction of a contact that bears nothing is nothing. Without it such a contact keeps the friction of
  /// the iteration before, as in Bullet, where a slab on many contacts sticks on slopes that are too steep.
  bool clampsFriction = true;
};

}  // namespace scatter::solver
