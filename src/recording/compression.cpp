#include "recording/compression.h"

#include <zstd.h>

#include "recording/bytes.h"

namespace scatter::recording {

namespace {

// Higher levels search longer for repeats, of which differences of poses have none.
constexpr int kLevel = 1;
constexpr int kSlowLevel = 15;

void pack(std::string_view stream, ByteWriter& out) {
  std::string packed(ZSTD_compressBound(stream.size()), '\0');
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), stream.data(), stream.size(), kLevel);
  const bool smaller = ZSTD_isError(size) == 0 && size < stream.size();
  out.number(stream.size());
  out.number(smaller ? size : stream.size());
  out.append(smaller ? std::string_view(packed.data(), size) : stream);
}

std::optional<std::string> unpack(ByteReader& in, std::size_t most) {
  const std::uint64_t size = in.number();
  const std::string_view packed = in.text();
  if (in.failed() || size > most || packed.size() > size) return std::nullopt;
  if (packed.size() == size) return std::string(packed);
  std::string stream(static_cast<std::size_t>(size), '\0');
  const std::size_t unpacked = ZSTD_decompress(stream.data(), stream.size(), packed.data(), packed.size());
  return ZSTD_isError(unpacked) == 0 && unpacked == size ? std::optional(std::move(stream)) : std::nullopt;
}

}  // namespace

std::string packStreams(std::span<const std::string_view> streams) {
  ByteWriter out;
  for (const std::string_view stream : streams) pack(stream, out);
  return out.take();
}

std::optional<std::vector<std::string>> unpackStreams(std::string_view packed, std::size_t count,
                                                      std::size_t most) {
  ByteReader in(packed);
  std::vector<std::string> streams;
  for (std::size_t i = 0; i < count; ++i) {
    auto stream = unpack(in, most);
    if (!stream) return std::nullopt;
    most -= stream->size();
    streams.push_back(std::move(*stream));
  }
  return in.left() == 0 ? std::optional(std::move(streams)) : std::nullopt;
}

std::string compressWell(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kSlowLevel));
  return packed;
}

}  // namespace scatter::recording
