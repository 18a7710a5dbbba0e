#include "solver/contact_solver.h"

#include <algorithm>

namespace scatter::solver {

namespace {

/// A pair with many contacts is solved a share at a time, with all others in between: what it bears reaches
/// the ends of a stack in one iteration. Of 1, 2, 4, 8, 16 and 32, eight turns is from where stacks of 20
/// wheels
/// (`scatter run` of the family wheel_stack) lie a millimetre deep in the place of eight, for the same time;
/// of shares of at least 1, 2, 3 and 4 contacts, three is from where implosions, with a few a pair, cost no
/// more.
constexpr int kTurns = 8;
constexpr int kLeastShare = 3;

/// Velocities of the bodies of one side of four pairs.
struct Motion {
  LaneVector linear;
  LaneVector angular;
};

Motion load(const std::vector<BodyVelocity>& all, const std::array<int, kLanes>& bodies) {
  const auto at = [&](int lane) -> const BodyVelocity& {
    return all[static_cast<std::size_t>(bodies[static_cast<std::size_t>(lane)])];
  };
  return {
      transposed(lanes(at(0).linear), lanes(at(1).linear), lanes(at(2).linear), lanes(at(3).linear)).v,
      transposed(lanes(at(0).angular), lanes(at(1).angular), lanes(at(2).angular), lanes(at(3).angular)).v};
}

void write(const LaneVector& vectors, std::vector<BodyVelocity>& all, const std::array<int, kLanes>& bodies,
           Quad BodyVelocity::*field) {
  const LaneQuad each = transposed(vectors.x, vectors.y, vectors.z, Lanes{});
  const Lanes* const of[] = {&each.v.x, &each.v.y, &each.v.z, &each.w};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    solver::store(*of[lane], all[static_cast<std::size_t>(bodies[lane])].*field);
  }
}

void store(const Motion& motion, std::vector<BodyVelocity>& all, const std::array<int, kLanes>& bodies) {
  write(motion.linear, all, bodies, &BodyVelocity::linear);
  write(motion.angular, all, bodies, &BodyVelocity::angular);
}

/// Four pairs' bodies while their rows are solved one after another.
template <bool BothMove>
class Sweep {
 public:
  Sweep(const BatchRows& batch, std::vector<BodyVelocity>& all)
      : batch_(batch), all_(all), a_(load(all, batch.a)), b_(BothMove ? load(all, batch.b) : Motion{}) {}

  void finish() {
    if constexpr (BothMove) store(b_, all_, batch_.b);
    store(a_, all_, batch_.a);
  }

  void solveNormal(NormalRow& row) {
    const Lanes wanted = row.target - row.impulse * row.softness - speed(row) * row.inverse;
    change(row, row.impulse, atLeast(row.impulse + wanted, Lanes{}));
  }

  void solvePush(NormalRow& row) {
    const Lanes zero{};
    const Lanes wanted = row.pushTarget - row.push * row.softness - speed(row) * row.inverse;
    change(row, row.push, row.pushTarget != zero ? atLeast(row.push + wanted, zero) : row.push);
  }

  void solveFriction(Row& row, const NormalRow& normal, bool clamps) {
    const Lanes wanted = row.impulse + row.target - speed(row) * row.inverse;
    const Lanes most = normal.friction * normal.impulse;
    const Lanes allowed = atMost(atLeast(wanted, -most), most);
    change(row, row.impulse, clamps ? allowed : normal.impulse > Lanes{} ? allowed : row.impulse);
  }

  [[nodiscard]] const Lanes& most() const { return most_; }

 private:
  [[nodiscard]] Lanes speed(const Row& row) const {
    const Lanes a = dot(row.direction, a_.linear) + dot(row.leverA, a_.angular);
    if constexpr (!BothMove) return a;
    return a - dot(row.direction, b_.linear) + dot(row.leverB, b_.angular);
  }

  void change(const Row& row, Lanes& impulse, const Lanes& next) {
    const Lanes by = next - impulse;
    impulse = next;
    a_.linear = a_.linear + row.direction * batch_.massA * by;
    a_.angular = a_.angular + row.spinA * by;
    if constexpr (BothMove) {
      b_.linear = b_.linear - row.direction * batch_.massB * by;
      b_.angular = b_.angular + row.spinB * by;
    }
    // A lane without a contact has no inverse and no change.
    most_ = atLeast(most_, magnitude(by) / atLeast(row.inverse, lanes(1e-30F)));
  }

