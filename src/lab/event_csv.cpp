#include <scatter/io/file.h>
#include <scatter/lab/event_csv.h>

#include "io/growing_file.h"
#include "lab/names.h"

#include <cassert>
#include <string>
#include <utility>

namespace scatter {

namespace {

constexpr const char* kHeader = "frame,kind,scope,policy,body,other,from,to,on_credit\n";

std::string rowOf(std::uint64_t frame, const LevelEvent& event) {
  std::string row = std::to_string(frame) + ',' + lab::nameOf(event.kind) + ',' + nameOf(event.scope);
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
  auto output = GrowingFile::create(file);
  if (!output) {
    return tl::unexpected(output.error());
  }
  return EventCsv(std::move(*output));
}

EventCsv::EventCsv(std::unique_ptr<GrowingFile> file) : file_(std::move(file)) {}

EventCsv::EventCsv(EventCsv&&) noexcept = default;
EventCsv& EventCsv::operator=(EventCsv&&) noexcept = default;
EventCsv::~EventCsv() = default;

Result<void> EventCsv::write(std::uint64_t frame, std::span<const LevelEvent> events) {
  assert(file_);
  std::string rows = hasHeader_ ? "" : kHeader;
  for (const LevelEvent& event : events) {
    rows += rowOf(frame, event);
  }
  auto added = file_->add(rows);
  hasHeader_ = hasHeader_ || added.has_value();
  return added;
}

void EventCsv::dropLast() noexcept {
  file_->dropLast();
}

Result<void> EventCsv::finish() {
  assert(file_);
  return (hasHeader_ ? Result<void>() : write(0, {})).and_then([&] { return file_->finish(); });
}

Result<void> writeEventCsv(const std::filesystem::path& file, const std::vector<FrameEvent>& events) {
  std::string text = kHeader;
  for (const FrameEvent& item : events) {
    text += rowOf(item.frame, item.event);
  }
  return writeFile(file, text);
}

}  // namespace scatter
