#include "lod/fake_engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scatter::lod::testing {
namespace {

// Of what a pair costs: looking for contacts, against solving them.
constexpr double kReuseSaves = 0.4;

// A few pairs cost ten times what the others do.
void drawCost(FakePair& pair, Random& random) {
  constexpr double kUsual = 5.0;
  constexpr double kMost = 50.0;
  pair.kind = static_cast<std::uint8_t>(random.uniform(0.0, 3.0));
  const double usual = kUsual * (0.5 + 0.5 * pair.kind);
  pair.finest = std::min(0.8 + (usual - 0.8) * random.exponential() * random.exponential(), kMost);
}

}  // namespace

double Random::exponential() {
  return -std::log(1.0 - uniform());
}

FakeEngine::FakeEngine(const FakeDef& def, std::vector<FakePair> script)
    : def_(def),
      script_(std::move(script)),
      random_(def.seed),
      governor_(def.governor),
      reused_(script_.size(), 0) {
  std::stable_sort(script_.begin(), script_.end(),
                   [](const FakePair& a, const FakePair& b) { return a.born < b.born; });
}

FakeStep FakeEngine::step(double budget) {
  FakeStep result;
  removeGone();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const FakePair& script = script_[owners_[i]];
    pairs_[i].wish = {script.importance, script.atMost, script.atLeast, 0};
    if (pairs_[i].blockedSteps > 0) --pairs_[i].blockedSteps;
  }
  governor_.plan(pairs_, costs_, def_.fixed, budget);
  result.units = def_.fixed;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    result.units += process(pairs_[i], script_[owners_[i]], result);
  }
  addBorn(result);
  result.planned = governor_.planned();
  governor_.learn(result.units);
  ++step_;
  return result;
}

void FakeEngine::removeGone() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (script_[owners_[i]].gone <= step_) continue;
    pairs_[kept] = pairs_[i];
    owners_[kept++] = owners_[i];
  }
  pairs_.resize(kept);
  owners_.resize(kept);
}

void FakeEngine::addBorn(FakeStep& result) {
  for (; nextBorn_ < script_.size() && script_[nextBorn_].born <= step_; ++nextBorn_) {
    const FakePair& script = script_[nextBorn_];
    PlannedPair pair;
    pair.view.a = static_cast<std::uint32_t>(2 * nextBorn_);
    pair.view.b = pair.view.a + 1;
    pair.view.finest = script.levels;
    pair.identity = static_cast<std::uint32_t>(nextBorn_);
    pair.kind = script.kind;
    pair.wish = {script.importance, script.atMost, script.atLeast, 0};
    pair.target = static_cast<std::uint8_t>(governor_.planNew(pair, costs_));
    result.units += process(pair, script, result);
    pairs_.push_back(pair);
    owners_.push_back(nextBorn_);
  }
}

double FakeEngine::process(PlannedPair& pair, const FakePair& script, FakeStep& result) {
  const double switching = switchTo(pair, result);
  PairView& view = pair.view;
  view.touching = script.touches >= 0 && step_ >= script.touches;
  view.credited = view.credited && view.touching;
  const double full = trueUnits(pair, script);
  const bool reuses = mayReuse(pair, script);
  const double units = reuses ? (1.0 - kReuseSaves) * full : full;
  governor_.spend(switching);
  governor_.spend(pair, units, full);
  const PairUnits learned{.all = units, .onCredit = view.credited && view.level < view.finest};
  if (!reuses) costs_.learn(pair.cost, view.level, view.finest, view.touching, learned);
  result.reused += reuses ? 1 : 0;
  result.touching += view.touching ? 1 : 0;
  result.touchingFinest += view.touching && view.level == view.finest ? 1 : 0;
  return units + switching;
}

/// Not for longer than until the bodies have moved too far against each other.
bool FakeEngine::mayReuse(const PlannedPair& pair, const FakePair& script) {
  constexpr int kMost = 3;
  int& steps = reused_[static_cast<std::size_t>(&script - script_.data())];
  const PairView& view = pair.view;
  const bool may = steps < kMost && view.touching && !view.credited && governor_.isShort();
  steps = may ? steps + 1 : 0;
  return may;
}

double FakeEngine::switchTo(PlannedPair& pair, FakeStep& result) {
  PairView& view = pair.view;
  if (view.level == 0) {
    view.level = pair.target;
    return 0.0;
  }
  if (pair.target == view.level || pair.blockedSteps > 0) return 0.0;
  const bool canWait = pair.target > view.level && view.level >= pair.wish.atLeast && !pair.mustSave;
  if (canWait && governor_.isShort()) return 0.0;
  const CostWeights& weights = costs_.weights();
  const bool isCoarser = pair.target < view.level;
  const bool onCredit = isCoarser && view.touching;
  const int middle = std::min<int>(def_.governor.creditLevel, view.finest - 1);
  const int level = onCredit ? std::max<int>(pair.target, middle) : pair.target;
  // Finer shapes lie within the coarser ones: those of a pair that holds no credit are apart.
  const bool isSure = onCredit || (!isCoarser && !view.credited);
  if ((onCredit && level >= view.level) || (!isSure && random_.uniform() < def_.blocked)) {
    pair.blockedSteps = static_cast<std::uint8_t>(10 + pair.identity % 10);
    return weights.separationQuery;
  }
  view.level = static_cast<std::uint8_t>(level);
  view.credited = onCredit;
  ++(isCoarser ? result.coarser : result.finer);
  return weights.separationQuery + weights.switched;
}

double FakeEngine::trueUnits(const PlannedPair& pair, const FakePair& script) {
  const PairView& view = pair.view;
  const double share = static_cast<double>(view.level - 1) / std::max(1, view.finest - 1);
  double units = 0.1 + 0.7 * share;
  if (view.touching) {
    // A hit is dearer than rest.
    const int since = step_ - script.touches;
    const double finest = script.finest * (1.0 + std::min(since, 5) * 0.2 * std::exp(-0.02 * since));
    units = view.credited ? std::min(finest, 3.0 + 0.3 * finest)
                          : 0.7 + std::max(finest - 0.7, 0.0) * std::pow(share, 4.0);
  }
  const double waver = 1.0 + def_.noise * (2.0 * random_.uniform() - 1.0);
  const double spike = random_.uniform() < def_.spike ? 2.0 : 1.0;
  return units * waver * spike * (def_.activity ? def_.activity(step_) : 1.0);
}

std::vector<FakePair> makePile(int pairs, int growth, std::uint64_t seed) {
  Random random(seed);
  std::vector<FakePair> script;
  for (int i = 0; i < pairs; ++i) {
    FakePair pair;
    const double share = random.uniform();
    // An s-curve: the crowd arrives in the middle.
    pair.born = static_cast<int>(growth * 0.5 * (1.0 + std::cbrt(2.0 * share - 1.0)));
    if (random.uniform() < 0.6) pair.touches = pair.born + 1 + static_cast<int>(random.uniform(0.0, 40.0));
    if (random.uniform() < 0.3) pair.gone = pair.born + 60 + static_cast<int>(random.uniform(0.0, 400.0));
    drawCost(pair, random);
    script.push_back(pair);
  }
  return script;
}

std::vector<FakePair> makeClump(int pairs, std::uint64_t seed) {
  Random random(seed);
  std::vector<FakePair> script(static_cast<std::size_t>(pairs));
  for (FakePair& pair : script) {
    pair.touches = 0;
    drawCost(pair, random);
  }
  return script;
}

}  // namespace scatter::lod::testing
