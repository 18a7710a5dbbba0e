#include "recording/export/foxglove.h"

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "recording/export/body_surface.h"

namespace scatter::recording {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* kMap = "map";
constexpr const char* kWorld = "world";
constexpr float kContactLine = 0.25F;  // metres along the normal

OrderedJson typed(const char* type) {
  return {{"type", type}};
}

OrderedJson object(OrderedJson properties) {
  return {{"type", "object"}, {"properties", std::move(properties)}};
}

OrderedJson list(OrderedJson items) {
  return {{"type", "array"}, {"items", std::move(items)}};
}

OrderedJson numbers(std::initializer_list<const char*> names) {
  OrderedJson properties;
  for (const char* name : names) properties[name] = typed("number");
  return object(std::move(properties));
}

OrderedJson timeSchema() {
  return object({{"sec", typed("integer")}, {"nsec", typed("integer")}});
}

OrderedJson poseSchema() {
  return object({{"position", numbers({"x", "y", "z"})}, {"orientation", numbers({"x", "y", "z", "w"})}});
}

OrderedJson timeOf(std::uint64_t nanoseconds) {
  constexpr std::uint64_t kSecond = 1000000000;
  return {{"sec", nanoseconds / kSecond}, {"nsec", nanoseconds % kSecond}};
}

// Tenths of millimetres are enough to be seen.
double rounded(float number) {
  return std::round(static_cast<double>(number) * 1e4) / 1e4;
}

OrderedJson vector(const Vec3& v) {
  return {{"x", rounded(v.x)}, {"y", rounded(v.y)}, {"z", rounded(v.z)}};
}

OrderedJson quaternion(const Quat& q) {
  const auto part = [](float number) { return std::round(static_cast<double>(number) * 1e6) / 1e6; };
  return {{"x", part(q.x)}, {"y", part(q.y)}, {"z", part(q.z)}, {"w", part(q.w)}};
}

OrderedJson noPose() {
  return {{"position", vector(Vec3(0.0F))}, {"orientation", quaternion(kNoRotation)}};
}

OrderedJson colour(const Vec3& c) {
  return {{"r", c.x}, {"g", c.y}, {"b", c.z}, {"a", 1.0}};
}

OrderedJson entity(const std::string& id, const std::string& frame, std::uint64_t nanoseconds) {
  OrderedJson entity{{"timestamp", timeOf(nanoseconds)},
                     {"frame_id", frame},
                     {"id", id},
                     {"lifetime", timeOf(0)},
                     {"frame_locked", true}};
  for (const char* none :
       {"metadata", "arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"}) {
    entity[none] = OrderedJson::array();
  }
  return entity;
}

const char* wordOf(LevelEventKind kind) {
  switch (kind) {
    case LevelEventKind::kRequested:
      return "asked for";
    case LevelEventKind::kAcknowledged:
      return "is to get";
    case LevelEventKind::kBlocked:
      return "cannot get";
    case LevelEventKind::kSwitched:
      return "switched to";
    case LevelEventKind::kRetracted:
      return "gave up";
  }
  return "?";
}

std::string dump(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace

std::string sceneSchema() {
  const OrderedJson triangles = object({{"pose", poseSchema()},
                                        {"points", list(numbers({"x", "y", "z"}))},
                                        {"color", numbers({"r", "g", "b", "a"})},
                                        {"colors", list(numbers({"r", "g", "b", "a"}))},
                                        {"indices", list(typed("integer"))}});
  const OrderedJson line = object({{"type", typed("integer")},
                                   {"pose", poseSchema()},
                                   {"thickness", typed("number")},
                                   {"scale_invariant", typed("boolean")},
                                   {"points", list(numbers({"x", "y", "z"}))},
                                   {"color", numbers({"r", "g", "b", "a"})},
                                   {"colors", list(numbers({"r", "g", "b", "a"}))},
                                   {"indices", list(typed("integer"))}});
  const OrderedJson none = list(typed("object"));
  const OrderedJson entities = object({{"timestamp", timeSchema()},
                                       {"frame_id", typed("string")},
                                       {"id", typed("string")},
                                       {"lifetime", timeSchema()},
                                       {"frame_locked", typed("boolean")},
                                       {"metadata", none},
                                       {"arrows", none},
                                       {"cubes", none},
                                       {"spheres", none},
                                       {"cylinders", none},
                                       {"lines", list(line)},
                                       {"triangles", list(triangles)},
                                       {"texts", none},
                                       {"models", none}});
  const OrderedJson deletion =
      object({{"timestamp", timeSchema()}, {"type", typed("integer")}, {"id", typed("string")}});
  return dump(object({{"deletions", list(deletion)}, {"entities", list(entities)}}));
}

std::string transformsSchema() {
  const OrderedJson transform = object({{"timestamp", timeSchema()},
                                        {"parent_frame_id", typed("string")},
                                        {"child_frame_id", typed("string")},
                                        {"translation", numbers({"x", "y", "z"})},
                                        {"rotation", numbers({"x", "y", "z", "w"})}});
  return dump(object({{"transforms", list(transform)}}));
}

std::string logSchema() {
  return dump(object({{"timestamp", timeSchema()},
                      {"level", typed("integer")},
                      {"message", typed("string")},
                      {"name", typed("string")},
                      {"file", typed("string")},
                      {"line", typed("integer")}}));
}

std::string dataSchema(const RecordingInfo& info) {
  OrderedJson properties;
  for (const RecordedChannel& channel : info.channels) {
    properties[channel.name] = typed(channel.kind == RecordedKind::kHash ? "string" : "number");
    if (!channel.unit.empty()) properties[channel.name]["description"] = channel.unit;
  }
  return dump(object(std::move(properties)));
}

std::string FoxgloveMessages::frameOf(BodyId body) const {
  // Two bodies may have one name.
  return recording_.nameOf(body) + "#" + std::to_string(static_cast<std::uint32_t>(body));
}

const std::string& FoxgloveMessages::trianglesOf(const BodyDef& def) {
  const void* shared = modelOf(def);
  // Of bodies that share their surface, some may have another colour.
  const auto key = std::pair(shared, shared == nullptr ? def.name : dump(colour(colorOf(def))));
  const auto [known, isNew] = triangles_.try_emplace(key);
  if (!isNew) return known->second;
  const SurfaceMesh surface = surfaceOf(def);
  if (surface.triangles.empty()) return known->second;
  OrderedJson points = OrderedJson::array();
  for (const Vec3& vertex : surface.vertices) points.push_back(vector(vertex));
  OrderedJson indices = OrderedJson::array();
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t corner : triangle) indices.push_back(corner);
  }
  known->second = dump({{"pose", noPose()},
                        {"points", std::move(points)},
                        {"color", colour(colorOf(def))},
                        {"colors", OrderedJson::array()},
                        {"indices", std::move(indices)}});
  return known->second;
}

