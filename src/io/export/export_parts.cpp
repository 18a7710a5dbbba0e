#include "io/export/export_parts.h"

#include <cctype>
#include <utility>

#include "io/numbers.h"
#include "levels/part_geometry.h"

namespace scatter::io {
namespace {

/// From y up to z up.
const Mat3 kUpright(Vec3(1.0F, 0.0F, 0.0F), Vec3(0.0F, 0.0F, 1.0F), Vec3(0.0F, -1.0F, 0.0F));

/// Of a round part's size: what two planes of the polytope around it may differ by to be one.
constexpr double kPlanar = 1e-9;

}  // namespace

Result<std::vector<ConvexPart>> partsOf(const Model& model, int level) {
  if (level >= 1 && level <= model.levels->count()) return model.levels->level(level).parts;
  return fail("\"" + model.name + "\" has levels 1 to " + std::to_string(model.levels->count()) +
              ", and none " + std::to_string(level));
}

Result<SurfaceMesh> surfaceOf(const ConvexPart& part) {
  const auto core = levels::flatSidedCore(part);
  if (!core) return fail(core.error().message);
  const levels::Polytope solid = *core ? **core : levels::outerPolytope(part, 0.0, {}, kPlanar);
  SurfaceMesh mesh;
  for (const glm::dvec3& vertex : solid.vertices()) mesh.vertices.emplace_back(vertex);
  for (const auto& face : solid.faces()) {
    const auto loop = solid.loop(face);
    for (std::size_t i = 2; i < loop.size(); ++i) mesh.triangles.push_back({loop[0], loop[i - 1], loop[i]});
  }
  return mesh;
}

std::string objObject(const std::string& name, const SurfaceMesh& mesh, std::size_t vertices) {
  std::string text = "o " + name + "\n";
  for (const Vec3& v : mesh.vertices) text += "v " + words({v.x, v.y, v.z}) + "\n";
  for (const auto& triangle : mesh.triangles) {
    text += "f";
    for (const std::uint32_t corner : triangle) text += " " + std::to_string(vertices + corner + 1);
    text += "\n";
  }
  return text;
}

Vec3 zUp(const Vec3& point) {
  return {point.x, -point.z, point.y};
}

Mat3 zUp(const Mat3& tensor) {
  return kUpright * tensor * glm::transpose(kUpright);
}

SurfaceMesh zUp(SurfaceMesh mesh) {
  for (Vec3& vertex : mesh.vertices) vertex = zUp(vertex);
  return mesh;
}

Transform zUp(const Transform& pose) {
  const Quat& q = pose.rotation;
  return {zUp(pose.position), Quat(q.w, q.x, -q.z, q.y)};
}

std::string wordOf(const std::string& name) {
  std::string word;
  for (const char c : name) {
    const bool isPlain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
    word += isPlain ? c : '_';
  }
  return word.empty() ? "model" : word;
}

std::string words(std::initializer_list<float> numbers) {
  std::string text;
  for (const float number : numbers) text += (text.empty() ? "" : " ") + formatNumber(number);
  return text;
}

}  // namespace scatter::io
