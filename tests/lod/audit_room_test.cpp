#include "lod/audit_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

namespace scatter::lod {
namespace {

constexpr AuditRoom::Load kRoomy{.isShort = false, .isOver = false, .admission = 1.0};
constexpr AuditRoom::Load kShort{.isShort = true, .isOver = false, .admission = 0.0};
constexpr AuditRoom::Load kOver{.isShort = true, .isOver = true, .admission = 0.0};

/// Audits of so many units each that are made before those of this lateness have no room any more.
int countMade(AuditRoom& room, const AuditRoom::Load& load, float late, double each) {
  int made = 0;
  for (; made < 10'000 && late >= room.from(load); ++made) room.take(each);
  return made;
}

TEST(AuditRoom, HasRoomForAllWithoutABudget) {
  AuditRoom room;
  EXPECT_EQ(countMade(room, kOver, lateness::kDue, 1.0), 10'000);
}

TEST(AuditRoom, HasAShareForThoseThatAreDue) {
  AuditRoom room;
  room.begin(1000.0);
  const int roomy = countMade(room, kRoomy, lateness::kDue, 1.0);
  EXPECT_EQ(room.from(kRoomy), lateness::kLate) << "those that are late have all that there is";
  room.begin(1000.0);
  const int shorter = countMade(room, kShort, lateness::kDue, 1.0);
  EXPECT_GT(shorter, 0);
  EXPECT_LT(shorter, roomy);
  EXPECT_LT(roomy, 1000);
}

TEST(AuditRoom, HasAShareForThoseThatAreLateOverABudget) {
  AuditRoom room;
  room.begin(1000.0);
  const int made = countMade(room, kOver, lateness::kLate, 1.0);
  EXPECT_GT(made, 10);
  EXPECT_LT(made, 200);
  EXPECT_EQ(room.from(kOver), lateness::kNever);
}

TEST(AuditRoom, MakesOneOfAnySize) {
  AuditRoom room;
  for (int step = 0; step < 3; ++step) {
    room.begin(1000.0);
    EXPECT_EQ(countMade(room, kOver, 100.0F, 5000.0), 1);
    for (int i = 0; i < 5; ++i) room.takeOverdue(2.0F);
  }
}

/// Pairs that become later by `speeds` a step, over a budget of 200 times five units: how late the latest is
/// after the first steps.
float findLatest(double each, const std::vector<float>& speeds) {
  AuditRoom room;
  std::vector<float> late(speeds.size(), 0.0F);
  float latest = 0.0F;
  for (int step = 0; step < 400; ++step) {
    room.begin(1000.0);
    for (std::size_t i = 0; i < late.size(); ++i) {
      late[i] += speeds[i];
      if (late[i] >= room.from(kOver)) {
        room.take(each);
        late[i] = 0.0F;
      } else if (late[i] >= lateness::kLate) {
        room.takeOverdue(late[i] + speeds[i]);
      }
    }
    if (step > 200) latest = std::max(latest, *std::ranges::max_element(late));
  }
  return latest;
}

// 20 audits fit into a step, so that all of 200 take ten steps.
TEST(AuditRoom, StarvesNoneOverABudget) {
  const std::vector<float> alike(200, 0.5F);
  EXPECT_LE(findLatest(5.0, alike), 0.5F * 11);
}

// In the order of the pairs the first would have them all. 50 × 2 / 5.75 + 150 × 0.1 / 5.75 = 20.
TEST(AuditRoom, MakesThoseFirstThatHaveWaitedLongest) {
  std::vector<float> speeds(200, 0.1F);
  std::ranges::fill(std::span(speeds).first(50), 2.0F);
  EXPECT_LT(findLatest(5.0, speeds), 9.0F);
  std::ranges::reverse(speeds);
  EXPECT_LT(findLatest(5.0, speeds), 9.0F);
}

}  // namespace
}  // namespace scatter::lod
