#include "io/mesh/assimp_mesh.h"

#include <assimp/BaseImporter.h>
#include <assimp/DefaultIOSystem.h>
#include <assimp/importerdesc.h>
#include <assimp/metadata.h>
#include <assimp/scene.h>
#include <scatter/io/file.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/mesh/group_names.h"
#include "io/mesh/plain_gltf.h"
#include "io/mesh/polygon.h"

namespace scatter::io {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestNode = 2000;

/// Opens the mesh's file and what lies in its folder, as long as they are plain files.
class OwnFolder : public Assimp::DefaultIOSystem {
 public:
  OwnFolder(const fs::path& file, std::uint64_t maxBytes)
      : folder_(fs::weakly_canonical(file).parent_path()), maxBytes_(maxBytes) {}

  bool Exists(const char* file) const override { return isAllowed(file); }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    const bool reads = std::string_view(mode).find_first_of("wa+") == std::string_view::npos;
    return reads && isAllowed(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
  }

 private:
  [[nodiscard]] bool isAllowed(const fs::path& file) const {
    std::error_code error;
    const fs::path target = fs::canonical(file, error);
    if (error || !fs::is_regular_file(target, error) || fs::file_size(target, error) > maxBytes_)
      return false;
    return std::mismatch(folder_.begin(), folder_.end(), target.begin(), target.end()).first == folder_.end();
  }

  fs::path folder_;
  std::uint64_t maxBytes_;
};

bool handles(const aiImporterDesc& description, const std::string& extension) {
  const std::string known = " " + std::string(description.mFileExtensions) + " ";
  // The two glTF versions share their extensions; the first one went out of use.
  return known.find(" " + extension + " ") != std::string::npos &&
         std::string_view(description.mName) != "glTF Importer";
}

/// Assimp tries every format it knows on a file that it cannot place: leaves it those of the extension.
void keepFormat(Assimp::Importer& importer, const std::string& extension) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    if (handles(*importer.GetImporterInfo(i), extension)) continue;
    const std::unique_ptr<Assimp::BaseImporter> format(importer.GetImporter(i));
    importer.UnregisterLoader(format.get());
  }
}

glm::dmat4 toMatrix(const aiMatrix4x4& m) {
  glm::dmat4 result;
  for (unsigned row = 0; row < 4; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      result[static_cast<int>(column)][static_cast<int>(row)] = static_cast<double>(m[row][column]);
    }
  }
  return result;
}

/// Turns the given axis up.
glm::dmat4 uprightFrom(UpAxis up) {
  glm::dmat4 turn{1.0};
  if (up == UpAxis::kZ) {
    turn[1] = {0.0, 0.0, -1.0, 0.0};
    turn[2] = {0.0, 1.0, 0.0, 0.0};
  } else if (up == UpAxis::kX) {
    turn[0] = {0.0, 1.0, 0.0, 0.0};
    turn[1] = {-1.0, 0.0, 0.0, 0.0};
  }
  return turn;
}

/// Numbers points; equal ones get the same number. Assimp repeats a vertex for each face of an obj file.
class Welder {
 public:
  explicit Welder(std::vector<Vec3>& vertices) : vertices_(vertices) {}

  std::uint32_t indexOf(const Vec3& vertex) {
    const auto next = static_cast<std::uint32_t>(vertices_.size());
    const auto [found, isNew] = numbers_.try_emplace({vertex.x, vertex.y, vertex.z}, next);
    if (isNew) vertices_.push_back(vertex);
    return found->second;
  }

 private:
  using Key = std::array<float, 3>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::size_t hash = 0;
      for (const float value : key) hash = hash * 0x9e3779b97f4a7c15U + std::hash<float>{}(value);
      return hash ^ hash >> 29U;
    }
  };

  std::vector<Vec3>& vertices_;
  std::unordered_map<Key, std::uint32_t, Hash> numbers_;
};

/// Walks a scene and collects its triangles.
class Collector {
 public:
  Collector(const aiScene& scene, const MeshOptions& options) : scene_(scene), options_(options) {}

