#pragma once

#include <scatter/io/model.h>
#include <scatter/io/physics_document.h>
#include <scatter/result.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scatter {

/// Reads the physics document of a COLLADA (.dae) or glTF (.gltf, .glb) file, in any case of letters. Fails
/// on another extension, and as readColladaDocument and readGltfDocument do.
[[nodiscard]] Result<PhysicsDocument> readDocument(const std::filesystem::path& path);

/// A rigid body of a physics file, as a world makes it.
struct FileModel {
  /// `levels` has the mass properties of the file: those given by hand, or those of the finest level. A body
  /// without levels has its shapes as the only one.
  Model model{};
  DocumentMotion motion = DocumentMotion::kDynamic;

  /// What the file has and the reader leaves out or mends, one line each; of the whole file.
  std::vector<std::string> warnings{};
};

/// Reads one rigid body of a COLLADA or glTF file. `body` is its name in the scene, or that of its model; it
/// may be empty if the file has no two bodies that differ in model, mass or motion. Fails if the file cannot
/// be read, has no such body or several, or if the body has a plane or a mesh as a shape: the message names
/// the file, and the bodies that it has.
[[nodiscard]] Result<FileModel> readModelFile(const std::filesystem::path& path, std::string_view body = {});

}  // namespace scatter
