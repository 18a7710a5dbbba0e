#include "recording_arguments.h"

#include <spdlog/fmt/fmt.h>

#include <optional>
#include <vector>

#include "messages.h"
#include "number_checks.h"

namespace scatter::app {

namespace {

std::vector<std::string> partsOf(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace

Result<std::unique_ptr<Recording>> openRecording(const std::string& file) {
  auto recording = Recording::open(file);
  if (recording && !(*recording)->damage().empty()) {
    printNote(fmt::format("{}: {}; frames {} to {} are whole", file, (*recording)->damage(),
                          (*recording)->first(), (*recording)->last()));
  }
  return recording;
}

Result<FrameRange> parseFrames(const std::string& text, const Recording& recording) {
  const std::vector<std::string> parts = partsOf(text);
  const auto numberOr = [&](std::size_t part, std::uint64_t missing) {
    return parts[part].empty() ? std::optional(missing) : parseNumber<std::uint64_t>(parts[part]);
  };
  const auto from = numberOr(0, recording.first());
  const auto to = parts.size() > 1 ? numberOr(1, recording.last()) : from;
  const auto step = parts.size() > 2 ? numberOr(2, 1) : std::uint64_t{1};
  if (text.empty() || parts.size() > 3 || !from || !to || !step || *step == 0) {
    return fail("\"" + text +
                "\" names no frames; write N, FROM:TO or FROM:TO:STEP, such as 600:0 for backwards");
  }
  if (!recording.has(*from) || !recording.has(*to)) {
    return fail(fmt::format("{} has frames {} to {}, not {}", recording.file().string(), recording.first(),
                            recording.last(), recording.has(*from) ? *to : *from));
  }
  return FrameRange{*from, *to, *step};
}

Result<void> forEachFrame(const Recording& recording, const FrameRange& range,
                          const std::function<Result<void>(const RecordedFrame& frame)>& use) {
  const bool backwards = range.from > range.to;
  for (std::uint64_t number = range.from;;) {
    const auto frame = recording.frame(number);
    if (!frame) return tl::unexpected(frame.error());
    if (auto used = use(**frame); !used) return used;
    const std::uint64_t left = backwards ? number - range.to : range.to - number;
    if (left < range.step) return {};
    number = backwards ? number - range.step : number + range.step;
  }
}

}  // namespace scatter::app
