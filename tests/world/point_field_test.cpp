#include <gtest/gtest.h>
#include <scatter/world/field.h>

#include <glm/geometric.hpp>

namespace scatter {

TEST(PointField, PullsWithConstantAccelerationInsideItsRadius) {
  const PointField field({1.0F, 2.0F, 3.0F}, 4.0F, 10.0F);
  for (const Vec3& away : {Vec3(0.1F, 0.0F, 0.0F), Vec3(3.0F, 4.0F, 0.0F), Vec3(0.0F, -9.9F, 0.0F)}) {
    const Vec3 pull = field.acceleration(Vec3(1.0F, 2.0F, 3.0F) + away);
    EXPECT_NEAR(glm::length(pull), 4.0F, 1e-4F);
    EXPECT_NEAR(glm::dot(glm::normalize(pull), glm::normalize(away)), -1.0F, 1e-4F);
  }
}

TEST(PointField, DoesNothingOutsideAndAtItsCenter) {
  const PointField field({1.0F, 2.0F, 3.0F}, 4.0F, 10.0F);
  EXPECT_EQ(field.acceleration({11.01F, 2.0F, 3.0F}), Vec3(0.0F));
  EXPECT_EQ(field.acceleration({1.0F, 2.0F, 3.0F}), Vec3(0.0F));
}

}  // namespace scatter
