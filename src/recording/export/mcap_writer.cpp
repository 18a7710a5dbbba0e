#include "recording/export/mcap_writer.h"

#include <zstd.h>

#include <utility>

#include "recording/bytes.h"

namespace scatter::recording {

namespace {

constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
constexpr std::size_t kChunkBytes = std::size_t{4} << 20U;  // before it is compressed
constexpr int kZstdLevel = 3;

enum Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kDataEnd = 0x0F,
};

void writeText(std::string_view text, ByteWriter& out) {
  out.fixed(static_cast<std::uint32_t>(text.size()));
  out.append(text);
}

std::string record(Opcode opcode, const ByteWriter& content) {
  ByteWriter out;
  out.byte(opcode);
  out.fixed(static_cast<std::uint64_t>(content.size()));
  out.append(content.view());
  return out.take();
}

}  // namespace

Result<McapWriter> McapWriter::create(const std::filesystem::path& file) {
  auto made = AtomicFile::create(file);
  if (!made) return tl::unexpected(made.error());
  McapWriter writer(std::move(*made));
  ByteWriter header;
  writeText("", header);
  writeText("scatter", header);
  if (auto written = writer.put(std::string(kMagic) + record(kHeader, header)); !written) {
    return tl::unexpected(written.error());
  }
  return writer;
}

Result<void> McapWriter::put(std::string_view bytes) {
  size_ += bytes.size();
  return file_->write(bytes);
}

Result<std::uint16_t> McapWriter::addChannel(const std::string& topic, const std::string& schemaName,
                                             const std::string& schema) {
  const auto number = static_cast<std::uint16_t>(channels_.size());
  const auto schemaNumber = static_cast<std::uint16_t>(number + 1);  // zero is none
  channels_.emplace_back();
  ByteWriter type;
  type.fixed(schemaNumber);
  writeText(schemaName, type);
  writeText("jsonschema", type);
  writeText(schema, type);
  ByteWriter channel;
  channel.fixed(number);
  channel.fixed(schemaNumber);
  writeText(topic, channel);
  writeText("json", channel);
  channel.fixed(std::uint32_t{0});
  const std::string records = record(kSchema, type) + record(kChannel, channel);
  definitions_ += records;
  return put(records).map([number] { return number; });
}

Result<void> McapWriter::write(std::uint16_t channel, std::uint64_t nanoseconds, std::string_view json) {
  if (chunk_.empty()) chunkStart_ = nanoseconds;
  if (chunks_ == 0 && chunk_.empty()) start_ = nanoseconds;
  end_ = nanoseconds;
  Channel& to = channels_[channel];
  to.index.emplace_back(nanoseconds, chunk_.size());
  ByteWriter message;
  message.fixed(channel);
  message.fixed(static_cast<std::uint32_t>(to.messages++));
  message.fixed(nanoseconds);
  message.fixed(nanoseconds);
  message.append(json);
  chunk_ += record(kMessage, message);
  return chunk_.size() >= kChunkBytes ? endChunk() : Result<void>();
}

Result<void> McapWriter::endChunk() {
  if (chunk_.empty()) return {};
  std::string packed(ZSTD_compressBound(chunk_.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), chunk_.data(), chunk_.size(), kZstdLevel));
  ByteWriter chunk;
  chunk.fixed(chunkStart_);
  chunk.fixed(end_);
  chunk.fixed(static_cast<std::uint64_t>(chunk_.size()));
  chunk.fixed(std::uint32_t{0});  // no checksum
  writeText("zstd", chunk);
  chunk.fixed(static_cast<std::uint64_t>(packed.size()));
  chunk.append(packed);
  const std::string chunkRecord = record(kChunk, chunk);

  std::string indices;
  ByteWriter places;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (channels_[i].index.empty()) continue;
    places.fixed(static_cast<std::uint16_t>(i));
    places.fixed(size_ + chunkRecord.size() + indices.size());
    ByteWriter index;
    index.fixed(static_cast<std::uint16_t>(i));
    index.fixed(static_cast<std::uint32_t>(16 * channels_[i].index.size()));
    for (const auto& [time, place] : channels_[i].index) {
      index.fixed(time);
      index.fixed(place);
    }
    indices += record(kMessageIndex, index);
    channels_[i].index.clear();
  }
  ByteWriter index;
  index.fixed(chunkStart_);
  index.fixed(end_);
  index.fixed(size_);
  index.fixed(static_cast<std::uint64_t>(chunkRecord.size()));
  index.fixed(static_cast<std::uint32_t>(places.size()));
  index.append(places.view());
  index.fixed(static_cast<std::uint64_t>(indices.size()));
  writeText("zstd", index);
  index.fixed(static_cast<std::uint64_t>(packed.size()));
  index.fixed(static_cast<std::uint64_t>(chunk_.size()));
  chunkIndices_ += record(kChunkIndex, index);
  ++chunks_;
  chunk_.clear();
  return put(chunkRecord + indices);
}

Result<std::uint64_t> McapWriter::finish() {
  if (auto ended = endChunk(); !ended) return tl::unexpected(ended.error());
  ByteWriter dataEnd;
  dataEnd.fixed(std::uint32_t{0});  // no checksum
  std::string tail = record(kDataEnd, dataEnd);
  const std::uint64_t summary = size_ + tail.size();
  ByteWriter statistics;
  std::uint64_t messages = 0;
  ByteWriter counts;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    messages += channels_[i].messages;
    counts.fixed(static_cast<std::uint16_t>(i));
    counts.fixed(channels_[i].messages);
  }
  statistics.fixed(messages);
  statistics.fixed(static_cast<std::uint16_t>(channels_.size()));
  statistics.fixed(static_cast<std::uint32_t>(channels_.size()));
  statistics.fixed(std::uint32_t{0});  // attachments
  statistics.fixed(std::uint32_t{0});  // metadata
  statistics.fixed(chunks_);
  statistics.fixed(start_);
  statistics.fixed(end_);
  statistics.fixed(static_cast<std::uint32_t>(counts.size()));
  statistics.append(counts.view());
  tail += definitions_ + record(kStatistics, statistics) + chunkIndices_;
  ByteWriter footer;
  footer.fixed(summary);
  footer.fixed(std::uint64_t{0});  // no offsets within the summary
  footer.fixed(std::uint32_t{0});  // no checksum
  tail += record(kFooter, footer);
  tail += kMagic;
  if (auto written = put(tail); !written) return tl::unexpected(written.error());
  return file_->commit().map([this] { return size_; });
}

}  // namespace scatter::recording
