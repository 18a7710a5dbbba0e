#pragma once

#include <limits>
#include <vector>

#include "collision/part_list.h"
#include "levels/part_builders.h"

namespace scatter::testing {

/// As the separation that is enough: to be sure that nothing is.
inline constexpr float kNever = std::numeric_limits<float>::max();

/// Owns the vertices of a polytope, laid out as PolytopeView wants them.
class OwnedPolytope {
 public:
  explicit OwnedPolytope(const std::vector<Vec3>& points);

  [[nodiscard]] PolytopeView view() const;

 private:
  int count_;
  std::vector<float> coordinates_[3];
};

Frame frameOf(const Quat& rotation, const Vec3& origin);
Frame randomFrame(Random& random, float distance);

/// From 10^low to 10^high, all orders of magnitude alike.
float anySize(Random& random, float low, float high);

/// A whole number from `low` to `high`.
int anyInt(Random& random, int low, int high);

/// A point, a segment, a flat set, a box or a rounded hull, of up to `most` points, about so large, around
/// the origin.
std::vector<Vec3> randomCore(Random& random, int most, float size);

PartDef hullPart(std::vector<Vec3> core, float margin);
PartDef boxPart(const Vec3& center, const Vec3& half, const Mat3& axes, float margin);
PartDef spherePart(const Vec3& center, float radius);
PartDef capsulePart(const Vec3& from, const Vec3& to, float radius);
PartDef enclosedPart(std::vector<Vec3> core, float margin);

/// Of any kind, within about `size` of the body's centre. The engine's bounds are `slack` wider than the
/// part.
PartDef randomPart(Random& random, float size, float slack);
std::vector<PartDef> randomParts(Random& random, int count, float size, float slack);

}  // namespace scatter::testing
