#pragma once

#include <scatter/io/model.h>
#include <scatter/result.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace scatter::tools {

/// Points around an axis, in order.
using Ring = std::vector<glm::dvec3>;

/// A regular polygon across the y axis, its first corner at `phase` radians from x towards z.
[[nodiscard]] Ring polygon(int corners, double radius, double y, double phase = 0.0);

/// A polygon across `axis` with `center`.
[[nodiscard]] Ring polygonAcross(const glm::dvec3& axis, const glm::dvec3& center, int corners,
                                 double radius);

/// A household object as a union of boxes and hulls, in groups. Metres; y up, the origin in the middle of its
/// base.
class Prop {
 public:
  Prop(std::string name, float mass) : name_(std::move(name)), mass_(mass) {}

  /// What is added from now on has one box of the middle level, along `axes`.
  void beginGroup(const glm::dmat3& axes = glm::dmat3(1.0));

  void addBox(const glm::dvec3& center, const glm::dvec3& halfExtents);

  /// A box from one end to the other, and as wide and high as stated to each side.
  void addBar(const glm::dvec3& from, const glm::dvec3& to, double halfWidth, double halfHeight);

  /// The hull of two rings of as many corners.
  void addFrustum(const Ring& from, const Ring& to);

  /// Several frustums, one after the other.
  void addLoft(const std::vector<Ring>& rings);

  /// A panel of a hollow body of revolution about the y axis: `inner` and `outer` radii at two heights,
  /// between two angles.
  struct Panel {
    double yFrom, yTo;
    double innerFrom, outerFrom;
    double innerTo, outerTo;
    double angleFrom, angleTo;
  };
  void addPanel(const Panel& panel);

  /// Adds a hull to the group's share of the middle level; with any of them, the group has no box.
  void addMiddleHull(const Ring& from, const Ring& to);

  [[nodiscard]] const std::string& name() const { return name_; }

  /// Three levels: all parts, then a box or some hulls a group, then one box.
  [[nodiscard]] Result<Model> build() const;

 private:
  struct Group {
    glm::dmat3 axes;
    std::vector<Vec3> points;  ///< Corners of all parts.
    std::vector<ConvexPart> middle;
  };

  void addMesh(const std::vector<Vec3>& from, const std::vector<Vec3>& to);
  [[nodiscard]] Level middleLevel() const;

  std::string name_;
  float mass_;
  VisualMesh mesh_;
  Level finest_;
  std::vector<Group> groups_;
};

[[nodiscard]] Prop makeTable();
[[nodiscard]] Prop makeChair();
[[nodiscard]] Prop makeShelf();
[[nodiscard]] Prop makeCrate();
[[nodiscard]] Prop makeBarrel();

/// A floor lamp. Its arm goes through the head of its pole and sticks out behind, so that things can hang on
/// it.
[[nodiscard]] Prop makeLamp();

/// A mug at six times its usual size: hollow, with a handle that fits around the lamp's arm.
[[nodiscard]] Prop makeMug();

}  // namespace scatter::tools
