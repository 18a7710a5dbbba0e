#include <scatter/io/file.h>
#include <scatter/lab/frame_csv.h>

#include "io/growing_file.h"
#include "lab/text.h"

#include <cassert>
#include <cmath>
#include <string>
#include <utility>

namespace scatter {

namespace {

std::string cellOf(const Channel& channel, double value) {
  if (channel.sampled && std::isnan(value)) {
    return {};
  }
  return channel.kind == ChannelKind::kInteger ? lab::fixedNumber(value, 0) : lab::shortestNumber(value);
}

std::string headerOf(const std::vector<Channel>& channels) {
  std::string line;
  for (const Channel& channel : channels) {
    line += (line.empty() ? "" : ",") + channel.name;
  }
  return line + '\n';
}

}  // namespace

Result<FrameCsv> FrameCsv::create(const std::filesystem::path& file, const FrameData& data) {
  auto output = GrowingFile::create(file);
  if (!output) {
    return tl::unexpected(output.error());
  }
  return FrameCsv(std::move(*output), headerOf(data.channels()), data.channels().size());
}

FrameCsv::FrameCsv(std::unique_ptr<GrowingFile> file, std::string header, std::size_t channels)
    : file_(std::move(file)), header_(std::move(header)), channels_(channels) {}

FrameCsv::FrameCsv(FrameCsv&&) noexcept = default;
FrameCsv& FrameCsv::operator=(FrameCsv&&) noexcept = default;
FrameCsv::~FrameCsv() = default;

Result<void> FrameCsv::write(const FrameData& data) {
  assert(file_ && data.channels().size() >= channels_);
  std::string line;
  for (std::size_t i = 0; i < channels_; ++i) {
    const auto id = static_cast<ChannelId>(i);
    line += i == 0 ? "" : ",";
    const Channel& channel = data.channel(id);
    line +=
        channel.kind == ChannelKind::kHash ? lab::hexNumber(data.hash(id)) : cellOf(channel, data.value(id));
  }
  auto added = file_->add(header_ + line + '\n');
  if (added) {
    header_.clear();
  }
  return added;
}

Result<void> FrameCsv::finish() {
  assert(file_);
  return file_->add(std::exchange(header_, {})).and_then([&] { return file_->finish(); });
}

Result<void> writeFrameCsv(const std::filesystem::path& file, const FrameTable& table) {
  std::vector<Channel> channels;
  for (const FrameColumn& column : table.columns()) {
    channels.push_back(column.channel);
  }
  std::string text = headerOf(channels);
  for (std::size_t frame = 0; frame < table.frames(); ++frame) {
    for (const FrameColumn& column : table.columns()) {
      text += &column == &table.columns().front() ? "" : ",";
      text += column.channel.kind == ChannelKind::kHash ? lab::hexNumber(column.hashes[frame])
                                                        : cellOf(column.channel, column.values[frame]);
    }
    text += '\n';
  }
  return writeFile(file, text);
}

}  // namespace scatter
