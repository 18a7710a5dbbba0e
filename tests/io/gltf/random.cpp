#include "io/gltf/random.h"

#include <glm/geometric.hpp>
#include <stdexcept>
#include <utility>

namespace scatter::test {

std::size_t RandomDocuments::below(std::size_t limit) {
  return static_cast<std::size_t>(random_() % limit);
}

float RandomDocuments::between(float low, float high) {
  // 24 bits, all that a float can hold.
  return low + (high - low) * static_cast<float>(random_() >> 40U) / 16777216.0F;
}

Vec3 RandomDocuments::vector(float largest) {
  return {between(-largest, largest), between(-largest, largest), between(-largest, largest)};
}

Transform RandomDocuments::pose() {
  Transform result;
  if (maybe()) {
    result.position = vector(10.0F);
  }
  if (maybe()) {
    result.rotation = glm::normalize(Quat{between(-1, 1), between(-1, 1), between(-1, 1), between(0.1F, 1)});
  }
  return result;
}

std::string RandomDocuments::name(const char* kind, std::size_t index) {
  static const char* const kOdd[] = {"", " ä/\\\"<&>", "\n\t", "日本", "#1"};
  return kind + std::to_string(index) + kOdd[below(5)];
}

VisualMesh RandomDocuments::mesh() {
  VisualMesh result;
  const std::size_t count = 3 + below(20);
  for (std::size_t i = 0; i < count; ++i) {
    result.vertices.push_back(vector(3.0F));
  }
  for (std::size_t i = below(10); i > 0; --i) {
    const auto corner = [&] { return static_cast<std::uint32_t>(below(count)); };
    result.triangles.push_back({corner(), corner(), corner()});
  }
  return result;
}

ConvexShape RandomDocuments::convexShape() {
  const float size = between(0.1F, 2.0F);
  const float other = between(0.1F, 2.0F);
  switch (below(5)) {
    case 0:
      return Box{Vec3{size, other, between(0.01F, 3.0F)}};
    case 1:
      return Sphere{size};
    case 2:
      return Capsule{size, other};
    case 3:
      return Cylinder{size, other};
    default: {
      ConvexHull hull;
      for (std::size_t i = 6 + below(20); i > 0; --i) {
        hull.vertices.push_back(vector(2.0F));
      }
      // A point that comes twice, as exporters write them.
      if (maybe()) {
        const Vec3 first = hull.vertices.front();
        hull.vertices.push_back(first);
      }
      return hull;
    }
  }
}

std::optional<std::size_t> RandomDocuments::material(const PhysicsDocument& document) {
  return document.materials.empty() || maybe() ? std::nullopt
                                               : std::optional(below(document.materials.size()));
}

std::optional<float> RandomDocuments::mass() {
  return maybe() ? std::optional(between(0.01F, 2000.0F)) : std::nullopt;
}

DocumentShape RandomDocuments::shape(const PhysicsDocument& document, bool convex) {
  DocumentShape result;
  const std::size_t kind = convex ? 2 : below(6);
  if (kind == 0) {
    result.geometry = DocumentPlane{glm::normalize(vector(1.0F) + Vec3(0.0F, 0.01F, 0.0F)), between(-3, 3)};
  } else if (kind == 1) {
    VisualMesh triangles = mesh();
    triangles.triangles.push_back({0, 1, 2});
    result.geometry = std::move(triangles);
  } else {
    result.geometry = convexShape();
  }
  result.pose = pose();
  if (below(4) == 0) {
    result.material = material(document);
    result.density = mass();
    result.mass = mass();
  }
  return result;
}

std::shared_ptr<const LevelSet> RandomDocuments::levels(const DocumentModel& model) {
  LevelSetDef definition;
  definition.name = maybe() ? model.name : "levels";
  definition.hullMargin = between(0.0F, 0.05F);
  Level finest;
  for (const DocumentShape& shape : model.shapes) {
    finest.parts.push_back({std::get<ConvexShape>(shape.geometry), shape.pose});
  }
  // Every shape is within 20 m of the body's frame.
  const std::size_t coarser = below(3);
  for (std::size_t i = 0; i < coarser; ++i) {
    const float half = 40.0F - 5.0F * static_cast<float>(i);
    definition.levels.push_back({{{Box{Vec3(half, half + between(0.0F, 1.0F), half)}, {}}}});
    if (maybe()) {
      definition.levels.back().parts.push_back({convexShape(), {}});
    }
  }
  definition.levels.push_back(std::move(finest));
  if (maybe()) {
    definition.mass = MassProperties{between(1, 2), vector(1.0F), Mat3(between(1, 3))};
  }
  auto made = LevelSet::create(std::move(definition));
  if (!made) {
    throw std::logic_error(made.error().message);
  }
  return *made;
}

DocumentModel RandomDocuments::model(const PhysicsDocument& document) {
  DocumentModel result;
  result.name = name("model", document.models.size());
  const bool isNested = below(3) == 0;
  for (std::size_t i = 1 + below(4); i > 0; --i) {
    result.shapes.push_back(shape(document, isNested));
  }
  if (isNested) {
    result.levels = levels(result);
  }
  if (maybe()) {
    result.mesh = mesh();
  }
  result.motion = motion();
  result.mass = mass();
  result.material = material(document);
  if (maybe()) {
    result.massFrame = DocumentMassFrame{pose(), std::nullopt};
    if (maybe()) {
      result.massFrame->inertia = Vec3{between(0.1F, 9), between(0.1F, 9), between(0.1F, 9)};
    }
  }
  return result;
}

DocumentBody RandomDocuments::body(const PhysicsDocument& document) {
  DocumentBody result;
  result.name = name("body", document.bodies.size());
  result.model = below(document.models.size());
  result.pose = pose();
  if (maybe()) {
    result.linearVelocity = vector(20.0F);
    result.angularVelocity = vector(5.0F);
  }
  if (below(3) == 0) {
    result.motion = motion();
    result.mass = mass();
  }
  return result;
}

DocumentLimit RandomDocuments::limit() {
  switch (below(4)) {
    case 0:
      return {};
    case 1:
      return {0.0F, 0.0F};
    case 2:
      return {0.25F, 0.25F};
    default:
      return {between(-3.0F, 0.0F), between(0.0F, 3.0F)};
  }
}

DocumentJoint RandomDocuments::joint(const PhysicsDocument& document) {
  DocumentJoint result;
  const std::size_t count = document.bodies.size();
  result.name = name("joint", document.joints.size());
  const std::size_t first = below(count);
  result.bodyA = first;
  if (count > 1 && maybe()) {
    result.bodyB = (first + 1 + below(count - 1)) % count;
  }
  if (maybe()) {
    std::swap(result.bodyA, result.bodyB);
  }
  result.frameA = pose();
  result.frameB = pose();
  for (std::size_t i = 0; i < 3; ++i) {
    result.linear[i] = limit();
    result.angular[i] = limit();
  }
  result.enabled = below(4) != 0;
  result.bodiesCollide = maybe();
  return result;
}

PhysicsDocument RandomDocuments::next() {
  PhysicsDocument document;
  document.name = name("scene", 0);
  for (std::size_t i = below(4); i > 0; --i) {
    document.materials.push_back({name("material", i), between(0, 2), between(0, 2), between(0, 1)});
  }
  for (std::size_t i = below(5); i > 0; --i) {
    document.models.push_back(model(document));
  }
  for (std::size_t i = document.models.empty() ? 0 : below(7); i > 0; --i) {
    document.bodies.push_back(body(document));
  }
  if (hasFilters_) {
    document.filters = {{{"a", "b"}, {}, {"c"}}, {{"c"}, {"a"}, {}}, {}};
    for (DocumentBody& body : document.bodies) {
      const bool isStatic =
          body.motion.value_or(document.models[body.model].motion) == DocumentMotion::kStatic;
      if (maybe()) body.filter = below(3);
      if (maybe() && !isStatic) body.gravityFactor = between(-2, 2);
    }
  }
  for (std::size_t i = document.bodies.empty() ? 0 : below(4); i > 0; --i) {
    document.joints.push_back(joint(document));
  }
  for (std::size_t i = below(3); i > 0; --i) {
    document.fields.push_back({name("field", i), vector(5.0F), between(-9, 9), between(0, 100)});
  }
  document.gravity = vector(10.0F);
  if (maybe()) {
    document.timeStep = between(0.001F, 0.1F);
  }
  return document;
}

}  // namespace scatter::test
