#include "io/gltf/json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/numbers.h"

namespace scatter::io {
namespace {

using nlohmann::json;

// glTF needs about 10; "extras" of other programs may need a few more.
constexpr std::size_t kMaxJsonDepth = 100;
constexpr std::size_t kMaxValues = 5'000'000;
constexpr std::size_t kMaxText = std::size_t{256} << 20U;

/// Looks through a JSON text without keeping it, so that what is too deep or too much costs no memory.
class Inspector : public nlohmann::json_sax<json> {
 public:
  std::string problem;

  bool null() override { return addValue(); }
  bool boolean(bool) override { return addValue(); }
  bool number_integer(number_integer_t) override { return addValue(); }
  bool number_unsigned(number_unsigned_t) override { return addValue(); }
  bool number_float(number_float_t, const string_t&) override { return addValue(); }
  bool string(string_t&) override { return addValue(); }
  bool binary(binary_t&) override { return addValue(); }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return enter(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }

  bool parse_error(std::size_t position, const std::string&, const json::exception& error) override {
    std::string what = error.what();
    what.erase(0, std::min(what.size(), what.find("] ") + 2));
    for (char& c : what) {
      c = static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    constexpr std::size_t kLongest = 200;
    problem = "is not valid JSON at byte " + std::to_string(position) + ": " + what.substr(0, kLongest);
    return false;
  }

 private:
  bool addValue() {
    if (++values_ > kMaxValues) {
      problem = "its JSON has more than " + std::to_string(kMaxValues) + " values; move data into buffers";
    }
    return problem.empty();
  }
  bool enter() {
    if (++depth_ > kMaxJsonDepth) {
      problem = "its JSON is nested deeper than " + std::to_string(kMaxJsonDepth) + " levels";
    }
    return addValue();
  }
  bool leave() {
    --depth_;
    return true;
  }

  std::size_t values_ = 0;
  std::size_t depth_ = 0;
};

}  // namespace

Result<JsonDocument> JsonDocument::parse(std::string_view text) {
  if (text.size() > kMaxText) {
    return scatter::fail("its JSON is larger than 256 MiB; move data into buffers");
  }
  Inspector inspector;
  if (!json::sax_parse(text.begin(), text.end(), &inspector)) {
    return scatter::fail(inspector.problem);
  }
  json value = json::parse(text.begin(), text.end(), nullptr, false);
  if (!value.is_object()) {
    return scatter::fail("is not glTF: its JSON is no object");
  }
  return JsonDocument(std::move(value));
}

JsonDocument::JsonDocument(json value) : value_(std::make_unique<json>(std::move(value))) {}
JsonDocument::JsonDocument(JsonDocument&&) noexcept = default;
JsonDocument& JsonDocument::operator=(JsonDocument&&) noexcept = default;
JsonDocument::~JsonDocument() = default;

JsonPlace JsonDocument::root() const {
  return {*value_, ""};
}

void JsonPlace::fail(const std::string& what) const {
  throw GltfFailure{path_.empty() ? what : path_ + ": " + what};
}

bool JsonPlace::isObject() const {
  return value_->is_object();
}

bool JsonPlace::isText() const {
  return value_->is_string();
}

std::optional<JsonPlace> JsonPlace::find(const char* key) const {
  if (!value_->is_object()) {
    fail("should be an object");
  }
  const auto found = value_->find(key);
  return found == value_->end() ? std::nullopt
                                : std::optional(JsonPlace(*found, path_.empty() ? key : path_ + "." + key));
}

std::optional<JsonPlace> JsonPlace::find(std::initializer_list<const char*> keys) const {
  std::optional<JsonPlace> place = *this;
  for (const char* key : keys) {
    place = place->find(key);
    if (!place) {
      break;
    }
  }
  return place;
}

JsonPlace JsonPlace::at(const char* key) const {
  auto found = find(key);
  if (!found) {
    fail("\"" + std::string(key) + "\" is missing");
  }
  return *found;
}

std::vector<std::string> JsonPlace::keys() const {
  std::vector<std::string> keys;
  for (const auto& member : value_->items()) {
    keys.push_back(member.key());
  }
  return keys;
}

std::size_t JsonPlace::size() const {
  if (!value_->is_array()) {
    fail("should be an array");
  }
  return value_->size();
}

JsonPlace JsonPlace::operator[](std::size_t index) const {
  return {(*value_)[index], path_ + "[" + std::to_string(index) + "]"};
}

double JsonPlace::number() const {
  if (!value_->is_number() || !std::isfinite(value_->get<double>())) {
    fail("should be a number");
  }
  return value_->get<double>();
}

double JsonPlace::number(double low, double high) const {
  const double value = number();
  if (!(value >= low && value <= high)) {
    fail(formatNumber(value, 6) + " is not from " + formatNumber(low, 6) + " to " + formatNumber(high, 6));
  }
  return value;
}

double JsonPlace::length() const {
  return number(-kMaxGltfLength, kMaxGltfLength);
}

double JsonPlace::size(double low) const {
  return number(low, kMaxGltfLength);
}

std::uint64_t JsonPlace::count() const {
  constexpr double kLargest = 9e15;
  if (value_->is_number_unsigned()) {
    return value_->get<std::uint64_t>();
  }
  const double value = value_->is_number() ? value_->get<double>() : -1.0;
  if (!(value >= 0.0 && value <= kLargest && std::floor(value) == value)) {
    fail("should be a whole number from 0");
  }
  return static_cast<std::uint64_t>(value);
}

std::size_t JsonPlace::index(std::size_t limit, const char* kind) const {
  const std::uint64_t value = count();
  if (value >= limit) {
    fail("there is no " + std::string(kind) + " " + std::to_string(value) + "; the file has " +
         std::to_string(limit));
  }
  return static_cast<std::size_t>(value);
}

bool JsonPlace::boolean() const {
  if (!value_->is_boolean()) {
    fail("should be true or false");
  }
  return value_->get<bool>();
}

std::string JsonPlace::text() const {
  if (!value_->is_string()) {
    fail("should be a string");
  }
  return value_->get<std::string>();
}

std::vector<double> JsonPlace::numbers(std::size_t count) const {
  if (size() != count) {
    fail("should hold " + std::to_string(count) + " numbers, but holds " + std::to_string(size()));
  }
  std::vector<double> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const json& value = (*value_)[i];
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      (*this)[i].fail("should be a number");
    }
    values.push_back(value.get<double>());
  }
  return values;
}

