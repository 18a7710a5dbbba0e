#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/result.h>

#include <filesystem>
#include <string_view>

namespace scatter {

/// Physics in glTF 2.0, by the draft extensions KHR_physics_rigid_bodies and KHR_implicit_shapes. Both are in
/// review (pull requests 2424 and 2370 of KhronosGroup/glTF); implemented is the state of
/// github.com/eoineoineoin/glTF_Physics of 29 October 2025, commit ac5c413. docs/files.md says what is read
/// and written, and how our `extras` are laid out.
/// @{

/// Reads a .gltf file, with buffers in it or beside it, or a .glb file. What is not supported is left
/// out and named in `warnings`. Errors read `FILE: nodes[3].mesh: what is wrong`.
[[nodiscard]] Result<PhysicsDocument> readGltfDocument(const std::filesystem::path& path);

/// The same from the bytes of a file, which may not refer to other files. `nameForMessages` stands for
/// the file name.
[[nodiscard]] Result<PhysicsDocument> parseGltfDocument(std::string_view bytes,
                                                        std::string_view nameForMessages);

/// Writes one file: binary if the name ends in .glb, JSON with base64 buffers if it ends in .gltf. Other
/// programs see plain rigid bodies of the finest level; readGltfDocument gives back the same document,
/// without warnings, where free joint axes may have another pair of limits that says so. The same document
/// always gives the same bytes. Fails, leaving nothing behind, if the document is not sound or the file
/// cannot be written whole.
[[nodiscard]] Result<void> writeGltfDocument(const PhysicsDocument& document,
                                             const std::filesystem::path& path);

/// @}

}  // namespace scatter
