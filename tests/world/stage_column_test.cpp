#include <gtest/gtest.h>
#include <scatter/world/step_report.h>

#include <set>

namespace scatter {

TEST(StageColumn, NamesEachStageOnce) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kStageCount; ++i) names.insert(stageColumn(static_cast<Stage>(i)));
  EXPECT_EQ(names.size(), kStageCount);
  EXPECT_EQ(stageColumn(Stage::kUpdateAabbs), "update_aabbs_ms");
  EXPECT_EQ(stageColumn(Stage::kNoncontactConstraints), "noncontact_constraints_ms");
  EXPECT_EQ(stageColumn(Stage::kContactConstraints), "contact_constraints_ms");
  EXPECT_EQ(stageColumn(Stage::kPlan), "plan_ms");
}

}  // namespace scatter