glm::dvec3 JsonPlace::vector(double largest) const {
  const std::vector<double> v = numbers(3);
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (std::abs(v[i]) > largest) {
      (*this)[i].fail(formatNumber(v[i], 6) + " is larger than " + formatNumber(largest, 6));
    }
  }
  return {v[0], v[1], v[2]};
}

glm::dquat JsonPlace::rotation() const {
  const std::vector<double> v = numbers(4);
  const double length = std::hypot(std::hypot(v[0], v[1], v[2]), v[3]);
  constexpr double kLargest = 1e9;
  if (!(length > 1.0 / kLargest && length < kLargest)) {
    fail("should be a quaternion of length 1");
  }
  return withUnitLength({v[3], v[0], v[1], v[2]});
}

bool isInReach(const glm::dvec3& position) {
  // Not a number is not in reach.
  return std::abs(position.x) <= kMaxGltfLength && std::abs(position.y) <= kMaxGltfLength &&
         std::abs(position.z) <= kMaxGltfLength;
}

glm::dquat withUnitLength(const glm::dquat& rotation) {
  // What is nearly of length 1 stays as it is, so that reading and writing it again changes nothing.
  constexpr double kNear = 4e-6;
  return std::abs(glm::dot(rotation, rotation) - 1.0) > kNear ? glm::normalize(rotation) : rotation;
}

Transform toTransform(const glm::dvec3& position, const glm::dquat& rotation) {
  const glm::dquat q = withUnitLength(rotation);
  return {Vec3(position), Quat(static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y),
                               static_cast<float>(q.z))};
}

Transform readTransform(const JsonPlace& place) {
  const auto translation = place.find("translation");
  const auto rotation = place.find("rotation");
  return toTransform(translation ? translation->vector() : glm::dvec3(0.0),
                     rotation ? rotation->rotation() : glm::dquat(1.0, 0.0, 0.0, 0.0));
}

}  // namespace scatter::io
