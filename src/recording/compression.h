#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scatter::recording {

/// Several strings of bytes in one, each compressed where that makes it smaller.
[[nodiscard]] std::string packStreams(std::span<const std::string_view> streams);

/// Nothing unless there are exactly `count`, whole, and of at most `most` bytes together.
[[nodiscard]] std::optional<std::vector<std::string>> unpackStreams(std::string_view packed,
                                                                    std::size_t count, std::size_t most);

/// Bytes as one zstd frame, which says how long they were. Slow, and small.
[[nodiscard]] std::string compressWell(std::string_view bytes);

}  // namespace scatter::recording
