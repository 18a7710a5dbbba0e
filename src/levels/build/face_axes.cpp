#include "levels/build/face_axes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "levels/mesh/triangle.h"

namespace scatter::levels {
namespace {

constexpr int kSweeps = 30;

/// Faces whose directions differ by less lie in one plane, as far as one can tell in single precision.
constexpr double kSameDirection = 1e-4;

/// Rotates two axes so that `matrix` has no entry that couples them (Jacobi).
void decouple(glm::dmat3& matrix, glm::dmat3& axes, int p, int q) {
  if (std::abs(matrix[p][q]) < 1e-300) return;
  const double angle = 0.5 * std::atan2(2.0 * matrix[p][q], matrix[q][q] - matrix[p][p]);
  glm::dmat3 turn{1.0};
  turn[p][p] = turn[q][q] = std::cos(angle);
  turn[q][p] = std::sin(angle);
  turn[p][q] = -std::sin(angle);
  matrix = glm::transpose(turn) * matrix * turn;
  axes = axes * turn;
}

}  // namespace

glm::dmat3 faceAxes(const TriangleHull& hull) {
  glm::dmat3 scatter{0.0};
  for (std::size_t i = 0; i < hull.triangles.size(); ++i) {
    const Triangle& t = hull.triangles[i];
    const double area = triangleArea(hull.vertices[t[0]], hull.vertices[t[1]], hull.vertices[t[2]]);
    scatter += area * glm::outerProduct(hull.planes[i].normal, hull.planes[i].normal);
  }
  glm::dmat3 axes{1.0};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    decouple(scatter, axes, 0, 1);
    decouple(scatter, axes, 0, 2);
    decouple(scatter, axes, 1, 2);
  }
  axes[0] = glm::normalize(axes[0]);
  axes[1] = glm::normalize(axes[1] - axes[0] * glm::dot(axes[0], axes[1]));
  axes[2] = glm::cross(axes[0], axes[1]);
  return axes;
}

glm::dvec3 anyAcross(const glm::dvec3& direction) {
  const glm::dvec3 other =
      std::abs(direction.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  return glm::normalize(glm::cross(direction, other));
}

glm::dvec3 largestFace(const TriangleHull& hull) {
  struct Face {
    glm::dvec3 normal{0.0};
    double area = 0.0;
  };
  std::vector<Face> faces;
  for (std::size_t i = 0; i < hull.triangles.size(); ++i) {
    const Triangle& t = hull.triangles[i];
    const glm::dvec3& normal = hull.planes[i].normal;
    const auto isSame = [&](const Face& face) { return glm::length(face.normal - normal) < kSameDirection; };
    auto face = std::find_if(faces.begin(), faces.end(), isSame);
    if (face == faces.end()) face = faces.insert(faces.end(), Face{normal, 0.0});
    face->area += triangleArea(hull.vertices[t[0]], hull.vertices[t[1]], hull.vertices[t[2]]);
  }
  if (faces.empty()) return {0.0, 1.0, 0.0};
  return std::max_element(faces.begin(), faces.end(),
                          [](const Face& a, const Face& b) { return a.area < b.area; })
      ->normal;
}

}  // namespace scatter::levels
