#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bodies.h"
#include "grounds.h"

namespace scatter::bench {

enum class WorldKind {
  kPlain,      ///< btDiscreteDynamicsWorld, plain bodies.
  kInstalled,  ///< The same with a btHybridInstallation.
  kHybrid,     ///< btHybridDynamicsWorld, hybrid bodies at their finest level.
  kMultiBody,  ///< btMultiBodyDynamicsWorld, plain bodies.
  kMultiBodyInstalled,
};

struct Trial {
  BodyKind body = BodyKind::kShip;
  int bodies = 0;
  GroundKind ground = GroundKind::kMesh;
  float relief = 0.0F;
  int steps = 0;
  std::uint64_t seed = 1;
  bool oneFriction = false;  ///< Multi-body worlds solve one direction of friction, as discrete ones do.
};

/// What a trial took: processor time of one thread, milliseconds.
struct Cost {
  double total = 0.0;
  double p99 = 0.0;  ///< Of a step.
  double detection = 0.0;
  double bodySteps = 0.0;  ///< Of bodies that were awake.
  double contacts = 0.0;   ///< The mean of a step.
  double asked = 0.0;      ///< Parts that Bullet's own algorithms decided, with the algorithm installed.
  int sunk = 0;            ///< Bodies whose middle is under the ground at the end.
  float deepest = 0.0F;    ///< Contact at the end, metres.
};

[[nodiscard]] Cost run(const Trial& trial, WorldKind kind);

/// Contacts of parts with the ground in fresh worlds, with the bodies where a trial has left them.
struct Contacts {
  int parts = 0;           ///< In contact in Bullet, or with the algorithm installed.
  int missed = 0;          ///< In Bullet alone.
  int missedDeep = 0;      ///< Of those, deeper than 1 mm.
  int extra = 0;           ///< With the algorithm alone.
  int sameCount = 0;       ///< As many points in both.
  double depthP99 = 0.0;   ///< Difference of the deepest points of a part, millimetres.
  double shallower = 0.0;  ///< The most that Bullet has deeper than the algorithm, millimetres.
  int sunk = 0;            ///< Bodies whose middle was under the ground when the trial ended.
  double trueDepth =
      0.0;  ///< The most by which the algorithm's differ from the lowest point of the part; on flat ground.
};

[[nodiscard]] Contacts compareContacts(const Trial& trial);

}  // namespace scatter::bench
