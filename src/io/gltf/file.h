#pragma once

#include <scatter/levels/level_set.h>

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/json.h"

namespace scatter::io {

/// What a glTF file holds more than once costs time and memory; a file may not ask for too much of it.
/// Vertices and triangles count each time they are read or copied, pairs of parts of adjacent levels four
/// times.
class GltfBudget {
 public:
  static constexpr std::size_t kMost = 30'000'000;

  /// Throws GltfFailure once more than kMost are spent.
  void spend(std::size_t amount, const JsonPlace& place);

 private:
  std::size_t left_ = kMost;
};

/// What a level set of these levels costs.
[[nodiscard]] std::size_t levelCost(const std::vector<Level>& levels);

/// Where the data of a glTF file comes from.
struct GltfAccess {
  /// Buffers in other files are looked for here, and refused without it.
  std::optional<std::filesystem::path> folder{};

  /// Which of them are read; all if this is empty.
  std::function<bool(const std::filesystem::path&)> allows{};

  /// What an EXT_meshopt_compression object and the bytes that it names stand for; may throw GltfFailure.
  /// If this is empty, the extension is not looked at.
  std::function<std::string(const JsonPlace& compression, std::string_view bytes)> decompress{};
};

/// The JSON of a .gltf or .glb file, its buffers, and the warnings about it. Views the bytes given.
class GltfFile {
 public:
  /// Throws GltfFailure.
  GltfFile(std::string_view bytes, GltfAccess access);

  [[nodiscard]] JsonPlace root() const { return json_->root(); }

  /// A top-level array; nothing if the file has none.
  [[nodiscard]] std::size_t count(const char* array) const;

  /// An entry of it; `reference` is the place that names it by index.
  [[nodiscard]] JsonPlace entry(const char* array, const JsonPlace& reference) const;
  [[nodiscard]] JsonPlace entry(const char* array, std::size_t index) const;

  /// The bytes of a buffer view, which is read if need be.
  [[nodiscard]] std::string_view bufferView(const JsonPlace& reference);

  [[nodiscard]] GltfBudget& budget() { return budget_; }

  void warn(const JsonPlace& place, const std::string& what);
  void warn(const std::string& what);

  /// Warns of every member of an object but the known ones, "name", "extras" and "extensions".
  void warnUnknown(const JsonPlace& place, std::initializer_list<std::string_view> known);

  /// Without the file's name, in the order in which they came; what there is too much of is counted.
  [[nodiscard]] std::vector<std::string> takeWarnings();

 private:
  [[nodiscard]] std::string_view readContainer(std::string_view bytes);
  [[nodiscard]] std::string_view slice(const JsonPlace& view);
  [[nodiscard]] std::string_view buffer(const JsonPlace& reference);
  [[nodiscard]] std::string loadBuffer(const JsonPlace& uri) const;

  /// Throws if there are too many of them.
  std::string_view keep(std::map<std::size_t, std::string>& store, std::size_t index, std::string bytes,
                        const JsonPlace& place);

  GltfAccess access_;
  std::optional<std::string_view> binary_;
  std::optional<JsonDocument> json_;
  std::map<std::size_t, std::string> buffers_;
  std::map<std::size_t, std::string> decompressed_;  ///< Buffer views.
  std::size_t bufferBytes_ = 0;
  GltfBudget budget_;
  std::vector<std::string> warnings_;
  std::size_t warningsLeftOut_ = 0;
};

}  // namespace scatter::io
