#include "io/gltf/container.h"

#include <cstdint>

namespace scatter::io {
namespace {

void appendWord(std::string& bytes, std::uint32_t word) {
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

}  // namespace

std::string packGlb(std::string json, std::string data) {
  constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
  constexpr std::uint32_t kBinaryChunk = 0x004E4942;
  json.resize((json.size() + 3) / 4 * 4, ' ');
  data.resize((data.size() + 3) / 4 * 4, '\0');
  const std::size_t size = 12 + 8 + json.size() + (data.empty() ? 0 : 8 + data.size());
  std::string bytes = "glTF";
  bytes.reserve(size);
  appendWord(bytes, 2);
  appendWord(bytes, static_cast<std::uint32_t>(size));
  appendWord(bytes, static_cast<std::uint32_t>(json.size()));
  appendWord(bytes, kJsonChunk);
  bytes += json;
  if (!data.empty()) {
    appendWord(bytes, static_cast<std::uint32_t>(data.size()));
    appendWord(bytes, kBinaryChunk);
    bytes += data;
  }
  return bytes;
}

}  // namespace scatter::io
