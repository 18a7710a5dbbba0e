#include "io/gltf/comparison.h"

#include <algorithm>
#include <cmath>

namespace scatter::test {
namespace {

bool same(const Transform& a, const Transform& b) {
  return a.position == b.position && a.rotation == b.rotation;
}

bool same(const VisualMesh& a, const VisualMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles;
}

bool same(const ConvexShape& a, const ConvexShape& b) {
  if (a.index() != b.index()) {
    return false;
  }
  if (const auto* box = std::get_if<Box>(&a)) {
    return box->halfExtents == std::get<Box>(b).halfExtents;
  }
  if (const auto* sphere = std::get_if<Sphere>(&a)) {
    return sphere->radius == std::get<Sphere>(b).radius;
  }
  if (const auto* capsule = std::get_if<Capsule>(&a)) {
    return capsule->radius == std::get<Capsule>(b).radius &&
           capsule->halfHeight == std::get<Capsule>(b).halfHeight;
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&a)) {
    return cylinder->radius == std::get<Cylinder>(b).radius &&
           cylinder->halfHeight == std::get<Cylinder>(b).halfHeight;
  }
  return std::get<ConvexHull>(a).vertices == std::get<ConvexHull>(b).vertices;
}

std::string difference(const DocumentShape& a, const DocumentShape& b) {
  if (a.geometry.index() != b.geometry.index()) {
    return ".kind";
  }
  bool geometry = false;
  if (const auto* convex = std::get_if<ConvexShape>(&a.geometry)) {
    geometry = same(*convex, std::get<ConvexShape>(b.geometry));
  } else if (const auto* plane = std::get_if<DocumentPlane>(&a.geometry)) {
    const auto& other = std::get<DocumentPlane>(b.geometry);
    geometry = plane->normal == other.normal && plane->offset == other.offset;
  } else {
    geometry = same(std::get<VisualMesh>(a.geometry), std::get<VisualMesh>(b.geometry));
  }
  if (!geometry) return ".geometry";
  if (!same(a.pose, b.pose)) return ".pose";
  if (a.material != b.material) return ".material";
  return a.density != b.density || a.mass != b.mass ? ".density or mass" : "";
}

bool same(const Level& a, const Level& b) {
  return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                    [](const ConvexPart& x, const ConvexPart& y) {
                      return same(x.shape, y.shape) && same(x.pose, y.pose);
                    });
}

std::string difference(const LevelSet& a, const LevelSet& b) {
  if (a.name() != b.name()) return ".name";
  if (a.count() != b.count()) return ".count";
  if (a.hullMargin() != b.hullMargin()) return ".hullMargin";
  for (int i = 1; i <= a.count(); ++i) {
    if (!same(a.level(i), b.level(i))) {
      return ".level(" + std::to_string(i) + ")";
    }
  }
  const bool mass = a.mass().volume == b.mass().volume && a.mass().centerOfMass == b.mass().centerOfMass &&
                    a.mass().inertia == b.mass().inertia;
  return mass ? "" : ".mass";
}

/// The first difference of two lists, by a function that gives that of two entries.
template <class List, class Difference>
std::string eachDifference(const std::string& name, const List& a, const List& b, const Difference& find) {
  if (a.size() != b.size()) {
    return name + ".size " + std::to_string(a.size()) + " and " + std::to_string(b.size());
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (const std::string found = find(a[i], b[i]); !found.empty()) {
      return name + "[" + std::to_string(i) + "]" + found;
    }
  }
  return "";
}

std::string modelDifference(const DocumentModel& a, const DocumentModel& b) {
  if (a.name != b.name) return ".name \"" + a.name + "\" and \"" + b.name + "\"";
  const std::string shapes = eachDifference(".shapes", a.shapes, b.shapes,
                                            [](const auto& x, const auto& y) { return difference(x, y); });
  if (!shapes.empty()) return shapes;
  if ((a.levels == nullptr) != (b.levels == nullptr)) return ".levels";
  if (a.levels) {
    if (const std::string levels = difference(*a.levels, *b.levels); !levels.empty())
      return ".levels" + levels;
  }
  if (!same(a.mesh, b.mesh)) return ".mesh";
  if (a.motion != b.motion) return ".motion";
  if (a.mass != b.mass) return ".mass";
  if (a.material != b.material) return ".material";
  const bool frames = a.massFrame.has_value() == b.massFrame.has_value() &&
                      (!a.massFrame || (same(a.massFrame->pose, b.massFrame->pose) &&
                                        a.massFrame->inertia == b.massFrame->inertia));
  return frames ? "" : ".massFrame";
}

std::string bodyDifference(const DocumentBody& a, const DocumentBody& b) {
  if (a.name != b.name) return ".name \"" + a.name + "\" and \"" + b.name + "\"";
  if (a.model != b.model) return ".model";
  if (!same(a.pose, b.pose)) return ".pose";
  if (a.linearVelocity != b.linearVelocity) return ".linearVelocity";
  if (a.angularVelocity != b.angularVelocity) return ".angularVelocity";
  if (a.motion != b.motion) return ".motion";
  if (a.gravityFactor != b.gravityFactor) return ".gravityFactor";
  if (a.filter != b.filter) return ".filter";
  return a.mass == b.mass ? "" : ".mass";
}

bool isFree(const DocumentLimit& limit) {
  return limit.lower > limit.upper || (std::isinf(limit.lower) && std::isinf(limit.upper));
}

std::string jointDifference(const DocumentJoint& a, const DocumentJoint& b) {
  const auto limits = [](const DocumentLimit& x, const DocumentLimit& y) {
    return (isFree(x) && isFree(y)) || (x.lower == y.lower && x.upper == y.upper);
  };
  if (a.name != b.name) return ".name";
  if (a.bodyA != b.bodyA || a.bodyB != b.bodyB) return ".body";
  if (!same(a.frameA, b.frameA) || !same(a.frameB, b.frameB)) return ".frame";
  if (!std::equal(a.linear.begin(), a.linear.end(), b.linear.begin(), limits)) return ".linear";
  if (!std::equal(a.angular.begin(), a.angular.end(), b.angular.begin(), limits)) return ".angular";
  return a.enabled == b.enabled && a.bodiesCollide == b.bodiesCollide ? "" : ".flags";
}

std::string materialDifference(const DocumentMaterial& a, const DocumentMaterial& b) {
  if (a.name != b.name) return ".name";
  return a.staticFriction == b.staticFriction && a.dynamicFriction == b.dynamicFriction &&
                 a.restitution == b.restitution
             ? ""
             : ".values";
}

std::string fieldDifference(const DocumentField& a, const DocumentField& b) {
  const bool values =
      a.name == b.name && a.center == b.center && a.acceleration == b.acceleration && a.radius == b.radius;
  return values ? "" : ".values";
}

}  // namespace

std::string findDifference(const PhysicsDocument& a, const PhysicsDocument& b) {
  if (a.name != b.name) return "name \"" + a.name + "\" and \"" + b.name + "\"";
  if (a.gravity != b.gravity) return "gravity";
  if (a.timeStep != b.timeStep) return "timeStep";
  if (a.filters != b.filters) return "filters";
  for (const std::string& found : {eachDifference("materials", a.materials, b.materials, materialDifference),
                                   eachDifference("models", a.models, b.models, modelDifference),
                                   eachDifference("bodies", a.bodies, b.bodies, bodyDifference),
                                   eachDifference("joints", a.joints, b.joints, jointDifference),
                                   eachDifference("fields", a.fields, b.fields, fieldDifference)}) {
    if (!found.empty()) {
      return found;
    }
  }
  return "";
}

}  // namespace scatter::test
