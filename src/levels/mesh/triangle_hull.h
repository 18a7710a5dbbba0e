#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "levels/polytope.h"

namespace scatter::levels {

using Triangle = std::array<std::uint32_t, 3>;

/// A convex hull as a closed surface of triangles, counter-clockwise from outside.
struct TriangleHull {
  std::vector<glm::dvec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<HalfSpace> planes;  ///< One per triangle.
  double area = 0.0;
  DoubleBounds bounds;

  /// How far the points stuck out of the hull when it had as many vertices as HullDef::budget.
  double excess = 0.0;
};

struct HullDef {
  double tolerance = 0.0;  ///< Points this close to the hull are left out.
  double thickness = 0.0;  ///< Sets thinner than this have no hull.
  int budget = 16;         ///< For TriangleHull::excess.
};

/// Makes hulls of point sets, farthest point first (quickhull). Keeps its memory for the next hull.
class HullBuilder {
 public:
  /// False if the points are too thin or rounding defeats it; `result` is then of no use.
  bool build(std::span<const glm::dvec3> points, const HullDef& definition, TriangleHull& result);

 private:
  enum class Outcome { kDone, kFlat, kInconsistent };

  struct Face {
    Triangle corners{};
    Triangle across{};  ///< The face beyond the edge from corner i to corner i + 1.
    HalfSpace plane;
    std::int32_t firstOutside = -1;  ///< A list through nextOutside_.
    std::int32_t farthest = -1;
    double distance = 0.0;  ///< Of the farthest point.
    bool isAlive = true;
    bool isVisible = false;
  };
  struct HorizonEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t outer = 0;  ///< The face that stays.
  };

  Outcome attempt(const HullDef& definition, TriangleHull& result);
  bool startSimplex(double thickness);
  void addFace(const Triangle& corners);
  void assign(std::uint32_t point, std::size_t firstFace);
  void enqueue(std::uint32_t face);
  std::int32_t takeFarthestFace();
  void collectVisible(std::uint32_t start, const glm::dvec3& eye);
  bool orderHorizon();
  bool insert(std::uint32_t face);
  void emit(TriangleHull& result) const;

  std::span<const glm::dvec3> originals_;  ///< What is returned.
  std::span<const glm::dvec3> points_;     ///< The same, moved a little or not.
  double tolerance_ = 0.0;
  std::vector<Face> faces_;
  std::vector<std::pair<double, std::uint32_t>>
      queue_;  ///< A heap of faces with points outside, by distance.
  std::vector<std::uint32_t> visible_;
  std::vector<HorizonEdge> horizon_;
  std::vector<std::int32_t> nextOutside_;
  std::vector<std::uint32_t> orphans_;
  std::vector<glm::dvec3> joggled_;
};

/// A point well inside: the centre of mass.
[[nodiscard]] glm::dvec3 centerOf(const TriangleHull& hull);

/// The distance of a point, 0 inside.
[[nodiscard]] double distanceTo(const TriangleHull& hull, const glm::dvec3& point);

/// How far the points reach along `direction`.
[[nodiscard]] double reach(std::span<const glm::dvec3> points, const glm::dvec3& direction);

}  // namespace scatter::levels
