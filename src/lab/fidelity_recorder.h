#pragma once

#include <scatter/lab/fidelity.h>
#include <scatter/lab/frame_data.h>
#include <scatter/world/world.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace scatter::lab {

/// Measures fidelity around the steps of a world and records it in channels of its own:
/// visible_overlap_pairs, contact_gap_p95, sampled_touching_pairs and sampled_finest_pairs in the frames that
/// are sampled, largest_jump in all. Changes nothing in the world.
class FidelityRecorder {
 public:
  /// Samples every so many frames, at least 1. World and data must outlive it.
  FidelityRecorder(World& world, FrameData& data, int every);

  void beforeStep();  ///< After the scene's update.
  void afterStep();   ///< Fills the frame that the step began.
  void skipStep();    ///< Instead of afterStep(): leaves the frame without a sample.

  /// Of the frames until now.
  [[nodiscard]] FidelityStatistics statistics() const;

 private:
  void sample();
  void countFinestShare(std::uint32_t finest, std::uint32_t touching);
  void measureJumps();
  void addImpact(FidelityStatistics& statistics) const;

  /// Of a frame that was sampled.
  struct Sample {
    std::uint64_t frame = 0;
    std::uint32_t visible = 0;
    std::uint32_t touching = 0;
    std::size_t firstGap = 0;  ///< In gaps_, up to the next sample's.
  };

  /// Of a frame with touching pairs.
  struct Share {
    std::uint64_t frame = 0;
    double finest = 0.0;
  };

  World& world_;
  FrameData& data_;
  ChannelId visible_;
  ChannelId gap_;
  ChannelId touching_;
  ChannelId finest_;
  ChannelId jump_;
  FidelityStatistics statistics_;
  std::uint64_t visibleTotal_ = 0;
  std::vector<double> gaps_;
  std::vector<Sample> samples_;
  std::vector<Share> shares_;
  std::vector<double> energies_;                  ///< Kinetic, by frame.
  std::vector<std::pair<BodyId, Vec3>> centers_;  ///< Before the step, by body.
};

}  // namespace scatter::lab
