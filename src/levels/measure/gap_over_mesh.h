#pragma once

#include <scatter/levels/level_set.h>

#include <glm/vec3.hpp>
#include <vector>

#include "levels/mesh/shells.h"
#include "levels/polytope.h"

namespace scatter::levels {

/// The gap that a level leaves over each place of a mesh: how far from the mesh one can get on the way
/// straight out from the place, until the level ends or the mesh comes again.
class GapOverMesh {
 public:
  /// `space` must outlive it.
  GapOverMesh(const Level& level, double hullMargin, const MeshSpace& space);

  /// At a place of the mesh, in the model's frame, with its unit normal, whichever way that points; hull
  /// margin counted. Of a mesh that is no solid both ways are gone, and the larger gap counts. Metres; 0
  /// where the level does not hold the place.
  [[nodiscard]] double at(const glm::dvec3& place, const glm::dvec3& normal) const;

 private:
  struct Part {
    std::vector<HalfSpace> sides;
    glm::dvec3 center{0.0};
    double radius = 0.0;  ///< Around the centre.
    double margin = 0.0;
  };

  /// Where the level ends on a way out, and by how much an engine widens it there.
  struct End {
    double way = 0.0;
    double margin = 0.0;
  };
  [[nodiscard]] End endOf(const glm::dvec3& from, const glm::dvec3& direction) const;
  [[nodiscard]] double along(const glm::dvec3& from, const glm::dvec3& direction) const;

  const MeshSpace& space_;
  double tolerance_;
  std::vector<Part> parts_;
};

/// The unit normal at a place of the mesh, in the model's frame, or the opposite one if that leads out of the
/// solid; of a mesh that is none the same.
[[nodiscard]] glm::dvec3 outward(const MeshSpace& space, const glm::dvec3& place, const glm::dvec3& normal);

}  // namespace scatter::levels
