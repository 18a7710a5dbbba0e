#pragma once

#include <scatter/result.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/atomic_file.h"

namespace scatter::recording {

/// Writes an MCAP file (https://mcap.dev/spec) of JSON messages in chunks that zstd compresses, with all
/// indices, so that programs find any time. The file appears when it is whole.
class McapWriter {
 public:
  [[nodiscard]] static Result<McapWriter> create(const std::filesystem::path& file);

  /// Its number. `schema` is a JSON schema of that name.
  [[nodiscard]] Result<std::uint16_t> addChannel(const std::string& topic, const std::string& schemaName,
                                                 const std::string& schema);

  /// Times must not fall.
  [[nodiscard]] Result<void> write(std::uint16_t channel, std::uint64_t nanoseconds, std::string_view json);

  /// How many bytes the file has.
  [[nodiscard]] Result<std::uint64_t> finish();

 private:
  struct Channel {
    std::uint64_t messages = 0;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> index;  ///< Times and places in this chunk.
  };

  explicit McapWriter(std::unique_ptr<AtomicFile> file) : file_(std::move(file)) {}
  [[nodiscard]] Result<void> put(std::string_view bytes);
  [[nodiscard]] Result<void> endChunk();

  std::unique_ptr<AtomicFile> file_;
  std::uint64_t size_ = 0;
  std::vector<Channel> channels_;
  std::string definitions_;  ///< Schemas and channels, which the end repeats.
  std::string chunkIndices_;
  std::uint32_t chunks_ = 0;
  std::string chunk_;
  std::uint64_t chunkStart_ = 0;
  std::uint64_t start_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace scatter::recording
