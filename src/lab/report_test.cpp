#include <scatter/lab/report_test.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lab/report_measures.h"
#include "lab/report_run.h"
#include "lab/report_story.h"
#include "lab/text.h"
#include "lab/text_table.h"

namespace scatter {

namespace {

// The report's hybrids stay coarse: no run of a test has so many frames.
constexpr int kNeverFinerAgain = 100000;

// Narrowphase pairs from which on a load is not fine. Of two ships any is; of the crowd as many as make the
// impact.
constexpr std::uint32_t kTwoShipsLoad = 1;
constexpr std::uint32_t kCrowdLoad = 50;

// The two ships pass each other in a few frames, the crowd takes longer.
constexpr int kTwoShipsRetry = 2;
constexpr int kCrowdRetry = 10;

bool isHybrid(int number) {
  return number % 2 == 0;
}

bool hasTwoShips(int number) {
  return number <= 2;
}

PhysicsDef physicsOf(int number) {
  PhysicsDef physics;
  if (!isHybrid(number)) {
    return physics;
  }
  physics.world = WorldKind::kHybrid;
  physics.collision.narrowphase = Narrowphase::kEngine;
  SwitchingDef& switching = physics.switching;
  switching.switching = Switching::kBody;
  switching.policy = Policy::kProximity;
  switching.proximitySteps = 0.0F;
  switching.quietSteps = kNeverFinerAgain;
  switching.retryInterval = hasTwoShips(number) ? kTwoShipsRetry : kCrowdRetry;
  switching.loadFinePairs = hasTwoShips(number) ? kTwoShipsLoad : kCrowdLoad;
  return physics;
}

std::string commandOf(const RunOptions& options) {
  std::string command = "scatter run " + options.scene;
  if (options.physics.world == WorldKind::kStandard) {
    return command + " --world standard";
  }
  const SwitchingDef& switching = options.physics.switching;
  return command + " --switching body --collision bullet --proximity-steps 0 --quiet-steps " +
         std::to_string(switching.quietSteps) + " --retry-interval " +
         std::to_string(switching.retryInterval) + " --load-fine-pairs " +
         std::to_string(switching.loadFinePairs);
}

std::string titleOf(int number) {
  return "Test " + std::to_string(number) + ": Scene " + (hasTwoShips(number) ? "1" : "2") + ", " +
         (isHybrid(number) ? "hybrid" : "default") + " build (report, section 5.1.5." +
         (hasTwoShips(number) ? "1)" : "2)");
}

// Lines of at most `width` columns; those after the first are indented.
std::string wrapped(const std::string& text, std::size_t width, const std::string& indent) {
  std::string lines;
  std::string rest = text;
  while (rest.size() > width) {
    const std::size_t end = rest.rfind(' ', width);
    if (end == std::string::npos) {
      break;
    }
    lines += rest.substr(0, end) + "\n" + indent;
    rest.erase(0, end + 1);
  }
  return lines + rest + "\n";
}

std::string valueText(const ReportMeasure& measure) {
  if (std::isnan(measure.ours)) {
    return "-";
  }
  return measure.isTime ? lab::readableNumber(measure.ours) : lab::fixedNumber(measure.ours, 0);
}

}  // namespace

Result<ReportTest> runReportTest(int number, const EngineFactory& engine, const std::filesystem::path& out,
                                 const Progress& progress) {
  if (number < 1 || number > kReportTests) {
    return fail("the report has no Test " + std::to_string(number) + "; give 1 to " +
                std::to_string(kReportTests));
  }
  std::map<BodyId, lab::ReportBody> bodies;
  RunOptions options{.scene = hasTwoShips(number) ? "report_1" : "report_2",
                     .engine = engine,
                     .physics = physicsOf(number),
                     .keepEvents = true,
                     .out = out,
                     .inspect = [&bodies](const World& world) { bodies = lab::reportBodies(world); },
                     .label = isHybrid(number) ? "hybrid" : "default"};
  auto run = runScene(options, progress);
  if (!run) {
    return tl::unexpected(run.error());
  }
  // What it holds on to is gone.
  run->options.inspect = {};
  ReportTest test{.number = number,
                  .title = titleOf(number),
                  .command = commandOf(run->options),
                  .run = std::move(*run),
                  .story = {},
                  .measures = {}};
  const lab::ReportRun told(test.run, std::move(bodies));
  const bool hybrid = isHybrid(number);
  test.story = hasTwoShips(number) ? lab::tellTwoShips(told) : lab::tellCrowd(told);
  test.measures = hasTwoShips(number) ? lab::measureTwoShips(told, hybrid) : lab::measureCrowd(told, hybrid);
  return test;
}

std::string formatReportTest(const ReportTest& test) {
  std::string text = test.title + "\n\n  frame  what happens\n";
  for (const StoryLine& line : test.story) {
    const std::string frame = std::to_string(line.frame);
    text += "  " + std::string(5 - std::min<std::size_t>(5, frame.size()), ' ') + frame + "  " +
            wrapped(line.text, 70, std::string(9, ' '));
  }
  std::vector<std::vector<std::string>> table{{"number", "report", "here"}};
  for (const ReportMeasure& measure : test.measures) {
    table.push_back({measure.name, measure.report, valueText(measure)});
  }
  return text + "\n" + lab::textTable(table) + "\nthe same run: " + wrapped(test.command, 64, "  ");
}

}  // namespace scatter
