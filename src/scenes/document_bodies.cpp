#include "scenes/document_bodies.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/document_mass.h"

namespace scatter {
namespace {

constexpr std::size_t kMostBodies = 100000;
constexpr std::size_t kManyHullVertices = 256;

Motion motionOf(DocumentMotion motion) {
  switch (motion) {
    case DocumentMotion::kStatic:
      return Motion::kStatic;
    case DocumentMotion::kKinematic:
      return Motion::kKinematic;
    case DocumentMotion::kDynamic:
      break;
  }
  return Motion::kDynamic;
}

/// The bits of BodyDef::group. A bit stands for all systems that a body is of at once: so two bits tell
/// whether bodies of several systems collide.
class FilterBits {
 public:
  explicit FilterBits(const std::vector<DocumentFilter>& filters) : filters_(filters) {
    sets_.emplace_back();  // Those without systems, and all that no document made.
    for (const DocumentFilter& filter : filters) {
      if (std::find(sets_.begin(), sets_.end(), systemsOf(filter)) == sets_.end())
        sets_.push_back(systemsOf(filter));
    }
  }

  [[nodiscard]] Result<void> check() const {
    if (sets_.size() <= kMostSets) return {};
    return fail("its bodies are of " + std::to_string(sets_.size() - 1) +
                " different sets of collision systems; at most " + std::to_string(kMostSets - 1) +
                " are told apart");
  }

  void set(std::size_t filter, BodyDef& def) const {
    const auto own = std::find(sets_.begin(), sets_.end(), systemsOf(filters_[filter]));
    def.group = 1U << static_cast<unsigned>(own - sets_.begin());
    def.collidesWith = 0;
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      if (allows(filters_[filter], sets_[i])) def.collidesWith |= 1U << static_cast<unsigned>(i);
    }
  }

 private:
  using Systems = std::set<std::string>;
  static constexpr std::size_t kMostSets = 31;  // Masks may be read as signed numbers.

  static Systems systemsOf(const DocumentFilter& filter) {
    return {filter.systems.begin(), filter.systems.end()};
  }
  static bool meets(const Systems& systems, const std::vector<std::string>& others) {
    return std::any_of(others.begin(), others.end(),
                       [&](const auto& other) { return systems.count(other) > 0; });
  }
  static bool allows(const DocumentFilter& filter, const Systems& others) {
    if (!filter.collideWith.empty()) return meets(others, filter.collideWith);
    return !meets(others, filter.notCollideWith);
  }

  const std::vector<DocumentFilter>& filters_;
  std::vector<Systems> sets_;
};

/// Makes the bodies of one document.
class Maker {
 public:
  Maker(const PhysicsDocument& document, DocumentWarnings& warnings)
      : document_(document), warnings_(warnings), filters_(document.filters) {}

  [[nodiscard]] Result<void> check() const { return filters_.check(); }
  Result<void> add(const DocumentBody& body);
  DocumentBodies take() { return std::move(bodies_); }

 private:
  Result<Shape> solid(const DocumentModel& model, float mass);
  std::vector<ConvexPart> convexParts(const DocumentModel& model, bool meshes);
  void setMaterial(const DocumentModel& model, Material& material);
  void addStaticShapes(const DocumentModel& model, const BodyDef& common);
  std::shared_ptr<const SurfaceMesh> drawn(const DocumentModel& model);
  [[nodiscard]] BodyDef common(const DocumentModel& model, const DocumentBody& body);

  const PhysicsDocument& document_;
  DocumentWarnings& warnings_;
  FilterBits filters_;
  DocumentBodies bodies_{};

