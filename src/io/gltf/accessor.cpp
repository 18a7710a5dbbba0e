#include "io/gltf/accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "io/gltf/component.h"

namespace scatter::io {
namespace {

std::size_t sizeOf(Component component) {
  switch (component) {
    case Component::kByte:
    case Component::kUnsignedByte:
      return 1;
    case Component::kShort:
    case Component::kUnsignedShort:
      return 2;
    default:
      return 4;
  }
}

Component readComponent(const JsonPlace& place) {
  const std::uint64_t value = place.count();
  if (value < 5120 || value > 5126 || value == 5124) {
    place.fail("there is no component type " + std::to_string(value));
  }
  return static_cast<Component>(value);
}

/// Elements that stand in a buffer view at equal distances.
struct Elements {
  std::string_view bytes;  ///< From the first element on.
  std::size_t count = 0;
  std::size_t stride = 0;
  Component component{};
  bool normalized = false;

  [[nodiscard]] double at(std::size_t element, std::size_t index) const;
};

template <class Number>
double readNumber(const char* data, bool normalized) {
  Number value{};
  std::memcpy(&value, data, sizeof value);
  if constexpr (std::is_integral_v<Number>) {
    if (normalized) {
      return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<Number>::max()),
                      -1.0);
    }
  }
  return static_cast<double>(value);
}

double Elements::at(std::size_t element, std::size_t index) const {
  const char* data = bytes.data() + element * stride + index * sizeOf(component);
  switch (component) {
    case Component::kByte:
      return readNumber<std::int8_t>(data, normalized);
    case Component::kUnsignedByte:
      return readNumber<std::uint8_t>(data, normalized);
    case Component::kShort:
      return readNumber<std::int16_t>(data, normalized);
    case Component::kUnsignedShort:
      return readNumber<std::uint16_t>(data, normalized);
    case Component::kUnsignedInt:
      return readNumber<std::uint32_t>(data, normalized);
    default:
      return readNumber<float>(data, normalized);
  }
}

/// `place` has the members bufferView and byteOffset.
Elements findElements(GltfFile& file, const JsonPlace& place, Component component, std::size_t width,
                      std::size_t count) {
  const JsonPlace reference = place.at("bufferView");
  const std::string_view view = file.bufferView(reference);
  const auto stride = file.entry("bufferViews", reference).find("byteStride");
  const auto offset = place.find("byteOffset");
  const std::size_t elementSize = width * sizeOf(component);
  Elements elements;
  elements.count = count;
  elements.component = component;
  elements.stride =
      stride ? static_cast<std::size_t>(std::min<std::uint64_t>(stride->count(), 1U << 30U)) : elementSize;
  const std::uint64_t begin = offset ? offset->count() : 0;
  // Division, because a product of hostile numbers may overflow.
  const bool fits = begin <= view.size() && elements.stride >= elementSize &&
                    (count == 0 || (view.size() - begin >= elementSize &&
                                    (view.size() - begin - elementSize) / elements.stride >= count - 1));
  if (!fits) {
    place.fail("reaches beyond the end of its buffer view, which has " + std::to_string(view.size()) +
               " bytes");
  }
  elements.bytes = view.substr(static_cast<std::size_t>(begin));
  return elements;
}

std::size_t readCount(GltfFile& file, const JsonPlace& place) {
  const std::size_t count = static_cast<std::size_t>(place.at("count").count());
  file.budget().spend(count, place.at("count"));
  return count;
}

/// Calls store(element, index, value) for the elements that replace others.
template <class Store>
void readSparse(GltfFile& file, const JsonPlace& sparse, Elements values, std::size_t width,
                std::size_t limit, const Store& store) {
  const std::size_t count = readCount(file, sparse);
  const JsonPlace indexPlace = sparse.at("indices");
  const Elements indices =
      findElements(file, indexPlace, readComponent(indexPlace.at("componentType")), 1, count);
  const bool normalized = values.normalized;
  values = findElements(file, sparse.at("values"), values.component, width, count);
  values.normalized = normalized;
  for (std::size_t i = 0; i < count; ++i) {
    const double target = indices.at(i, 0);
    if (!(target >= 0.0 && target < static_cast<double>(limit))) {
      indexPlace.fail("names an element that does not exist");
    }
    for (std::size_t j = 0; j < width; ++j) {
      store(static_cast<std::size_t>(target), j, values.at(i, j));
    }
  }
}

/// Calls store(element, index, value) for all that is not zero.
template <class Store>
void readElements(GltfFile& file, const JsonPlace& place, std::size_t width, std::size_t count,
                  const Store& store) {
  Elements elements;
  elements.component = readComponent(place.at("componentType"));
  const auto normalized = place.find("normalized");
  if (place.find("bufferView")) {
    elements = findElements(file, place, elements.component, width, count);
  }
  elements.normalized = normalized && normalized->boolean();
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t j = 0; j < width; ++j) {
      store(i, j, elements.at(i, j));
    }
  }
  if (const auto sparse = place.find("sparse")) {
    readSparse(file, *sparse, elements, width, count, store);
  }
}

void expectType(const JsonPlace& accessor, const char* type) {
  const JsonPlace place = accessor.at("type");
  if (place.text() != type) {
    place.fail("should be \"" + std::string(type) + "\"");
  }
}

}  // namespace

std::vector<Vec3> readPositions(GltfFile& file, const JsonPlace& reference) {
  const JsonPlace accessor = file.entry("accessors", reference);
  expectType(accessor, "VEC3");
  std::vector<Vec3> positions(readCount(file, accessor), Vec3(0.0F));
  readElements(file, accessor, 3, positions.size(), [&](std::size_t i, std::size_t axis, double value) {
    if (!(std::abs(value) <= kMaxGltfLength)) {
      accessor.fail("element " + std::to_string(i) + " is not finite or too far from the origin");
    }
    positions[i][static_cast<int>(axis)] = static_cast<float>(value);
  });
  return positions;
}

std::vector<float> readFloats(GltfFile& file, const JsonPlace& reference, const char* type,
                              std::size_t width) {
  const JsonPlace accessor = file.entry("accessors", reference);
  expectType(accessor, type);
  const std::size_t count = readCount(file, accessor);
  std::vector<float> values(count * width, 0.0F);
  readElements(file, accessor, width, count, [&](std::size_t i, std::size_t j, double value) {
    values[i * width + j] = static_cast<float>(value);
  });
  return values;
}

std::vector<std::uint32_t> readIndices(GltfFile& file, const JsonPlace& reference) {
  const JsonPlace accessor = file.entry("accessors", reference);
  expectType(accessor, "SCALAR");
  const Component component = readComponent(accessor.at("componentType"));
  if (component != Component::kUnsignedByte && component != Component::kUnsignedShort &&
      component != Component::kUnsignedInt) {
    accessor.at("componentType").fail("indices should be unsigned");
  }
  std::vector<std::uint32_t> indices(readCount(file, accessor), 0);
  readElements(file, accessor, 1, indices.size(), [&](std::size_t i, std::size_t, double value) {
    indices[i] = static_cast<std::uint32_t>(value);
  });
  return indices;
}

}  // namespace scatter::io
