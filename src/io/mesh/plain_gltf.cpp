#include "io/mesh/plain_gltf.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "io/gltf/accessor.h"
#include "io/gltf/component.h"
#include "io/gltf/container.h"
#include "io/gltf/file.h"
#include "io/mesh/meshopt.h"

namespace scatter::io {
namespace {

using nlohmann::json;

/// Writes what Assimp is to know of a file anew.
class PlainWriter {
 public:
  explicit PlainWriter(GltfFile& source) : source_(source) {}

  PlainGltf write() {
    copyMeshes();
    copyNodes();
    copySkins();
    copyMaterials();
    for (const char* key : {"scene", "scenes"}) {
      if (const auto found = source_.root().find(key)) result_[key] = found->value();
    }
    if (!data_.empty()) result_["buffers"] = json::array({{{"byteLength", data_.size()}}});
    if (source_.count("animations") > 0) warnings_.emplace_back("animations are ignored");
    return {.glb = packGlb(result_.dump(-1, ' ', false, json::error_handler_t::replace), std::move(data_)),
            .warnings = std::move(warnings_)};
  }

 private:
  /// An accessor of the result.
  struct Numbers {
    std::size_t accessor = 0;
    std::size_t count = 0;
    std::uint32_t largest = 0;  ///< Of indices.
  };

  template <class Value>
  Numbers add(const std::vector<Value>& values, std::size_t width, Component component, const char* type) {
    const std::size_t bytes = values.size() * sizeof(Value);
    result_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", bytes}});
    data_.append(reinterpret_cast<const char*>(values.data()), bytes);
    json& accessors = result_["accessors"];
    accessors.push_back({{"bufferView", accessors.size()},
                         {"componentType", component},
                         {"count", values.size() / width},
                         {"type", type}});
    return {.accessor = accessors.size() - 1, .count = values.size() / width};
  }

  /// What `make` makes of the accessor that `reference` names, which many may do.
  template <class Make>
  const Numbers& once(const JsonPlace& reference, char use, const Make& make) {
    const std::pair key(reference.index(source_.count("accessors"), "accessor"), use);
    const auto found = numbers_.find(key);
    return found != numbers_.end() ? found->second : numbers_.emplace(key, make()).first->second;
  }

  const Numbers& floats(const JsonPlace& reference, const char* type, std::size_t width) {
    return once(reference, 'f', [&] {
      return add(readFloats(source_, reference, type, width), width, Component::kFloat, type);
    });
  }

  const Numbers& joints(const JsonPlace& reference) {
    return once(reference, 'j', [&] {
      std::vector<std::uint16_t> joints;
      for (const float joint : readFloats(source_, reference, "VEC4", 4))
        joints.push_back(static_cast<std::uint16_t>(std::clamp(joint, 0.0F, 65535.0F)));
      return add(joints, 4, Component::kUnsignedShort, "VEC4");
    });
  }

  const Numbers& indices(const JsonPlace& reference) {
    return once(reference, 'i', [&] {
      const std::vector<std::uint32_t> indices = readIndices(source_, reference);
      Numbers numbers = add(indices, 1, Component::kUnsignedInt, "SCALAR");
      if (!indices.empty()) numbers.largest = *std::max_element(indices.begin(), indices.end());
      return numbers;
    });
  }

  json attributesOf(const JsonPlace& primitive, std::optional<std::size_t>& vertices) {
    json result = json::object();
    const JsonPlace attributes = primitive.at("attributes");
    for (const auto& [name, unused] : attributes.value().items()) {
      const JsonPlace attribute = attributes.at(name.c_str());
      if (name == "POSITION") {
        const Numbers& positions = floats(attribute, "VEC3", 3);
        vertices = positions.count;
        result[name] = positions.accessor;
      } else if (name.starts_with("WEIGHTS_")) {
        result[name] = floats(attribute, "VEC4", 4).accessor;
      } else if (name.starts_with("JOINTS_")) {
        result[name] = joints(attribute).accessor;
      }
    }
    return result;
  }

