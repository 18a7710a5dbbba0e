#include "lab/page/pose_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "recording/bytes.h"

namespace scatter::lab {

namespace {

constexpr float kTurns = 8192.0F;
constexpr float kMostWhole = 1.0e9F;  // of whole numbers that the page can hold
constexpr std::size_t kNumbers = 7;

using Numbers = std::array<std::int32_t, kNumbers>;

std::int32_t whole(float value) {
  return static_cast<std::int32_t>(std::lround(std::clamp(value, -kMostWhole, kMostWhole)));
}

Numbers numbersOf(const Vec3& position, const Quat& turn, float quantum) {
  return {whole(position.x / quantum), whole(position.y / quantum), whole(position.z / quantum),
          whole(kTurns * turn.x),      whole(kTurns * turn.y),      whole(kTurns * turn.z),
          whole(kTurns * turn.w)};
}

std::uint8_t stateOf(const BlockBody& body) {
  return static_cast<std::uint8_t>(body.level | (body.asleep ? 128U : 0U));
}

// One of a body's numbers from frame to frame; they wrap as the page's 32-bit ones do.
class Predictor {
 public:
  std::int32_t differenceTo(std::int32_t value) {
    const auto now = static_cast<std::uint32_t>(value);
    const std::uint32_t step = now - last_;
    const auto difference = static_cast<std::int32_t>(step - step_);
    step_ = begun_ ? step : 0;
    last_ = now;
    begun_ = true;
    return difference;
  }

 private:
  std::uint32_t last_ = 0;
  std::uint32_t step_ = 0;
  bool begun_ = false;
};

}  // namespace

std::string PoseBlock::encode(float quantum) const {
  recording::ByteWriter states;
  for (std::size_t frame = 0; frame < frames_.size(); ++frame) {
    for (std::size_t body = 0; body < bodies_; ++body) {
      const std::uint8_t before = frame > 0 ? stateOf(frames_[frame - 1][body]) : 0;
      states.byte(stateOf(frames_[frame][body]) ^ before);
    }
  }
  std::array<recording::ByteWriter, kNumbers> runs;
  for (std::size_t body = 0; body < bodies_; ++body) {
    std::array<Predictor, kNumbers> predictors{};
    Quat last = kNoRotation;
    for (const auto& frame : frames_) {
      if (frame[body].level == 0) continue;
      Quat turn = frame[body].pose.rotation;
      if (glm::dot(turn, last) < 0.0F) turn = -turn;
      last = turn;
      const Numbers numbers = numbersOf(frame[body].pose.position, turn, quantum);
      for (std::size_t i = 0; i < kNumbers; ++i) runs[i].difference(predictors[i].differenceTo(numbers[i]));
    }
  }
  for (const recording::ByteWriter& run : runs) states.append(run.view());
  return states.take();
}

}  // namespace scatter::lab
