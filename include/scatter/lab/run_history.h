#pragma once

#include <scatter/lab/frame_data.h>
#include <scatter/recording/recording.h>
#include <scatter/result.h>
#include <scatter/world/world.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace scatter {

struct HistoryDef {
  /// Of disk that the frames may take, in a file without a name in $TMPDIR or /var/tmp; where that is full,
  /// they take 64 MB of memory. A frame takes about 8 bytes for each body that moves, and 250: of 300 bodies,
  /// 4 GiB hold 18 hours of overload.
  std::uint64_t bytes = std::uint64_t{4} << 30U;
  bool pairLevels = false;          ///< Whether record() keeps the pairs that it is given.
  std::uint32_t blockFrames = 120;  ///< As RecordingDef has it.
};

/// What the loop keeps of a run, so that it can be looked at again, in the format of recordings: where every
/// body was, to a tenth of a millimetre, its level, whether it slept, what happened to levels, and the frame
/// data. It takes some dozen megabytes of memory, however long the run is. When it is full, the oldest frames
/// go.
class RunHistory {
 public:
  explicit RunHistory(const HistoryDef& def = {});

  /// A recording, to be looked at and nothing else: record() and clear() must not be called. Fails as
  /// Recording::open() does.
  [[nodiscard]] static Result<std::unique_ptr<RunHistory>> open(const std::filesystem::path& recording);

  /// What was opened; null if nothing was.
  [[nodiscard]] const Recording* replayed() const;

  RunHistory(const RunHistory&) = delete;
  RunHistory& operator=(const RunHistory&) = delete;
  ~RunHistory();

  /// Keeps the world as it is after its last step. Each call follows one step after the call before it; the
  /// first one after clear() may come at any frame. Frames that are not in a whole block yet are always kept.
  void record(const World& world, std::span<const PairLevel> pairs = {}, const FrameData* data = nullptr);
  void clear();

  [[nodiscard]] bool empty() const;
  [[nodiscard]] std::size_t size() const;      ///< Frames.
  [[nodiscard]] std::uint64_t oldest() const;  ///< World::frame(); not if empty.
  [[nodiscard]] std::uint64_t newest() const;
  [[nodiscard]] bool has(std::uint64_t frame) const;
  [[nodiscard]] std::uint64_t bytes() const;  ///< Of disk, or of memory where the disk is full.
  [[nodiscard]] const HistoryDef& def() const;

  /// Changes the bound; the oldest frames go if there are too many now.
  void setBytes(std::uint64_t bytes);

  class Frame;
  /// From oldest() to newest(). What cannot be read any more is shown as the newest frame.
  [[nodiscard]] Frame frame(std::uint64_t number) const;

  /// What a body that any of the frames names was made from, also if it has gone since; else null.
  [[nodiscard]] const BodyDef* def(BodyId body) const;

  /// Writes a recording of the oldest frame to the newest one, which goes on with every frame that comes; up
  /// to its last whole block it is there however the program ends. Fails if the file cannot be written. Not
  /// while another one is written.
  [[nodiscard]] Result<void> startRecording(const std::filesystem::path& file, const RecordingInfo& info);

  /// Writes the rest and the end. Fails if any of it could not be written; what is in the file stays.
  /// `stopped` as RecordingWriter::finish() has it.
  [[nodiscard]] Result<void> stopRecording(const std::string& stopped = {});
  [[nodiscard]] bool isRecording() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// One frame, to be read. Its events' names live as long as the history.
class RunHistory::Frame {
 public:
  explicit Frame(std::shared_ptr<const RecordedFrame> frame) : frame_(std::move(frame)) {}

  [[nodiscard]] std::uint64_t number() const { return frame_->number; }

  /// In the order in which they were added to the world; the index below counts in it.
  [[nodiscard]] std::span<const BodyId> bodies() const { return *frame_->roster; }
  [[nodiscard]] std::optional<std::size_t> find(BodyId body) const;
  [[nodiscard]] const Transform& pose(std::size_t index) const { return frame_->bodies[index].pose; }
  [[nodiscard]] int level(std::size_t index) const { return frame_->bodies[index].level; }  ///< At most 127.
  [[nodiscard]] bool asleep(std::size_t index) const { return frame_->bodies[index].asleep; }
  [[nodiscard]] std::span<const LevelEvent> events() const { return frame_->events; }
  [[nodiscard]] std::span<const PairLevel> pairs() const { return frame_->pairs; }

 private:
  std::shared_ptr<const RecordedFrame> frame_;
};

}  // namespace scatter
