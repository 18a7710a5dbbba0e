#include "bullet/physics/collision_report.h"

#include "bullet/physics/body.h"

namespace scatter {

namespace {

template <class Count>
std::uint64_t wide(Count count) {
  return static_cast<std::uint64_t>(count);
}

MissedContact reported(const btHybridMissedContact& missed) {
  return {.bodyA = BulletBody::of(*missed.m_bodyA).name(),
          .bodyB = BulletBody::of(*missed.m_bodyB).name(),
          .childA = missed.m_childA,
          .childB = missed.m_childB,
          .distance = missed.m_distance};
}

}  // namespace

ContactReport fromBullet(const btHybridContactReport& report) {
  ContactReport result{.steps = wide(report.m_steps),
                       .childPairs = wide(report.m_childPairs),
                       .expected = wide(report.m_expected),
                       .missed = wide(report.m_missed),
                       .extra = wide(report.m_extra),
                       .doubtful = wide(report.m_doubtful + report.m_bulletErrs),
                       .lastMissed = {}};
  for (int i = 0; i < report.m_lastMissed.size(); ++i) {
    result.lastMissed.push_back(reported(report.m_lastMissed[i]));
  }
  return result;
}

CollisionMemory fromBullet(const btHybridCollisionMemory& memory) {
  return {.pairs = wide(memory.m_pairs),
          .childPairs = wide(memory.m_childPairs),
          .pairBytes = wide(memory.m_pairBytes),
          .childPairBytes = wide(memory.m_childPairBytes),
          .bodyBytes = wide(memory.m_bodyBytes),
          .partBytes = wide(memory.m_partBytes)};
}

}  // namespace scatter
