#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "io/gltf/shapes.h"
#include "levels/convex_hull.h"

namespace scatter::io {
namespace {

constexpr int kScaledSides = 24;
constexpr double kNear = 1e-6;

/// What the scale of a shape's node does.
struct Scale {
  glm::dmat3 matrix{1.0};
  glm::dvec3 factors{1.0};  ///< Along the axes, positive.
  bool alongAxes = false;
  bool uniform = false;  ///< A rotation or mirror image times one factor.
  bool roundY = false;   ///< Along the axes, with one factor for x and z.
};

bool isNear(double a, double b) {
  return std::abs(a - b) <= kNear * std::max(std::abs(a), std::abs(b));
}

Scale analyse(const glm::dmat3& m) {
  Scale scale;
  scale.matrix = m;
  scale.factors = {glm::length(m[0]), glm::length(m[1]), glm::length(m[2])};
  const glm::dvec3& f = scale.factors;
  const auto isOff = [&](int column, int row) { return std::abs(m[column][row]) > kNear * f[column]; };
  scale.alongAxes =
      !isOff(0, 1) && !isOff(0, 2) && !isOff(1, 0) && !isOff(1, 2) && !isOff(2, 0) && !isOff(2, 1);
  // The error of an exact scale would show in sizes that are read back.
  if (scale.alongAxes) {
    scale.factors = {std::abs(m[0][0]), std::abs(m[1][1]), std::abs(m[2][2])};
  }
  const bool equal = isNear(f.x, f.y) && isNear(f.y, f.z);
  const double square = f.x * f.x;
  const auto isRight = [&](int a, int b) { return std::abs(glm::dot(m[a], m[b])) <= kNear * square; };
  scale.uniform = equal && isRight(0, 1) && isRight(1, 2) && isRight(2, 0);
  scale.roundY = scale.alongAxes && isNear(f.x, f.z);
  return scale;
}

/// Points of a circle at height `y`; a single one if the radius is zero.
void addCircle(std::vector<glm::dvec3>& points, double y, double radius) {
  for (int i = 0; i < (radius > 0.0 ? kScaledSides : 1); ++i) {
    const double angle = 2.0 * glm::pi<double>() * i / kScaledSides;
    points.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
  }
}

/// Points of a sphere around (0, y, 0), on circles about the y axis.
void addSphere(std::vector<glm::dvec3>& points, double y, double radius) {
  constexpr int kCircles = 8;
  for (int i = 0; i <= kCircles; ++i) {
    const double angle = glm::pi<double>() * i / kCircles;
    const bool pole = i == 0 || i == kCircles;
    addCircle(points, y - radius * std::cos(angle), pole ? 0.0 : radius * std::sin(angle));
  }
}

DocumentGeometry scaledHull(const std::vector<glm::dvec3>& points, const glm::dmat3& matrix) {
  ConvexHull hull;
  for (const glm::dvec3& point : points) {
    hull.vertices.emplace_back(matrix * point);
  }
  return ConvexShape(std::move(hull));
}

/// Scales one kind of shape each.
struct Scaler {
  const Scale& scale;

  ScaledShape operator()(const Box& box) const {
    const glm::dvec3 h(box.halfExtents);
    if (scale.alongAxes) {
      return {ConvexShape(Box{Vec3(h * scale.factors)}), ""};
    }
    std::vector<glm::dvec3> corners;
    for (unsigned i = 0; i < 8; ++i) {
      corners.emplace_back((i & 1U) != 0 ? h.x : -h.x, (i & 2U) != 0 ? h.y : -h.y,
                           (i & 4U) != 0 ? h.z : -h.z);
    }
    return {scaledHull(corners, scale.matrix), ""};
  }

  ScaledShape operator()(const Sphere& sphere) const {
    const auto radius = static_cast<double>(sphere.radius);
    if (scale.uniform) {
      return {ConvexShape(Sphere{static_cast<float>(radius * scale.factors.x)}), ""};
    }
    std::vector<glm::dvec3> points;
    addSphere(points, 0.0, radius);
    return {scaledHull(points, scale.matrix),
            "the node's scale makes an ellipsoid of the sphere; it is read as "
            "a convex hull"};
  }

