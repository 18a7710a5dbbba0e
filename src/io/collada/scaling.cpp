#include "io/collada/scaling.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <utility>

#include "io/collada/check.h"
#include "io/collada/frame.h"
#include "io/collada/round.h"

namespace scatter::io {
namespace {

/// A part that is being scaled: `linear` takes its local points to the scaled ones, all in its body's frame.
struct Scaling {
  glm::dmat3 linear;
  Vec3 position;    ///< Where its origin goes.
  Quat rotation;    ///< Its axes turned; exact only where `straight`.
  Vec3 size{1.0F};  ///< Along its axes; never negative.
  bool straight;    ///< The axes stay at right angles.
};

Scaling scalingOf(const Transform& pose, const Vec3& scale) {
  Scaling result{glm::dmat3(1.0), scale * pose.position, pose.rotation, Vec3(1.0F), true};
  const glm::dmat3 axes = glm::mat3_cast(glm::normalize(glm::dquat(pose.rotation)));
  glm::dvec3 images[3];
  for (int i = 0; i < 3; ++i) {
    images[i] = glm::dvec3(scale) * axes[i];
    result.linear[i] = images[i];
    result.size[i] = static_cast<float>(glm::length(images[i]));
    images[i] /= glm::length(images[i]);
  }
  const auto slant = [&](int i, int k) { return std::abs(glm::dot(images[i], images[k])); };
  result.straight = slant(0, 1) < 1e-5 && slant(0, 2) < 1e-5 && slant(1, 2) < 1e-5;
  if (glm::dot(glm::cross(images[0], images[1]), images[2]) < 0.0) {
    images[2] = -images[2];
  }
  if (result.straight) {
    result.rotation = unitRotation(Quat(glm::quat_cast(glm::dmat3(images[0], images[1], images[2]))));
  }
  return result;
}

bool same(float a, float b) {
  return std::abs(a - b) <= 1e-5F * std::abs(a);
}

/// Scales one convex shape; `exact` is cleared if it became a hull near it.
struct ShapeScaler {
  const Scaling& scaling;
  bool& exact;

  ConvexShape operator()(const Box& box) const {
    if (scaling.straight) {
      return Box{box.halfExtents * scaling.size};
    }
    ConvexHull corners;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 signs(corner % 2 == 0 ? -1.0F : 1.0F, corner / 2 % 2 == 0 ? -1.0F : 1.0F,
                       corner / 4 == 0 ? -1.0F : 1.0F);
      corners.vertices.push_back(signs * box.halfExtents);
    }
    return (*this)(std::move(corners));
  }
  ConvexShape operator()(const Sphere& sphere) const {
    if (isUniform()) {
      return Sphere{sphere.radius * scaling.size.x};
    }
    const RoundEnd end{0.0F, {sphere.radius, sphere.radius}, sphere.radius};
    return near(roundHull(end, end));
  }
  ConvexShape operator()(const Capsule& capsule) const {
    if (isUniform()) {
      return Capsule{capsule.radius * scaling.size.x, capsule.halfHeight * scaling.size.y};
    }
    return near(round(capsule.radius, capsule.halfHeight, capsule.radius));
  }
  ConvexShape operator()(const Cylinder& cylinder) const {
    if (scaling.straight && same(scaling.size.x, scaling.size.z)) {
      return Cylinder{cylinder.radius * scaling.size.x, cylinder.halfHeight * scaling.size.y};
    }
    return near(round(cylinder.radius, cylinder.halfHeight, 0.0F));
  }
  ConvexShape operator()(ConvexHull hull) const {
    for (Vec3& vertex : hull.vertices) {
      vertex = Vec3(scaling.linear * glm::dvec3(vertex));
    }
    return hull;
  }

  [[nodiscard]] bool isUniform() const {
    return scaling.straight && same(scaling.size.x, scaling.size.y) && same(scaling.size.x, scaling.size.z);
  }
  static ConvexHull round(float radius, float halfHeight, float cap) {
    return roundHull({-halfHeight, {radius, radius}, cap}, {halfHeight, {radius, radius}, cap});
  }
  [[nodiscard]] ConvexShape near(ConvexHull hull) const {
    exact = false;
    return (*this)(std::move(hull));
  }
};

/// A hull's vertices were moved into the body's axes, so that it is not turned any more.
Transform poseOf(const Scaling& scaling, bool hull) {
  return {scaling.position, hull ? kNoRotation : scaling.rotation};
}

bool scalePart(ConvexShape& shape, Transform& pose, const Vec3& scale) {
  bool exact = true;
  const Scaling scaling = scalingOf(pose, scale);
  shape = std::visit(ShapeScaler{scaling, exact}, std::move(shape));
  pose = poseOf(scaling, std::holds_alternative<ConvexHull>(shape));
  return exact;
}

void scalePlane(DocumentPlane& plane, Transform& pose, const Vec3& scale) {
  const Vec3 normal = (pose.rotation * plane.normal) / scale;
  const float offset = plane.offset + glm::dot(pose.rotation * plane.normal, pose.position);
  plane = {glm::normalize(normal), offset / glm::length(normal)};
  pose = {};
}

void scaleMesh(VisualMesh& mesh, Transform& pose, const Vec3& scale) {
  const Scaling scaling = scalingOf(pose, scale);
  for (Vec3& vertex : mesh.vertices) {
    vertex = Vec3(scaling.linear * glm::dvec3(vertex));
  }
  if (scale.x * scale.y * scale.z < 0.0F) {
    for (auto& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  pose = poseOf(scaling, true);
}

}  // namespace

bool scaleShapes(std::vector<DocumentShape>& shapes, const Vec3& scale) {
  bool exact = true;
  for (DocumentShape& shape : shapes) {
    if (auto* convex = std::get_if<ConvexShape>(&shape.geometry)) {
      exact = scalePart(*convex, shape.pose, scale) && exact;
    } else if (auto* plane = std::get_if<DocumentPlane>(&shape.geometry)) {
      scalePlane(*plane, shape.pose, scale);
    } else {
      scaleMesh(std::get<VisualMesh>(shape.geometry), shape.pose, scale);
    }
  }
  return exact;
}

Result<std::shared_ptr<const LevelSet>> scaleLevels(const LevelSet& levels, const Vec3& scale) {
  LevelSetDef def;
  def.name = levels.name();
  def.hullMargin = levels.hullMargin();
  for (int index = 1; index <= levels.count(); ++index) {
    def.levels.push_back(levels.level(index));
    for (ConvexPart& part : def.levels.back().parts) {
      if (!scalePart(part.shape, part.pose, scale)) {
        return fail("a round part cannot be scaled unequally");
      }
      if (findShapeDefect({part.shape, part.pose, {}, {}, {}}, kColladaBounds)) {
        return fail("a part gets too big or too small");
      }
    }
  }
  return LevelSet::create(std::move(def));
}

}  // namespace scatter::io
