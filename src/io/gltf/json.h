#pragma once

#include <scatter/math.h>
#include <scatter/result.h>

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scatter::io {

/// Ends the reading of a glTF file. Thrown and caught within the reader, which makes an Error of it.
struct GltfFailure {
  std::string message;  ///< Without the file's name.
};

/// No length in a glTF file may be larger, in metres.
inline constexpr double kMaxGltfLength = 1e5;

/// A value in a JSON document and its path, which begins every message about it, such as
/// "nodes[3].mesh". All functions throw GltfFailure if the value is not what is asked for.
class JsonPlace {
 public:
  JsonPlace(const nlohmann::json& value, std::string path) : value_(&value), path_(std::move(path)) {}

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const nlohmann::json& value() const { return *value_; }
  [[noreturn]] void fail(const std::string& what) const;

  [[nodiscard]] bool isObject() const;
  [[nodiscard]] bool isText() const;

  /// A member of this object, if there.
  [[nodiscard]] std::optional<JsonPlace> find(const char* key) const;
  [[nodiscard]] JsonPlace at(const char* key) const;

  /// `find` along several keys, each an object's member.
  [[nodiscard]] std::optional<JsonPlace> find(std::initializer_list<const char*> keys) const;

  [[nodiscard]] std::vector<std::string> keys() const;  ///< Of what is known to be an object.
  [[nodiscard]] std::size_t size() const;               ///< Of this array.
  [[nodiscard]] JsonPlace operator[](std::size_t index) const;

  [[nodiscard]] double number() const;
  [[nodiscard]] double number(double low, double high) const;
  [[nodiscard]] double length() const;  ///< From minus to plus kMaxGltfLength.
  [[nodiscard]] double size(double low) const;
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] std::size_t index(std::size_t limit, const char* kind) const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::vector<double> numbers(std::size_t count) const;
  [[nodiscard]] glm::dvec3 vector(double largest = kMaxGltfLength) const;

  /// x, y, z, w; normalised if it is not of length 1.
  [[nodiscard]] glm::dquat rotation() const;

 private:
  const nlohmann::json* value_;
  std::string path_;
};

/// A parsed JSON text. Depth and number of values are limited.
class JsonDocument {
 public:
  /// The message is without the file's name.
  [[nodiscard]] static Result<JsonDocument> parse(std::string_view text);
  JsonDocument(JsonDocument&&) noexcept;
  JsonDocument& operator=(JsonDocument&&) noexcept;
  ~JsonDocument();

  [[nodiscard]] JsonPlace root() const;

 private:
  explicit JsonDocument(nlohmann::json value);
  std::unique_ptr<nlohmann::json> value_;
};

/// Whether no coordinate is larger than kMaxGltfLength.
[[nodiscard]] bool isInReach(const glm::dvec3& position);

/// The same rotation; of length 1 if it was not nearly so before.
[[nodiscard]] glm::dquat withUnitLength(const glm::dquat& rotation);

/// Rounded to floats.
[[nodiscard]] Transform toTransform(const glm::dvec3& position, const glm::dquat& rotation);

/// The members "translation" and "rotation" of an object, each optional.
[[nodiscard]] Transform readTransform(const JsonPlace& place);

}  // namespace scatter::io