  const BatchRows& batch_;
  std::vector<BodyVelocity>& all_;
  Motion a_;
  Motion b_;
  Lanes most_{};
};

template <bool BothMove>
Lanes sweepNormals(ContactRows& rows, const BatchRows& batch, int first, int step) {
  Sweep<BothMove> sweep(batch, rows.velocities);
  NormalRow* const normals = rows.normals.data() + batch.first;
  for (int i = first; i < batch.count; i += step) sweep.solveNormal(normals[i]);
  sweep.finish();
  return sweep.most();
}

template <bool BothMove>
Lanes sweepFrictions(ContactRows& rows, const BatchRows& batch, int first, int step, bool clamps) {
  Sweep<BothMove> sweep(batch, rows.velocities);
  const NormalRow* const normals = rows.normals.data() + batch.first;
  const int directions = rows.frictionDirections;
  Row* const frictions = rows.frictions.data() + batch.first * static_cast<std::size_t>(directions);
  for (int i = first; i < batch.count; i += step) {
    for (int k = 0; k < directions; ++k)
      sweep.solveFriction(frictions[i * directions + k], normals[i], clamps);
  }
  sweep.finish();
  return sweep.most();
}

template <bool BothMove>
Lanes sweepPushes(ContactRows& rows, const BatchRows& batch, int first, int step) {
  Sweep<BothMove> sweep(batch, rows.pushes);
  NormalRow* const normals = rows.normals.data() + batch.first;
  for (int i = first; i < batch.count; i += step) sweep.solvePush(normals[i]);
  sweep.finish();
  return sweep.most();
}

float squaredMost(const Lanes& most) {
  const float value = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  return value * value;
}

}  // namespace

void ContactProblem::clear() {
  bodies.clear();
  points = {};
  pairs.clear();
  order.clear();
}

void ContactSolver::begin(const ContactProblem& problem, const ContactSettings& settings,
                          const Share& share) {
  colouring_.colour(problem);
  rows_.build(problem, colouring_, settings, share);
  takeTurns();
  clampsFriction_ = settings.clampsFriction;
  pushes_ = std::any_of(rows_.batches.begin(), rows_.batches.end(),
                        [](const BatchRows& batch) { return batch.pushes; });
}

// Where no two pairs share a body, nothing can come in between.
void ContactSolver::takeTurns() {
  const int most = colouring_.colours() > 1 ? kTurns : 1;
  turns_.clear();
  for (int first = 0; first < most; ++first) {
    for (std::size_t i = 0; i < rows_.batches.size(); ++i) {
      const int count = rows_.batches[i].count;
      const int step = std::clamp(count / kLeastShare, 1, most);
      if (first < step) turns_.push_back({static_cast<int>(i), first, step});
    }
  }
}

float ContactSolver::solveVelocities() {
  Lanes most{};
  for (const Turn& turn : turns_) {
    const BatchRows& batch = rows_.batches[static_cast<std::size_t>(turn.batch)];
    most = atLeast(most, batch.bothMove ? sweepNormals<true>(rows_, batch, turn.first, turn.step)
                                        : sweepNormals<false>(rows_, batch, turn.first, turn.step));
  }
  for (const Turn& turn : turns_) {
    const BatchRows& batch = rows_.batches[static_cast<std::size_t>(turn.batch)];
    most = atLeast(most, batch.bothMove
                             ? sweepFrictions<true>(rows_, batch, turn.first, turn.step, clampsFriction_)
                             : sweepFrictions<false>(rows_, batch, turn.first, turn.step, clampsFriction_));
  }
  return squaredMost(most);
}

float ContactSolver::solvePushes() {
  Lanes most{};
  for (const Turn& turn : turns_) {
    const BatchRows& batch = rows_.batches[static_cast<std::size_t>(turn.batch)];
    if (!batch.pushes) continue;
    most = atLeast(most, batch.bothMove ? sweepPushes<true>(rows_, batch, turn.first, turn.step)
                                        : sweepPushes<false>(rows_, batch, turn.first, turn.step));
  }
  return squaredMost(most);
}

std::span<BodyVelocity> ContactSolver::velocities() {
  return std::span(rows_.velocities).subspan(ContactRows::kIdle);
}

std::span<BodyVelocity> ContactSolver::pushVelocities() {
  return std::span(rows_.pushes).subspan(ContactRows::kIdle);
}

}  // namespace scatter::solver
