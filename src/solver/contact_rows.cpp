#include "solver/contact_rows.h"

#include <limits>

namespace scatter::solver {

namespace {

constexpr float kTiny = 1e-30F;

/// Squared lateral speed from which on friction follows it, as in Bullet.
constexpr float kStill = std::numeric_limits<float>::epsilon();

/// Above it a normal is nearly the z axis, and another axis is used to find what is across it: as in Bullet.
constexpr float kHalfRoot = 0.70710678F;

// A lane without a contact: what comes of it is 0.
constexpr ProblemPoint kNothing{};

/// The bodies of one side of four pairs.
struct BodyLanes {
  LaneVector center;
  Lanes mass;  ///< Inverse.
  LaneVector velocity;
  LaneVector spin;
  LaneVector force;
  LaneVector torque;
  LaneVector inertia[3];
  LaneVector linear;
  LaneVector angular;

  [[nodiscard]] LaneVector turnedBy(const LaneVector& lever) const {
    return LaneVector{dot(inertia[0], lever), dot(inertia[1], lever), dot(inertia[2], lever)} * angular;
  }
};

LaneVector vectorOf(const std::array<const ContactBody*, kLanes>& bodies, Quad ContactBody::*field) {
  return transposed(lanes(bodies[0]->*field), lanes(bodies[1]->*field), lanes(bodies[2]->*field),
                    lanes(bodies[3]->*field))
      .v;
}

void gather(const std::array<const ContactBody*, kLanes>& bodies, BodyLanes& all) {
  const LaneQuad center = transposed(lanes(bodies[0]->center), lanes(bodies[1]->center),
                                     lanes(bodies[2]->center), lanes(bodies[3]->center));
  all.center = center.v;
  all.mass = center.w;
  all.velocity = vectorOf(bodies, &ContactBody::velocity);
  all.spin = vectorOf(bodies, &ContactBody::spin);
  all.force = vectorOf(bodies, &ContactBody::force);
  all.torque = vectorOf(bodies, &ContactBody::torque);
  for (int i = 0; i < 3; ++i) {
    all.inertia[i] = transposed(lanes(bodies[0]->inertia[i]), lanes(bodies[1]->inertia[i]),
                                lanes(bodies[2]->inertia[i]), lanes(bodies[3]->inertia[i]))
                         .v;
  }
  all.linear = vectorOf(bodies, &ContactBody::linear);
  all.angular = vectorOf(bodies, &ContactBody::angular);
}

LaneQuad gather(const std::array<const ProblemPoint*, kLanes>& points, Quad ProblemPoint::*field) {
  return transposed(lanes(points[0]->*field), lanes(points[1]->*field), lanes(points[2]->*field),
                    lanes(points[3]->*field));
}

/// Some direction across a unit vector, as Bullet's btPlaneSpace1 chooses it.
LaneVector across(const LaneVector& n) {
  const Lanes zero{};
  const Lanes one = lanes(1.0F);
  const Lanes yz = n.y * n.y + n.z * n.z;
  const Lanes xy = n.x * n.x + n.y * n.y;
  const Lanes scaleYz = one / root(atLeast(yz, lanes(kTiny)));
  const Lanes scaleXy = one / root(atLeast(xy, lanes(kTiny)));
  return choose(magnitude(n.z) > lanes(kHalfRoot), LaneVector{zero, -n.z * scaleYz, n.y * scaleYz},
                LaneVector{-n.y * scaleXy, n.x * scaleXy, zero});
}

class BatchBuilder {
 public:
  BatchBuilder(const ContactProblem& problem, const PairBatch& pairs, const ContactSettings& settings,
               ContactRows& rows, BatchRows& batch)
      : problem_(problem),
        pairs_(pairs),
        settings_(settings),
        rows_(rows),
        batch_(batch),
        perSecond_(lanes(1.0F / settings.timeStep)) {}

  void run() {
    placeBodies();
    batch_.massA = a_.linear;
    batch_.massB = b_.linear;
    for (int i = 0; i < batch_.count; ++i) {
      findPoints(i);
      buildNormal(rows_.normals[batch_.first + static_cast<std::size_t>(i)]);
      buildFriction(batch_.first + static_cast<std::size_t>(i));
    }
  }

