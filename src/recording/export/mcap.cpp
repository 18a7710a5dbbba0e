#include <scatter/recording/export.h>

#include <cmath>
#include <set>

#include "recording/export/foxglove.h"
#include "recording/export/mcap_writer.h"

namespace scatter {

namespace {

/// A recording as an MCAP file.
class McapExport {
 public:
  McapExport(const Recording& recording, recording::McapWriter& writer)
      : recording_(recording), messages_(recording), writer_(writer) {}

  Result<void> begin(bool contacts) {
    const auto add = [this](const char* topic, const char* name, const std::string& schema,
                            std::uint16_t& to) {
      return writer_.addChannel(topic, name, schema).map([&to](std::uint16_t channel) { to = channel; });
    };
    return add("/scene", "foxglove.SceneUpdate", recording::sceneSchema(), scene_)
        .and_then([&] {
          return add("/tf", "foxglove.FrameTransforms", recording::transformsSchema(), transforms_);
        })
        .and_then([&] {
          return add("/data", "scatter.FrameData", recording::dataSchema(recording_.info()), data_);
        })
        .and_then([&] { return add("/events", "foxglove.Log", recording::logSchema(), events_); })
        .and_then([&] {
          return contacts ? add("/contacts", "foxglove.SceneUpdate", recording::sceneSchema(), contacts_)
                          : Result<void>();
        });
  }

  Result<void> add(const RecordedFrame& frame, bool contacts) {
    const auto time = static_cast<std::uint64_t>(
        std::llround(1e9 * static_cast<double>(frame.number) * recording_.info().stepSeconds));
    Result<void> written;
    // Who jumps to a time sees the last message before it, so that each has all bodies.
    if (roster_ != *frame.roster) {
      roster_ = *frame.roster;
      bodies_.insert(roster_.begin(), roster_.end());
      written = writer_.write(scene_, time, messages_.scene(frame, time));
    }
    const auto then = [&](std::uint16_t channel, const std::string& message) {
      if (written) written = writer_.write(channel, time, message);
    };
    then(transforms_, messages_.transforms(frame, time));
    if (!frame.values.empty()) then(data_, messages_.data(frame));
    for (const LevelEvent& event : frame.events) then(events_, messages_.log(event, time));
    if (contacts) then(contacts_, messages_.contacts(frame, time));
    return written;
  }

  [[nodiscard]] std::uint64_t bodies() const { return bodies_.size(); }

 private:
  const Recording& recording_;
  recording::FoxgloveMessages messages_;
  recording::McapWriter& writer_;
  std::uint16_t scene_ = 0;
  std::uint16_t transforms_ = 0;
  std::uint16_t data_ = 0;
  std::uint16_t events_ = 0;
  std::uint16_t contacts_ = 0;
  std::vector<BodyId> roster_;
  std::set<BodyId> bodies_;
};

}  // namespace

Result<ExportCounts> writeMcap(const Recording& recording, const ExportRange& range,
                               const std::filesystem::path& file) {
  auto writer = recording::McapWriter::create(file);
  if (!writer) return tl::unexpected(writer.error());
  // There may be none in the first frames.
  const bool contacts = recording.info().notes.count("contacts") > 0;
  McapExport out(recording, *writer);
  if (auto begun = out.begin(contacts); !begun) return tl::unexpected(begun.error());
  ExportCounts counts;
  for (std::uint64_t number = range.first; number <= range.last; number += range.step) {
    const auto frame = recording.frame(number);
    if (!frame) return tl::unexpected(frame.error());
    if (auto added = out.add(**frame, contacts); !added) return tl::unexpected(added.error());
    ++counts.frames;
  }
  auto size = writer->finish();
  if (!size) return tl::unexpected(size.error());
  counts.bodies = out.bodies();
  counts.bytes = *size;
  return counts;
}

}  // namespace scatter
