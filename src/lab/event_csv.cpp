#include <scatter/lab/event_csv.h>

#include "io/atomic_file.h"
#include "lab/names.h"

#include <cassert>
#include <string>
#include <utility>

namespace scatter {

namespace {

std::string rowOf(std::uint64_t frame, const LevelEvent& event) {
  std::string row = std::to_string(frame) + ',' + lab::nameOf(event.kind) + ',' + lab::nameOf(event.scope);
  row += ',';
  row += event.policy;
  for (const std::uint32_t number :
       {static_cast<std::uint32_t>(event.body), static_cast<std::uint32_t>(event.other)}) {
    row += ',' + std::to_string(number);
  }
  row += ',' + std::to_string(event.from) + ',' + std::to_string(event.to);
  return row + (event.onCredit ? ",1\n" : ",0\n");
}

}  // namespace

Result<EventCsv> EventCsv::create(const std::filesystem::path& file) {
  auto output = AtomicFile::create(file);
  if (!output) {
    return tl::unexpected(output.error());
  }
  if (auto written = (*output)->write("frame,kind,scope,policy,body,other,from,to,on_credit\n"); !written) {
    return tl::unexpected(written.error());
  }
  return EventCsv(std::move(*output));
}

EventCsv::EventCsv(std::unique_ptr<AtomicFile> file) : file_(std::move(file)) {}

EventCsv::EventCsv(EventCsv&&) noexcept = default;
EventCsv& EventCsv::operator=(EventCsv&&) noexcept = default;
EventCsv::~EventCsv() = default;

Result<void> EventCsv::write(std::uint64_t frame, std::span<const LevelEvent> events) {
  assert(file_);
  std::string rows;
  for (const LevelEvent& event : events) {
    rows += rowOf(frame, event);
  }
  return rows.empty() ? Result<void>() : file_->write(rows);
}

Result<void> EventCsv::finish() {
  assert(file_);
  return std::exchange(file_, nullptr)->commit();
}

Result<void> writeEventCsv(const std::filesystem::path& file, const std::vector<FrameEvent>& events) {
  auto csv = EventCsv::create(file);
  if (!csv) {
    return tl::unexpected(csv.error());
  }
  for (const FrameEvent& item : events) {
    if (auto written = csv->write(item.frame, {&item.event, 1}); !written) {
      return written;
    }
  }
  return csv->finish();
}

}  // namespace scatter
