#include "lab/page/page_data.h"

#include <scatter/lab/recorder.h>
#include <scatter/recording/recording.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "lab/figure_panels.h"
#include "lab/page/page_blobs.h"
#include "lab/page/page_motion.h"
#include "lab/page/page_shapes.h"
#include "lab/run_files.h"
#include "lab/summary_json.h"
#include "lab/text.h"
#include "recording/bytes.h"

namespace scatter::lab {

namespace {

Json stages() {
  Json stages = Json::array();
  for (std::size_t i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    stages.push_back({stageColumn(stage), stageName(stage), stageColor(stage)});
  }
  return stages;
}

// One column after the other as floats: the lowest bytes of all numbers, then the next ones, which packs
// better.
std::string bytesOf(const std::vector<float>& numbers) {
  std::string bytes(4 * numbers.size(), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(numbers[i]);
    for (std::size_t byte = 0; byte < 4; ++byte) {
      bytes[byte * numbers.size() + i] = static_cast<char>(bits >> 8U * byte & 255U);
    }
  }
  return bytes;
}

Json frameData(const FrameTable& table, PageBlobs& blobs) {
  Json columns = Json::array();
  std::vector<float> numbers;
  for (const FrameColumn& column : table.columns()) {
    if (column.channel.kind == ChannelKind::kHash) continue;
    columns.push_back(
        {column.channel.name, column.channel.unit, column.channel.kind == ChannelKind::kInteger});
    for (const double value : column.values) numbers.push_back(static_cast<float>(value));
  }
  const std::string bytes = bytesOf(numbers);
  return {{"columns", columns}, {"blob", blobs.add(bytes)}, {"bytes", bytes.size()}};
}

// Without a motion, `noMotion` says in a sentence why.
void addMotion(const ComparedWorld& world, PageShapes& shapes, PageBlobs& blobs, Json& json) {
  if (!world.recording) {
    json["noMotion"] = "The run was not recorded, so that it cannot be played.";
    return;
  }
  const auto recording = Recording::open(*world.recording);
  auto motion =
      recording ? pageMotion(**recording, shapes, blobs) : Result<Json>(tl::unexpected(recording.error()));
  if (motion) {
    json["motion"] = std::move(*motion);
  } else {
    json["noMotion"] = "The run cannot be played: " + motion.error().message + ".";
  }
}

}  // namespace

std::string pageData(const Comparison& comparison) {
  PageBlobs blobs;
  PageShapes shapes;
  Json worlds = Json::array();
  for (std::size_t i = 0; i < comparison.worlds.size(); ++i) {
    const ComparedWorld& world = comparison.worlds[i];
    Json json{{"label", world.label()},
              {"color", worldColor(i)},
              {"frames", world.median.frames()},
              {"governedMs", figureWorld(world.run().options, world.median).governedMs},
              {"byClock", isClockGoverned(world.run().options.physics)},
              {"typicalRepeat", world.typical + 1},
              {"data", frameData(world.median, blobs)}};
    addMotion(world, shapes, blobs, json);
    worlds.push_back(std::move(json));
  }
  const RunOptions& first = comparison.options.runs.front();
  const Json page{
      {"scene", first.scene},        {"stepSeconds", kStepSeconds}, {"repeat", comparison.options.repeat},
      {"budgetMs", first.budgetMs},  {"stages", stages()},          {"worlds", std::move(worlds)},
      {"look", shapes.finish(blobs)}};
  // Within a script nothing is escaped, and "</script>" would end it.
  const std::string text =
      replaceAll(page.dump(-1, ' ', true, Json::error_handler_t::replace), "<", "\\u003c");
  return R"(<script type="application/json" id="page-data">)" + text + "</script>\n" + blobs.html();
}

}  // namespace scatter::lab
