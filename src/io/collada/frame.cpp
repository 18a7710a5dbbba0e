#include "io/collada/frame.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <pugixml.hpp>
#include <string>

#include "io/numbers.h"

namespace scatter::io {
namespace {

constexpr float kHalfSqrt2 = 0.70710678F;

bool isText(const pugi::xml_node& node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

std::string countMismatch(std::size_t expected, std::size_t found) {
  return "should hold " + std::to_string(expected) + (expected == 1 ? " number" : " numbers") +
         ", but holds " + std::to_string(found);
}

}  // namespace

Quat unitRotation(const Quat& rotation) {
  return withoutNoise(Quat(glm::normalize(glm::dquat(rotation))));
}

Quat withoutNoise(const Quat& rotation) {
  constexpr float kNoise = 1e-12F;
  return std::abs(rotation.w) < kNoise ? Quat(0.0F, rotation.x, rotation.y, rotation.z) : rotation;
}

Result<XmlSource> parseColladaXml(std::string_view text, std::string_view name) {
  auto source = XmlSource::parse(text, name);
  if (source && std::string_view(source->root().name()) != "COLLADA") {
    return source->failAt(source->root(), "is not a COLLADA document");
  }
  return source;
}

Result<ColladaFrame> ColladaFrame::read(const XmlSource& xml, ColladaNotes& notes) {
  ColladaFrame frame(xml, notes);
  const pugi::xml_node asset = xml.root().child("asset");
  if (const auto unit = frame.readUnit(asset); !unit) {
    return tl::unexpected(unit.error());
  }
  if (const auto up = frame.readUpAxis(asset); !up) {
    return tl::unexpected(up.error());
  }
  return frame;
}

void ColladaFrame::note(const pugi::xml_node& node, const std::string& what) const {
  notes_->add(*xml_, node, what);
}

Result<void> ColladaFrame::mend(const pugi::xml_node& node, const std::string& what,
                                const std::string& remedy) const {
  if (!notes_->mends()) {
    return xml_->failAt(node, what);
  }
  note(node, what + "; " + remedy);
  return {};
}

void ColladaFrame::noteUnknown(const pugi::xml_node& parent,
                               std::initializer_list<std::string_view> known) const {
  if (!notes_->mends()) {
    return;
  }
  for (const pugi::xml_node& child : parent.children()) {
    const std::string_view name = child.name();
    if (child.type() != pugi::node_element || name == "asset" ||
        std::find(known.begin(), known.end(), name) != known.end()) {
      continue;
    }
    if (name == "extra") {
      noteUnknown(child, {});
    } else if (name != "technique") {
      note(child, "is not known in <" + std::string(parent.name()).substr(0, 60) + "> and is ignored");
    } else if (const std::string_view profile = child.attribute("profile").value(); profile != "SCATTER") {
      note(child, "profile " + inQuotes(profile) + " is not read");
    } else {
      noteUnknown(child, {"levels", "motion", "point", "shown_mesh"});
    }
  }
}

void ColladaFrame::noteUnused(const char* library, const char* kind,
                              const std::set<std::size_t>& used) const {
  for (const pugi::xml_node& entries : xml_->root().children(library)) {
    for (const pugi::xml_node& entry : entries.children(kind)) {
      if (!used.contains(entry.hash_value())) {
        const pugi::xml_attribute id = entry.attribute("id");
        note(entry, inQuotes((id ? id : entry.attribute("name")).value()) +
                        " is instanced by nothing that is read; it is left out");
      }
    }
  }
}

Result<pugi::xml_node> ColladaFrame::resolve(const pugi::xml_node& node, const char* attribute,
                                             const char* kind) const {
  const std::string_view url = node.attribute(attribute).value();
  const bool bare = !url.empty() && url.front() != '#';
  const pugi::xml_node found = bare ? xml_->findId(url) : pugi::xml_node();
  if (found && std::string_view(found.name()) == kind) {
    note(node, std::string(attribute) + " should begin with '#'");
    return found;
  }
  return xml_->resolve(node, attribute, kind);
}

Result<pugi::xml_node> ColladaFrame::follow(const pugi::xml_node& node, const char* attribute,
                                            const char* kind) const {
  const auto found = resolve(node, attribute, kind);
  if (!found) {
    return xml_->failAt(node, found.error().message);
  }
  return found;
}

Result<pugi::xml_node> ColladaFrame::followOrMend(const pugi::xml_node& node, const char* attribute,
                                                  const char* kind, const std::string& remedy) const {
  const auto found = resolve(node, attribute, kind);
  if (!found) {
    return mend(node, found.error().message, remedy).map([] { return pugi::xml_node(); });
  }
  return found;
}

Vec3 ColladaFrame::turnYUp(const Vec3& vector) const {
  switch (up_) {
    case UpAxis::kX:
      return {-vector.y, vector.x, vector.z};
    case UpAxis::kZ:
      return {vector.x, vector.z, -vector.y};
    default:
      return vector;
  }
}

Vec3 ColladaFrame::turnBack(const Vec3& vector) const {
  switch (up_) {
    case UpAxis::kX:
      return {vector.y, -vector.x, vector.z};
    case UpAxis::kZ:
      return {vector.x, -vector.z, vector.y};
    default:
      return vector;
  }
}

Transform ColladaFrame::inYUp(const Transform& transform) const {
  if (up_ == UpAxis::kY) {
    return transform;
  }
  return {turnYUp(transform.position), unitRotation(toYUp_ * transform.rotation)};
}

Transform ColladaFrame::toYUp(const Transform& transform) const {
  if (up_ == UpAxis::kY) {
    return transform;
  }
  const Quat rotation = toYUp_ * transform.rotation * glm::conjugate(toYUp_);
  return {turnYUp(transform.position),
          transform.rotation == kNoRotation ? kNoRotation : unitRotation(rotation)};
}

Result<void> ColladaFrame::readUnit(const pugi::xml_node& asset) {
  const pugi::xml_node unit = asset.child("unit");
  const pugi::xml_attribute meter = unit.attribute("meter");
  if (!meter) {
    return {};
  }
  const auto value = parseNumber(meter.value());
  if (!value || !(*value >= 1e-6 && *value <= 1e6)) {
    return xml_->failAt(unit, "meter " + inQuotes(meter.value()) + " is not a number from 1e-6 to 1e6");
  }
  metersPerUnit_ = *value;
  return {};
}

Result<void> ColladaFrame::readUpAxis(const pugi::xml_node& asset) {
  const pugi::xml_node up = asset.child("up_axis");
  std::string_view text = up.child_value();
  const std::string_view axis = takeWord(text);
  if (axis == "Z_UP") {
    up_ = UpAxis::kZ;
    toYUp_ = Quat(kHalfSqrt2, -kHalfSqrt2, 0.0F, 0.0F);
  } else if (axis == "X_UP") {
    up_ = UpAxis::kX;
    toYUp_ = Quat(kHalfSqrt2, 0.0F, 0.0F, kHalfSqrt2);
  } else if (up && axis != "Y_UP") {
    return xml_->failAt(up, inQuotes(axis) + " is not one of X_UP, Y_UP and Z_UP");
  }
  return {};
}

Result<std::vector<double>> ColladaFrame::openNumbers(const pugi::xml_node& node, std::size_t count) const {
  std::vector<double> values;
  for (const pugi::xml_node& piece : node.children()) {
    if (!isText(piece)) {
      continue;
    }
    std::string_view text = piece.value();
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
      const auto value = parseNumber(word);
      if (!value || std::isnan(*value)) {
        return xml_->failAt(node, inQuotes(word) + " is not a finite number");
      }
      values.push_back(*value);
    }
  }
  if (count != 0 && values.size() != count) {
    return xml_->failAt(node, countMismatch(count, values.size()));
  }
  return values;
}

Result<std::vector<double>> ColladaFrame::numbers(const pugi::xml_node& node, std::size_t count) const {
  auto values = openNumbers(node, count);
  if (values && !std::all_of(values->begin(), values->end(), [](double v) { return std::isfinite(v); })) {
    return xml_->failAt(node, "\"INF\" is not a finite number");
  }
  return values;
}

Result<std::vector<float>> ColladaFrame::lengths(const pugi::xml_node& node, std::size_t count) const {
  const auto values = numbers(node, count);
  if (!values) {
    return tl::unexpected(values.error());
  }
  std::vector<float> result;
  result.reserve(values->size());
  for (const double value : *values) {
    const double meters = value * metersPerUnit_;
    if (std::abs(meters) > kMaxLength) {
      return xml_->failAt(node, formatNumber(meters, 6) + " m is too large; the limit is " +
                                    formatNumber(kMaxLength, 6) + " m");
    }
    result.push_back(static_cast<float>(meters));
  }
  return result;
}

Result<Vec3> ColladaFrame::vector(const pugi::xml_node& node) const {
  return lengths(node, 3).map([](const std::vector<float>& v) { return Vec3(v[0], v[1], v[2]); });
}

Result<Vec3> ColladaFrame::plainVector(const pugi::xml_node& node) const {
  const auto values = numbers(node, 3);
  if (!values) {
    return tl::unexpected(values.error());
  }
  for (const double value : *values) {
    if (std::abs(value) > 1e9) {
      return xml_->failAt(node, formatNumber(value, 6) + " is too large; the limit is 1e9");
    }
  }
  return Vec3((*values)[0], (*values)[1], (*values)[2]);
}

Result<std::optional<float>> ColladaFrame::scalar(const pugi::xml_node& node, double low, double high) const {
  if (!node) {
    return std::nullopt;
  }
  const auto values = numbers(node, 1);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const double value = std::clamp(values->front(), low, high);
  if (value != values->front()) {
    const std::string range =
        " is not from " + formatNumber(low, 6).append(" to ").append(formatNumber(high, 6));
    const auto mended =
        mend(node, formatNumber(values->front(), 6) + range, formatNumber(value, 6) + " is taken");
    if (!mended) {
      return tl::unexpected(mended.error());
    }
  }
  return static_cast<float>(value);
}

Result<bool> ColladaFrame::flag(const pugi::xml_node& node, bool fallback) const {
  std::string_view text = node.child_value();
  std::string word(takeWord(text));
  std::transform(word.begin(), word.end(), word.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (word == "true" || word == "1") {
    return true;
  }
  if (word == "false" || word == "0") {
    return false;
  }
  if (!word.empty()) {
    return xml_->failAt(node, inQuotes(word) + " is neither true nor false");
  }
  return fallback;
}

Result<std::vector<float>> ColladaFrame::sizes(const pugi::xml_node& node, std::size_t count,
                                               float thin) const {
  auto values = lengths(node, count);
  if (!values || values->empty()) {
    return values;
  }
  const auto [least, most] = std::minmax_element(values->begin(), values->end());
  constexpr auto kLeast = static_cast<float>(kMinLength);
  if (*least >= kLeast) {
    return values;
  }
  const std::string what =
      formatNumber(*least) + (*least > 0.0F ? " m is too short" : " is not a positive length");
  const float replacement = *most >= kLeast ? std::min(1e-3F, 0.01F * *most) : thin;
  if (*least < 0.0F || replacement < kLeast) {
    return xml_->failAt(node, what);
  }
  if (const auto mended = mend(node, what, "a thin shape is taken"); !mended) {
    return tl::unexpected(mended.error());
  }
  std::replace_if(
      values->begin(), values->end(), [](float value) { return value < kLeast; }, replacement);
  return values;
}

Result<std::vector<std::uint32_t>> ColladaFrame::indices(const pugi::xml_node& node) const {
  std::vector<std::uint32_t> values;
  for (const pugi::xml_node& piece : node.children()) {
    std::string_view text = isText(piece) ? piece.value() : "";
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
      const auto value = parseIndex(word);
      if (!value) {
        return xml_->failAt(node, inQuotes(word) + " is not an index");
      }
      values.push_back(*value);
    }
  }
  return values;
}

Result<std::uint32_t> ColladaFrame::indexAttribute(const pugi::xml_node& node, const char* name,
                                                   std::uint32_t fallback) const {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) {
    return fallback;
  }
  std::string_view text = attribute.value();
  const auto value = parseIndex(takeWord(text));
  if (!value) {
    return xml_->failAt(node,
                        std::string(name) + " " + inQuotes(attribute.value()) + " is not a whole number");
  }
  return *value;
}

}  // namespace scatter::io
