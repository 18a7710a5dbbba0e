#include "lab/report_meetings.h"

#include <algorithm>

namespace scatter::lab {

namespace {

// The report's first and second peaks lie before this frame (section 5.1.5.2).
constexpr std::uint64_t kEndOfImpact = 550;

std::uint64_t after(const std::optional<std::uint64_t>& frame) {
  return *frame + 1;
}

}  // namespace

ReportMeetings findMeetings(const ReportRun& run) {
  ReportMeetings meetings;
  meetings.overlap = run.firstWith("overlapping_pairs", 1);
  meetings.contact = run.firstWith("contacts", 1);
  if (!meetings.contact) {
    return meetings;
  }
  meetings.apart = run.firstWithout("overlapping_pairs", after(meetings.contact));
  if (!meetings.apart) {
    return meetings;
  }
  meetings.overlapAgain = run.firstWith("overlapping_pairs", after(meetings.apart));
  meetings.contactAgain = run.firstWith("contacts", after(meetings.apart));
  return meetings;
}

ReportImpact findImpact(const ReportRun& run) {
  const std::uint64_t end = std::min(kEndOfImpact, run.frames());
  return {.overlap = run.firstWith("overlapping_pairs", 1),
          .contact = run.firstWith("contacts", 1),
          .peak = run.peakFrame("manifolds", 1, end),
          .end = end};
}

}  // namespace scatter::lab
