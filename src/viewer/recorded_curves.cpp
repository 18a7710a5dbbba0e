#include "viewer/recorded_curves.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <limits>

namespace scatter::viewer {

RecordedCurves::RecordedCurves(const Recording& recording)
    : recording_(recording), next_(recording.first()), values_(recording.info().channels.size()) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (recording.info().channels[i].kind != RecordedKind::kHash) channels_.push_back(i);
  }
}

void RecordedCurves::readFor(double milliseconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
  do {
    if (isWhole()) return;
    const auto frame = recording_.frame(next_);
    if (!frame) return;
    take(**frame);
    ++next_;
  } while (Clock::now() < end);
}

void RecordedCurves::take(const RecordedFrame& frame) {
  hasContacts_ = hasContacts_ || !frame.contacts.empty() || !frame.pairs.empty();
  for (const std::size_t channel : channels_) {
    const double value = channel < frame.values.size() ? std::bit_cast<double>(frame.values[channel])
                                                       : std::numeric_limits<double>::quiet_NaN();
    values_[channel].push_back(static_cast<float>(value));
  }
}

std::span<const float> RecordedCurves::values(std::string_view channel) const {
  const auto found = recording_.info().channel(channel);
  return found ? std::span<const float>(values_[*found]) : std::span<const float>();
}

std::vector<float> mostOfEach(std::span<const float> values, std::size_t each) {
  std::vector<float> most;
  for (std::size_t first = 0; first < values.size(); first += each) {
    const auto some = values.subspan(first, std::min(each, values.size() - first));
    most.push_back(*std::max_element(some.begin(), some.end()));
  }
  return most;
}

}  // namespace scatter::viewer
