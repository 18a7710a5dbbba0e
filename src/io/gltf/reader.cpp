#include <scatter/io/file.h>
#include <scatter/io/gltf.h>

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "io/gltf/joints.h"
#include "io/gltf/models.h"

namespace scatter::io {
namespace {

constexpr float kStandardGravity = 9.81F;

/// Reads one file into a document.
class Reader {
 public:
  /// A scene without a name gets `standardName`.
  Reader(std::string_view bytes, std::optional<std::filesystem::path> folder, std::string standardName)
      : file_(bytes, {.folder = std::move(folder)}),
        nodes_(file_),
        meshes_(file_),
        notes_(readSceneNotes(file_, nodes_)),
        bodies_(file_, nodes_, notes_),
        models_(file_, nodes_, meshes_, notes_),
        bodyOfNode_(nodes_.count()) {
    document_.name = std::move(standardName);
  }

  PhysicsDocument read() {
    checkExtensions();
    readScene();
    readMaterials();
    readFilters();
    readPrototypes();
    for (const GltfBody& body : bodies_.all()) {
      if (nodes_[body.node].inScene) {
        addBody(body);
      }
    }
    document_.joints = readJoints(file_, nodes_, bodies_, bodyOfNode_);
    compactModels();
    document_.warnings = file_.takeWarnings();
    return std::move(document_);
  }

 private:
  void checkExtensions();
  void readScene();
  void readMaterials();
  void readFilters();
  void readPrototypes();
  void addBody(const GltfBody& body);
  void takeBodyNotes(const GltfBody& source, const BodyNotes& notes, DocumentBody& body);
  void compactModels();
  [[nodiscard]] float massOf(std::size_t model);
  [[nodiscard]] std::string uniqueName(const std::string& name);

