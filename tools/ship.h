#pragma once

#include <scatter/io/model.h>
#include <scatter/result.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

namespace scatter::tools {

/// A rounded cross-section, across the axis of its loft. Metres, in the loft's frame: x along the axis, y
/// up, z = x × y.
struct Section {
  double x = 0.0;
  double halfWidth = 0.1;  ///< Along z.
  double top = 0.1;        ///< Height above the centre.
  double bottom = 0.1;     ///< Depth below the centre.
  double y = 0.0;          ///< Of the centre.
  double z = 0.0;
};

/// Some successive segments of a loft that share a box at the finest level, and the box of the middle
/// level that holds them.
struct Cut {
  int segments = 1;
  std::string group;
};

/// A solid stretched over cross-sections, the segments between which are convex.
struct Loft {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{1.0, 0.0, 0.0};  ///< Of the axis; need not be of unit length.
  glm::dvec3 up{0.0, 1.0, 0.0};         ///< Made perpendicular to the axis.
  double exponent = 2.0;                ///< Of the superellipse: 2 round, larger ones boxier.
  std::vector<Section> sections;
  std::vector<Cut> cuts;
};

/// A ship as a union of lofts: x forward, y up, z to starboard.
class Ship {
 public:
  /// `center` becomes the origin of the model.
  Ship(std::string name, float mass, const glm::dvec3& center)
      : name_(std::move(name)), mass_(mass), center_(center) {}

  void add(const Loft& loft);

  /// Adds the loft and its mirror image to port. Group names get "-right" and "-left", but for those
  /// in `shared`.
  void addPair(const Loft& loft, const std::vector<std::string>& shared = {});

  /// Turns the group's middle box into this direction.
  void alignGroup(const std::string& group, const glm::dvec3& direction);

  [[nodiscard]] const std::string& name() const { return name_; }

  /// Three levels: the finest of a box per cut, then a box per group, then one.
  [[nodiscard]] Result<Model> build() const;

 private:
  using Ring = std::vector<Vec3>;

  /// A cut of a loft that was added, as points.
  struct Piece {
    std::vector<Ring> rings;
    glm::dmat3 axes;
    std::string group;
  };

  void addRings(const Loft& loft, std::vector<Ring> rings, bool mirrored);
  void addMesh(const std::vector<Ring>& rings, bool mirrored);
  [[nodiscard]] Level finestLevel() const;
  [[nodiscard]] Level middleLevel() const;

  std::string name_;
  float mass_;
  glm::dvec3 center_;
  VisualMesh mesh_;
  std::vector<Piece> pieces_;
  std::vector<std::string> groups_;
  std::map<std::string, glm::dmat3> groupAxes_;
};

/// A concave ship with two prongs, about 6 m long.
[[nodiscard]] Ship makeHunter();

/// A slim ship with small swept wings, about 5 m long.
[[nodiscard]] Ship makeFighter();

}  // namespace scatter::tools
