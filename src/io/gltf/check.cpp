#include "io/gltf/check.h"

#include <string>
#include <vector>

#include "io/gltf/models.h"

namespace scatter::io {
namespace {

/// What reading a model will cost.
std::size_t costOf(const DocumentModel& model) {
  const auto ofMesh = [](const VisualMesh& mesh) {
    return 2 * mesh.vertices.size() + 4 * mesh.triangles.size();
  };
  std::size_t cost = ofMesh(model.mesh);
  for (const DocumentShape& shape : model.shapes) {
    const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
    const auto* hull = convex != nullptr ? std::get_if<ConvexHull>(convex) : nullptr;
    const auto* mesh = std::get_if<VisualMesh>(&shape.geometry);
    // A hull of n corners has less than 2 n triangles.
    cost += 1 + (hull != nullptr ? 10 * hull->vertices.size() : mesh != nullptr ? ofMesh(*mesh) : 0);
  }
  if (model.levels) {
    std::vector<Level> levels;
    for (int i = 1; i <= model.levels->count(); ++i) {
      levels.push_back(model.levels->level(i));
    }
    cost += levelCost(levels);
  }
  return cost;
}

/// Every body's node has a mass, be it from densities.
Result<void> checkMasses(const PhysicsDocument& document) {
  for (const DocumentModel& model : document.models) {
    const double mass = documentMass(model);
    if (!(mass >= kMinGltfMass && mass <= kMaxGltfMass)) {
      return fail("model \"" + model.name + "\": the mass of its shapes is not positive and finite");
    }
  }
  return {};
}

Result<void> checkCost(const PhysicsDocument& document) {
  std::size_t cost = 0;
  for (const DocumentModel& model : document.models) {
    cost += costOf(model);
  }
  if (cost > GltfBudget::kMost) {
    return fail("it has too many vertices, triangles or parts to be read again");
  }
  return {};
}

}  // namespace

Result<void> checkGltfDocument(const PhysicsDocument& document) {
  return checkDocument(document, kGltfBounds).and_then([&] { return checkMasses(document); }).and_then([&] {
    return checkCost(document);
  });
}

}  // namespace scatter::io
