#pragma once

#include <scatter/levels/surface_mesh.h>
#include <scatter/math.h>
#include <scatter/result.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scatter {

/// The axis of a file that becomes y.
enum class UpAxis : std::uint8_t { kX, kY, kZ };

struct MeshOptions {
  /// Metres per unit of the file, instead of what the file says. Files that say nothing (all but dae,
  /// gltf, glb, fbx) are in metres otherwise.
  std::optional<double> unit{};

  /// Of files that do not say it themselves: all but dae, gltf, glb and fbx.
  UpAxis up = UpAxis::kY;

  std::uint64_t maxFileBytes = std::uint64_t{1} << 30U;
  std::size_t maxTriangles = 20'000'000;

  /// Processor seconds for reading it; small files get less.
  int maxSeconds = 120;
};

/// What a name in a mesh file stands for.
enum class MeshGroupKind : std::uint8_t {
  kMaterial,
  kObject,       ///< A node with all that is under it, an object or group of an obj file, or a mesh.
  kVertexGroup,  ///< A bone: triangles whose corners follow it by half or more, on average.
};

/// Triangles that a mesh file has a name for.
struct MeshGroup {
  MeshGroupKind kind{};
  std::string name;

  /// First index and the one behind the last, ascending.
  std::vector<std::array<std::uint32_t, 2>> runs;
};

/// All triangles of a mesh file as one mesh, in metres, y up.
struct MeshFile {
  std::string name{};  ///< The file's, without folder and extension.
  SurfaceMesh mesh{};  ///< Not empty; every value is finite, every index in range, no vertex equals another.
  int pieces = 0;      ///< Meshes in the file, each as often as it is placed.

  /// No two of a kind have the same name; those without a name are left out.
  std::vector<MeshGroup> groups{};

  /// From the file's unit and axes to metres, y up: those of MeshOptions, or an FBX file's. COLLADA and glTF
  /// files count as being in metres, y up.
  Mat3 fromFile{1.0F};

  /// What was left out or mended, one line each, beginning with the file's name.
  std::vector<std::string> warnings{};
};

/// The extensions that readMesh knows, lower case, without dots: all that Assimp reads.
[[nodiscard]] const std::vector<std::string>& meshExtensions();

/// Reads a mesh file in any format that Assimp knows, chosen by its extension: all meshes with the transforms
/// of their nodes, polygons cut into triangles; glTF with KHR_mesh_quantization or EXT_meshopt_compression,
/// too. Points and lines are left out with a warning; bones and animations are ignored. Of other files, only
/// those in its folder and below are read. The format is read in a process of its own, so that a file which
/// breaks the reader, hangs it or wants more memory than 256 bytes for each of its own (and 1 GiB) is refused
/// like any other. Fails if there are no triangles, a number is not finite or a limit is passed.
[[nodiscard]] Result<MeshFile> readMesh(const std::filesystem::path& path, const MeshOptions& options = {});

/// The metres of a unit: a positive number, or one of m, cm, mm, km, in, ft.
[[nodiscard]] Result<double> parseUnit(std::string_view text);

}  // namespace scatter
