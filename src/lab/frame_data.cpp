#include <scatter/lab/frame_data.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

namespace scatter {

FrameData::FrameData(std::size_t capacity) : capacity_(std::max<std::size_t>(capacity, 1)) {}

ChannelId FrameData::addChannel(Channel channel) {
  assert(!channel.name.empty() && !find(channel.name));
  channels_.push_back(std::move(channel));
  // All bits zero is both the number 0 and the hash 0.
  rings_.emplace_back(capacity_, 0);
  return static_cast<ChannelId>(channels_.size() - 1);
}

std::optional<ChannelId> FrameData::find(std::string_view name) const {
  const auto found = std::find_if(channels_.begin(), channels_.end(),
                                  [name](const Channel& channel) { return channel.name == name; });
  if (found == channels_.end()) {
    return std::nullopt;
  }
  return static_cast<ChannelId>(found - channels_.begin());
}

void FrameData::beginFrame() {
  ++framesBegun_;
  for (auto& ring : rings_) {
    ring[slot(0)] = 0;
  }
}

void FrameData::set(ChannelId id, double value) {
  assert(framesBegun_ > 0 && channel(id).kind != ChannelKind::kHash);
  rings_[index(id)][slot(0)] = std::bit_cast<std::uint64_t>(value);
}

void FrameData::setHash(ChannelId id, std::uint64_t value) {
  assert(framesBegun_ > 0 && channel(id).kind == ChannelKind::kHash);
  rings_[index(id)][slot(0)] = value;
}

std::size_t FrameData::available() const {
  return static_cast<std::size_t>(std::min<std::uint64_t>(framesBegun_, capacity_));
}

double FrameData::value(ChannelId id, std::size_t framesAgo) const {
  assert(channel(id).kind != ChannelKind::kHash);
  return std::bit_cast<double>(rings_[index(id)][slot(framesAgo)]);
}

std::uint64_t FrameData::hash(ChannelId id, std::size_t framesAgo) const {
  assert(channel(id).kind == ChannelKind::kHash);
  return rings_[index(id)][slot(framesAgo)];
}

FrameData::Window FrameData::window(ChannelId id, std::size_t frames) const {
  return {*this, id, std::min(frames, available())};
}

std::size_t FrameData::slot(std::size_t framesAgo) const {
  assert(framesAgo < available());
  return static_cast<std::size_t>((framesBegun_ - 1 - framesAgo) % capacity_);
}

}  // namespace scatter
