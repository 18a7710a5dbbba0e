#include "recording/block.h"

#include "recording/bytes.h"
#include "recording/checks.h"

namespace scatter::recording {

namespace {

constexpr std::uint32_t kMark = 0x4B4C4253;  // "SBLK"

}  // namespace

std::string makeBlock(BlockKind kind, std::uint64_t first, std::uint32_t frames, std::string_view content) {
  ByteWriter out;
  out.fixed(kMark);
  out.fixed(static_cast<std::uint32_t>(kind));
  out.fixed(first);
  out.fixed(frames);
  out.fixed(static_cast<std::uint32_t>(content.size()));
  out.fixed(hashOf(content));
  out.fixed(hashOf(out.view()));
  out.append(content);
  return out.take();
}

std::optional<BlockHeader> readHeader(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) return std::nullopt;
  ByteReader in(bytes.substr(0, kHeaderBytes));
  const auto mark = in.fixed<std::uint32_t>();
  const auto kind = in.fixed<std::uint32_t>();
  BlockHeader header;
  header.kind = static_cast<BlockKind>(kind);
  header.first = in.fixed<std::uint64_t>();
  header.frames = in.fixed<std::uint32_t>();
  header.size = in.fixed<std::uint32_t>();
  header.hash = in.fixed<std::uint64_t>();
  const bool whole = in.fixed<std::uint64_t>() == hashOf(bytes.substr(0, kHeaderBytes - 8));
  const bool known = kind >= 1 && kind <= static_cast<std::uint32_t>(BlockKind::kEnd);
  return mark == kMark && whole && known ? std::optional(header) : std::nullopt;
}

}  // namespace scatter::recording
