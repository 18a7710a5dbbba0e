#include "io/gltf/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>
#include <string_view>
#include <utility>

namespace scatter::io {
namespace {

double sizeOr(const std::optional<JsonPlace>& parent, const char* key, double standard, bool mayBeZero) {
  const auto place = parent ? parent->find(key) : std::nullopt;
  if (!place) {
    return standard;
  }
  const double value = place->size(0.0);
  // Smaller sizes have inertias that single precision cannot hold.
  constexpr double kSmallest = 1e-6;
  if (value < kSmallest && !(mayBeZero && value == 0.0)) {
    place->fail("should be positive, at least 1e-6");
  }
  return value;
}

GltfShape readBox(const std::optional<JsonPlace>& box) {
  const auto size = box ? box->find("size") : std::nullopt;
  if (!size) {
    return Box{Vec3(0.5F)};
  }
  const glm::dvec3 v = size->vector();
  if (!(std::min({v.x, v.y, v.z}) >= 1e-6)) {
    size->fail("should be three positive numbers, each at least 1e-6");
  }
  return Box{Vec3(v) / 2.0F};
}

GltfShape readRound(const JsonPlace& shape, const std::optional<JsonPlace>& place, bool capsule) {
  GltfRound round;
  round.capsule = capsule;
  round.height = sizeOr(place, "height", 0.5, false);
  round.radiusBottom = sizeOr(place, "radiusBottom", 0.25, true);
  round.radiusTop = sizeOr(place, "radiusTop", 0.25, true);
  if (round.radiusBottom == 0.0 && round.radiusTop == 0.0) {
    shape.fail("both radii are zero");
  }
  return round;
}

GltfShape readPlane(const std::optional<JsonPlace>& place) {
  GltfPlane plane;
  if (place && place->find("sizeX")) {
    plane.sizeX = sizeOr(place, "sizeX", 0.0, false);
  }
  if (place && place->find("sizeZ")) {
    plane.sizeZ = sizeOr(place, "sizeZ", 0.0, false);
  }
  const auto doubleSided = place ? place->find("doubleSided") : std::nullopt;
  plane.doubleSided = doubleSided && doubleSided->boolean();
  return plane;
}

GltfShape readHull(GltfFile& file, const JsonPlace& place) {
  const JsonPlace list = place.at("vertices");
  const std::size_t size = list.size();
  if (size % 3 != 0) {
    list.fail("should hold three numbers a vertex");
  }
  file.budget().spend(size, list);
  const std::vector<double> numbers = list.numbers(size);
  ConvexHull hull;
  for (std::size_t i = 0; i < size; i += 3) {
    const glm::dvec3 v(numbers[i], numbers[i + 1], numbers[i + 2]);
    if (!isInReach(v)) {
      list.fail("vertex " + std::to_string(i / 3) + " is too far from the origin");
    }
    hull.vertices.emplace_back(v);
  }
  return hull;
}

}  // namespace

std::optional<GltfShape> readGltfShape(GltfFile& file, const JsonPlace& place) {
  const JsonPlace typePlace = place.at("type");
  const std::string type = typePlace.text();
  const auto values = place.find(type.c_str());
  file.warnUnknown(place, {"type", type, "translation", "rotation"});
  if (values) {
    file.warnUnknown(*values, {"size", "radius", "radiusBottom", "radiusTop", "height", "sizeX", "sizeZ",
                               "doubleSided", "vertices"});
  }
  if (type == "box") {
    return readBox(values);
  }
  if (type == "sphere") {
    return Sphere{static_cast<float>(sizeOr(values, "radius", 0.5, false))};
  }
  if (type == "capsule" || type == "cylinder") {
    return readRound(place, values, type == "capsule");
  }
  if (type == "plane") {
    return readPlane(values);
  }
  if (type == "hull") {
    return readHull(file, place.at("hull"));
  }
  file.warn(typePlace, "this kind of shape is not supported and is left out");
  return std::nullopt;
}

}  // namespace scatter::io
