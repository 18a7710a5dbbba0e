#include "levels/principal_axes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <random>

namespace scatter {

namespace {

Mat3 diagonal(const Vec3& moments) {
  Mat3 m(0.0F);
  for (int i = 0; i < 3; ++i) m[i][i] = moments[i];
  return m;
}

float largestDifference(const Mat3& a, const Mat3& b) {
  float largest = 0.0F;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
  }
  return largest;
}

}  // namespace

TEST(PrincipalAxes, DiagonalTensorIsLeftAlone) {
  const PrincipalAxes axes = principalAxes(diagonal({1.0F, 2.0F, 3.0F}));
  EXPECT_EQ(axes.rotation, kNoRotation);
  EXPECT_EQ(axes.moments, Vec3(1.0F, 2.0F, 3.0F));
}

TEST(PrincipalAxes, RoundingDoesNotTurnASymmetricTensor) {
  Mat3 tensor = diagonal(Vec3(2.0F));
  tensor[0][1] = tensor[1][0] = 1e-6F;
  EXPECT_EQ(principalAxes(tensor).rotation, kNoRotation);
}

TEST(PrincipalAxes, GivesBackTheTensor) {
  std::mt19937 random(1);
  const auto uniform = [&random] {
    return static_cast<float>(random() >> 8U) / static_cast<float>(1U << 24U);
  };
  for (int i = 0; i < 200; ++i) {
    const Vec3 moments{1.0F + uniform(), 1.0F + 2.0F * uniform(), 1.0F + 0.01F * uniform()};
    const Quat turned = glm::normalize(Quat(uniform(), uniform(), uniform(), uniform() - 0.5F));
    const Mat3 basis = glm::mat3_cast(turned);
    const Mat3 tensor = basis * diagonal(moments) * glm::transpose(basis);
    const PrincipalAxes axes = principalAxes(tensor);
    const Mat3 found = glm::mat3_cast(axes.rotation);
    EXPECT_NEAR(glm::determinant(found), 1.0F, 1e-5F);
    // Products under 1e-4 of the largest moment are ignored.
    EXPECT_LT(largestDifference(found * diagonal(axes.moments) * glm::transpose(found), tensor), 4e-4F);
  }
}

}  // namespace scatter
