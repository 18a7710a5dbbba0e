#pragma once

#include <BulletHybrid/btHybridRequest.h>
#include <scatter/world/level_event.h>

#include <span>
#include <vector>

namespace scatter {

/// Collects what happens to requests, span by span. A span ends with a step and begins where the one
/// before it ended.
class LevelListener final : public btHybridListener {
 public:
  void requested(btHybridRigidBody* body, const btHybridRequest& request) override;
  void acknowledged(btHybridRigidBody* body, const btHybridRequest& request) override;
  void blocked(btHybridRigidBody* body, const btHybridRequest& request) override;
  void switched(btHybridRigidBody* body, int from, int to, const btHybridRequest& request) override;
  void retracted(btHybridRigidBody* body, const btHybridRequest& request, btHybridRetraction reason) override;

  void pairEvent(const btHybridPairEvent& event) override;

  /// To be called after each step.
  void endSpan();

  /// The last span's events, oldest first.
  [[nodiscard]] std::span<const LevelEvent> events() const { return ended_; }

 private:
  void add(LevelEventKind kind, const btHybridRigidBody& body, const btHybridRequest& request);

  std::vector<LevelEvent> ended_;
  std::vector<LevelEvent> open_;
};

}  // namespace scatter
