#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scatter {

enum class ChannelKind : std::uint8_t {
  kReal,
  kInteger,  ///< Counts and booleans (0 or 1), exact up to 2^53.
  kHash,     ///< 64 bits, written as 16 hexadecimal digits.
};

struct Channel {
  std::string name;  ///< A column name, such as "physics_ms".
  std::string unit;  ///< Such as "ms"; empty for a plain number.
  ChannelKind kind = ChannelKind::kReal;

  /// Measured in some frames only: in the others it is not a number, and an empty cell in a file.
  bool sampled = false;
};

/// Names a channel of a FrameData.
enum class ChannelId : std::uint32_t {};

/// What is recorded per frame, kept in a ring buffer that any component reads back while the program runs
/// (report, section 4.3). One thread at a time.
class FrameData {
 public:
  /// Keeps the last `capacity` frames, at least one.
  explicit FrameData(std::size_t capacity);

  /// The name must be new. Frames before now read as zero in the new channel.
  ChannelId addChannel(Channel channel);
  [[nodiscard]] std::optional<ChannelId> find(std::string_view name) const;
  [[nodiscard]] const std::vector<Channel>& channels() const { return channels_; }
  [[nodiscard]] const Channel& channel(ChannelId id) const { return channels_[index(id)]; }

  /// Starts the next frame, with zero in every channel; the oldest frame falls out of a full buffer.
  void beginFrame();

  /// For a real or integer channel of the current frame; beginFrame() comes first.
  void set(ChannelId id, double value);
  void setHash(ChannelId id, std::uint64_t value);

  [[nodiscard]] std::uint64_t framesBegun() const { return framesBegun_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }

  /// Frames that can be read back: framesAgo is less than this.
  [[nodiscard]] std::size_t available() const;

  /// 0 is the current frame, 1 the one before it.
  [[nodiscard]] double value(ChannelId id, std::size_t framesAgo = 0) const;
  [[nodiscard]] std::uint64_t hash(ChannelId id, std::size_t framesAgo = 0) const;

  /// The last `frames` values of a channel, or as many as there are, oldest first, for a range-based for.
  class Window;
  [[nodiscard]] Window window(ChannelId id, std::size_t frames) const;

 private:
  [[nodiscard]] static std::size_t index(ChannelId id) { return static_cast<std::size_t>(id); }
  [[nodiscard]] std::size_t slot(std::size_t framesAgo) const;

  std::size_t capacity_;
  std::uint64_t framesBegun_ = 0;
  std::vector<Channel> channels_;
  std::vector<std::vector<std::uint64_t>> rings_;  // the bits of a double, or a hash
};

/// Invalid after the next beginFrame().
class FrameData::Window {
 public:
  class Iterator {
   public:
    Iterator(const FrameData& data, ChannelId id, std::size_t left) : data_(&data), id_(id), left_(left) {}
    double operator*() const { return data_->value(id_, left_ - 1); }
    Iterator& operator++() {
      --left_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return left_ == other.left_; }

   private:
    const FrameData* data_;
    ChannelId id_;
    std::size_t left_;
  };

  Window(const FrameData& data, ChannelId id, std::size_t frames) : data_(data), id_(id), frames_(frames) {}
  [[nodiscard]] Iterator begin() const { return {data_, id_, frames_}; }
  [[nodiscard]] Iterator end() const { return {data_, id_, 0}; }
  [[nodiscard]] std::size_t size() const { return frames_; }

 private:
  const FrameData& data_;
  ChannelId id_;
  std::size_t frames_;
};

}  // namespace scatter
