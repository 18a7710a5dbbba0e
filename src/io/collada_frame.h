#pragma once

#include "io/xml_source.h"

#include <scatter/math.h>
#include <scatter/result.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scatter::io {

/// A COLLADA document, its unit and its axes: reads numbers and turns them into metres, y up.
class ColladaFrame {
 public:
  /// Reads `<asset>`: `<unit meter>` and `<up_axis>`. One metre and Y_UP if absent.
  [[nodiscard]] static Result<ColladaFrame> read(const XmlSource& xml);

  [[nodiscard]] const XmlSource& xml() const { return *xml_; }

  /// From the file's axes to y up.
  [[nodiscard]] const Quat& toYUp() const { return toYUp_; }

  [[nodiscard]] float toMeters(double length) const { return static_cast<float>(length * metersPerUnit_); }

  /// Finite numbers in the element's text; exactly `count` of them unless it is 0.
  [[nodiscard]] Result<std::vector<double>> numbers(const pugi::xml_node& node, std::size_t count) const;

  /// The same, as metres; at most kMaxLength.
  [[nodiscard]] Result<std::vector<float>> lengths(const pugi::xml_node& node, std::size_t count) const;

  /// Three lengths, in the file's axes.
  [[nodiscard]] Result<Vec3> vector(const pugi::xml_node& node) const;

  /// One to three lengths that are all positive.
  [[nodiscard]] Result<std::vector<float>> sizes(const pugi::xml_node& node, std::size_t count) const;

  [[nodiscard]] Result<std::vector<std::uint32_t>> indices(const pugi::xml_node& node) const;

  /// A whole-number attribute; `fallback` if it is absent.
  [[nodiscard]] Result<std::uint32_t> indexAttribute(const pugi::xml_node& node, const char* name,
                                                     std::uint32_t fallback) const;

  /// Metres. Further out, single precision cannot tell a centimetre.
  static constexpr double kMaxLength = 1e5;

 private:
  explicit ColladaFrame(const XmlSource& xml) : xml_(&xml) {}

  [[nodiscard]] Result<void> readUnit(const pugi::xml_node& asset);
  [[nodiscard]] Result<void> readUpAxis(const pugi::xml_node& asset);

  const XmlSource* xml_;
  double metersPerUnit_ = 1.0;
  Quat toYUp_ = kNoRotation;
};

}  // namespace scatter::io
