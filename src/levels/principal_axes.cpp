#include "levels/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace scatter {

namespace {

using Matrix = glm::dmat3;

double largestProduct(const Matrix& m) {
  return std::max({std::abs(m[0][1]), std::abs(m[0][2]), std::abs(m[1][2])});
}

double largestMoment(const Matrix& m) {
  return std::max({std::abs(m[0][0]), std::abs(m[1][1]), std::abs(m[2][2])});
}

/// The rotation by at most 45 degrees in the plane of axes p and q that makes the product m[p][q] zero.
Matrix jacobiRotation(const Matrix& m, int p, int q) {
  Matrix rotation(1.0);
  if (m[p][q] == 0.0) return rotation;
  const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
  const double tangent = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
  const double cosine = 1.0 / std::sqrt(tangent * tangent + 1.0);
  rotation[p][p] = rotation[q][q] = cosine;
  rotation[q][p] = tangent * cosine;
  rotation[p][q] = -tangent * cosine;
  return rotation;
}

}  // namespace

PrincipalAxes principalAxes(const Mat3& inertia) {
  constexpr double kNegligible = 1e-4;
  constexpr double kConverged = 1e-12;
  constexpr int kMaxSweeps = 32;

  Matrix tensor(inertia);
  Matrix axes(1.0);
  const double scale = largestMoment(tensor);
  if (largestProduct(tensor) > kNegligible * scale) {
    for (int sweep = 0; sweep < kMaxSweeps && largestProduct(tensor) > kConverged * scale; ++sweep) {
      for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
        const Matrix rotation = jacobiRotation(tensor, p, q);
        tensor = glm::transpose(rotation) * tensor * rotation;
        axes = axes * rotation;
      }
    }
  }
  return {glm::normalize(Quat(glm::quat_cast(axes))), Vec3(tensor[0][0], tensor[1][1], tensor[2][2])};
}

}  // namespace scatter
