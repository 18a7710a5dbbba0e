#pragma once

#include <cstdint>
#include <vector>

namespace scatter {

/// How true a run's contacts were to the finest shapes, over its samples (see FidelitySample) and frames.
struct FidelityStatistics {
  int every = 0;              ///< Frames from one sample to the next; 0: not measured, and the rest is empty.
  std::uint64_t samples = 0;  ///< Taken.

  /// Touching pairs of all samples by level, from the finest: [0] at the pair's finest level.
  std::vector<std::uint64_t> touchingByLevel{};

  double visibleOverlapMean = 0.0;  ///< Pairs in a sample.
  std::uint64_t visibleOverlapPeak = 0;
  double visibleOverlapPer100 = 0.0;  ///< Of all samples, per hundred of their touching pairs.

  std::uint64_t contactGaps = 0;  ///< In all samples: one for each pair that touches at a coarser level.
  double contactGapP95 = 0.0;     ///< Metres; 95 % of them are no larger. Zero without any.
  double contactGapMax = 0.0;     ///< Metres.

  /// Metres: the mean over the hybrids at the run's start of the longest side of the box, along the model's
  /// axes, around the finest level's parts. Zero without hybrids.
  double length = 0.0;

  /// Share, 0 to 1, of the touching pairs that are at their finest level: over the frames with touching pairs
  /// if the physics counts them in every frame, else over the samples. 1 if nothing touched.
  double finestShareMean = 1.0;
  double finestShareWorst = 1.0;
  std::uint64_t finestShareWorstFrame = 0;  ///< Counts from 1; 0 if nothing touched.

  /// Metres; the furthest that a dynamic, awake body's centre of mass was moved in one step by anything but
  /// its velocity: |displacement - velocity after the step * time step|. Of every frame.
  double largestJump = 0.0;
  std::uint64_t largestJumpFrame = 0;

  /// The impact: the hundred frames that follow the one with the most kinetic energy, which counts from 1; 0
  /// without frames. Its share of touching pairs at their finest level, and of its samples the rest; a run
  /// that is mostly at rest hides it in its means.
  std::uint64_t impactFrame = 0;
  double impactFinestShare = 1.0;
  double impactContactGapP95 = 0.0;  ///< Metres.
  double impactVisibleOverlapPer100 = 0.0;

  /// After the last frame: the root mean square distance, metres, of the hybrids' centres of mass from their
  /// mean; and the mean kinetic energy, joules, of the last hundred frames.
  double pileRadius = 0.0;
  double kineticEnergyEnd = 0.0;

  [[nodiscard]] std::uint64_t touchingPairs() const;    ///< Of all samples.
  [[nodiscard]] double share(std::size_t below) const;  ///< Of those, so many levels below the finest.
  [[nodiscard]] double contactGapP95Percent() const;    ///< Of `length`.
};

}  // namespace scatter
