#include <scatter/io/collada.h>
#include <scatter/io/gltf.h>
#include <scatter/io/model_file.h>

#include <algorithm>
#include <utility>

#include "io/document_mass.h"
#include "io/extension.h"

namespace scatter {
namespace io {
namespace {

constexpr std::size_t kMostNamesShown = 8;

/// Of the scene; where nothing is placed in it, of the models themselves.
std::vector<DocumentBody> bodiesOf(const PhysicsDocument& document) {
  if (!document.bodies.empty()) return document.bodies;
  std::vector<DocumentBody> bodies;
  for (std::size_t i = 0; i < document.models.size(); ++i) {
    DocumentBody body;
    body.name = document.models[i].name;
    body.model = i;
    bodies.push_back(std::move(body));
  }
  return bodies;
}

/// Whether the same can be made of both, but for where they are.
bool areAlike(const DocumentBody& a, const DocumentBody& b) {
  return a.model == b.model && a.mass == b.mass && a.motion == b.motion;
}

std::string listed(const std::vector<DocumentBody>& bodies) {
  std::string names;
  for (std::size_t i = 0; i < std::min(bodies.size(), kMostNamesShown); ++i) {
    names += (i == 0 ? "\"" : ", \"") + bodies[i].name + "\"";
  }
  if (bodies.size() > kMostNamesShown) {
    names += " and " + std::to_string(bodies.size() - kMostNamesShown) + " more";
  }
  return names;
}

/// The body of that name, the one of that model, or the only kind of body that there is.
Result<DocumentBody> chooseBody(const PhysicsDocument& document, std::string_view name) {
  const std::vector<DocumentBody> all = bodiesOf(document);
  if (all.empty()) return fail("has no rigid body; export the model with its physics");
  std::vector<DocumentBody> meant;
  for (const DocumentBody& body : all) {
    if (!name.empty() && body.name == name) return body;
    if (name.empty() || document.models[body.model].name == name) meant.push_back(body);
  }
  if (meant.empty()) return fail("has no rigid body \"" + std::string(name) + "\"; it has " + listed(all));
  const bool isOneKind = std::all_of(meant.begin(), meant.end(), [&meant](const DocumentBody& body) {
    return areAlike(body, meant.front());
  });
  if (!isOneKind) return fail("has several rigid bodies; name one of " + listed(meant));
  return meant.front();
}

Result<std::vector<ConvexPart>> finestParts(const DocumentModel& model) {
  if (model.levels) return model.levels->finest().parts;
  std::vector<ConvexPart> parts;
  for (const DocumentShape& shape : model.shapes) {
    const auto* convex = std::get_if<ConvexShape>(&shape.geometry);
    if (convex == nullptr) return fail("is not made of convex shapes alone; make levels from its mesh");
    parts.push_back({.shape = *convex, .pose = shape.pose});
  }
  return parts;
}

Result<std::shared_ptr<const LevelSet>> levelsOf(const DocumentModel& model, float mass) {
  const auto parts = finestParts(model);
  if (!parts) return tl::unexpected(parts.error());
  const auto properties = documentMassProperties(model, *parts, mass);
  if (!properties) return tl::unexpected(properties.error());
  if (!*properties && model.levels) return model.levels;
  return levelsWithMass(model, *parts, *properties);
}

Result<Model> modelOf(const PhysicsDocument& document, const DocumentBody& body) {
  const DocumentModel& given = document.models[body.model];
  Model model;
  model.name = given.name;
  model.mesh = given.mesh;
  const auto mass = documentMass(given, body);
  if (!mass) return tl::unexpected(mass.error());
  model.mass = *mass;
  auto levels = levelsOf(given, model.mass);
  if (!levels) return tl::unexpected(levels.error());
  model.levels = std::move(*levels);
  if (const auto material = documentMaterial(given)) {
    model.friction = document.materials[*material].dynamicFriction;
    model.restitution = document.materials[*material].restitution;
  }
  return model;
}

}  // namespace
}  // namespace io

Result<PhysicsDocument> readDocument(const std::filesystem::path& path) {
  const std::string extension = io::lowerExtension(path);
  if (extension == ".dae") return readColladaDocument(path);
  if (extension == ".gltf" || extension == ".glb") return readGltfDocument(path);
  return fail(path.string() + ": is no physics file by its extension; give it .dae, .gltf or .glb");
}

Result<FileModel> readModelFile(const std::filesystem::path& path, std::string_view body) {
  auto document = readDocument(path);
  if (!document) return tl::unexpected(document.error());
  const auto chosen = io::chooseBody(*document, body);
  if (!chosen) return fail(path.string() + ": " + chosen.error().message);
  FileModel result;
  result.motion = chosen->motion.value_or(document->models[chosen->model].motion);
  auto model = io::modelOf(*document, *chosen);
  if (!model) return fail(path.string() + ": body \"" + chosen->name + "\": " + model.error().message);
  if (result.motion == DocumentMotion::kDynamic && !(model->mass > 0.0F)) {
    return fail(path.string() + ": body \"" + chosen->name +
                "\": a dynamic body needs a mass of more than 0 kg");
  }
  result.model = std::move(*model);
  result.warnings = std::move(document->warnings);
  return result;
}

}  // namespace scatter
