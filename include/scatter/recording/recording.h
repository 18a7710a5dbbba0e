#pragma once

#include <scatter/recording/recorded_frame.h>
#include <scatter/recording/recording_info.h>
#include <scatter/result.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace scatter {

/// A recording that is read, at any frame and in any order. It keeps some dozen megabytes, whatever its
/// length. One thread at a time.
class Recording {
 public:
  /// Reads what is needed to find frames. A file that a killed or interrupted program has left, or that is
  /// damaged behind its first frames, is opened with what is whole before that: see damage(). Fails if the
  /// file cannot be read, is no recording, or has no whole frame.
  [[nodiscard]] static Result<std::unique_ptr<Recording>> open(const std::filesystem::path& file);

  /// Whether a file begins as recordings do.
  [[nodiscard]] static bool isOne(const std::filesystem::path& file);

  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  ~Recording();

  [[nodiscard]] const RecordingInfo& info() const;
  [[nodiscard]] std::uint64_t first() const;  ///< The number of a frame, as World::frame().
  [[nodiscard]] std::uint64_t last() const;
  [[nodiscard]] bool has(std::uint64_t frame) const { return frame >= first() && frame <= last(); }

  /// From first() to last(). Fails if it is damaged.
  [[nodiscard]] Result<std::shared_ptr<const RecordedFrame>> frame(std::uint64_t number) const;

  /// What a body was made from, as far as it is needed to show it: name, shape, mesh, motion and mass; null
  /// if the recording does not say.
  [[nodiscard]] const BodyDef* def(BodyId body) const;

  /// Such as "ship-12", or "body 7" if it has no name.
  [[nodiscard]] std::string nameOf(BodyId body) const;

  /// Why the run ended before its last frame, in a line; empty if it did not, or nobody could say.
  [[nodiscard]] const std::string& stopped() const;

  /// What is not whole, in a line; empty if all is. A recording that is still written has no end, too.
  [[nodiscard]] const std::string& damage() const;

  [[nodiscard]] std::uint64_t bytes() const;     ///< Of the file, as far as it is whole.
  [[nodiscard]] std::size_t seekPoints() const;  ///< Blocks.
  [[nodiscard]] const std::filesystem::path& file() const;

 private:
  struct Parts;
  explicit Recording(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace scatter
