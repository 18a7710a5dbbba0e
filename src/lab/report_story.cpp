#include "lab/report_story.h"

#include <algorithm>
#include <map>
#include <string>

#include "lab/report_meetings.h"
#include "lab/text.h"

namespace scatter::lab {

namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::string whole(double value) {
  return fixedNumber(value, 0);
}

void addIf(std::vector<StoryLine>& story, const std::optional<std::uint64_t>& frame,
           const std::string& text) {
  if (frame) {
    story.push_back({.frame = *frame, .text = text});
  }
}

std::string manifoldsBetween(const ReportRun& run, std::uint64_t first, std::uint64_t last) {
  const std::uint64_t peak = run.peakFrame("manifolds", first, last);
  return "manifolds reach " + whole(run.at("manifolds", peak)) + " in frame " + std::to_string(peak);
}

std::string describe(const ReportRun& run, const FrameEvent& event) {
  const std::string name = run.body(event.event.body).name;
  switch (event.event.kind) {
    case LevelEventKind::kRequested:
      return name + " asks for level " + std::to_string(event.event.to);
    case LevelEventKind::kAcknowledged:
      return {};
    case LevelEventKind::kBlocked:
      return name + ": the try is not safe, its coarser shape would touch; it waits";
    case LevelEventKind::kSwitched:
      return name + " switches to level " + std::to_string(event.event.to) + ": " +
             std::to_string(run.partsOf(event.event.body, event.frame)) + " boxes instead of " +
             std::to_string(
                 run.body(event.event.body).parts.at(static_cast<std::size_t>(event.event.from) - 1));
    case LevelEventKind::kRetracted:
      return name + ": the request is retracted";
  }
  return {};
}

// In the order in which they happened within a frame.
void sortByFrame(std::vector<StoryLine>& story) {
  std::stable_sort(story.begin(), story.end(),
                   [](const StoryLine& a, const StoryLine& b) { return a.frame < b.frame; });
}

void tellEnd(const ReportRun& run, std::vector<StoryLine>& story) {
  std::map<int, std::size_t> ships;
  for (const auto& [id, body] : run.bodies()) {
    if (body.parts.size() > 1) {
      ++ships[run.lastLevelOf(id)];
    }
  }
  std::string text = "the end: ";
  for (const auto& [level, count] : ships) {
    text += counted(count, "ship", "ships") + " at level " + std::to_string(level) + ", ";
  }
  const double waiting = run.at("requests", run.frames());
  text += counted(static_cast<std::size_t>(waiting), "request waits", "requests wait");
  story.push_back({.frame = run.frames(), .text = text});
}

bool switches(const ReportRun& run) {
  return run.run().options.physics.world == WorldKind::kHybrid;
}

// What requests came to in these frames.
std::string tally(const ReportRun& run, std::uint64_t first, std::uint64_t last) {
  const std::uint64_t most = run.peakFrame("requests", first, last);
  return counted(run.events(LevelEventKind::kSwitched, first, last).size(), "switch", "switches") + ", " +
         counted(run.events(LevelEventKind::kBlocked, first, last).size(), "try that is not safe",
                 "tries that are not safe") +
         ", at most " + whole(run.at("requests", most)) + " wait";
}

void tellRetractions(const ReportRun& run, std::vector<StoryLine>& story) {
  std::map<std::uint64_t, std::size_t> byLoad;
  for (const FrameEvent& event : run.events(LevelEventKind::kRetracted)) {
    byLoad[event.frame] += run.wasLoadFine(event.frame) ? 1 : 0;
  }
  for (const auto& [frame, count] : byLoad) {
    if (count > 0) {
      story.push_back({.frame = frame,
                       .text = "the load is fine: " +
                               counted(count, "waiting request is", "waiting requests are") + " retracted"});
    }
  }
}

void tellCrowdSwitching(const ReportRun& run, const ReportImpact& impact, std::vector<StoryLine>& story) {
  const auto requests = run.events(LevelEventKind::kRequested);
  if (requests.empty()) {
    return;
  }
  const std::uint64_t first = requests.front().frame;
  story.push_back({.frame = first,
                   .text = "the load is no longer fine: " +
                           counted(run.events(LevelEventKind::kRequested, first, first).size(), "ship asks",
                                   "ships ask") +
                           " for level 1"});
  story.push_back({.frame = impact.peak, .text = "until here " + tally(run, first, impact.peak)});
  story.push_back(
      {.frame = impact.end, .text = "as they disperse " + tally(run, impact.peak + 1, impact.end)});
  if (impact.end < run.frames()) {
    story.push_back(
        {.frame = run.frames(), .text = "since then " + tally(run, impact.end + 1, run.frames())});
  }
  tellRetractions(run, story);
}

}  // namespace

std::vector<StoryLine> tellTwoShips(const ReportRun& run) {
  const ReportMeetings meetings = findMeetings(run);
  std::vector<StoryLine> story;
  addIf(story, meetings.overlap, "their bounds overlap");
  for (const FrameEvent& event : run.run().events) {
    if (std::string text = describe(run, event); !text.empty()) {
      story.push_back({.frame = event.frame, .text = std::move(text)});
    }
  }
  if (meetings.overlap && meetings.contact && meetings.apart) {
    addIf(story, meetings.contact,
          "they collide; " + manifoldsBetween(run, *meetings.overlap, *meetings.apart));
    addIf(story, meetings.apart, "their bounds have parted");
  }
  addIf(story, meetings.overlapAgain, "their bounds overlap again");
  if (meetings.contactAgain) {
    addIf(story, meetings.contactAgain,
          "they touch again; " + manifoldsBetween(run, *meetings.contactAgain, run.frames()));
  }
  tellEnd(run, story);
  sortByFrame(story);
  return story;
}

std::vector<StoryLine> tellCrowd(const ReportRun& run) {
  const ReportImpact impact = findImpact(run);
  std::vector<StoryLine> story;
  addIf(story, impact.overlap, "the first bounds overlap");
  addIf(story, impact.contact, "the first contact");
  story.push_back({.frame = impact.peak,
                   .text = "the peak of the impact: " + whole(run.at("manifolds", impact.peak)) +
                           " manifolds of " + whole(run.at("narrowphase_pairs", impact.peak)) + " pairs"});
  if (switches(run)) {
    tellCrowdSwitching(run, impact, story);
  }
  const std::uint64_t most = run.peakFrame("manifolds", 1, run.frames());
  story.push_back(
      {.frame = most, .text = "the most manifolds of the run: " + whole(run.at("manifolds", most))});
  tellEnd(run, story);
  sortByFrame(story);
  return story;
}

}  // namespace scatter::lab
