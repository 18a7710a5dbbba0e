#include "io/gltf/mesh.h"

#include <glm/matrix.hpp>
#include <string>

#include "io/gltf/accessor.h"

namespace scatter::io {
namespace {

enum Mode : std::uint64_t { kPoints = 0, kTriangles = 4, kStrip = 5, kFan = 6 };

/// The corners of triangles in order, from those of a strip or fan.
std::vector<std::uint32_t> toTriangles(const std::vector<std::uint32_t>& corners, std::uint64_t mode) {
  if (mode == kTriangles) {
    return corners;
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const bool odd = mode == kStrip && i % 2 == 1;
    const std::size_t first = mode == kFan ? 0 : i - 2;
    const std::size_t second = i - 1;
    triangles.insert(triangles.end(),
                     {corners[odd ? second : first], corners[odd ? first : second], corners[i]});
  }
  return triangles;
}

std::vector<std::uint32_t> readCorners(GltfFile& file, const JsonPlace& primitive, std::size_t vertexCount) {
  std::vector<std::uint32_t> corners;
  if (const auto indices = primitive.find("indices")) {
    corners = readIndices(file, *indices);
    for (const std::uint32_t corner : corners) {
      if (corner >= vertexCount) {
        indices->fail("names vertex " + std::to_string(corner) + " of " + std::to_string(vertexCount));
      }
    }
    return corners;
  }
  for (std::size_t i = 0; i < vertexCount; ++i) {
    corners.push_back(static_cast<std::uint32_t>(i));
  }
  return corners;
}

}  // namespace

GltfPlacement GltfPlacement::operator*(const GltfPlacement& child) const {
  const glm::dmat3 turn = glm::mat3_cast(child.rotation);
  // (R S)(r s) = (R r)(rᵀ S r s)
  const bool plain = stretch == glm::dmat3(1.0);
  return {position + rotation * (stretch * child.position), rotation * child.rotation,
          plain ? child.stretch : glm::transpose(turn) * stretch * turn * child.stretch};
}

bool GltfPlacement::isIdentity() const {
  return position == glm::dvec3(0.0) && rotation == glm::dquat(1.0, 0.0, 0.0, 0.0) &&
         stretch == glm::dmat3(1.0);
}

const VisualMesh& GltfMeshes::at(const JsonPlace& reference) {
  const std::size_t index = reference.index(file_->count("meshes"), "mesh");
  auto found = meshes_.find(index);
  if (found == meshes_.end()) {
    found = meshes_.emplace(index, read(file_->entry("meshes", index))).first;
  }
  return found->second;
}

void GltfMeshes::append(const JsonPlace& reference, const GltfPlacement& placement, VisualMesh& target) {
  const VisualMesh& mesh = at(reference);
  file_->budget().spend(mesh.vertices.size() + mesh.triangles.size(), reference);
  const auto base = static_cast<std::uint32_t>(target.vertices.size());
  const bool mirrored = glm::determinant(placement.stretch) < 0.0;
  const glm::dmat3 linear = glm::mat3_cast(placement.rotation) * placement.stretch;
  const bool plain = placement.isIdentity();
  for (const Vec3& v : mesh.vertices) {
    const glm::dvec3 moved = placement.position + linear * glm::dvec3(v);
    if (!isInReach(moved)) {
      reference.fail("a vertex lies too far from the origin in its body");
    }
    target.vertices.push_back(plain ? v : Vec3(moved));
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    target.triangles.push_back({base + a, base + (mirrored ? c : b), base + (mirrored ? b : c)});
  }
}

VisualMesh GltfMeshes::read(const JsonPlace& mesh) {
  VisualMesh result;
  const JsonPlace primitives = mesh.at("primitives");
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    readPrimitive(primitives[i], result);
  }
  return result;
}

void GltfMeshes::readPrimitive(const JsonPlace& primitive, VisualMesh& mesh) {
  for (const char* packed : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    if (primitive.find({"extensions", packed})) {
      file_->warn(primitive, std::string(packed) + " is not supported; this part of the mesh is left out");
      return;
    }
  }
  if (primitive.find("targets")) {
    file_->warn(primitive, "morph targets are not supported; the mesh is read as it is without them");
  }
  const auto modePlace = primitive.find("mode");
  const std::uint64_t mode = modePlace ? modePlace->index(7, "mode") : kTriangles;
  const auto position = primitive.at("attributes").find("POSITION");
  if (!position || (mode != kPoints && mode < kTriangles)) {
    file_->warn(primitive, "has lines or no positions; this part of the mesh is left out");
    return;
  }
  const std::vector<Vec3> vertices = readPositions(*file_, *position);
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), vertices.begin(), vertices.end());
  if (mode == kPoints) {
    return;
  }
  const std::vector<std::uint32_t> corners =
      toTriangles(readCorners(*file_, primitive, vertices.size()), mode);
  if (corners.size() % 3 != 0) {
    file_->warn(primitive, "has corners left over that make no triangle");
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    mesh.triangles.push_back({base + corners[i], base + corners[i + 1], base + corners[i + 2]});
  }
}

}  // namespace scatter::io
