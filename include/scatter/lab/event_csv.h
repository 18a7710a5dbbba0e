#pragma once

#include <scatter/result.h>
#include <scatter/world/level_event.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace scatter {

class GrowingFile;

/// A LevelEvent and the frame, from 1, in which it happened.
struct FrameEvent {
  std::uint64_t frame = 0;
  LevelEvent event;
};

/// Streams level events to a CSV file: frame, kind, scope, policy, body, other, from, to, on_credit. Bodies
/// are BodyIds; `other` is 0 where a body switches for all its pairs. The file appears under its name, in the
/// place of an earlier one, with the first frame, and always holds all events of whole frames.
class EventCsv {
 public:
  [[nodiscard]] static Result<EventCsv> create(const std::filesystem::path& file);

  EventCsv(EventCsv&&) noexcept;
  EventCsv& operator=(EventCsv&&) noexcept;
  ~EventCsv();

  /// Adds the events of a frame, of which there may be none, or nothing and fails.
  [[nodiscard]] Result<void> write(std::uint64_t frame, std::span<const LevelEvent> events);

  /// Takes the frame away that was written last.
  void dropLast() noexcept;

  /// Waits until all is on the disk. Nothing may be written afterwards.
  [[nodiscard]] Result<void> finish();

 private:
  explicit EventCsv(std::unique_ptr<GrowingFile> file);

  std::unique_ptr<GrowingFile> file_;
  bool hasHeader_ = false;
};

/// The same file from a whole run at once.
[[nodiscard]] Result<void> writeEventCsv(const std::filesystem::path& file,
                                         const std::vector<FrameEvent>& events);

}  // namespace scatter
