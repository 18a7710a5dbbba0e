#include <scatter/lab/contact_check.h>

namespace scatter {

void ContactCheck::follow(std::uint64_t frame, const ContactReport& report) {
  if (report.missed > missed) {
    for (const MissedContact& contact : report.lastMissed) {
      if (firstMissed.size() < kMissesKept) {
        firstMissed.push_back({.frame = frame, .contact = contact});
      }
    }
  }
  steps = report.steps;
  childPairs = report.childPairs;
  expected = report.expected;
  missed = report.missed;
  extra = report.extra;
  doubtful = report.doubtful;
}

}  // namespace scatter
