#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace scatter::recording {

/// What a file begins with; changes when blocks are written in another way.
inline constexpr std::string_view kFileStart{"\x89SCATREC\r\n\x1a\n\x01\0\0\0", 16};

enum class BlockKind : std::uint8_t {
  kInfo = 1,    ///< The recording's; the first block.
  kBodies = 2,  ///< What bodies of the frames after it are made from.
  kFrames = 3,  ///< Frames that can be read without others.
  kEnd = 4,     ///< Why there are no more: nothing, or a line.
};

/// Comes before a block's bytes.
struct BlockHeader {
  BlockKind kind = BlockKind::kFrames;
  std::uint64_t first = 0;   ///< The number of the first frame.
  std::uint32_t frames = 0;  ///< 0 unless it is one of frames.
  std::uint32_t size = 0;    ///< Of what comes after the header.
  std::uint64_t hash = 0;    ///< hashOf() that.
};

inline constexpr std::size_t kHeaderBytes = 40;

/// Header and content in one.
[[nodiscard]] std::string makeBlock(BlockKind kind, std::uint64_t first, std::uint32_t frames,
                                    std::string_view content);

/// Nothing if the bytes are not those of a header.
[[nodiscard]] std::optional<BlockHeader> readHeader(std::string_view bytes);

}  // namespace scatter::recording