 private:
  void placeBodies() {
    std::array<const ContactBody*, kLanes> a{};
    std::array<const ContactBody*, kLanes> b{};
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const bool isIdle = pairs_.pairs[lane] == PairBatch::kNoPair;
      const ContactPair& pair =
          problem_.pairs[static_cast<std::size_t>(isIdle ? pairs_.pairs[0] : pairs_.pairs[lane])];
      a[lane] = &problem_.bodies[static_cast<std::size_t>(pair.a)];
      b[lane] = &problem_.bodies[static_cast<std::size_t>(pair.b)];
      const auto idle = static_cast<int>(lane);
      batch_.a[lane] = isIdle ? idle : pair.a + static_cast<int>(ContactRows::kIdle);
      batch_.b[lane] = isIdle || !b[lane]->moves ? idle : pair.b + static_cast<int>(ContactRows::kIdle);
    }
    gather(a, a_);
    gather(b, b_);
  }

  void findPoints(int row) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      points_[lane] = &kNothing;
      if (pairs_.pairs[lane] == PairBatch::kNoPair) continue;
      const ContactPair& pair = problem_.pairs[static_cast<std::size_t>(pairs_.pairs[lane])];
      if (row >= pair.count) continue;
      const int point = problem_.order[static_cast<std::size_t>(pair.first) + static_cast<std::size_t>(row)];
      points_[lane] = &problem_.points[static_cast<std::size_t>(point)];
    }
  }

  // What has the geometry of a row; returns the denominator of its effective mass.
  Lanes place(const LaneVector& direction, Row& row) const {
    row.direction = direction;
    row.leverA = cross(armA_, direction);
    row.leverB = -cross(armB_, direction);
    const LaneVector turnA = a_.turnedBy(row.leverA);
    const LaneVector turnB = b_.turnedBy(row.leverB);
    row.spinA = turnA * a_.angular;
    row.spinB = turnB * b_.angular;
    return a_.mass + dot(direction, cross(turnA, armA_)) + b_.mass + dot(direction, cross(-turnB, armB_));
  }

  [[nodiscard]] Lanes bounce(const Lanes& restitution, const LaneVector& normal) const {
    const LaneVector between = a_.velocity + cross(a_.spin, armA_) - b_.velocity - cross(b_.spin, armB_);
    const Lanes speed = dot(normal, between);
    const Lanes zero{};
    return magnitude(speed) < lanes(settings_.restitutionThreshold) ? zero
                                                                    : atLeast(-restitution * speed, zero);
  }

  void buildNormal(NormalRow& row) {
    const Lanes zero{};
    const LaneQuad onA = gather(points_, &ProblemPoint::onA);
    const LaneQuad onB = gather(points_, &ProblemPoint::onB);
    const LaneQuad normal = gather(points_, &ProblemPoint::normal);
    const LaneQuad law = gather(points_, &ProblemPoint::law);
    isContact_ = law.w > zero;
    armA_ = onA.v - a_.center;
    armB_ = onB.v - b_.center;
    const Lanes softness = law.v.y * perSecond_;
    row.inverse = lanes(settings_.relaxation) / (place(normal.v, row) + softness);
    row.inverse = isContact_ ? row.inverse : zero;
    row.softness = softness * row.inverse;
    row.friction = onB.w;
    row.impulse = isContact_ ? law.v.x : zero;
    const LaneVector a = a_.velocity + a_.force + cross(a_.spin + a_.torque, armA_);
    const LaneVector b = b_.velocity + b_.force + cross(b_.spin + b_.torque, armB_);
    between_ = a - b;
    speed_ = dot(normal.v, between_);
    aim(row, onA.w + lanes(settings_.slop), bounce(normal.w, normal.v) - speed_, law.v.z);
  }

  // Bodies that are apart may come as near as they are; bodies in each other are to leave each other.
  void aim(NormalRow& row, const Lanes& distance, const Lanes& change, const Lanes& reduction) {
    const Lanes zero{};
    const LaneMask isApart = distance > zero;
    const Lanes velocity = (isApart ? change - distance * perSecond_ : change) * row.inverse;
    const Lanes error = isApart ? zero : -distance * reduction * perSecond_ * row.inverse;
    const LaneMask isJoined = distance > lanes(settings_.splits ? settings_.splitDepth : -1e30F);
    row.target = isContact_ ? (isJoined ? error + velocity : velocity) : zero;
    row.pushTarget = isContact_ ? (isJoined ? zero : error) : zero;
    row.push = zero;
    for (int lane = 0; lane < kLanes; ++lane) batch_.pushes = batch_.pushes || row.pushTarget[lane] != 0.0F;
  }

  void buildFriction(std::size_t normalIndex) {
    const NormalRow& normal = rows_.normals[normalIndex];
    const LaneVector lateral = between_ - normal.direction * speed_;
    const Lanes lateral2 = dot(lateral, lateral);
    const LaneMask follows = settings_.followsVelocity ? lateral2 > lanes(kStill) : LaneMask{};
    const LaneVector along = lateral * (lanes(1.0F) / root(atLeast(lateral2, lanes(kTiny))));
    LaneVector direction = choose(follows, along, across(normal.direction));
    const auto directions = static_cast<std::size_t>(rows_.frictionDirections);
    for (std::size_t i = 0; i < directions; ++i) {
      if (i == 1) {
        const LaneVector other = cross(direction, normal.direction);
        direction = choose(follows, other, -other);
      }
      slow(direction, rows_.frictions[normalIndex * directions + i]);
    }
  }

  void slow(const LaneVector& direction, Row& row) const {
    const Lanes zero{};
    row.inverse = lanes(settings_.relaxation) / place(direction, row);
    row.inverse = isContact_ ? row.inverse : zero;
    const Lanes speed = dot(direction, a_.velocity + a_.force) + dot(row.leverA, a_.spin) -
                        dot(direction, b_.velocity + b_.force) + dot(row.leverB, b_.spin);
    row.target = isContact_ ? -speed * row.inverse : zero;
    row.impulse = zero;
  }

  const ContactProblem& problem_;
  const PairBatch& pairs_;
  const ContactSettings& settings_;
  ContactRows& rows_;
  BatchRows& batch_;
  Lanes perSecond_;
  BodyLanes a_{};
  BodyLanes b_{};
  std::array<const ProblemPoint*, kLanes> points_{};
  LaneMask isContact_{};
  LaneVector armA_{};
  LaneVector armB_{};
  LaneVector between_{};  ///< Velocity of a as seen from b, this step's forces included.
  Lanes speed_{};         ///< Of it, along the normal.
};

