#pragma once

#include "io/collada/notes.h"
#include "io/collada/xml_source.h"

#include <scatter/math.h>
#include <scatter/result.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace scatter::io {

enum class UpAxis : std::uint8_t { kX, kY, kZ };

/// The rotation as the rounding of a unit quaternion, so that it can be written as axis and angle without
/// loss.
[[nodiscard]] Quat unitRotation(const Quat& rotation);

/// A turn by 180 degrees without the rounding error in its w.
[[nodiscard]] Quat withoutNoise(const Quat& rotation);

/// Fails if the text is no XML or no COLLADA document. Views `text` and `name`, which must outlive the
/// result.
[[nodiscard]] Result<XmlSource> parseColladaXml(std::string_view text, std::string_view name);

/// A COLLADA document, its unit and its axes: reads numbers and turns them into metres, y up.
class ColladaFrame {
 public:
  /// Reads `<asset>`: `<unit meter>` and `<up_axis>`. One metre and Y_UP if absent. `notes` must outlive the
  /// frame.
  [[nodiscard]] static Result<ColladaFrame> read(const XmlSource& xml, ColladaNotes& notes);

  [[nodiscard]] const XmlSource& xml() const { return *xml_; }

  /// Says something of an element that does no harm.
  void note(const pugi::xml_node& node, const std::string& what) const;

  /// What is wrong with an element and what is taken for it: a note from a reader that mends, else an error.
  [[nodiscard]] Result<void> mend(const pugi::xml_node& node, const std::string& what,
                                  const std::string& remedy) const;

  [[nodiscard]] Result<void> take(const pugi::xml_node& node, std::size_t elements) const {
    return notes_->take(*xml_, node, elements);
  }

  /// Notes every child element but the known ones, `<asset>` and `<extra>` or `<technique>` of SCATTER.
  void noteUnknown(const pugi::xml_node& parent, std::initializer_list<std::string_view> known) const;

  /// Notes every `kind` in the libraries of that name whose hash value is not among `used`.
  void noteUnused(const char* library, const char* kind, const std::set<std::size_t>& used) const;

  /// XmlSource::follow, that also takes an id without its '#'.
  [[nodiscard]] Result<pugi::xml_node> follow(const pugi::xml_node& node, const char* attribute,
                                              const char* kind) const;

  /// The same; a reader that mends notes a link that leads nowhere, and gives no element.
  [[nodiscard]] Result<pugi::xml_node> followOrMend(const pugi::xml_node& node, const char* attribute,
                                                    const char* kind, const std::string& remedy) const;

  /// From the file's axes to y up.
  [[nodiscard]] const Quat& toYUp() const { return toYUp_; }

  [[nodiscard]] float toMeters(double length) const { return static_cast<float>(length * metersPerUnit_); }
  [[nodiscard]] double metersPerUnit() const { return metersPerUnit_; }

  /// A vector in the file's axes, turned without rounding.
  [[nodiscard]] Vec3 turnYUp(const Vec3& vector) const;

  /// The inverse of turnYUp.
  [[nodiscard]] Vec3 turnBack(const Vec3& vector) const;

  /// A transform of a child frame in a parent frame, both in the file's axes, between the same frames turned
  /// y up.
  [[nodiscard]] Transform toYUp(const Transform& transform) const;

  /// A frame in the file's axes, in a parent frame that is turned y up.
  [[nodiscard]] Transform inYUp(const Transform& transform) const;

  /// Finite numbers in the element's text; exactly `count` of them unless it is 0.
  [[nodiscard]] Result<std::vector<double>> numbers(const pugi::xml_node& node, std::size_t count) const;

  /// The same, but that they may be infinite.
  [[nodiscard]] Result<std::vector<double>> openNumbers(const pugi::xml_node& node, std::size_t count) const;

  /// Finite numbers as metres; at most kMaxLength.
  [[nodiscard]] Result<std::vector<float>> lengths(const pugi::xml_node& node, std::size_t count) const;

  /// Three lengths, in the file's axes.
  [[nodiscard]] Result<Vec3> vector(const pugi::xml_node& node) const;

  /// The same for other numbers than lengths, at most 1e9; no unit.
  [[nodiscard]] Result<Vec3> plainVector(const pugi::xml_node& node) const;

  /// A number from `low` to `high`; nothing if the element is absent.
  [[nodiscard]] Result<std::optional<float>> scalar(const pugi::xml_node& node, double low,
                                                    double high) const;

  /// `fallback` if the element is absent or empty.
  [[nodiscard]] Result<bool> flag(const pugi::xml_node& node, bool fallback) const;

  /// One to three lengths that are all positive. Of several, a 0 becomes thin if others are positive; a
  /// single one becomes `thin`, if that is given.
  [[nodiscard]] Result<std::vector<float>> sizes(const pugi::xml_node& node, std::size_t count,
                                                 float thin = 0.0F) const;

  [[nodiscard]] Result<std::vector<std::uint32_t>> indices(const pugi::xml_node& node) const;

  /// A whole-number attribute; `fallback` if it is absent.
  [[nodiscard]] Result<std::uint32_t> indexAttribute(const pugi::xml_node& node, const char* name,
                                                     std::uint32_t fallback) const;

  /// Metres. Further out, single precision cannot tell a centimetre.
  static constexpr double kMaxLength = 1e5;

  /// Metres. Half of it is still far from the least number.
  static constexpr double kMinLength = 1e-9;

 private:
  [[nodiscard]] Result<pugi::xml_node> resolve(const pugi::xml_node& node, const char* attribute,
                                               const char* kind) const;
  ColladaFrame(const XmlSource& xml, ColladaNotes& notes) : xml_(&xml), notes_(&notes) {}

  [[nodiscard]] Result<void> readUnit(const pugi::xml_node& asset);
  [[nodiscard]] Result<void> readUpAxis(const pugi::xml_node& asset);

  const XmlSource* xml_;
  ColladaNotes* notes_;
  double metersPerUnit_ = 1.0;
  UpAxis up_ = UpAxis::kY;
  Quat toYUp_ = kNoRotation;
};

}  // namespace scatter::io
