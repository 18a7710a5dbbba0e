#include "recording/pose_track.h"

#include <scatter/recording/recorded_frame.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace scatter::recording {

namespace {

constexpr std::int64_t kFurthest = std::int64_t{1} << 50U;
constexpr std::int32_t kOne = 32768;
// Further than any orientation is from what is expected.
constexpr std::int64_t kMostDifference = 4 * std::int64_t{kOne};
constexpr std::int64_t kOneSquared = std::int64_t{kOne} * kOne;

// What follows from the other three may differ by so much from what was measured.
constexpr std::int32_t kTolerance = 3;

using Rotation = std::array<std::int32_t, 4>;

std::int64_t stored(float metres, std::int64_t before) {
  if (!std::isfinite(metres)) return before;
  const double units = static_cast<double>(metres) / static_cast<double>(kRecordedMetres);
  const auto most = static_cast<double>(kFurthest);
  return static_cast<std::int64_t>(std::nearbyint(std::clamp(units, -most, most)));
}

Rotation stored(const Quat& q, const Rotation& before) {
  const std::array<float, 4> parts{q.w, q.x, q.y, q.z};
  double length = 0.0;
  for (const float part : parts) length += static_cast<double>(part) * static_cast<double>(part);
  if (!std::isfinite(length) || length < 1e-6) return before;
  Rotation rotation{};
  std::int64_t along = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    rotation[i] =
        static_cast<std::int32_t>(std::nearbyint(static_cast<double>(parts[i]) / std::sqrt(length) * kOne));
    along += std::int64_t{rotation[i]} * before[i];
  }
  // Both signs are the same orientation: the nearer one is easier to expect.
  if (along < 0) {
    for (std::int32_t& part : rotation) part = -part;
  }
  return rotation;
}

std::size_t largestOf(const Rotation& rotation) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (std::abs(rotation[i]) > std::abs(rotation[largest])) largest = i;
  }
  return largest;
}

// The number that makes the length of all four one, without its sign.
std::int32_t completed(const Rotation& rotation, std::size_t missing) {
  std::int64_t left = kOneSquared;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i != missing) left -= std::int64_t{rotation[i]} * rotation[i];
  }
  return left <= 0 ? 0 : static_cast<std::int32_t>(std::nearbyint(std::sqrt(static_cast<double>(left))));
}

std::int32_t bounded(std::int64_t part) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(part, -kOne, kOne));
}

}  // namespace

Transform StoredPose::pose() const {
  Transform pose;
  for (int i = 0; i < 3; ++i) {
    pose.position[i] = static_cast<float>(static_cast<double>(position[static_cast<std::size_t>(i)]) *
                                          static_cast<double>(kRecordedMetres));
  }
  const double scale = 1.0 / kOne;
  const auto part = [&](std::size_t i) { return static_cast<float>(rotation[i] * scale); };
  pose.rotation = glm::normalize(Quat(part(0), part(1), part(2), part(3)));
  return pose;
}

StoredPose PoseTrack::expected() const {
  StoredPose pose;
  for (std::size_t i = 0; i < 3; ++i) pose.position[i] = 2 * last_.position[i] - before_.position[i];
  for (std::size_t i = 0; i < 4; ++i) {
    pose.rotation[i] = bounded(2 * std::int64_t{last_.rotation[i]} - before_.rotation[i]);
  }
  return pose;
}

void PoseTrack::moveTo(const StoredPose& pose) {
  before_ = last_;
  last_ = pose;
}

bool PoseTrack::write(const Transform& pose, ByteWriter& positions, ByteWriter& rotations) {
  const StoredPose guess = expected();
  StoredPose now;
  now.rotation = stored(pose.rotation, last_.rotation);
  const std::size_t missing = largestOf(guess.rotation);
  const std::int32_t size = completed(now.rotation, missing);
  const std::int32_t follows = guess.rotation[missing] < 0 ? -size : size;
  if (std::abs(follows - now.rotation[missing]) > kTolerance) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    now.position[i] = stored(pose.position[static_cast<int>(i)], last_.position[i]);
    positions.difference(now.position[i] - guess.position[i]);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (i != missing) rotations.difference(now.rotation[i] - guess.rotation[i]);
  }
  now.rotation[missing] = follows;
  moveTo(now);
  return true;
}

void PoseTrack::read(ByteReader& positions, ByteReader& rotations) {
  StoredPose now = expected();
  const std::size_t missing = largestOf(now.rotation);
  const bool negative = now.rotation[missing] < 0;
  for (std::int64_t& part : now.position) {
    part = std::clamp(part + std::clamp(positions.difference(), -4 * kFurthest, 4 * kFurthest), -kFurthest,
                      kFurthest);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (i != missing) {
      now.rotation[i] =
          bounded(now.rotation[i] + std::clamp(rotations.difference(), -kMostDifference, kMostDifference));
    }
  }
  const std::int32_t size = completed(now.rotation, missing);
  now.rotation[missing] = negative ? -size : size;
  moveTo(now);
}

void PoseTrack::begin(const Transform& pose, ByteWriter& positions, ByteWriter& rotations) {
  for (std::size_t i = 0; i < 3; ++i) {
    last_.position[i] = stored(pose.position[static_cast<int>(i)], last_.position[i]);
    positions.difference(last_.position[i]);
  }
  last_.rotation = stored(pose.rotation, last_.rotation);
  for (const std::int32_t part : last_.rotation) rotations.difference(part);
  before_ = last_;
}

void PoseTrack::readBegin(ByteReader& positions, ByteReader& rotations) {
  for (std::int64_t& part : last_.position) {
    part = std::clamp(positions.difference(), -kFurthest, kFurthest);
  }
  for (std::int32_t& part : last_.rotation) part = bounded(rotations.difference());
  if (last_.rotation == Rotation{}) last_.rotation = StoredPose{}.rotation;
  before_ = last_;
}

}  // namespace scatter::recording