void add(BodyVelocity& to, const LaneVector& linear, const LaneVector& angular, float impulse,
         std::size_t lane) {
  to.linear.x += linear.x[lane] * impulse;
  to.linear.y += linear.y[lane] * impulse;
  to.linear.z += linear.z[lane] * impulse;
  to.angular.x += angular.x[lane] * impulse;
  to.angular.y += angular.y[lane] * impulse;
  to.angular.z += angular.z[lane] * impulse;
}

// Gives the bodies what the rows begin with. Of a body in several batches, the order decides about the bits.
void warmStart(const BatchRows& batch, const std::vector<NormalRow>& normals,
               std::vector<BodyVelocity>& velocities) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    BodyVelocity a = velocities[static_cast<std::size_t>(batch.a[lane])];
    BodyVelocity b = velocities[static_cast<std::size_t>(batch.b[lane])];
    for (int i = 0; i < batch.count; ++i) {
      const NormalRow& row = normals[batch.first + static_cast<std::size_t>(i)];
      if (!(row.impulse[lane] != 0.0F)) continue;
      add(a, row.direction * batch.massA, row.spinA, row.impulse[lane], lane);
      add(b, -(row.direction * batch.massB), row.spinB, row.impulse[lane], lane);
    }
    if (batch.a[lane] >= kLanes) velocities[static_cast<std::size_t>(batch.a[lane])] = a;
    if (batch.b[lane] >= kLanes) velocities[static_cast<std::size_t>(batch.b[lane])] = b;
  }
}

}  // namespace

// Room for the rows of all batches.
void ContactRows::place(const Colouring& colouring) {
  batches.resize(colouring.batches().size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < batches.size(); ++i) {
    const PairBatch& pairs = colouring.batches()[i];
    batches[i] = BatchRows{};
    batches[i].first = count;
    batches[i].count = pairs.rows;
    batches[i].bothMove = pairs.bothMove;
    count += static_cast<std::size_t>(pairs.rows);
  }
  normals.resize(count);
  frictions.resize(count * static_cast<std::size_t>(frictionDirections));
}

void ContactRows::build(const ContactProblem& problem, const Colouring& colouring,
                        const ContactSettings& settings, const Share& share) {
  frictionDirections = settings.frictionDirections;
  place(colouring);
  velocities.assign(problem.bodies.size() + kIdle, {});
  pushes.assign(problem.bodies.size() + kIdle, {});
  shareBatches(batches.size(), share, [&](std::size_t i) {
    BatchBuilder(problem, colouring.batches()[i], settings, *this, batches[i]).run();
  });
  for (const BatchRows& batch : batches) warmStart(batch, normals, velocities);
}

}  // namespace scatter::solver
