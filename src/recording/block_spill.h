#pragma once

#include <scatter/result.h>

#include <cstdint>
#include <map>
#include <string>

#include "recording/frame_store.h"
#include "recording/recording_encoder.h"

namespace scatter::recording {

/// Blocks in a file without a name, which goes away with the program; in memory where the disk is full.
class BlockSpill {
 public:
  BlockSpill() = default;
  BlockSpill(const BlockSpill&) = delete;
  BlockSpill& operator=(const BlockSpill&) = delete;
  ~BlockSpill();

  /// A block of frames.
  [[nodiscard]] BlockPlace add(const EncodedBlock& block);

  /// Without its header. Fails if the disk does.
  [[nodiscard]] Result<std::string> read(const BlockPlace& place) const;

  /// Gives its room back.
  void drop(const BlockPlace& place);

  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

  /// Whether the oldest block is to be dropped, as there is no more room.
  [[nodiscard]] bool mustDrop() const { return memoryBytes_ > kMostMemory; }

 private:
  static constexpr std::uint64_t kMostMemory = std::uint64_t{64} << 20U;

  [[nodiscard]] bool write(const std::string& bytes);

  int descriptor_ = -1;
  bool tried_ = false;
  std::uint64_t size_ = 0;  ///< Of the file.
  std::uint64_t bytes_ = 0;
  std::uint64_t memoryBytes_ = 0;
  std::map<std::uint64_t, std::string> memory_;  ///< By the first frame.
};

}  // namespace scatter::recording
