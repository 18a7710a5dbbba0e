#include "recording/frame_store.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "recording/checks.h"
#include "recording/frame_coder.h"

namespace scatter::recording {

namespace {

constexpr std::size_t kMostKeptBytes = std::size_t{64} << 20U;

}  // namespace

void FrameStore::dropFirst() {
  assert(!places_.empty());
  const std::uint64_t first = places_.front().first;
  const auto gone =
      std::find_if(kept_.begin(), kept_.end(), [=](const Kept& one) { return one.first == first; });
  if (gone != kept_.end()) {
    keptBytes_ -= gone->bytes;
    kept_.erase(gone);
  }
  places_.pop_front();
}

Result<std::shared_ptr<const RecordedFrame>> FrameStore::frame(std::uint64_t number) {
  const auto after =
      std::upper_bound(places_.begin(), places_.end(), number,
                       [](std::uint64_t one, const BlockPlace& place) { return one < place.first; });
  assert(after != places_.begin() && number < std::prev(after)->end());
  const BlockPlace& place = *std::prev(after);
  return framesOf(place).map([&](std::shared_ptr<const Frames> frames) {
    const RecordedFrame* frame = &(*frames)[static_cast<std::size_t>(number - place.first)];
    return std::shared_ptr<const RecordedFrame>(std::move(frames), frame);
  });
}

Result<std::shared_ptr<const FrameStore::Frames>> FrameStore::framesOf(const BlockPlace& place) {
  const auto known =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& one) { return one.first == place.first; });
  if (known != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, known);
    return kept_.front().frames;
  }
  const auto bytes = fetch_(place);
  if (!bytes) return tl::unexpected(bytes.error());
  auto frames = hashOf(*bytes) == place.hash
                    ? decodeFrames(*bytes, place.first, place.frames,
                                   [this](std::string_view name) -> std::string_view {
                                     return *names_.emplace(name).first;
                                   })
                    : std::nullopt;
  if (!frames) {
    return fail("frames " + std::to_string(place.first) + " to " + std::to_string(place.end() - 1) +
                " are damaged; those before and after can be read");
  }
  auto shared = std::make_shared<const Frames>(std::move(*frames));
  keep(place.first, shared);
  return shared;
}

void FrameStore::keep(std::uint64_t first, std::shared_ptr<const Frames> frames) {
  const std::size_t bytes =
      std::accumulate(frames->begin(), frames->end(), std::size_t{0},
                      [](std::size_t sum, const RecordedFrame& frame) { return sum + frame.bytes(); });
  kept_.push_front({first, bytes, std::move(frames)});
  keptBytes_ += bytes;
  // Two stay, for those who look at a frame and the one before.
  while (keptBytes_ > kMostKeptBytes && kept_.size() > 2) {
    keptBytes_ -= kept_.back().bytes;
    kept_.pop_back();
  }
}

}  // namespace scatter::recording
