#pragma once

#include <scatter/io/physics_document.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scatter::test {

/// Parts of a small glTF file; a test replaces those that it is about.
struct GltfText {
  std::string shapes = R"({"type":"box","box":{"size":[1,2,4]}})";
  std::string materials;
  std::string filters;
  std::string joints;
  std::string nodes;
  std::string roots = "0";  ///< Indices of the scene's nodes.
  std::string more;         ///< Members of the top level, each with a comma before it.

  [[nodiscard]] std::string text() const;
};

/// A node whose members are those given, with this in its KHR_physics_rigid_bodies.
[[nodiscard]] std::string physicsNode(const std::string& physics, const std::string& members = "");

/// A node with a collider of shape 0 and the motion given, if any.
[[nodiscard]] std::string boxNode(const std::string& motion, const std::string& members = "");

/// Reads a text that must be readable.
[[nodiscard]] PhysicsDocument readGltf(const std::string& text);

/// Numbers as the bytes of a buffer.
template <class Number>
[[nodiscard]] std::string bytesOf(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

/// Members "buffers", "bufferViews" and "accessors", with a comma before each. The accessors and views are
/// as given.
[[nodiscard]] std::string bufferMembers(const std::string& bytes, const std::string& views,
                                        const std::string& accessors);

/// A GLB file with these chunks; no binary one if empty.
[[nodiscard]] std::string glb(std::string json, const std::string& binary);

}  // namespace scatter::test