std::string FoxgloveMessages::scene(const RecordedFrame& frame, std::uint64_t nanoseconds) {
  constexpr int kAll = 1;
  constexpr std::string_view kPlace = "\"triangles\":[";
  std::string entities;
  for (const BodyId body : *frame.roster) {
    const BodyDef* def = recording_.def(body);
    if (def == nullptr || trianglesOf(*def).empty()) continue;
    std::string one = dump(entity(frameOf(body), frameOf(body), nanoseconds));
    // As text: all ships of a fleet would be a hundred megabytes of objects.
    one.insert(one.rfind(kPlace) + kPlace.size(), trianglesOf(*def));
    entities += (entities.empty() ? "" : ",") + one;
  }
  const OrderedJson deletion{{"timestamp", timeOf(nanoseconds)}, {"type", kAll}, {"id", ""}};
  return "{\"deletions\":[" + dump(deletion) + "],\"entities\":[" + entities + "]}";
}

std::string FoxgloveMessages::transforms(const RecordedFrame& frame, std::uint64_t nanoseconds) const {
  // Viewers have z up.
  const Quat upright(std::sqrt(0.5F), std::sqrt(0.5F), 0.0F, 0.0F);
  OrderedJson transforms = OrderedJson::array();
  transforms.push_back({{"timestamp", timeOf(nanoseconds)},
                        {"parent_frame_id", kMap},
                        {"child_frame_id", kWorld},
                        {"translation", vector(Vec3(0.0F))},
                        {"rotation", quaternion(upright)}});
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    const Transform& pose = frame.bodies[i].pose;
    transforms.push_back({{"timestamp", timeOf(nanoseconds)},
                          {"parent_frame_id", kWorld},
                          {"child_frame_id", frameOf((*frame.roster)[i])},
                          {"translation", vector(pose.position)},
                          {"rotation", quaternion(pose.rotation)}});
  }
  return dump({{"transforms", std::move(transforms)}});
}

std::string FoxgloveMessages::data(const RecordedFrame& frame) const {
  OrderedJson data;
  const auto& channels = recording_.info().channels;
  for (std::size_t i = 0; i < std::min(channels.size(), frame.values.size()); ++i) {
    if (channels[i].kind == RecordedKind::kHash) {
      char digits[17];
      std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(frame.values[i]));
      data[channels[i].name] = digits;
    } else if (const auto value = std::bit_cast<double>(frame.values[i]); std::isfinite(value)) {
      data[channels[i].name] = value;
    }
  }
  return dump(data);
}

std::string FoxgloveMessages::log(const LevelEvent& event, std::uint64_t nanoseconds) const {
  constexpr int kInfo = 2;
  std::string message = recording_.nameOf(event.body) + " " + wordOf(event.kind) + " level " +
                        std::to_string(event.to) + ", from " + std::to_string(event.from);
  if (event.other != BodyId{}) message += ", with " + recording_.nameOf(event.other);
  if (event.onCredit) message += ", on credit";
  return dump({{"timestamp", timeOf(nanoseconds)},
               {"level", kInfo},
               {"message", message},
               {"name", std::string(event.policy)},
               {"file", ""},
               {"line", 0}});
}

std::string FoxgloveMessages::contacts(const RecordedFrame& frame, std::uint64_t nanoseconds) const {
  constexpr int kPairsOfPoints = 2;
  OrderedJson points = OrderedJson::array();
  for (const RecordedContact& contact : frame.contacts) {
    points.push_back(vector(contact.pointA));
    points.push_back(vector(contact.pointA + kContactLine * contact.normal));
  }
  OrderedJson one = entity("contacts", kWorld, nanoseconds);
  one["lines"].push_back({{"type", kPairsOfPoints},
                          {"pose", noPose()},
                          {"thickness", 2.0},
                          {"scale_invariant", true},
                          {"points", std::move(points)},
                          {"color", colour(Vec3(1.0F, 0.9F, 0.2F))},
                          {"colors", OrderedJson::array()},
                          {"indices", OrderedJson::array()}});
  return dump({{"deletions", OrderedJson::array()}, {"entities", OrderedJson::array({std::move(one)})}});
}

}  // namespace scatter::recording
