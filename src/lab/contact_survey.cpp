#include <scatter/lab/contact_survey.h>

#include "lab/run_series.h"
#include "lab/text.h"
#include "lab/text_table.h"

#include <utility>

namespace scatter {

namespace {

using Cells = std::vector<std::string>;

Cells countsOf(const ContactCheck& check) {
  Cells cells;
  for (const std::uint64_t count :
       {check.steps, check.childPairs, check.expected, check.missed, check.extra, check.doubtful}) {
    cells.push_back(std::to_string(count));
  }
  return cells;
}

std::string extraShare(const ContactCheck& check) {
  if (check.expected == 0) {
    return "-";
  }
  return lab::fixedNumber(100.0 * static_cast<double>(check.extra) / static_cast<double>(check.expected), 2);
}

Cells rowOf(const std::string& scene, std::uint64_t frames, const ContactCheck& check) {
  Cells cells{scene, std::to_string(frames)};
  const Cells counts = countsOf(check);
  cells.insert(cells.end(), counts.begin(), counts.end());
  cells.push_back(extraShare(check));
  return cells;
}

}  // namespace

Result<std::vector<SceneContacts>> surveyContacts(
    const std::vector<RunOptions>& runs, const std::function<void(const CompareProgress&)>& progress) {
  std::vector<SceneContacts> scenes;
  lab::RunSeries series(runs.size(), progress);
  for (const RunOptions& options : runs) {
    const auto run = series.run(options, options.scene);
    if (!run) {
      return tl::unexpected(run.error());
    }
    scenes.push_back(
        {.scene = options.scene, .frames = run->summary.frames, .check = run->summary.contactCheck});
  }
  return scenes;
}

ContactCheck totalOf(const std::vector<SceneContacts>& scenes) {
  ContactCheck total;
  for (const SceneContacts& scene : scenes) {
    total.steps += scene.check.steps;
    total.childPairs += scene.check.childPairs;
    total.expected += scene.check.expected;
    total.missed += scene.check.missed;
    total.extra += scene.check.extra;
    total.doubtful += scene.check.doubtful;
  }
  return total;
}

std::string formatContacts(const std::vector<SceneContacts>& scenes) {
  std::vector<Cells> lines{
      {"scene", "frames", "verified", "child pairs", "expected", "missed", "extra", "doubtful", "extra %"}};
  std::uint64_t frames = 0;
  for (const SceneContacts& scene : scenes) {
    lines.push_back(rowOf(scene.scene, scene.frames, scene.check));
    frames += scene.frames;
  }
  lines.push_back(rowOf("all", frames, totalOf(scenes)));
  return lab::textTable(lines) +
         lab::fitTerminal(
             "Expected: child pairs in contact in the engine's own collision world at the same places. "
             "Missed: of "
             "those, without a contact in the world. Extra: in contact in the world and not in the engine. "
             "Doubtful, in none of these: rounding decides, or the engine is proven wrong.");
}

std::string contactsCsv(const std::vector<SceneContacts>& scenes) {
  std::vector<Cells> lines{
      {"scene", "frames", "frames_verified", "child_pairs", "expected", "missed", "extra", "doubtful"}};
  for (const SceneContacts& scene : scenes) {
    Cells cells = rowOf(scene.scene, scene.frames, scene.check);
    cells.pop_back();
    lines.push_back(std::move(cells));
  }
  return lab::csvText(lines);
}

std::string formatMisses(const ContactCheck& check) {
  const auto part = [](const std::string& body, int child) {
    return child < 0 ? body : body + " part " + std::to_string(child + 1);
  };
  std::string text;
  for (const FrameMiss& miss : check.firstMissed) {
    const MissedContact& contact = miss.contact;
    text += "  missed in frame " + std::to_string(miss.frame) + ": " + part(contact.bodyA, contact.childA) +
            " and " + part(contact.bodyB, contact.childB) + ", distance " +
            lab::fixedNumber(static_cast<double>(contact.distance), 4) + " m\n";
  }
  return text;
}

}  // namespace scatter
