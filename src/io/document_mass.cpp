#include "io/document_mass.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "levels/point_inertia.h"
#include "levels/principal_axes.h"

namespace scatter::io {
namespace {

bool isConvex(const DocumentShape& shape) {
  return std::holds_alternative<ConvexShape>(shape.geometry);
}

/// Kilograms of a shape that says what it weighs.
Result<std::optional<double>> ownMass(const DocumentShape& shape) {
  if (shape.mass) return static_cast<double>(*shape.mass);
  const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
  if (!shape.density || convex == nullptr) return std::nullopt;
  const auto properties = massProperties({{.shape = *convex, .pose = shape.pose}});
  if (!properties) return tl::unexpected(properties.error());
  return static_cast<double>(*shape.density) * static_cast<double>(properties->volume);
}

/// Whether the shapes' own masses say more than one density for all.
bool isUneven(const DocumentModel& model) {
  for (const DocumentShape& shape : model.shapes) {
    const DocumentShape& first = model.shapes.front();
    if (shape.mass ? model.shapes.size() > 1 : shape.density != first.density) return true;
  }
  return false;
}

/// Of shapes that each have a mass of their own.
Result<std::optional<MassProperties>> unevenMass(const DocumentModel& model) {
  struct Piece {
    MassProperties properties;
    double mass;
  };
  std::vector<Piece> pieces;
  double total = 0.0;
  MassProperties result;
  for (const DocumentShape& shape : model.shapes) {
    if (!isConvex(shape)) continue;
    const auto mass = ownMass(shape);
    if (!mass) return tl::unexpected(mass.error());
    if (!*mass) return std::nullopt;
    const auto properties = massProperties({{std::get<ConvexShape>(shape.geometry), shape.pose}});
    if (!properties) return tl::unexpected(properties.error());
    pieces.push_back({*properties, **mass});
    total += **mass;
    result.volume += properties->volume;
  }
  if (!(total > 0.0)) return std::nullopt;
  glm::dvec3 center(0.0);
  for (const Piece& piece : pieces) {
    center += piece.mass / total * glm::dvec3(piece.properties.centerOfMass);
  }
  glm::dmat3 inertia(0.0);
  for (const Piece& piece : pieces) {
    const glm::dvec3 out = glm::dvec3(piece.properties.centerOfMass) - center;
    inertia += piece.mass / total * (glm::dmat3(piece.properties.inertia) + levels::pointInertia(out));
  }
  result.centerOfMass = Vec3(center);
  result.inertia = Mat3(inertia);
  return result;
}

/// Of a homogeneous solid. Levels know that of theirs: it takes a while where many parts overlap.
Result<MassProperties> evenMass(const DocumentModel& model, const std::vector<ConvexPart>& parts) {
  if (model.levels) return model.levels->mass();
  return massProperties(parts);
}

}  // namespace

Result<float> documentMass(const DocumentModel& model, const DocumentBody& body) {
  if (body.mass) return *body.mass;
  if (model.mass) return *model.mass;
  double total = 0.0;
  for (const DocumentShape& shape : model.shapes) {
    const auto mass = ownMass(shape);
    if (!mass) return tl::unexpected(mass.error());
    total += mass->value_or(0.0);
  }
  return total > 0.0 ? static_cast<float>(total) : 1.0F;
}

Result<std::optional<MassProperties>> documentMassProperties(const DocumentModel& model,
                                                             const std::vector<ConvexPart>& parts,
                                                             float mass) {
  std::optional<MassProperties> result;
  if (isUneven(model)) {
    auto uneven = unevenMass(model);
    if (!uneven) return uneven;
    result = *uneven;
  }
  if (!model.massFrame) return result;
  if (!result) {
    auto even = evenMass(model, parts);
    if (!even) return tl::unexpected(even.error());
    result = *even;
  }
  const Transform& frame = model.massFrame->pose;
  result->centerOfMass = frame.position;
  if (!model.massFrame->inertia) return result;
  const Mat3 rotation = glm::mat3_cast(frame.rotation);
  Mat3 moments(0.0F);
  for (int axis = 0; axis < 3; ++axis) moments[axis][axis] = (*model.massFrame->inertia)[axis] / mass;
  result->inertia = rotation * moments * glm::transpose(rotation);
  return result;
}

std::optional<DocumentMassFrame> massFrameOf(const LevelSet& levels, float mass) {
  const auto even = massProperties(levels.finest().parts);
  const MassProperties& own = levels.mass();
  if (even && even->centerOfMass == own.centerOfMass && even->inertia == own.inertia) return std::nullopt;
  const PrincipalAxes axes = principalAxes(own.inertia);
  return DocumentMassFrame{{own.centerOfMass, axes.rotation}, axes.moments * mass};
}

Result<std::shared_ptr<const LevelSet>> levelsWithMass(const DocumentModel& model,
                                                       const std::vector<ConvexPart>& parts,
                                                       const std::optional<MassProperties>& mass) {
  LevelSetDef def;
  def.name = model.name;
  def.mass = mass;
  if (!model.levels) {
    def.levels = {Level{parts}};
    return LevelSet::create(std::move(def));
  }
  def.hullMargin = model.levels->hullMargin();
  for (int level = 1; level <= model.levels->count(); ++level) {
    def.levels.push_back(model.levels->level(level));
  }
  return LevelSet::create(std::move(def));
}

std::optional<std::size_t> documentMaterial(const DocumentModel& model) {
  if (model.material) return model.material;
  for (const DocumentShape& shape : model.shapes) {
    if (shape.material) return shape.material;
  }
  return std::nullopt;
}

}  // namespace scatter::io
