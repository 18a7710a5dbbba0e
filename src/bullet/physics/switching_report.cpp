#include "bullet/physics/switching_report.h"

#include <cmath>

namespace scatter {

namespace {

std::uint32_t count(int number) {
  return static_cast<std::uint32_t>(number);
}

std::uint32_t whole(double number) {
  return static_cast<std::uint32_t>(std::lround(number));
}

}  // namespace

void addBodyCounts(const btHybridStepInfo& info, StepCounters& counters) {
  counters.requests += count(info.m_standingRequests);
  counters.switchesCoarser += count(info.m_switchesCoarser);
  counters.switchesFiner += count(info.m_switchesFiner);
  counters.retractions += count(info.m_retractions);
  counters.blockedTries += count(info.m_blockedTries);
  counters.separationQueries += count(info.m_separationQueries);
}

void addPairCounts(const btHybridPairStepInfo& info, StepCounters& counters) {
  counters.requests += count(info.m_requests);
  counters.switchesCoarser += count(info.m_switchesCoarser);
  counters.switchesFiner += count(info.m_switchesFiner);
  counters.retractions += count(info.m_retractions);
  counters.blockedTries += count(info.m_blockedTries);
  counters.separationQueries += count(info.m_separationQueries);
  counters.creditedPairs = count(info.m_creditedPairs);
  // Bodies are always at their finest level; of the pairs some are not.
  counters.finestPairs -= count(info.m_pairs - info.m_finestPairs);
  counters.touchingPairs = count(info.m_touchingPairs);
  counters.touchingFinestPairs = count(info.m_touchingFinest);
  counters.reusedPairs = count(info.m_reusedPairs);
  counters.costUnits = whole(info.m_units);
  counters.plannedUnits = whole(info.m_plannedUnits);
  counters.floorUnits = whole(info.m_floorUnits);
}

}  // namespace scatter
