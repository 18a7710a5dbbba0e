#include "level_file.h"

#include <scatter/io/collada.h>
#include <scatter/io/gltf.h>
#include <scatter/io/physics_document.h>

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <variant>

#include "io/document_mass.h"
#include "messages.h"

namespace scatter::app {

namespace fs = std::filesystem;

namespace {

bool isGltf(const fs::path& path) {
  return path.extension() == ".gltf" || path.extension() == ".glb";
}

Result<PhysicsDocument> readDocument(const std::string& path) {
  // What is said about the document is what is wrong with its levels.
  const NestingUnchecked unchecked;
  return isGltf(path) ? readGltfDocument(path) : readColladaDocument(path);
}

/// The shapes of a plain body as its only level; nothing if one of them is no convex part.
std::optional<Level> onlyLevelOf(const DocumentModel& model) {
  Level level;
  for (const DocumentShape& shape : model.shapes) {
    const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
    if (convex == nullptr) return std::nullopt;
    level.parts.push_back({*convex, shape.pose});
  }
  return level;
}

/// With the mass properties that the file gives, if it does.
Result<std::shared_ptr<const LevelSet>> withOwnMass(const DocumentModel& model) {
  const std::vector<ConvexPart>& parts = model.levels->finest().parts;
  const auto mass = io::documentMass(model, {});
  if (!mass) return fail(mass.error().message);
  const auto properties = io::documentMassProperties(model, parts, *mass);
  if (!properties) return fail(properties.error().message);
  if (!*properties) return model.levels;
  const NestingUnchecked unchecked;
  return io::levelsWithMass(model, parts, *properties);
}

/// Null for a body that has no levels and cannot have them.
Result<std::shared_ptr<const LevelSet>> levelsOf(const DocumentModel& model) {
  if (model.levels) return withOwnMass(model);
  std::optional<Level> level = onlyLevelOf(model);
  if (!level) return std::shared_ptr<const LevelSet>();
  return LevelSet::create(
      {.name = model.name, .levels = {std::move(*level)}, .hullMargin = 0.0F, .mass = {}});
}

}  // namespace

Result<std::vector<LevelModel>> readLevelFile(const std::string& path) {
  const Result<PhysicsDocument> document = readDocument(path);
  if (!document) return fail(document.error().message);
  std::vector<LevelModel> models;
  for (const DocumentModel& model : document->models) {
    Result<std::shared_ptr<const LevelSet>> levels = levelsOf(model);
    if (!levels) return fail(path + ": " + levels.error().message);
    if (*levels == nullptr) {
      printNote(path + ": " + model.name + " has a shape that is no convex part, and is left out");
      continue;
    }
    models.push_back({model.name, std::move(*levels), {model.mesh.vertices, model.mesh.triangles}});
  }
  if (models.empty()) return fail(path + ": has no rigid body of convex parts");
  return models;
}

bool isLevelFile(const std::string& path) {
  if (fs::path(path).extension() != ".dae" && !isGltf(path)) return false;
  const Result<PhysicsDocument> document = readDocument(path);
  if (!document || document->bodies.size() != 1 || !document->joints.empty() || !document->fields.empty())
    return false;
  const DocumentBody& body = document->bodies.front();
  const bool isStill = body.linearVelocity == Vec3(0.0F) && body.angularVelocity == Vec3(0.0F);
  return isStill && document->models[body.model].levels != nullptr;
}

Result<void> checkLevelFileName(const std::string& path) {
  const fs::path file(path);
  if (file.extension() != ".dae" && !isGltf(file)) {
    return fail(path + ": is no physics file by its extension; give it .dae, .gltf or .glb");
  }
  std::error_code error;
  if (file.has_parent_path() && !fs::is_directory(file.parent_path(), error)) {
    return fail("cannot write " + path + ": there is no folder " + file.parent_path().string());
  }
  return {};
}

Result<void> writeLevelFile(const Model& model, const std::string& path) {
  if (!isGltf(path)) return writeCollada(model, path);
  PhysicsDocument document;
  document.name = model.name;
  DocumentMaterial material;
  material.name = "material";
  material.staticFriction = model.friction;
  material.dynamicFriction = model.friction;
  material.restitution = model.restitution;
  document.materials.push_back(material);
  DocumentModel body;
  body.name = model.name;
  body.levels = model.levels;
  for (const ConvexPart& part : model.levels->finest().parts) {
    DocumentShape shape;
    shape.geometry = part.shape;
    shape.pose = part.pose;
    body.shapes.push_back(std::move(shape));
  }
  body.mesh = model.mesh;
  body.mass = model.mass;
  body.massFrame = io::massFrameOf(*model.levels, model.mass);
  body.material = 0;
  document.models.push_back(std::move(body));
  DocumentBody placed;
  placed.name = model.name;
  document.bodies.push_back(placed);
  return writeGltfDocument(document, path);
}

}  // namespace scatter::app