  /// Level sets with a mass of their own, by model and mass: bodies of a kind share them.
  std::map<std::pair<const DocumentModel*, float>, std::shared_ptr<const LevelSet>> levels_;
  std::map<const DocumentModel*, std::shared_ptr<const SurfaceMesh>> meshes_;
};

bool hasPlane(const DocumentModel& model) {
  for (const DocumentShape& shape : model.shapes) {
    if (std::holds_alternative<DocumentPlane>(shape.geometry)) return true;
  }
  return false;
}

void Maker::setMaterial(const DocumentModel& model, Material& material) {
  const std::optional<std::size_t> index = io::documentMaterial(model);
  if (!index) return;
  for (const DocumentShape& shape : model.shapes) {
    if (shape.material && *shape.material != *index) {
      warnings_.add("model \"" + model.name + "\": a body has one material; \"" +
                    document_.materials[*index].name + "\" is taken for all its shapes");
      break;
    }
  }
  const DocumentMaterial& given = document_.materials[*index];
  if (given.staticFriction != given.dynamicFriction) {
    warnings_.add("material \"" + given.name +
                  "\": static friction is not told apart; the dynamic one is taken for both");
  }
  material.friction = given.dynamicFriction;
  material.restitution = given.restitution;
}

BodyDef Maker::common(const DocumentModel& model, const DocumentBody& body) {
  BodyDef def;
  def.name = body.name;
  def.motion = motionOf(body.motion.value_or(model.motion));
  def.pose = body.pose;
  def.linearVelocity = body.linearVelocity;
  def.angularVelocity = body.angularVelocity;
  if (def.motion == Motion::kDynamic && hasPlane(model)) {
    warnings_.add("body \"" + body.name + "\": a plane can only be static; so is the body");
    def.motion = Motion::kStatic;
  }
  if (def.motion != Motion::kDynamic) {
    const bool moves = body.linearVelocity != Vec3(0.0F) || body.angularVelocity != Vec3(0.0F);
    if (moves && def.motion == Motion::kKinematic) {
      warnings_.add("body \"" + body.name + "\": nothing moves a kinematic body; its velocity is left out");
    }
    def.linearVelocity = def.angularVelocity = Vec3(0.0F);
  }
  setMaterial(model, def.material);
  def.gravityFactor = body.gravityFactor;
  if (body.filter) filters_.set(*body.filter, def);
  return def;
}

std::vector<ConvexPart> Maker::convexParts(const DocumentModel& model, bool meshes) {
  std::vector<ConvexPart> parts;
  for (const DocumentShape& shape : model.shapes) {
    if (const auto* convex = std::get_if<ConvexShape>(&shape.geometry)) {
      parts.push_back({.shape = *convex, .pose = shape.pose});
      continue;
    }
    const auto* mesh = std::get_if<VisualMesh>(&shape.geometry);
    if (mesh == nullptr || !meshes) continue;
    warnings_.add("model \"" + model.name +
                  "\": a mesh of a body that moves is taken as its convex hull; make levels from it" +
                  (mesh->vertices.size() > kManyHullVertices ? ", which also makes it cheaper" : ""));
    parts.push_back({.shape = ConvexHull{mesh->vertices}, .pose = shape.pose});
  }
  return parts;
}

Result<Shape> Maker::solid(const DocumentModel& model, float mass) {
  const std::vector<ConvexPart> parts =
      model.levels ? model.levels->finest().parts : convexParts(model, true);
  const auto known = levels_.find({&model, mass});
  if (known != levels_.end()) return known->second;
  const auto properties = io::documentMassProperties(model, parts, mass);
  if (!properties) return tl::unexpected(properties.error());
  if (*properties) {
    auto levels = io::levelsWithMass(model, parts, *properties);
    if (!levels) return tl::unexpected(levels.error());
    levels_.emplace(std::pair(&model, mass), *levels);
    return std::move(*levels);
  }
  if (model.levels) return model.levels;
  if (parts.empty()) return fail("it has no shape");
  const Transform& pose = parts.front().pose;
  if (parts.size() == 1 && pose.position == Vec3(0.0F) && pose.rotation == kNoRotation) {
    return std::visit([](const auto& convex) -> Shape { return convex; }, parts.front().shape);
  }
  return Compound{parts};
}

/// Planes and meshes are bodies of their own.
void Maker::addStaticShapes(const DocumentModel& model, const BodyDef& common) {
  for (const DocumentShape& shape : model.shapes) {
    BodyDef def = common;
    if (bodies_.defs.size() > bodies_.first.back()) {
      def.name += "-" + std::to_string(bodies_.defs.size() - bodies_.first.back() + 1);
    }
    if (const auto* plane = std::get_if<DocumentPlane>(&shape.geometry)) {
      const Transform pose = common.pose * shape.pose;
      const float length = glm::length(plane->normal);
      const Vec3 normal = pose.rotation * (plane->normal / length);
      def.shape = Plane{normal, plane->offset / length + glm::dot(normal, pose.position)};
      def.pose = {};
    } else if (const auto* mesh = std::get_if<VisualMesh>(&shape.geometry)) {
      def.shape = std::make_shared<const TriangleMesh>(TriangleMesh{mesh->vertices, mesh->triangles});
      def.pose = common.pose * shape.pose;
    } else {
      continue;
    }
    bodies_.defs.push_back(std::move(def));
  }
}

/// One for all bodies of the model.
std::shared_ptr<const SurfaceMesh> Maker::drawn(const DocumentModel& model) {
  if (model.mesh.triangles.empty()) return nullptr;
  std::shared_ptr<const SurfaceMesh>& mesh = meshes_[&model];
  if (!mesh) mesh = std::make_shared<const SurfaceMesh>(model.mesh);
  return mesh;
}

Result<void> Maker::add(const DocumentBody& body) {
  const DocumentModel& model = document_.models[body.model];
  const BodyDef common = this->common(model, body);
  const bool isStatic = common.motion == Motion::kStatic;
  bodies_.first.push_back(bodies_.defs.size());
  if (isStatic && !model.levels) {
    BodyDef def = common;
    std::vector<ConvexPart> parts = convexParts(model, false);
    if (!parts.empty()) {
      def.shape = Compound{std::move(parts)};
      bodies_.defs.push_back(std::move(def));
    }
    addStaticShapes(model, common);
  } else {
    BodyDef def = common;
    const auto mass = io::documentMass(model, body);
    if (!mass) return fail("body \"" + body.name + "\": " + mass.error().message);
    def.mass = *mass;
    if (def.motion == Motion::kDynamic && !(def.mass > 0.0F)) {
      return fail("body \"" + body.name + "\": a dynamic body needs a mass of more than 0 kg");
    }
    auto shape = solid(model, def.mass);
    if (!shape) return fail("body \"" + body.name + "\": " + shape.error().message);
    def.shape = std::move(*shape);
    def.mesh = drawn(model);
    bodies_.defs.push_back(std::move(def));
  }
  if (bodies_.defs.size() == bodies_.first.back()) return fail("body \"" + body.name + "\": it has no shape");
  return {};
}

}  // namespace

void DocumentWarnings::add(const std::string& what) {
  if (known_.insert(what).second) lines_.push_back(file_ + ": " + what);
}

Result<DocumentBodies> makeDocumentBodies(const PhysicsDocument& document, DocumentWarnings& warnings) {
  if (document.bodies.empty()) return fail("there are no rigid bodies in it");
  if (document.bodies.size() > kMostBodies) {
    return fail("more than " + std::to_string(kMostBodies) + " rigid bodies");
  }
  Maker maker(document, warnings);
  if (auto sound = maker.check(); !sound) return tl::unexpected(sound.error());
  for (const DocumentBody& body : document.bodies) {
    if (auto added = maker.add(body); !added) return tl::unexpected(added.error());
  }
  return maker.take();
}

}  // namespace scatter
