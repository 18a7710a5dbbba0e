#pragma once

#include <scatter/levels/surface_mesh.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "levels/part_builders.h"

namespace scatter::testing {

/// A grid of points wrapped or not along each direction, with two triangles a cell.
template <class PointAt>
SurfaceMesh gridMesh(std::uint32_t columns, std::uint32_t rows, bool wrapsColumns, bool wrapsRows,
                     const PointAt& pointAt) {
  SurfaceMesh mesh;
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) mesh.vertices.push_back(pointAt(i, j));
  }
  const auto index = [&](std::uint32_t i, std::uint32_t j) { return (j % rows) * columns + i % columns; };
  for (std::uint32_t j = 0; j + (wrapsRows ? 0 : 1) < rows; ++j) {
    for (std::uint32_t i = 0; i + (wrapsColumns ? 0 : 1) < columns; ++i) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

inline Vec3 onCircle(double angle, double radius) {
  return Vec3(static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle)),
              0.0F);
}

inline double turn(std::uint32_t step, std::uint32_t steps) {
  return 2.0 * std::numbers::pi * step / steps;
}

/// A tube of the given radius around the closed curve `at(angle)`.
template <class At>
SurfaceMesh tubeMesh(std::uint32_t along, std::uint32_t around, float radius, const At& at) {
  return gridMesh(around, along, true, true, [&](std::uint32_t i, std::uint32_t j) {
    const double s = turn(j, along);
    const Vec3 forward = glm::normalize(at(s + 1e-3) - at(s - 1e-3));
    const Vec3 side = glm::normalize(glm::cross(forward, Vec3(0.12F, 0.2F, 1.0F)));
    const Vec3 up = glm::cross(forward, side);
    const Vec3 offset = onCircle(turn(i, around), static_cast<double>(radius));
    return at(s) + side * offset.x + up * offset.y;
  });
}

inline SurfaceMesh torusMesh(std::uint32_t along = 48, std::uint32_t around = 24, float radius = 0.3F) {
  return tubeMesh(along, around, radius, [](double s) { return onCircle(s, 1.0); });
}

/// A trefoil knot of 2 · along · around triangles.
inline SurfaceMesh knotMesh(std::uint32_t along, std::uint32_t around, float radius = 0.2F) {
  return tubeMesh(along, around, radius, [](double s) {
    const double reach = 1.0 + 0.45 * std::cos(3.0 * s);
    Vec3 point = onCircle(2.0 * s, reach);
    point.z = static_cast<float>(0.45 * std::sin(3.0 * s));
    return point;
  });
}

inline SurfaceMesh sphereMesh(std::uint32_t segments = 32, float radius = 1.0F, const Vec3& at = Vec3(0.0F)) {
  return gridMesh(segments, segments / 2 + 1, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double polar = 0.5 * turn(j, segments / 2);
    Vec3 point = onCircle(turn(i, segments), static_cast<double>(radius) * std::sin(polar));
    if (j == 0 || j == segments / 2) point = Vec3(0.0F);
    point.z = -radius * static_cast<float>(std::cos(polar));
    return at + point;
  });
}

/// A closed prism of `sides` sides, standing on y = `bottom`.
inline SurfaceMesh prismMesh(std::uint32_t sides, float radius, float bottom, float top,
                             const Vec3& at = Vec3(0.0F)) {
  SurfaceMesh mesh;
  for (const float y : {bottom, top}) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const Vec3 round = onCircle(turn(i, sides), static_cast<double>(radius));
      mesh.vertices.push_back(at + Vec3(round.x, y, round.y));
    }
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    mesh.triangles.push_back({i, sides + next, next});
    mesh.triangles.push_back({i, sides + i, sides + next});
    if (i < 2) continue;
    mesh.triangles.push_back({0, i - 1, i});
    mesh.triangles.push_back({sides, sides + i, sides + i - 1});
  }
  return mesh;
}

