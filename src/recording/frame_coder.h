#pragma once

#include <scatter/recording/recorded_frame.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/bytes.h"
#include "recording/pose_track.h"

namespace scatter::recording {

/// Frames that follow each other, as bytes: each is told by what has changed since the one before, the first
/// one by itself. One thread at a time.
class FrameEncoder {
 public:
  /// The first frame may have any number, each further one has the next.
  void add(const FrameSample& frame);

  [[nodiscard]] std::uint32_t frames() const { return frames_; }
  [[nodiscard]] std::uint64_t first() const { return first_; }

  /// Bodies times frames.
  [[nodiscard]] std::size_t bodyFrames() const { return bodyFrames_; }

  /// Until now, before they are compressed.
  [[nodiscard]] std::size_t bytes() const;

  /// All frames since the last call, compressed.
  [[nodiscard]] std::string take();

 private:
  struct Track {
    BodyId body{};
    bool known = false;
    std::uint8_t state = 0;
    StateBits bits{};
    PoseTrack pose{};
    std::array<std::uint8_t, kStateQuantityCount> checks{};
  };

  void writeRoster(const FrameSample& frame);
  void writeBodies(const FrameSample& frame);
  void writeHashes(const FrameSample& frame);
  void writeEvents(const FrameSample& frame);
  void writeTwo(BodyId a, BodyId b, std::int64_t& before);  // `before`: the first of those before them
  void writePairs(const FrameSample& frame);
  void writeContacts(const FrameSample& frame);
  [[nodiscard]] std::uint64_t indexOf(std::string_view policy);
  [[nodiscard]] std::string planesOfValues() const;

  std::uint32_t frames_ = 0;
  std::uint64_t first_ = 0;
  std::size_t bodyFrames_ = 0;
  std::vector<Track> tracks_;
  std::vector<std::uint8_t> moved_;  // a bit for each body, of the frame before
  std::vector<std::uint8_t> movedBefore_;
  std::vector<std::string_view> policies_;
  std::vector<std::vector<std::uint64_t>> values_;
  ByteWriter structure_;
  ByteWriter positions_;
  ByteWriter rotations_;
  ByteWriter checks_;
  ByteWriter events_;
  ByteWriter contacts_;
};

/// What gives a name of a policy that lives as long as it must.
using NameKeeper = std::function<std::string_view(std::string_view)>;

/// Frames that FrameEncoder::take() gave. Nothing if they are damaged.
[[nodiscard]] std::optional<std::vector<RecordedFrame>> decodeFrames(std::string_view bytes,
                                                                     std::uint64_t first,
                                                                     std::uint32_t frames,
                                                                     const NameKeeper& keepName);

}  // namespace scatter::recording
