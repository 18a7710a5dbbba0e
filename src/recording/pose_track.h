#pragma once

#include <scatter/math.h>

#include <array>
#include <cstdint>
#include <optional>

#include "recording/bytes.h"

namespace scatter::recording {

/// A pose in whole numbers of kRecordedMetres and kRecordedTurn. Predictions are made of such numbers alone,
/// so that every machine makes the same.
struct StoredPose {
  std::array<std::int64_t, 3> position{};
  std::array<std::int32_t, 4> rotation{32768, 0, 0, 0};  ///< w, x, y, z.

  [[nodiscard]] Transform pose() const;
  bool operator==(const StoredPose&) const = default;
};

/// Where a body was in the last two frames, from which follows where it is expected: it goes on as it did.
/// Writer and reader each have one for every body, and tell it the same.
class PoseTrack {
 public:
  /// Writes where the body is and turns to, as the difference from what is expected, which `positions` and
  /// `rotations` get. False if the orientation cannot be told so: it must be written with begin(). A number
  /// that is not finite is stored as what it was before.
  [[nodiscard]] bool write(const Transform& pose, ByteWriter& positions, ByteWriter& rotations);

  /// The same for a body whose way is not known, or that has turned too far.
  void begin(const Transform& pose, ByteWriter& positions, ByteWriter& rotations);

  /// Reads what write() wrote.
  void read(ByteReader& positions, ByteReader& rotations);

  /// Reads what begin() wrote.
  void readBegin(ByteReader& positions, ByteReader& rotations);

  /// The body has not moved.
  void rest() { before_ = last_; }

  [[nodiscard]] const StoredPose& last() const { return last_; }

 private:
  [[nodiscard]] StoredPose expected() const;
  void moveTo(const StoredPose& pose);

  StoredPose last_{};
  StoredPose before_{};
};

}  // namespace scatter::recording