  Result<MeshFile> collect(const glm::dmat4& root) {
    if (scene_.mRootNode != nullptr) addNode(*scene_.mRootNode, root, 0);
    if (error_) return fail(std::move(*error_));
    if (result_.mesh.triangles.empty()) return fail("has no triangles");
    describeLosses();
    result_.groups = groups_.take();
    return std::move(result_);
  }

 private:
  void addNode(const aiNode& node, const glm::dmat4& parent, int depth) {
    if (depth > kDeepestNode) error_ = "has nodes nested more than " + std::to_string(kDeepestNode) + " deep";
    const glm::dmat4 frame = depth == 0 ? parent : parent * toMatrix(node.mTransformation);
    const std::size_t first = result_.mesh.triangles.size();
    for (unsigned i = 0; i < node.mNumMeshes && !error_; ++i) {
      if (node.mMeshes[i] < scene_.mNumMeshes) addMesh(*scene_.mMeshes[node.mMeshes[i]], frame);
    }
    for (unsigned i = 0; i < node.mNumChildren && !error_; ++i) addNode(*node.mChildren[i], frame, depth + 1);
    // The root of most formats is named after the file, or by Assimp.
    if (depth > 0 || node.mNumMeshes > 0) addGroup(MeshGroupKind::kObject, node.mName, first);
  }

  /// Of the triangles from `first` on, unless Assimp has made up the name.
  void addGroup(MeshGroupKind kind, const aiString& name, std::size_t first) {
    const std::string text = name.C_Str();
    if (text != AI_DEFAULT_MATERIAL_NAME && text != "defaultobject")
      groups_.add(kind, text, first, result_.mesh.triangles.size());
  }

  void addMesh(const aiMesh& mesh, const glm::dmat4& frame) {
    ++result_.pieces;
    hasBones_ = hasBones_ || mesh.mNumBones > 0;
    const bool mirrors = glm::determinant(glm::dmat3(frame)) < 0.0;
    indices_.assign(mesh.mNumVertices, kNone);
    corners_.clear();
    const std::size_t first = result_.mesh.triangles.size();
    for (unsigned i = 0; i < mesh.mNumFaces && !error_; ++i) addFace(mesh, mesh.mFaces[i], frame, mirrors);
    addGroup(MeshGroupKind::kObject, mesh.mName, first);
    if (mesh.mMaterialIndex < scene_.mNumMaterials)
      addGroup(MeshGroupKind::kMaterial, scene_.mMaterials[mesh.mMaterialIndex]->GetName(), first);
    for (unsigned i = 0; i < mesh.mNumBones && !error_; ++i) addBone(*mesh.mBones[i], mesh, first);
  }

  /// Of the mesh whose triangles begin with `first`.
  void addBone(const aiBone& bone, const aiMesh& mesh, std::size_t first) {
    constexpr float kHalfOfThree = 1.5F;
    std::vector<float> follows(mesh.mNumVertices, 0.0F);
    for (unsigned i = 0; i < bone.mNumWeights; ++i) {
      const aiVertexWeight& weight = bone.mWeights[i];
      if (weight.mVertexId < mesh.mNumVertices) follows[weight.mVertexId] = weight.mWeight;
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const auto [a, b, c] = corners_[i];
      if (follows[a] + follows[b] + follows[c] >= kHalfOfThree)
        groups_.add(MeshGroupKind::kVertexGroup, bone.mName.C_Str(), first + i, first + i + 1);
    }
  }

