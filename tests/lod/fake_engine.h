#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "lod/cost_model.h"
#include "lod/governor.h"

namespace scatter::lod::testing {

/// Random numbers that are the same on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  double exponential();

 private:
  std::mt19937_64 engine_;
};

/// How a pair of the fake engine behaves. Steps count from the world's first one.
struct FakePair {
  int born = 0;
  int touches = -1;     ///< When it comes into contact; -1: never.
  int gone = 1 << 30;   ///< When its bounds part.
  double finest = 1.0;  ///< Units a step at the finest level, touching, at rest.
  std::uint8_t kind = 0;
  std::uint8_t levels = 3;
  float importance = 1.0F;
  std::uint8_t atLeast = 1;
  std::uint8_t atMost = 255;
};

struct FakeDef {
  std::uint64_t seed = 1;
  double noise = 0.2;    ///< Share by which a pair's cost wavers from step to step.
  double spike = 0.05;   ///< Chance of a step in which a pair costs twice as much.
  double blocked = 0.2;  ///< Chance that a switch which overlap can prevent is not safe.
  double fixed = 300.0;  ///< Units besides the pairs.
  std::function<double(int step)> activity{};  ///< What all costs are multiplied by.
  GovernorDef governor{};
};

struct FakeStep {
  double units = 0.0;
  double planned = 0.0;
  int coarser = 0;  ///< Switches of pairs that were there before.
  int finer = 0;
  int touching = 0;
  int touchingFinest = 0;
  int reused = 0;  ///< Pairs that kept their contacts, because the step was short.
};

/// Stands for a physics engine: a few thousand pairs whose true costs the governor cannot know. As in the
/// real one, a pair that touches at its finest level can only be made cheaper on credit, and less so than one
/// that came into contact coarsely.
class FakeEngine {
 public:
  FakeEngine(const FakeDef& def, std::vector<FakePair> script);

  /// One step under a budget; infinite for none.
  FakeStep step(double budget);

  [[nodiscard]] const std::vector<PlannedPair>& pairs() const { return pairs_; }
  [[nodiscard]] const FakePair& scriptOf(std::size_t pair) const { return script_[owners_[pair]]; }
  [[nodiscard]] const Governor& governor() const { return governor_; }

 private:
  void removeGone();
  void addBorn(FakeStep& result);
  double process(PlannedPair& pair, const FakePair& script, FakeStep& result);
  [[nodiscard]] bool mayReuse(const PlannedPair& pair, const FakePair& script);
  double switchTo(PlannedPair& pair, FakeStep& result);
  double trueUnits(const PlannedPair& pair, const FakePair& script);

  FakeDef def_;
  std::vector<FakePair> script_;
  Random random_;
  CostModel costs_{CostWeights{}};
  Governor governor_;
  std::vector<PlannedPair> pairs_;
  std::vector<std::size_t> owners_;  ///< By pair: its script.
  std::vector<int> reused_;          ///< By script: steps in a row.
  std::size_t nextBorn_ = 0;
  int step_ = 0;
};

/// A pile that forms: pairs come up over `growth` steps, most of them touch some steps later.
[[nodiscard]] std::vector<FakePair> makePile(int pairs, int growth, std::uint64_t seed);

/// Pairs that are there from the start and touch at once.
[[nodiscard]] std::vector<FakePair> makeClump(int pairs, std::uint64_t seed);

}  // namespace scatter::lod::testing
