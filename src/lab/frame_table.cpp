#include <scatter/lab/frame_table.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace scatter {

FrameTable::FrameTable(const std::vector<Channel>& channels) {
  columns_.reserve(channels.size());
  for (const Channel& channel : channels) {
    columns_.push_back({.channel = channel, .values = {}, .hashes = {}});
  }
}

FrameTable::FrameTable(std::vector<FrameColumn> columns) : columns_(std::move(columns)) {
  for (const FrameColumn& column : columns_) {
    frames_ = std::max(column.values.size(), column.hashes.size());
    assert(frames_ == std::max(columns_.front().values.size(), columns_.front().hashes.size()));
  }
}

void FrameTable::append(const FrameData& data) {
  assert(data.channels().size() >= columns_.size());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto id = static_cast<ChannelId>(i);
    assert(data.channel(id).name == columns_[i].channel.name);
    if (columns_[i].channel.kind == ChannelKind::kHash) {
      columns_[i].hashes.push_back(data.hash(id));
    } else {
      columns_[i].values.push_back(data.value(id));
    }
  }
  ++frames_;
}

const FrameColumn* FrameTable::find(std::string_view name) const {
  const auto found = std::find_if(columns_.begin(), columns_.end(),
                                  [name](const FrameColumn& column) { return column.channel.name == name; });
  return found == columns_.end() ? nullptr : &*found;
}

const std::vector<double>& FrameTable::values(std::string_view name) const {
  const FrameColumn* column = find(name);
  assert(column != nullptr && column->channel.kind != ChannelKind::kHash);
  return column->values;
}

const std::vector<std::uint64_t>& FrameTable::hashes(std::string_view name) const {
  const FrameColumn* column = find(name);
  assert(column != nullptr && column->channel.kind == ChannelKind::kHash);
  return column->hashes;
}

void FrameTable::setValues(std::string_view name, std::vector<double> values) {
  assert(values.size() == frames_);
  for (FrameColumn& column : columns_) {
    if (column.channel.name == name) {
      column.values = std::move(values);
      return;
    }
  }
}

}  // namespace scatter
