#pragma once

#include <scatter/recording/recorded_frame.h>
#include <scatter/result.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace scatter::recording {

/// Where a block of frames lies.
struct BlockPlace {
  std::uint64_t first = 0;
  std::uint32_t frames = 0;
  std::uint64_t where = 0;  ///< As the fetcher understands it.
  std::uint32_t size = 0;   ///< Without the header.
  std::uint64_t hash = 0;

  [[nodiscard]] std::uint64_t end() const { return first + frames; }
};

/// Frames in blocks, of which those that were looked at last are kept as they were read: whatever the length
/// of the run, some dozen megabytes.
class FrameStore {
 public:
  using Fetch = std::function<Result<std::string>(const BlockPlace&)>;
  explicit FrameStore(Fetch fetch) : fetch_(std::move(fetch)) {}

  /// Follows the block before it.
  void add(const BlockPlace& place) { places_.push_back(place); }
  void dropFirst();
  void dropLast() { places_.pop_back(); }  ///< Nobody has looked at it yet.

  [[nodiscard]] const std::deque<BlockPlace>& places() const { return places_; }

  /// One that a block has. Fails if its block cannot be fetched or is damaged. The frame keeps its block.
  [[nodiscard]] Result<std::shared_ptr<const RecordedFrame>> frame(std::uint64_t number);

 private:
  using Frames = std::vector<RecordedFrame>;
  struct Kept {
    std::uint64_t first = 0;
    std::size_t bytes = 0;
    std::shared_ptr<const Frames> frames;
  };

  [[nodiscard]] Result<std::shared_ptr<const Frames>> framesOf(const BlockPlace& place);
  void keep(std::uint64_t first, std::shared_ptr<const Frames> frames);

  Fetch fetch_;
  std::deque<BlockPlace> places_;
  std::list<Kept> kept_;  // the one that was looked at last in front
  std::size_t keptBytes_ = 0;
  std::set<std::string, std::less<>> names_;
};

}  // namespace scatter::recording