  void addFace(const aiMesh& mesh, const aiFace& face, const glm::dmat4& frame, bool mirrors) {
    if (face.mNumIndices < 3) {
      ++(face.mNumIndices == 2 ? lines_ : points_);
      return;
    }
    std::vector<glm::dvec3> corners;
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const unsigned index = face.mIndices[i];
      if (index >= mesh.mNumVertices) {
        error_ = "has a face that names vertex " + std::to_string(index) + " of " +
                 std::to_string(mesh.mNumVertices);
        return;
      }
      const aiVector3D& v = mesh.mVertices[index];
      corners.emplace_back(frame * glm::dvec4(v.x, v.y, v.z, 1.0));
    }
    for (auto [a, b, c] : triangulate(corners)) {
      if (mirrors) std::swap(b, c);
      addTriangle({indexOf(face.mIndices[a], corners[a]), indexOf(face.mIndices[b], corners[b]),
                   indexOf(face.mIndices[c], corners[c])});
      if (mesh.mNumBones > 0) corners_.push_back({face.mIndices[a], face.mIndices[b], face.mIndices[c]});
    }
  }

  std::uint32_t indexOf(unsigned fileIndex, const glm::dvec3& position) {
    std::uint32_t& index = indices_[fileIndex];
    if (index != kNone) return index;
    const Vec3 vertex(position);
    if (!(std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z))) {
      error_ = "has a vertex that is not finite or does not fit a float (number " +
               std::to_string(fileIndex + 1) + " of piece " + std::to_string(result_.pieces) +
               "); export it again";
    }
    index = welder_.indexOf(vertex);
    return index;
  }

  void addTriangle(const std::array<std::uint32_t, 3>& triangle) {
    if (result_.mesh.triangles.size() >= options_.maxTriangles) {
      error_ = "has more than " + std::to_string(options_.maxTriangles) + " triangles; simplify it first";
      return;
    }
    result_.mesh.triangles.push_back(triangle);
  }

  void describeLosses() {
    std::vector<std::string>& warnings = result_.warnings;
    if (points_ > 0) warnings.push_back(std::to_string(points_) + " points are left out");
    if (lines_ > 0) warnings.push_back(std::to_string(lines_) + " lines are left out");
    if (hasBones_) warnings.emplace_back("bones are ignored; the mesh is taken as it is stored");
    if (scene_.mNumAnimations > 0) warnings.emplace_back("animations are ignored");
  }

  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  const aiScene& scene_;
  const MeshOptions& options_;
  MeshFile result_;
  Welder welder_{result_.mesh.vertices};
  std::vector<std::uint32_t> indices_;            ///< From the current mesh's vertices to the result's.
  std::vector<std::array<unsigned, 3>> corners_;  ///< Of the current mesh's triangles, if it has bones.
  GroupNames groups_;
  std::optional<std::string> error_;
  std::size_t points_ = 0;
  std::size_t lines_ = 0;
  bool hasBones_ = false;
};

/// An axis of an FBX file as its header has it; nothing if it has none.
std::optional<glm::dvec3> fbxAxis(const aiMetadata& header, const std::string& name) {
  std::int32_t axis = -1;
  std::int32_t sign = 0;
  if (!header.Get(name, axis) || !header.Get(name + "Sign", sign) || axis < 0 || axis > 2 || sign * sign != 1)
    return std::nullopt;
  glm::dvec3 direction{0.0};
  direction[axis] = sign;
  return direction;
}

/// From the file's axes to x right, y up, z towards the viewer. Assimp leaves that to later, or puts it into
/// the root, as its version has it; so the root is not looked at.
glm::dmat4 fbxFrame(const aiScene& scene) {
  if (scene.mMetaData == nullptr) return glm::dmat4(1.0);
  const auto right = fbxAxis(*scene.mMetaData, "CoordAxis");
  const auto up = fbxAxis(*scene.mMetaData, "UpAxis");
  const auto front = fbxAxis(*scene.mMetaData, "FrontAxis");
  if (!right || !up || !front) return glm::dmat4(1.0);
  const glm::dmat3 rows(*right, *up, *front);
  if (std::abs(glm::determinant(rows)) < 0.5) return glm::dmat4(1.0);
  const glm::dmat4 frame(glm::transpose(rows));
  return frame;
}

/// Metres.
double fbxUnit(const aiScene& scene) {
  constexpr double kCentimetre = 0.01;
  // Versions of Assimp differ in its type.
  float single = 1.0F;
  double factor = 1.0;
  const aiMetadata* header = scene.mMetaData;
  if (header != nullptr && header->Get("UnitScaleFactor", single)) factor = static_cast<double>(single);
  if (header != nullptr) header->Get("UnitScaleFactor", factor);
  return std::isfinite(factor) && factor > 0.0 ? factor * kCentimetre : kCentimetre;
}

/// Formats that say which way is up.
bool saysUp(const std::string& extension) {
  return extension == "dae" || extension == "gltf" || extension == "glb" || extension == "fbx";
}

