#include "lab/fidelity_recorder.h"

#include <scatter/lab/recorder.h>
#include <scatter/lab/summary.h>

#include "lab/model_length.h"
#include "lab/pile_size.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace scatter {

std::uint64_t FidelityStatistics::touchingPairs() const {
  return std::accumulate(touchingByLevel.begin(), touchingByLevel.end(), std::uint64_t{0});
}

double FidelityStatistics::share(std::size_t below) const {
  const std::uint64_t all = touchingPairs();
  if (all == 0 || below >= touchingByLevel.size()) {
    return 0.0;
  }
  return static_cast<double>(touchingByLevel[below]) / static_cast<double>(all);
}

double FidelityStatistics::contactGapP95Percent() const {
  return length > 0.0 ? 100.0 * contactGapP95 / length : 0.0;
}

namespace lab {

namespace {

constexpr double kGapShare = 0.95;

// As many as the end of a run is judged by. Of the fleet, the time from the first contacts to the densest
// pile.
constexpr std::uint64_t kImpactFrames = 100;

ChannelId addSampled(FrameData& data, const char* name, const char* unit, ChannelKind kind) {
  return data.addChannel({.name = name, .unit = unit, .kind = kind, .sampled = true});
}

template <class Shares>
double meanShare(const Shares& shares) {
  double sum = 0.0;
  for (const auto& share : shares) {
    sum += share.finest;
  }
  return sum / static_cast<double>(shares.size());
}

double meanLength(const World& world) {
  double sum = 0.0;
  int count = 0;
  for (const auto& object : world.objects()) {
    if (const auto* levels = std::get_if<std::shared_ptr<const LevelSet>>(&object->def().shape)) {
      sum += modelLength(**levels);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace

FidelityRecorder::FidelityRecorder(World& world, FrameData& data, int every)
    : world_(world),
      data_(data),
      visible_(addSampled(data, "visible_overlap_pairs", "", ChannelKind::kInteger)),
      gap_(addSampled(data, "contact_gap_p95", "m", ChannelKind::kReal)),
      touching_(addSampled(data, "sampled_touching_pairs", "", ChannelKind::kInteger)),
      finest_(addSampled(data, "sampled_finest_pairs", "", ChannelKind::kInteger)),
      jump_(data.addChannel({.name = "largest_jump", .unit = "m", .kind = ChannelKind::kReal})) {
  assert(every > 0);
  statistics_.every = every;
  statistics_.length = meanLength(world);
}

void FidelityRecorder::beforeStep() {
  centers_.clear();
  for (const auto& object : world_.objects()) {
    if (object->def().motion == Motion::kDynamic) {
      centers_.emplace_back(object->body(), object->state().centerOfMass);
    }
  }
  const auto byBody = [](const auto& a, const auto& b) { return a.first < b.first; };
  if (!std::is_sorted(centers_.begin(), centers_.end(), byBody)) {
    std::sort(centers_.begin(), centers_.end(), byBody);
  }
}

void FidelityRecorder::afterStep() {
  if (world_.frame() % static_cast<std::uint64_t>(statistics_.every) == 0) {
    sample();
  } else {
    skipStep();
  }
  measureJumps();
  energies_.push_back(world_.physics().kineticEnergy());
  const StepCounters& counters = world_.physics().counters();
  countFinestShare(counters.touchingFinestPairs, counters.touchingPairs);
}

void FidelityRecorder::skipStep() {
  for (const ChannelId id : {visible_, gap_, touching_, finest_}) {
    data_.set(id, std::numeric_limits<double>::quiet_NaN());
  }
}

void FidelityRecorder::sample() {
  const FidelitySample sample = world_.physics().diagnostics().measureFidelity();
  const std::uint32_t finest = sample.touchingByLevel.empty() ? 0 : sample.touchingByLevel.front();
  const std::vector<double> gaps(sample.contactGaps.begin(), sample.contactGaps.end());
  data_.set(visible_, sample.visibleOverlapPairs);
  data_.set(gap_, nearestRank(gaps, kGapShare));
  data_.set(touching_, sample.touchingPairs);
  data_.set(finest_, finest);

  samples_.push_back({.frame = world_.frame(),
                      .visible = sample.visibleOverlapPairs,
                      .touching = sample.touchingPairs,
                      .firstGap = gaps_.size()});
  ++statistics_.samples;
  visibleTotal_ += sample.visibleOverlapPairs;
  statistics_.visibleOverlapPeak =
      std::max<std::uint64_t>(statistics_.visibleOverlapPeak, sample.visibleOverlapPairs);
  gaps_.insert(gaps_.end(), gaps.begin(), gaps.end());
  auto& byLevel = statistics_.touchingByLevel;
  byLevel.resize(std::max(byLevel.size(), sample.touchingByLevel.size()));
  for (std::size_t i = 0; i < sample.touchingByLevel.size(); ++i) {
    byLevel[i] += sample.touchingByLevel[i];
  }
  // Physics that does not count them in every step leaves the counter at zero.
  if (world_.physics().counters().touchingPairs == 0) {
    countFinestShare(finest, sample.touchingPairs);
  }
}

void FidelityRecorder::countFinestShare(std::uint32_t finest, std::uint32_t touching) {
  if (touching == 0) {
    return;
  }
  const double share = static_cast<double>(finest) / touching;
  shares_.push_back({.frame = world_.frame(), .finest = share});
  if (statistics_.finestShareWorstFrame == 0 || share < statistics_.finestShareWorst) {
    statistics_.finestShareWorst = share;
    statistics_.finestShareWorstFrame = world_.frame();
  }
}

void FidelityRecorder::measureJumps() {
  double largest = 0.0;
  for (const auto& object : world_.objects()) {
    const BodyId body = object->body();
    const auto before = std::lower_bound(centers_.begin(), centers_.end(), body,
                                         [](const auto& entry, BodyId id) { return entry.first < id; });
    // The program may have added or moved objects when it heard of the step.
    if (before == centers_.end() || before->first != body) {
      continue;
    }
    const BodyState after = object->state();
    if (after.asleep) {
      continue;
    }
    const Vec3 jump =
        after.centerOfMass - before->second - after.linearVelocity * static_cast<float>(kStepSeconds);
    largest = std::max(largest, static_cast<double>(glm::length(jump)));
  }
  data_.set(jump_, largest);
  if (largest > statistics_.largestJump) {
    statistics_.largestJump = largest;
    statistics_.largestJumpFrame = world_.frame();
  }
}

FidelityStatistics FidelityRecorder::statistics() const {
  FidelityStatistics statistics = statistics_;
  const auto touching = static_cast<double>(statistics.touchingPairs());
  const auto visible = static_cast<double>(visibleTotal_);
  if (statistics.samples > 0) {
    statistics.visibleOverlapMean = visible / static_cast<double>(statistics.samples);
  }
  statistics.visibleOverlapPer100 = touching > 0.0 ? 100.0 * visible / touching : 0.0;
  statistics.contactGaps = gaps_.size();
  statistics.contactGapP95 = nearestRank(gaps_, kGapShare);
  statistics.contactGapMax = nearestRank(gaps_, 1.0);
  if (!shares_.empty()) {
    statistics.finestShareMean = meanShare(shares_);
  }
  addImpact(statistics);
  statistics.pileRadius = pileSize(world_).radius;
  statistics.kineticEnergyEnd = meanOfLast(energies_);
  return statistics;
}

void FidelityRecorder::addImpact(FidelityStatistics& statistics) const {
  if (energies_.empty()) {
    return;
  }
  const auto most = std::max_element(energies_.begin(), energies_.end());
  const auto first = static_cast<std::uint64_t>(most - energies_.begin()) + 1;
  const auto isImpact = [first](std::uint64_t frame) {
    return frame >= first && frame < first + kImpactFrames;
  };
  std::vector<Share> shares;
  std::copy_if(shares_.begin(), shares_.end(), std::back_inserter(shares),
               [&](const Share& share) { return isImpact(share.frame); });
  std::vector<double> gaps;
  double visible = 0.0;
  double touching = 0.0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (isImpact(samples_[i].frame)) {
      const std::size_t end = i + 1 < samples_.size() ? samples_[i + 1].firstGap : gaps_.size();
      gaps.insert(gaps.end(), gaps_.begin() + static_cast<std::ptrdiff_t>(samples_[i].firstGap),
                  gaps_.begin() + static_cast<std::ptrdiff_t>(end));
      visible += samples_[i].visible;
      touching += samples_[i].touching;
    }
  }
  statistics.impactFrame = first;
  statistics.impactFinestShare = shares.empty() ? 1.0 : meanShare(shares);
  statistics.impactContactGapP95 = nearestRank(std::move(gaps), kGapShare);
  statistics.impactVisibleOverlapPer100 = touching > 0.0 ? 100.0 * visible / touching : 0.0;
}

}  // namespace lab

}  // namespace scatter