/// Twelve triangles around a box.
inline SurfaceMesh boxMesh(const Vec3& halfExtents, const Vec3& at = Vec3(0.0F)) {
  SurfaceMesh mesh;
  for (const Vec3& corner : boxCorners(halfExtents)) mesh.vertices.push_back(at + corner);
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

/// A bent sheet, open and without thickness.
inline SurfaceMesh sheetMesh(std::uint32_t steps = 20) {
  return gridMesh(steps, steps, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const float x = static_cast<float>(i) / static_cast<float>(steps - 1);
    const float y = static_cast<float>(j) / static_cast<float>(steps - 1);
    return Vec3(x, y, 0.3F * std::sin(5.0F * x) * std::cos(3.0F * y));
  });
}

/// A flat grid, level, with sides of 1 around the origin.
inline SurfaceMesh levelSheet(std::uint32_t steps = 8) {
  return gridMesh(steps, steps, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const auto last = static_cast<float>(steps - 1);
    return Vec3(static_cast<float>(j) / last - 0.5F, 0.0F, static_cast<float>(i) / last - 0.5F);
  });
}

/// A flat grid in a slanted plane.
inline SurfaceMesh flatMesh(std::uint32_t steps = 8) {
  return gridMesh(steps, steps, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const auto x = static_cast<float>(i);
    const auto y = static_cast<float>(j);
    return Vec3(x, y, 0.37F * x - 0.21F * y);
  });
}

/// A tube without ends.
inline SurfaceMesh openCylinderMesh(std::uint32_t segments = 32) {
  return gridMesh(segments, 9, true, false, [&](std::uint32_t i, std::uint32_t j) {
    Vec3 point = onCircle(turn(i, segments), 0.5);
    point.z = 0.25F * static_cast<float>(j);
    return point;
  });
}

/// A coil of thin wire.
inline SurfaceMesh wireMesh() {
  return tubeMesh(160, 5, 0.004F, [](double s) {
    Vec3 point = onCircle(4.0 * s, 1.0 + 0.1 * std::cos(s));
    point.z = static_cast<float>(std::sin(s));
    return point;
  });
}

/// Triangles anywhere, unconnected.
inline SurfaceMesh soupMesh(std::uint64_t seed, std::uint32_t count, float size = 0.2F) {
  Random random(seed);
  SurfaceMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3 at = random.inBox(Vec3(1.0F));
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(at + random.inBox(Vec3(size)));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

inline SurfaceMesh joined(SurfaceMesh a, const SurfaceMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

inline SurfaceMesh insideOut(SurfaceMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Three shells, one of them inside-out, and a cavity.
inline SurfaceMesh shellsMesh() {
  const SurfaceMesh hollow = joined(sphereMesh(24), insideOut(sphereMesh(16, 0.6F)));
  return joined(joined(hollow, insideOut(torusMesh(24, 12))),
                boxMesh(Vec3(0.3F, 0.1F, 0.7F), Vec3(3.0F, 0.2F, 0.0F)));
}

/// A closed room of 5 × 3 × 4 as it is seen from within, and furniture on its floor.
inline SurfaceMesh roomMesh() {
  return joined(insideOut(boxMesh({2.5F, 1.5F, 2.0F})),
                joined(boxMesh({0.5F, 0.4F, 0.3F}, {1.0F, -1.1F, 0.5F}),
                       boxMesh({0.3F, 0.3F, 0.3F}, {-1.0F, -1.2F, -0.5F})));
}

inline SurfaceMesh moved(SurfaceMesh mesh, float scale, const Vec3& by) {
  for (Vec3& vertex : mesh.vertices) vertex = scale * vertex + by;
  return mesh;
}

/// Each corner of each triangle is a vertex of its own, and triangles come twice.
inline SurfaceMesh unwelded(const SurfaceMesh& mesh) {
  SurfaceMesh result;
  for (int copy = 0; copy < 2; ++copy) {
    for (const auto& t : mesh.triangles) {
      const auto first = static_cast<std::uint32_t>(result.vertices.size());
      for (const std::uint32_t corner : t) result.vertices.push_back(mesh.vertices[corner]);
      result.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return result;
}

}  // namespace scatter::testing
