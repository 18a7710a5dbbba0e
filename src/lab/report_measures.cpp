#include "lab/report_measures.h"

#include <algorithm>
#include <limits>

#include "lab/report_meetings.h"

namespace scatter::lab {

namespace {

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

double frameOf(const std::optional<std::uint64_t>& frame) {
  return frame ? static_cast<double>(*frame) : kNever;
}

double peakValue(const ReportRun& run, std::string_view column, std::uint64_t first, std::uint64_t last) {
  return run.at(column, run.peakFrame(column, first, last));
}

double manifoldsFrom(const ReportRun& run, const std::optional<std::uint64_t>& first,
                     const std::optional<std::uint64_t>& last) {
  return first ? peakValue(run, "manifolds", *first, last.value_or(run.frames())) : kNever;
}

double partPairsAt(const ReportRun& run, const std::optional<std::uint64_t>& frame) {
  return frame ? static_cast<double>(run.partPairs(*frame)) : kNever;
}

// The first event of a kind that a body has.
double firstFrame(const ReportRun& run, LevelEventKind kind, const std::string& body) {
  for (const FrameEvent& event : run.events(kind)) {
    if (run.body(event.event.body).name == body) {
      return static_cast<double>(event.frame);
    }
  }
  return kNever;
}

double countOf(const std::vector<FrameEvent>& events) {
  return static_cast<double>(events.size());
}

double retractedByLoad(const ReportRun& run) {
  const auto events = run.events(LevelEventKind::kRetracted);
  return static_cast<double>(std::count_if(events.begin(), events.end(), [&run](const FrameEvent& event) {
    return run.wasLoadFine(event.frame);
  }));
}

double lastSwitch(const ReportRun& run) {
  const auto switches = run.events(LevelEventKind::kSwitched);
  return switches.empty() ? kNever : static_cast<double>(switches.back().frame);
}

}  // namespace

std::vector<ReportMeasure> measureTwoShips(const ReportRun& run, bool hybrid) {
  const ReportMeetings meetings = findMeetings(run);
  std::vector<ReportMeasure> measures{
      {"bounds overlap, frame", "after 140", frameOf(meetings.overlap)},
      {"first contact, frame", "140 to 180", frameOf(meetings.contact)},
      {"most manifolds, first meeting", hybrid ? "424" : "392",
       manifoldsFrom(run, meetings.overlap, meetings.apart)},
      {"box pairs when bounds overlap", hybrid ? "-" : "392", partPairsAt(run, meetings.overlap)},
      {"bounds apart, frame", hybrid ? "200" : "-", frameOf(meetings.apart)},
      {"bounds overlap again, frame", "200 to 450", frameOf(meetings.overlapAgain)},
      {"second contact, frame", "-", frameOf(meetings.contactAgain)},
      {"most manifolds, second meeting", hybrid ? "20" : "392",
       manifoldsFrom(run, meetings.overlapAgain, std::nullopt)},
      {"box pairs when they overlap again", hybrid ? "20" : "392", partPairsAt(run, meetings.overlapAgain)},
      {"objects at most", hybrid ? "more than 2" : "2", peakValue(run, "objects", 1, run.frames())},
  };
  if (hybrid) {
    const double hunter = firstFrame(run, LevelEventKind::kSwitched, "hunter");
    measures.insert(
        measures.end(),
        {{"first request, frame", "after 140", firstFrame(run, LevelEventKind::kRequested, "hunter")},
         {"hunter switches, frames after overlap", "1", hunter - frameOf(meetings.overlap)},
         {"fighter's first try fails, frame", "to 180", firstFrame(run, LevelEventKind::kBlocked, "fighter")},
         {"tries that failed", "1 or more", countOf(run.events(LevelEventKind::kBlocked))},
         {"fighter switches, frame", "200", firstFrame(run, LevelEventKind::kSwitched, "fighter")}});
  }
  return measures;
}

std::vector<ReportMeasure> measureCrowd(const ReportRun& run, bool hybrid) {
  const ReportImpact impact = findImpact(run);
  std::vector<ReportMeasure> measures{
      {"first overlap, frame", "140", frameOf(impact.overlap)},
      {"first contact, frame", "280", frameOf(impact.contact)},
      {"peak of the impact, frame", "360 to 380", static_cast<double>(impact.peak)},
      {"manifolds, peak of the impact", hybrid ? "66255" : "77874", run.at("manifolds", impact.peak)},
      {"part pairs if all overlapped", hybrid ? "-" : "77874", static_cast<double>(run.partPairs(1))},
      {"manifolds, most of the run", hybrid ? "66255" : "77874",
       peakValue(run, "manifolds", 1, run.frames())},
      {"manifolds, last frame", "-", run.at("manifolds", run.frames())},
      {"contacts, peak of the impact", "-", peakValue(run, "contacts", 1, impact.end)},
      {"objects at most", hybrid ? "more than 31" : "31", peakValue(run, "objects", 1, run.frames())},
      {"physics, peak frame, ms", "500", run.run().summary.physicsCpuMs.peak, true},
  };
  if (hybrid) {
    const auto switched = [&run](std::uint64_t first, std::uint64_t last) {
      return countOf(run.events(LevelEventKind::kSwitched, first, last));
    };
    const auto requests = run.events(LevelEventKind::kRequested);
    measures.insert(measures.end(),
                    {{"first request, frame", "140",
                      requests.empty() ? kNever : static_cast<double>(requests.front().frame)},
                     {"switches up to the peak", "some", switched(1, impact.peak)},
                     {"switches until frame 550", "most", switched(impact.peak + 1, impact.end)},
                     {"switches after frame 550", "some", switched(impact.end + 1, run.frames())},
                     {"last switch, frame", "1200", lastSwitch(run)},
                     {"tries that failed", "-", countOf(run.events(LevelEventKind::kBlocked))},
                     {"most requests that wait", "-", peakValue(run, "requests", 1, run.frames())},
                     {"retracted since the load is fine", "proposed", retractedByLoad(run)}});
  }
  return measures;
}

}  // namespace scatter::lab
