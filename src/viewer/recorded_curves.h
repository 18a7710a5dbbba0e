#pragma once

#include <scatter/recording/recording.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace scatter::viewer {

/// The frame data of a recording, frame after frame. It is read a little at a time, so that the window of a
/// long recording opens at once.
class RecordedCurves {
 public:
  /// The recording must outlive it.
  explicit RecordedCurves(const Recording& recording);

  /// Reads on for about so long. Ends where the recording is damaged.
  void readFor(double milliseconds);

  [[nodiscard]] bool isWhole() const { return next_ > recording_.last(); }
  [[nodiscard]] std::uint64_t frames() const { return recording_.last() - recording_.first() + 1; }
  [[nodiscard]] std::uint64_t framesRead() const { return next_ - recording_.first(); }

  /// Those that are numbers, as indices of the recording's channels.
  [[nodiscard]] const std::vector<std::size_t>& channels() const { return channels_; }

  /// Whether a frame that was read has contacts, or pairs.
  [[nodiscard]] bool hasContacts() const { return hasContacts_; }

  /// Of the frames that were read, from the first one on; empty if no channel with numbers has that name.
  [[nodiscard]] std::span<const float> values(std::string_view channel) const;

 private:
  void take(const RecordedFrame& frame);

  bool hasContacts_ = false;

  const Recording& recording_;
  std::uint64_t next_;  ///< The frame that is read next.
  std::vector<std::size_t> channels_;
  std::vector<std::vector<float>> values_;  ///< By the recording's channels.
};

/// The largest of each so many values, the last of which may be fewer.
[[nodiscard]] std::vector<float> mostOfEach(std::span<const float> values, std::size_t each);

}  // namespace scatter::viewer
