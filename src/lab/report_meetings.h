#pragma once

#include <cstdint>
#include <optional>

#include "lab/report_run.h"

namespace scatter::lab {

/// How the two ships of Scene 1 meet: twice. What did not happen is absent.
struct ReportMeetings {
  std::optional<std::uint64_t> overlap;  ///< Of their bounds.
  std::optional<std::uint64_t> contact;
  std::optional<std::uint64_t> apart;  ///< Their bounds, after the first contact.
  std::optional<std::uint64_t> overlapAgain;
  std::optional<std::uint64_t> contactAgain;
};

[[nodiscard]] ReportMeetings findMeetings(const ReportRun& run);

/// How the crowd of Scene 2 collides: the impact ends in the last frame of which the report tells.
struct ReportImpact {
  std::optional<std::uint64_t> overlap;  ///< The first of any bounds.
  std::optional<std::uint64_t> contact;
  std::uint64_t peak = 1;  ///< The most manifolds of the impact.
  std::uint64_t end = 1;
};

[[nodiscard]] ReportImpact findImpact(const ReportRun& run);

}  // namespace scatter::lab