  json primitive(const JsonPlace& place) {
    if (place.find({"extensions", "KHR_draco_mesh_compression"})) {
      place.fail(
          "KHR_draco_mesh_compression is not read together with KHR_mesh_quantization or "
          "EXT_meshopt_compression;"
          " leave one of them out");
    }
    json result = json::object();
    std::optional<std::size_t> vertices;
    result["attributes"] = attributesOf(place, vertices);
    if (const auto reference = place.find("indices")) {
      const Numbers& corners = indices(*reference);
      if (corners.count > 0 && vertices && corners.largest >= *vertices) {
        reference->fail("names vertex " + std::to_string(corners.largest) + " of " +
                        std::to_string(*vertices));
      }
      result["indices"] = corners.accessor;
    }
    for (const char* key : {"mode", "material"}) {
      if (const auto found = place.find(key)) result[key] = found->value();
    }
    return result;
  }

  void copyMeshes() {
    for (std::size_t i = 0; i < source_.count("meshes"); ++i) {
      const JsonPlace mesh = source_.entry("meshes", i);
      json result = named(mesh);
      const JsonPlace primitives = mesh.at("primitives");
      for (std::size_t j = 0; j < primitives.size(); ++j) {
        result["primitives"].push_back(primitive(primitives[j]));
        if (hasWholePositions(primitives[j])) wholeMeshes_.insert(i);
      }
      result_["meshes"].push_back(std::move(result));
    }
  }

  bool hasWholePositions(const JsonPlace& primitive) {
    const auto position = primitive.find({"attributes", "POSITION"});
    return position && source_.entry("accessors", *position).at("componentType").count() !=
                           static_cast<std::uint64_t>(Component::kFloat);
  }

  void copyNodes() {
    bool isUnitHidden = false;
    for (std::size_t i = 0; i < source_.count("nodes"); ++i) {
      const JsonPlace node = source_.entry("nodes", i);
      const auto mesh = node.find("mesh");
      isUnitHidden = isUnitHidden || (mesh && node.find("skin") && wholeMeshes_.contains(mesh->count()));
      json result = node.value();
      for (const char* key : {"camera", "extensions", "extras", "weights"}) result.erase(key);
      result_["nodes"].push_back(std::move(result));
    }
    if (isUnitHidden) {
      warnings_.emplace_back(
          "a mesh with bones has positions in whole numbers, and only its bones know their unit; check its "
          "size, "
          "and say --unit");
    }
  }

  void copySkins() {
    for (std::size_t i = 0; i < source_.count("skins"); ++i) {
      const JsonPlace skin = source_.entry("skins", i);
      json result = named(skin);
      result["joints"] = skin.at("joints").value();
      if (const auto matrices = skin.find("inverseBindMatrices"))
        result["inverseBindMatrices"] = floats(*matrices, "MAT4", 16).accessor;
      result_["skins"].push_back(std::move(result));
    }
  }

  void copyMaterials() {
    for (std::size_t i = 0; i < source_.count("materials"); ++i)
      result_["materials"].push_back(named(source_.entry("materials", i)));
  }

  static json named(const JsonPlace& place) {
    const auto name = place.find("name");
    return name ? json{{"name", name->text()}} : json::object();
  }

  GltfFile& source_;
  json result_{{"asset", {{"version", "2.0"}}}};
  std::string data_;
  std::map<std::pair<std::size_t, char>, Numbers> numbers_;
  std::set<std::uint64_t> wholeMeshes_;  ///< With positions that are no floats.
  std::vector<std::string> warnings_;
};

}  // namespace

Result<PlainGltf> makePlainGltf(std::string_view bytes, const std::filesystem::path& file,
                                const std::function<bool(const std::filesystem::path&)>& allows) {
  try {
    GltfFile source(bytes, {.folder = file.parent_path(), .allows = allows, .decompress = decompressMeshopt});
    return PlainWriter(source).write();
  } catch (const GltfFailure& failure) {
    return fail(failure.message);
  }
}

}  // namespace scatter::io