/// The root's frame, in metres and upright. Assimp's COLLADA reader puts unit and up axis into the root.
glm::dmat4 rootFrame(const aiScene& scene, const std::string& extension, const MeshOptions& options) {
  const bool isFbx = extension == "fbx";
  const glm::dmat4 own =
      scene.mRootNode != nullptr ? toMatrix(scene.mRootNode->mTransformation) : glm::dmat4(1.0);
  const glm::dmat4 root = isFbx ? fbxFrame(scene) : own;
  double scale = options.unit.value_or(isFbx ? fbxUnit(scene) : 1.0);
  if (options.unit && extension == "dae") {
    const double fileUnit = std::cbrt(std::abs(glm::determinant(glm::dmat3(root))));
    if (fileUnit > 0.0) scale /= fileUnit;
  }
  glm::dmat4 frame = saysUp(extension) ? root : uprightFrom(options.up) * root;
  for (int column = 0; column < 4; ++column) {
    frame[column] = glm::dvec4(scale * glm::dvec3(frame[column]), frame[column].w);
  }
  return frame;
}

/// Who uses an extension of glTF names it in a list.
bool names(std::string_view gltf, std::string_view extension) {
  return gltf.find('"' + std::string(extension) + '"') != std::string_view::npos;
}

/// For Assimp, which reads wrong numbers with these extensions; nothing if the file uses none of them.
Result<std::optional<PlainGltf>> plainGltf(const fs::path& path, const std::string& extension,
                                           const OwnFolder& folder) {
  if (extension != "gltf" && extension != "glb") return std::nullopt;
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return fail(bytes.error().message);
  if (names(*bytes, "KHR_meshopt_compression")) {
    return fail(
        "uses KHR_meshopt_compression, which is not known here; export it with EXT_meshopt_compression, or "
        "uncompressed");
  }
  if (!names(*bytes, "KHR_mesh_quantization") && !names(*bytes, "EXT_meshopt_compression"))
    return std::nullopt;
  return makePlainGltf(*bytes, path, [&](const fs::path& file) { return folder.Exists(file.c_str()); });
}

/// See MeshFile::fromFile.
Mat3 fileAxes(const aiScene& scene, const std::string& extension, const MeshOptions& options) {
  glm::dmat3 axes(1.0);
  if (extension == "fbx") {
    axes = options.unit.value_or(fbxUnit(scene)) * glm::dmat3(fbxFrame(scene));
  } else if (!saysUp(extension)) {
    axes = options.unit.value_or(1.0) * glm::dmat3(uprightFrom(options.up));
  }
  const Mat3 single(axes);
  return single;
}

}  // namespace

std::vector<std::string> assimpExtensions() {
  aiString list;
  Assimp::Importer().GetExtensionList(list);
  std::vector<std::string> extensions;
  std::istringstream words(list.C_Str());
  // Each is "*." and the extension; those of two words cannot be told by the last one.
  for (std::string word; std::getline(words, word, ';');) {
    const std::string extension = word.substr(std::min(word.size(), std::size_t{2}));
    if (!extension.empty() && extension.find('.') == std::string::npos) extensions.push_back(extension);
  }
  std::sort(extensions.begin(), extensions.end());
  return extensions;
}

Result<MeshFile> readWithAssimp(const fs::path& path, const std::string& extension,
                                const MeshOptions& options) {
  auto folder = std::make_unique<OwnFolder>(path, options.maxFileBytes);
  const Result<std::optional<PlainGltf>> plain = plainGltf(path, extension, *folder);
  if (!plain) return fail(plain.error().message);
  Assimp::Importer importer;
  keepFormat(importer, extension);
  importer.SetIOHandler(folder.release());  // The importer owns it.
  const aiScene* scene =
      *plain ? importer.ReadFileFromMemory((*plain)->glb.data(), (*plain)->glb.size(), 0, "glb")
             : importer.ReadFile(path.string(), 0);
  if (scene == nullptr) return fail(std::string("cannot be read: ") + importer.GetErrorString());
  Result<MeshFile> file = Collector(*scene, options).collect(rootFrame(*scene, extension, options));
  if (file && *plain)
    std::copy((*plain)->warnings.begin(), (*plain)->warnings.end(), std::back_inserter(file->warnings));
  if (file) file->fromFile = fileAxes(*scene, extension, options);
  return file;
}

}  // namespace scatter::io