  GltfFile file_;
  GltfNodes nodes_;
  GltfMeshes meshes_;
  std::optional<SceneNotes> notes_;
  GltfBodies bodies_;
  GltfModels models_;
  std::vector<std::optional<std::size_t>> bodyOfNode_;
  std::set<std::string> names_;
  std::map<std::string, std::size_t> nameCounts_;
  std::map<std::size_t, float> masses_;
  PhysicsDocument document_;
};

/// Whether an extension is read, or only says what surfaces look like.
bool isRead(std::string_view extension) {
  constexpr std::array kRead{kRigidBodies, kImplicitShapes, "KHR_draco_mesh_compression",
                             "EXT_meshopt_compression", "KHR_mesh_quantization"};
  return std::find(kRead.begin(), kRead.end(), extension) != kRead.end() ||
         extension.starts_with("KHR_materials_") || extension.starts_with("KHR_lights_") ||
         extension.starts_with("KHR_texture_") || extension.starts_with("EXT_texture_");
}

void Reader::checkExtensions() {
  const auto used = file_.root().find("extensionsUsed");
  bool hasPhysics = file_.root().find({"extensions", kRigidBodies}).has_value();
  for (std::size_t i = 0; used && i < used->size(); ++i) {
    const std::string name = (*used)[i].text();
    hasPhysics = hasPhysics || name == kRigidBodies;
    if (!isRead(name)) {
      file_.warn((*used)[i], "this extension is not supported and is left out");
    }
  }
  if (!hasPhysics && !notes_) {
    file_.warn("the file has no physics: it does not use " + std::string(kRigidBodies));
  } else if (file_.count("animations") > 0) {
    file_.warn("animations: they are not supported and are left out");
  }
}

void Reader::readScene() {
  const auto name = nodes_.scene() ? nodes_.scene()->find("name") : std::nullopt;
  if (name) {
    document_.name = name->text();
  }
  if (notes_) {
    document_.gravity = notes_->gravity;
    document_.timeStep = notes_->timeStep;
    document_.fields = notes_->fields;
    return;
  }
  document_.gravity = Vec3(0.0F, -kStandardGravity, 0.0F);
  if (!bodies_.all().empty()) {
    file_.warn("the file does not say what gravity is; it is taken as 9.81 m/s² down");
  }
}

void Reader::readMaterials() {
  const auto materials = file_.root().find({"extensions", kRigidBodies, "physicsMaterials"});
  for (std::size_t i = 0; materials && i < materials->size(); ++i) {
    const JsonPlace place = (*materials)[i];
    const auto value = [&](const char* key, float standard, double high) {
      const auto found = place.find(key);
      return found ? static_cast<float>(found->number(0.0, high)) : standard;
    };
    file_.warnUnknown(
        place, {"staticFriction", "dynamicFriction", "restitution", "frictionCombine", "restitutionCombine"});
    constexpr double kMaxFriction = 1e3;
    constexpr float kDraftFriction = 0.6F;
    DocumentMaterial material;
    const auto name = place.find("name");
    material.name = name ? name->text() : "material " + std::to_string(i);
    material.staticFriction = value("staticFriction", kDraftFriction, kMaxFriction);
    material.dynamicFriction = value("dynamicFriction", kDraftFriction, kMaxFriction);
    material.restitution = value("restitution", 0.0F, 1.0);
    for (const char* key : {"frictionCombine", "restitutionCombine"}) {
      const auto mode = place.find(key);
      if (mode && mode->text() != "multiply") {
        file_.warn(*mode, "is not supported; values of two bodies are multiplied");
      }
    }
    document_.materials.push_back(std::move(material));
  }
}

void Reader::readFilters() {
  const auto filters = file_.root().find({"extensions", kRigidBodies, "collisionFilters"});
  for (std::size_t i = 0; filters && i < filters->size(); ++i) {
    const JsonPlace place = (*filters)[i];
    file_.warnUnknown(place, {"collisionSystems", "collideWithSystems", "notCollideWithSystems"});
    const auto names = [&](const char* key) {
      std::vector<std::string> list;
      const auto found = place.find(key);
      for (std::size_t k = 0; found && k < found->size(); ++k) list.push_back((*found)[k].text());
      return list;
    };
    DocumentFilter filter{names("collisionSystems"), names("collideWithSystems"),
                          names("notCollideWithSystems")};
    if (!filter.collideWith.empty() && !filter.notCollideWith.empty()) {
      file_.warn(place, "says both with whom to collide and with whom not to; the latter is left out");
      filter.notCollideWith.clear();
    }
    document_.filters.push_back(std::move(filter));
  }
}

/// Models that no body is of.
void Reader::readPrototypes() {
  for (const GltfBody& body : bodies_.all()) {
    if (!nodes_[body.node].inScene) {
      static_cast<void>(models_.modelOf(body));
    }
  }
}

std::string Reader::uniqueName(const std::string& name) {
  std::string candidate = name;
  while (!names_.insert(candidate).second) {
    candidate = name + " " + std::to_string(++nameCounts_.try_emplace(name, 1).first->second);
  }
  return candidate;
}

void Reader::addBody(const GltfBody& source) {
  const auto model = models_.modelOf(source);
  if (!model) {
    return;
  }
  DocumentBody body;
  const auto name = nodes_.json(source.node).find("name");
  body.name = uniqueName(name ? name->text() : "body " + std::to_string(source.node));
  body.model = *model;
  body.pose = nodes_[source.node].world.rigid();
  body.linearVelocity = source.linearVelocity;
  body.angularVelocity = source.angularVelocity;
  body.gravityFactor = source.gravityFactor;
  body.filter = source.filter;
  if (const BodyNotes* notes = models_.notesOf(source); notes != nullptr && notes->model == *model) {
    takeBodyNotes(source, *notes, body);
  }
  bodyOfNode_[source.node] = document_.bodies.size();
  document_.bodies.push_back(std::move(body));
}

/// Where the node no longer says what the notes say, someone changed the node: it counts.
void Reader::takeBodyNotes(const GltfBody& source, const BodyNotes& notes, DocumentBody& body) {
  const DocumentModel& model = *models_.models()[notes.model];
  body.motion = notes.motion;
  body.mass = notes.mass;
  if (source.motion != notes.motion.value_or(model.motion)) {
    body.motion = source.motion;
  }
  if (source.mass && *source.mass != notes.mass.value_or(massOf(notes.model))) {
    body.mass = source.mass;
  }
}

/// Of the model, worked out once.
float Reader::massOf(std::size_t model) {
  const auto [found, isNew] = masses_.try_emplace(model, 0.0F);
  if (isNew) {
    found->second = static_cast<float>(documentMass(*models_.models()[model]));
  }
  return found->second;
}

void Reader::compactModels() {
  std::vector<std::size_t> places(models_.models().size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = document_.models.size();
    if (std::optional<DocumentModel>& model = models_.models()[i]) {
      document_.models.push_back(std::move(*model));
    } else if (notes_ && i < notes_->models.size()) {
      file_.warn("scatter_scene: model " + std::to_string(i) + " has no body and is left out");
    }
  }
  for (DocumentBody& body : document_.bodies) {
    body.model = places[body.model];
  }
}

/// One line that can be shown.
std::string cleanLine(std::string_view name, const std::string& message) {
  std::string line = std::string(name) + ": " + message;
  for (char& c : line) {
    c = static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  }
  return line;
}

Result<PhysicsDocument> readBytes(std::string_view bytes, std::string_view name,
                                  std::optional<std::filesystem::path> folder, std::string standardName) {
  try {
    PhysicsDocument document = Reader(bytes, std::move(folder), std::move(standardName)).read();
    for (std::string& warning : document.warnings) {
      warning = cleanLine(name, warning);
    }
    return document;
  } catch (const GltfFailure& failure) {
    return fail(cleanLine(name, failure.message));
  } catch (const std::bad_alloc&) {
    return fail(cleanLine(name, "there is not enough memory to read it"));
  }
}

}  // namespace
}  // namespace scatter::io

namespace scatter {

Result<PhysicsDocument> parseGltfDocument(std::string_view bytes, std::string_view nameForMessages) {
  return io::readBytes(bytes, nameForMessages, std::nullopt, "");
}

Result<PhysicsDocument> readGltfDocument(const std::filesystem::path& path) {
  return readFile(path).and_then([&](const std::string& bytes) {
    return io::readBytes(bytes, path.string(), path.parent_path(), path.stem().string());
  });
}

}  // namespace scatter
