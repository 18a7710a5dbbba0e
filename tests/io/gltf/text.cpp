#include "io/gltf/text.h"

#include <gtest/gtest.h>
#include <scatter/io/gltf.h>

#include "io/gltf/base64.h"

namespace scatter::test {

std::string GltfText::text() const {
  std::string result = R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_implicit_shapes",)"
                       R"("KHR_physics_rigid_bodies"],"extensions":{"KHR_implicit_shapes":{"shapes":[)";
  result += shapes + R"(]},"KHR_physics_rigid_bodies":{"physicsMaterials":[)" + materials;
  result += R"(],"collisionFilters":[)" + filters + R"(],"physicsJoints":[)" + joints + "]}},";
  return result + R"("scene":0,"scenes":[{"name":"test","nodes":[)" + roots + R"(]}],"nodes":[)" + nodes +
         "]" + more + "}";
}

std::string physicsNode(const std::string& physics, const std::string& members) {
  return "{" + members + (members.empty() ? "" : ",") + R"("extensions":{"KHR_physics_rigid_bodies":{)" +
         physics + "}}}";
}

std::string boxNode(const std::string& motion, const std::string& members) {
  return physicsNode(
      (motion.empty() ? "" : "\"motion\":" + motion + ",") + R"("collider":{"geometry":{"shape":0}})",
      members);
}

PhysicsDocument readGltf(const std::string& text) {
  auto document = parseGltfDocument(text, "test.gltf");
  EXPECT_TRUE(document.has_value()) << document.error().message;
  return document.value_or(PhysicsDocument{});
}

std::string bufferMembers(const std::string& bytes, const std::string& views, const std::string& accessors) {
  return R"(,"buffers":[{"byteLength":)" + std::to_string(bytes.size()) +
         R"(,"uri":"data:application/octet-stream;base64,)" + io::encodeBase64(bytes) +
         R"("}],"bufferViews":[)" + views + R"(],"accessors":[)" + accessors + "]";
}

std::string glb(std::string json, const std::string& binary) {
  const auto word = [](std::size_t value) {
    const auto narrow = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&narrow), sizeof narrow);
  };
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string chunks = word(json.size()) + "JSON" + json;
  if (!binary.empty()) {
    chunks += word(binary.size()) + std::string("BIN\0", 4) + binary;
  }
  return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

}  // namespace scatter::test
