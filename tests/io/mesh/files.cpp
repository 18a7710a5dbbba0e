#include "io/mesh/files.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

namespace scatter::test {

namespace {

using Corner = std::array<float, 3>;
using Corners = std::array<std::uint16_t, 3>;

constexpr std::array<Corner, 8> kCorners{
    {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 0}, {0, 0, 3}, {1, 0, 3}, {0, 2, 3}, {1, 2, 3}}};
constexpr std::array<Corners, 12> kTriangles{{{0, 2, 1},
                                              {1, 2, 3},
                                              {4, 5, 6},
                                              {5, 7, 6},
                                              {0, 1, 4},
                                              {1, 5, 4},
                                              {2, 6, 3},
                                              {3, 6, 7},
                                              {0, 4, 2},
                                              {2, 4, 6},
                                              {1, 3, 5},
                                              {3, 7, 5}}};

std::string number(float value) {
  return std::to_string(static_cast<int>(value));
}

std::string words(const Corner& corner) {
  return number(corner[0]) + " " + number(corner[1]) + " " + number(corner[2]);
}

template <class Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Positions, then indices.
std::string buffer() {
  std::string bytes;
  for (const Corner& corner : kCorners) append(bytes, corner);
  for (const Corners& triangle : kTriangles) append(bytes, triangle);
  return bytes;
}

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
    }
  }
  return text;
}

std::string gltfJson(const std::string& node, const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{)" + node +
         R"("mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],"max":[1,2,3]},)"
         R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],)"
         R"("buffers":[{"byteLength":168)" +
         uri + "}]}";
}

}  // namespace

std::string gltfSkinnedBox() {
  std::string bytes = buffer();
  for (std::size_t i = 0; i < kCorners.size(); ++i)
    append(bytes, std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(i / 4), 0, 0, 0});
  for (std::size_t i = 0; i < kCorners.size(); ++i)
    append(bytes, std::array<float, 4>{1.0F, 0.0F, 0.0F, 0.0F});
  // Bones at rest; Assimp crashes without them.
  for (int bone = 0; bone < 2; ++bone) {
    for (int i = 0; i < 16; ++i) append(bytes, i % 5 == 0 ? 1.0F : 0.0F);
  }
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,2]}],)"
         R"("nodes":[{"name":"box","mesh":0,"skin":0},{"name":"low"},{"name":"high"}],"skins":[{"joints":[1,2],"inverseBindMatrices":4}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],"max":[1,2,3]},)"
         R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"},)"
         R"({"bufferView":2,"componentType":5121,"count":8,"type":"VEC4"},)"
         R"({"bufferView":3,"componentType":5126,"count":8,"type":"VEC4"},)"
         R"({"bufferView":4,"componentType":5126,"count":2,"type":"MAT4"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72},)"
         R"({"buffer":0,"byteOffset":168,"byteLength":32},{"buffer":0,"byteOffset":200,"byteLength":128},{"buffer":0,"byteOffset":328,"byteLength":128}],)"
         R"("buffers":[{"byteLength":456,"uri":"data:application/octet-stream;base64,)" +
         base64(bytes) + "\"}]}";
}

std::string objBox() {
  std::string text = "o box\n";
  for (const Corner& corner : kCorners) text += "v " + words(corner) + "\n";
  for (const Corners& t : kTriangles) {
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
            std::to_string(t[2] + 1) + "\n";
  }
  return text;
}

std::string objTool() {
  std::string text = "mtllib missing.mtl\n";
  const std::array<std::array<const char*, 2>, 3> pieces{
      {{"body", "steel"}, {"handle", "rubber"}, {"tip", "rubber"}}};
  std::size_t count = 0;
  for (const auto& [object, material] : pieces) {
    text += std::string("o ") + object + "\n";
    for (const Corner& c : kCorners) {
      const std::size_t piece = count / kCorners.size();
      const auto x = 2.0F * static_cast<float>(piece);
      text += "v " + words({x + c[0], c[1] / 2, c[2] / 3}) + "\n";
    }
    text += std::string("usemtl ") + material + "\n";
    for (const Corners& t : kTriangles) {
      text += "f";
      for (const std::uint16_t corner : t) text += " " + std::to_string(count + corner + 1);
      text += "\n";
    }
    count += kCorners.size();
  }
  return text;
}

std::string asciiStlBox() {
  std::string text = "solid box\n";
  for (const Corners& t : kTriangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const std::uint16_t corner : t) text += "  vertex " + words(kCorners.at(corner)) + "\n";
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

std::string binaryStlBox() {
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(kTriangles.size()));
  for (const Corners& t : kTriangles) {
    append(bytes, Corner{0.0F, 0.0F, 0.0F});
    for (const std::uint16_t corner : t) append(bytes, kCorners.at(corner));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string plyBox() {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Corner& corner : kCorners) text += words(corner) + "\n";
  for (const Corners& t : kTriangles) {
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  }
  return text;
}

std::string fbxBox(const std::string& settings) {
  std::string vertices;
  for (const Corner& corner : kCorners) {
    for (const float value : corner) vertices += (vertices.empty() ? "" : ",") + number(value);
  }
  std::string indices;
  for (const Corners& triangle : kTriangles) {
    // The last corner of a polygon is stored as its complement.
    for (std::size_t k = 0; k < 3; ++k) {
      const int index = triangle[k];
      indices += (indices.empty() ? "" : ",") + std::to_string(k == 2 ? -index - 1 : index);
    }
  }
  return "; FBX 7.4.0 project file\n"
         "FBXHeaderExtension: {\n FBXHeaderVersion: 1003\n FBXVersion: 7400\n}\n"
         "GlobalSettings: {\n Version: 1000\n Properties70: {\n" +
         settings +
         " }\n}\n"
         "Objects: {\n"
         " Geometry: 10, \"Geometry::box\", \"Mesh\" {\n"
         "  Vertices: *24 {\n   a: " +
         vertices + "\n  }\n  PolygonVertexIndex: *36 {\n   a: " + indices +
         "\n  }\n  GeometryVersion: 124\n }\n"
         " Model: 20, \"Model::box\", \"Mesh\" {\n  Version: 232\n  Properties70: {\n  }\n }\n"
         "}\n"
         "Connections: {\n C: \"OO\",20,0\n C: \"OO\",10,20\n}\n";
}

std::string offBox() {
  std::string text = "OFF\n8 12 0\n";
  for (const Corner& corner : kCorners) text += words(corner) + "\n";
  for (const Corners& t : kTriangles) {
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  }
  return text;
}

std::string daeBox(const std::string& asset, const std::string& transform) {
  std::string positions;
  for (const Corner& corner : kCorners) positions += words(corner) + " ";
  std::string corners;
  for (const Corners& t : kTriangles) {
    for (const std::uint16_t corner : t) corners += std::to_string(corner) + " ";
  }
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)" +
         asset + R"(</asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="24">)" +
         positions + R"(</float_array><technique_common><accessor source="#a" count="8" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
         corners + R"(</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n">)" +
         transform + R"(<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
}

std::string gltfBox(const std::string& node) {
  return gltfJson(node, R"(,"uri":"data:application/octet-stream;base64,)" + base64(buffer()) + "\"");
}

std::string glbBox() {
  std::string json = gltfJson("", "");
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::string data = buffer();
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + data.size()));
  append(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append(bytes, static_cast<std::uint32_t>(data.size()));
  return bytes + std::string("BIN\0", 4) + data;
}

void writeText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace scatter::test
