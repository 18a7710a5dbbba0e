#include "lab/comparison_folder.h"

#include <scatter/io/file.h>
#include <scatter/lab/frame_csv.h>

#include "lab/scene_run.h"
#include "lab/summary_reader.h"

#include <string>
#include <system_error>
#include <utility>

namespace scatter::lab {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRepeatPrefix = "repeat-";

fs::path descriptionIn(const fs::path& folder) {
  return folder / "comparison.json";
}

Json worldIdentity(const RunOptions& run) {
  Summary asked;
  asked.physics = run.physics;
  asked.seed = run.seed.value_or(1);
  asked.frames = static_cast<std::uint64_t>(run.frames);
  asked.budgetMs = run.budgetMs;
  return {{"label", run.label},
          {"fidelity_every", run.fidelityEvery},
          {"hands", run.hands.text()},
          {"options", runOptionsJson(asked)}};
}

void removeRunFiles(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : {"summary.json", "frames.csv", "events.csv", kRecordingName}) {
    fs::remove(folder / name, ignored);
  }
}

// The innermost key whose values differ.
std::string differingKey(const Json& a, const Json& b, const std::string& name) {
  if (a.type() != b.type() || !a.is_structured() || a.size() != b.size()) {
    return name;
  }
  const Json& other = b;
  for (const auto& [key, value] : a.items()) {
    const Json match = a.is_array() ? other.at(std::stoul(key)) : other.value(key, Json());
    if (value != match) {
      return differingKey(value, match, a.is_array() ? name : key);
    }
  }
  return name;
}

// Made anew, the first frame must be the one that was recorded.
Result<void> checkFirstFrame(SceneRun& made, const FrameTable& table, const fs::path& folder) {
  made.step();
  if (isClockGoverned(made.options().physics) ||
      made.table().hashes("state_hash").front() == table.hashes("state_hash").front()) {
    return {};
  }
  return fail("the run in " + folder.string() +
              " starts in another way than the scene does now; remove that folder to run it again");
}

}  // namespace

Json comparisonIdentity(const CompareOptions& options) {
  Json worlds = Json::array();
  for (const RunOptions& run : options.runs) {
    worlds.push_back(worldIdentity(run));
  }
  return {{"scene", options.runs.front().scene},
          {"repeat", options.repeat},
          {"build", buildJson(buildInfo())},
          {"machine", machineJson(machineInfo())},
          {"worlds", std::move(worlds)}};
}

Result<ComparisonFolder> ComparisonFolder::open(const CompareOptions& options) {
  ComparisonFolder folder(options);
  std::error_code ignored;
  if (fs::exists(descriptionIn(*options.out), ignored)) {
    if (auto usable = folder.checkEarlier(); !usable) {
      return tl::unexpected(usable.error());
    }
    folder.resumes_ = options.resume;
  }
  return folder;
}

Result<void> ComparisonFolder::checkEarlier() const {
  const auto earlier = readJson(descriptionIn(*options_.out));
  const std::string name = options_.out->string();
  if (!options_.resume) {
    const bool unfinished = earlier && earlier->is_object() && !earlier->value("complete", true);
    const int finished = unfinished && !options_.anew ? finishedRuns() : 0;
    if (finished == 0) {
      return {};
    }
    return fail(name + " has " + std::to_string(finished) +
                " finished runs of a comparison that was cut short; go on with --resume, begin again with "
                "--anew, or choose another folder");
  }
  if (!earlier) {
    return tl::unexpected(earlier.error());
  }
  const Json before = earlier->is_object() ? earlier->value(kComparedKey, Json()) : Json();
  const Json now = comparisonIdentity(options_);
  if (before != now) {
    return fail("the comparison in " + name + " was another one (" + differingKey(now, before, "all of it") +
                " differs), so that it cannot be resumed; begin again with --anew, or choose another folder");
  }
  return {};
}

fs::path ComparisonFolder::runFolder(std::size_t world, int repeat) const {
  const fs::path folder = *options_.out / options_.runs[world].label;
  return options_.repeat == 1 ? folder : folder / (kRepeatPrefix + std::to_string(repeat + 1));
}

bool ComparisonFolder::isFinished(std::size_t world, int repeat) const {
  const auto summary = readJson(runFolder(world, repeat) / "summary.json");
  return summary && summary->is_object() && summary->value("complete", false);
}

int ComparisonFolder::finishedRuns() const {
  int finished = 0;
  for (std::size_t world = 0; world < options_.runs.size(); ++world) {
    for (int repeat = 0; repeat < options_.repeat; ++repeat) {
      finished += isFinished(world, repeat) ? 1 : 0;
    }
  }
  return finished;
}

Result<std::optional<Run>> ComparisonFolder::finishedRun(std::size_t world, int repeat) const {
  if (!resumes_ || !isFinished(world, repeat)) {
    return std::nullopt;
  }
  const fs::path folder = runFolder(world, repeat);
  Run run{.options = options_.runs[world], .table = {}, .summary = {}, .events = {}};
  run.options.out = folder;
  auto made = SceneRun::create(run.options);
  if (!made) {
    return tl::unexpected(made.error());
  }
  auto table = readFrameTable(folder / "frames.csv", (*made)->data().channels());
  if (!table) {
    return tl::unexpected(table.error());
  }
  if (table->frames() != static_cast<std::size_t>(run.options.frames)) {
    return fail(folder.string() + " has not as many frames as its summary says; remove it to run it again");
  }
  if (auto same = checkFirstFrame(**made, *table, folder); !same) {
    return tl::unexpected(same.error());
  }
  run.table = std::move(*table);
  run.summary = (*made)->summary();
  summarise(run.table, run.summary);
  const fs::path file = folder / "summary.json";
  auto read = readJson(file).and_then([&](const Json& json) { return readSummary(json, file, run.summary); });
  if (!read) {
    return tl::unexpected(read.error());
  }
  return std::optional(std::move(run));
}

// What an earlier comparison has left would be taken for this one's.
void ComparisonFolder::removeEarlierRuns(const fs::path& except) const {
  std::error_code ignored;
  for (const RunOptions& run : options_.runs) {
    const fs::path folder = *options_.out / run.label;
    if (folder != except) {
      removeRunFiles(folder);
    }
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      const bool isRepeat = entry.path().filename().string().starts_with(kRepeatPrefix);
      if (isRepeat && entry.path() != except) {
        removeRunFiles(entry.path());
        fs::remove(entry.path(), ignored);
      }
    }
  }
  fs::remove(*options_.out / "report.html", ignored);
}

Result<void> ComparisonFolder::begin(const fs::path& run) {
  if (std::exchange(begun_, true) || resumes_) {
    return {};
  }
  removeEarlierRuns(run);
  const Json json{{"complete", false},
                  {"stopped", "it was cut short, or is still running: scatter compare with --resume goes on"},
                  {"command_line", options_.commandLine},
                  {kComparedKey, comparisonIdentity(options_)}};
  return writeFile(descriptionIn(*options_.out),
                   json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace scatter::lab