  ScaledShape operator()(const GltfRound& round) const {
    const bool tapered = round.radiusBottom != round.radiusTop;
    const double radius = round.radiusTop;
    const double half = round.height / 2.0;
    const bool upright = scale.roundY && (!round.capsule || scale.uniform);
    if (!tapered && upright) {
      const auto scaledRadius = static_cast<float>(radius * scale.factors.x);
      const auto scaledHalf = static_cast<float>(half * scale.factors.y);
      return {round.capsule ? ConvexShape(Capsule{scaledRadius, scaledHalf})
                            : ConvexShape(Cylinder{scaledRadius, scaledHalf}),
              ""};
    }
    std::vector<glm::dvec3> points;
    const auto addEnd = [&](double y, double r) {
      round.capsule ? addSphere(points, y, r) : addCircle(points, y, r);
    };
    addEnd(-half, round.radiusBottom);
    addEnd(half, round.radiusTop);
    const std::string kind = round.capsule ? "capsule" : "cylinder";
    return {scaledHull(points, scale.matrix),
            tapered ? "a " + kind + " with two radii is read as a convex hull"
                    : "the node's scale leaves no " + kind + "; it is read as a convex hull"};
  }

  ScaledShape operator()(const GltfPlane& plane) const {
    std::string note = plane.doubleSided ? "a double-sided plane is read as single-sided" : "";
    if (plane.sizeX && plane.sizeZ) {
      return {sheet(*plane.sizeX / 2.0, *plane.sizeZ / 2.0), std::move(note)};
    }
    if (plane.sizeX || plane.sizeZ) {
      note += note.empty() ? "" : "; ";
      note += "a plane of finite size along one axis is read as an infinite one";
    }
    // Normals turn with the inverse transpose.
    const glm::dvec3 normal = glm::transpose(glm::inverse(scale.matrix)) * glm::dvec3(0.0, 1.0, 0.0);
    const bool up = scale.alongAxes && normal.y > 0.0;
    return {DocumentPlane{up ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(glm::normalize(normal)), 0.0F}, std::move(note)};
  }

  ScaledShape operator()(const ConvexHull& hull) const {
    std::vector<glm::dvec3> points;
    for (const Vec3& vertex : hull.vertices) {
      points.emplace_back(vertex);
    }
    return {scaledHull(points, scale.matrix), ""};
  }

  /// A rectangle that faces along y.
  [[nodiscard]] VisualMesh sheet(double x, double z) const {
    VisualMesh mesh;
    for (const auto& [sx, sz] : {std::pair{-x, -z}, std::pair{-x, z}, std::pair{x, z}, std::pair{x, -z}}) {
      mesh.vertices.emplace_back(scale.matrix * glm::dvec3(sx, 0.0, sz));
    }
    const bool mirrored = glm::determinant(scale.matrix) < 0.0;
    mesh.triangles = {{0, mirrored ? 2U : 1U, mirrored ? 1U : 2U},
                      {0, mirrored ? 3U : 2U, mirrored ? 2U : 3U}};
    return mesh;
  }
};

std::tuple<float, float, float> key(const Vec3& v) {
  // A negative zero compares equal to a plain one.
  return {v.x, v.y, v.z};
}

std::vector<glm::dvec3> toDoubles(const std::vector<Vec3>& points) {
  return {points.begin(), points.end()};
}

}  // namespace

std::optional<ScaledShape> scaleShape(const GltfShape& shape, const glm::dmat3& stretch) {
  const Scale scale = analyse(stretch);
  const double volume = std::abs(glm::determinant(stretch));
  if (!(volume > 1e-9 * scale.factors.x * scale.factors.y * scale.factors.z)) {
    return std::nullopt;
  }
  return std::visit(Scaler{scale}, shape);
}

Result<std::vector<Vec3>> hullCorners(const std::vector<Vec3>& points) {
  const auto hull = levels::convexHull(toDoubles(points));
  if (!hull) {
    return tl::unexpected(hull.error());
  }
  std::set<std::tuple<float, float, float>> corners;
  for (const glm::dvec3& corner : hull->vertices()) {
    corners.insert(key(Vec3(corner)));
  }
  std::vector<Vec3> result;
  for (const Vec3& point : points) {
    // Erased, so that a point that comes twice is taken once.
    if (corners.erase(key(point)) > 0) {
      result.push_back(point);
    }
  }
  // A hull that qhull had to move a little has corners that are none of the points.
  return corners.empty() ? result : points;
}

std::vector<std::array<std::uint32_t, 3>> hullTriangles(const std::vector<Vec3>& points) {
  const auto hull = levels::convexHull(toDoubles(points));
  std::map<std::tuple<float, float, float>, std::uint32_t> indices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    indices.emplace(key(points[i]), static_cast<std::uint32_t>(i));
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t f = 0; hull && f < hull->faces().size(); ++f) {
    const auto loop = hull->loop(hull->faces()[f]);
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t vertex : loop) {
      const auto found = indices.find(key(Vec3(hull->vertices()[vertex])));
      if (found == indices.end()) {
        return {};
      }
      corners.push_back(found->second);
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  return triangles;
}

}  // namespace scatter::io
