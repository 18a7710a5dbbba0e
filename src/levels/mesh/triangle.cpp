#include "levels/mesh/triangle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace scatter::levels {
namespace {

glm::dvec3 closestOnSegment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double squared = glm::dot(along, along);
  if (!(squared > 0.0)) return a;
  return a + along * std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0);
}

glm::dvec3 nearer(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
  return glm::dot(a - point, a - point) <= glm::dot(b - point, b - point) ? a : b;
}

}  // namespace

glm::dvec3 closestPoint(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b,
                        const glm::dvec3& c) {
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 ap = point - a;
  const double d1 = glm::dot(ab, ap);
  const double d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const glm::dvec3 bp = point - b;
  const double d3 = glm::dot(ab, bp);
  const double d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return closestOnSegment(point, a, b);
  const glm::dvec3 cp = point - c;
  const double d5 = glm::dot(ab, cp);
  const double d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return closestOnSegment(point, a, c);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return closestOnSegment(point, b, c);
  const double sum = va + vb + vc;
  if (sum > 0.0) return a + ab * (vb / sum) + ac * (vc / sum);
  return nearer(point, closestOnSegment(point, a, b),
                nearer(point, closestOnSegment(point, b, c), closestOnSegment(point, a, c)));
}

double triangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::length(areaVector(a, b, c));
}

glm::dvec3 areaVector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return 0.5 * glm::cross(b - a, c - a);
}

double solidAngle(const glm::dvec3& eye, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 toA = a - eye;
  const glm::dvec3 toB = b - eye;
  const glm::dvec3 toC = c - eye;
  const double la = glm::length(toA);
  const double lb = glm::length(toB);
  const double lc = glm::length(toC);
  const double across = glm::dot(toA, glm::cross(toB, toC));
  const double along =
      la * lb * lc + glm::dot(toA, toB) * lc + glm::dot(toB, toC) * la + glm::dot(toC, toA) * lb;
  return 2.0 * std::atan2(across, along);
}

}  // namespace scatter::levels
