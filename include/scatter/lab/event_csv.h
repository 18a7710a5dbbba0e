#pragma once

#include <scatter/result.h>
#include <scatter/world/level_event.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace scatter {

class AtomicFile;

/// A LevelEvent and the frame, from 1, in which it happened.
struct FrameEvent {
  std::uint64_t frame = 0;
  LevelEvent event;
};

/// Streams level events to a CSV file: frame, kind, scope, policy, body, other, from, to, on_credit. Bodies
/// are BodyIds; `other` is 0 where a body switches for all its pairs. The file appears under its name only in
/// finish(); until then it has a temporary name beside it, which is removed on any error and when this is
/// destroyed.
class EventCsv {
 public:
  [[nodiscard]] static Result<EventCsv> create(const std::filesystem::path& file);

  EventCsv(EventCsv&&) noexcept;
  EventCsv& operator=(EventCsv&&) noexcept;
  ~EventCsv();

  [[nodiscard]] Result<void> write(std::uint64_t frame, std::span<const LevelEvent> events);

  /// Moves the file to its name; nothing may be written afterwards.
  [[nodiscard]] Result<void> finish();

 private:
  explicit EventCsv(std::unique_ptr<AtomicFile> file);

  std::unique_ptr<AtomicFile> file_;
};

/// The same file from a whole run at once.
[[nodiscard]] Result<void> writeEventCsv(const std::filesystem::path& file,
                                         const std::vector<FrameEvent>& events);

}  // namespace scatter
