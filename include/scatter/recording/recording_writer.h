#pragma once

#include <scatter/recording/recorded_frame.h>
#include <scatter/recording/recording_info.h>
#include <scatter/result.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace scatter {

/// How many frames a block holds: it ends with whatever comes first. A block begins with a seek point, from
/// which its frames are read, and is what a killed program may lose.
struct RecordingDef {
  std::size_t blockBytes = std::size_t{512} << 10U;       ///< Before they are compressed.
  std::size_t blockBodyFrames = std::size_t{256} << 10U;  ///< Bodies times frames.
  std::uint32_t blockFrames = 1024;
  double blockSeconds = 2.0;  ///< By the clock.
};

/// Writes a recording while a run goes on. Frames are coded, compressed and written by a thread of its own;
/// the caller waits only while that thread is 64 frames behind. The file appears under its name, in the place
/// of an earlier one, at once, and is whole up to its last whole block, however the program ends. Calls are
/// made by one thread.
class RecordingWriter {
 public:
  [[nodiscard]] static Result<std::unique_ptr<RecordingWriter>> create(const std::filesystem::path& file,
                                                                       const RecordingInfo& info,
                                                                       const RecordingDef& def = {});
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// Writes what it has; the recording then has no end, as if the program had been killed.
  ~RecordingWriter();

  /// An empty frame to be filled, and then handed over with add(). Valid until then.
  [[nodiscard]] FrameSample& next();

  /// Fails if an earlier frame could not be written: everything before is kept, and nothing is added any
  /// more.
  [[nodiscard]] Result<void> add();

  /// Writes the rest and the end, and waits until all is on the disk. `stopped` says in a line why there are
  /// no more frames; empty: there were to be no more. Nothing may be added afterwards.
  [[nodiscard]] Result<void> finish(const std::string& stopped = {});

  /// Processor time of the writer's thread until now, seconds.
  [[nodiscard]] double threadSeconds() const;

 private:
  class Worker;
  explicit RecordingWriter(std::unique_ptr<Worker> worker);

  std::unique_ptr<Worker> worker_;
};

}  // namespace scatter
