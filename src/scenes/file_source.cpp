#include <scatter/io/model_file.h>
#include <scatter/io/scene_library.h>
#include <scatter/world/scene.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "io/extension.h"
#include "scenes/document_scene.h"
#include "scenes/file_scene.h"

namespace scatter {
namespace {

namespace fs = std::filesystem;

constexpr int kDocumentFrames = 600;

Result<SceneInfo> readScene(const fs::path& path) {
  auto read = readSceneFile(path);
  if (!read) return tl::unexpected(read.error());
  auto file = std::make_shared<const SceneFile>(std::move(*read));
  SceneInfo info;
  info.name = path.stem().string();
  info.summary = file->summary;
  info.frames = file->frames;
  info.seed = file->seed;
  info.make = [file = std::move(file)] { return std::make_unique<FileScene>(file); };
  return info;
}

bool isGltf(const std::string& extension) {
  return extension == ".gltf" || extension == ".glb";
}

Result<SceneInfo> readDocumentScene(const fs::path& path) {
  const auto document = readDocument(path);
  if (!document) return tl::unexpected(document.error());
  auto made = planDocument(*document, path.string());
  if (!made) return tl::unexpected(made.error());
  auto plan = std::make_shared<const DocumentPlan>(std::move(*made));
  SceneInfo info;
  info.name = path.stem().string();
  info.summary = "the physics scene of " + path.filename().string();
  info.frames = kDocumentFrames;
  info.warnings = plan->warnings;
  info.make = [plan = std::move(plan)] { return std::make_unique<DocumentScene>(plan); };
  return info;
}

/// Scene files: those of the library by name, and any scene file, COLLADA or glTF file by its path.
class FileSource final : public SceneSource {
 public:
  [[nodiscard]] std::vector<std::string> names() const override { return sceneFileNames(); }

  [[nodiscard]] bool claims(const std::string& name) const override {
    const std::string extension = io::lowerExtension(name);
    return name.find('/') != std::string::npos || extension == ".toml" || extension == ".dae" ||
           isGltf(extension);
  }

  [[nodiscard]] Result<SceneInfo> find(const std::string& name) const override {
    if (!claims(name)) return findSceneFile(name).and_then(readScene);
    const std::string extension = io::lowerExtension(name);
    if (extension == ".toml") return readScene(name);
    if (extension == ".dae" || isGltf(extension)) return readDocumentScene(name);
    return fail("the scene \"" + name +
                "\" is not the name of a scene, and no file that ends in .toml, .dae, .gltf or .glb");
  }
};

const SceneRegistration kRegisterFiles{std::make_unique<FileSource>()};

}  // namespace
}  // namespace scatter
