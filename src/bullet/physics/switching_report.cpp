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
  counters.requests += count(info.requests);
  counters.switchesCoarser += count(info.switchesCoarser);
  counters.switchesFiner += count(info.switchesFiner);
  counters.retractions += count(info.retractions);
  counters.blockedTries += count(info.blockedTries);
  counters.separationQueries += count(info.separationQueries);
  counters.creditedPairs = count(info.creditedPairs);
  // Bodies are always at their finest level; of the pairs some are not.
  counters.finestPairs -= count(info.pairs - info.finestPairs);
  counters.touchingPairs = count(info.touchingPairs);
  counters.touchingFinestPairs = count(info.touchingFinest);
  counters.reusedPairs = count(info.reusedPairs);
  counters.hiddenContacts = count(info.hiddenContacts);
  counters.restingBodies = count(info.restingBodies);
  counters.wokenBodies = count(info.wokenBodies);
  counters.iterationsLeftOut = count(info.iterationsLeftOut);
  counters.costUnits = whole(info.units);
  counters.plannedUnits = whole(info.plannedUnits);
  counters.floorUnits = whole(info.floorUnits);
}

}  // namespace scatter
