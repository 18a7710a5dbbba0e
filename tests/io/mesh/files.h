#pragma once

#include <filesystem>
#include <string>

namespace scatter::test {

/// The cube from (0, 0, 0) to (1, 2, 3) in each format, as the file's bytes.
[[nodiscard]] std::string objBox();
[[nodiscard]] std::string asciiStlBox();
[[nodiscard]] std::string binaryStlBox();
[[nodiscard]] std::string plyBox();

/// Within `<asset>` goes the unit and the up axis, within the node its transform.
[[nodiscard]] std::string daeBox(const std::string& asset = "", const std::string& transform = "");

/// ASCII FBX; `settings` are properties of its global settings, a line each.
[[nodiscard]] std::string fbxBox(const std::string& settings = "");
[[nodiscard]] std::string offBox();

/// With its buffer inside; `node` holds the node's other members, such as `"scale":[1,1,-1],`.
[[nodiscard]] std::string gltfBox(const std::string& node = "");
[[nodiscard]] std::string glbBox();

/// glTF: the corners at z = 0 follow the bone "low", those at z = 3 the bone "high".
[[nodiscard]] std::string gltfSkinnedBox();

/// An obj with three cubes of 1, at x = 0, 2 and 4: the objects "body", "handle" and "tip", of which the last
/// two are of the material "rubber", the first is of "steel".
[[nodiscard]] std::string objTool();

void writeText(const std::filesystem::path& file, const std::string& text);

}  // namespace scatter::test
