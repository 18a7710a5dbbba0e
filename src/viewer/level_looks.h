#pragma once

#include <scatter/levels/measure_levels.h>

#include <optional>
#include <vector>

#include "viewer/levels_viewer.h"
#include "viewer/renderer.h"

namespace scatter::viewer {

/// How one level of a model looks.
struct LevelLook {
  struct Part {
    MeshId mesh{};      ///< Around its centre.
    Vec3 center{0.0F};  ///< In the model's frame.
    float radius = 0.0F;
  };
  std::vector<Part> parts{};
  MeshId whole{};

  /// The model's mesh, if there is one, coloured from no gap to the level's largest, or to that of all
  /// levels.
  std::optional<MeshId> gaps{};
  std::optional<MeshId> gapsOnOneScale{};
  double scaleEnd = 0.0;  ///< The largest gap, metres, but at least 1 % of the diagonal: less is close.

  std::optional<LevelFigures> measured{};  ///< Of the level's surface, if there is a mesh.
};

/// The renderer's meshes for the levels of a model.
class LevelLooks {
 public:
  /// Measures the levels, which takes a second or so. Fails on a mesh that cannot be measured.
  [[nodiscard]] static Result<LevelLooks> create(Renderer& renderer, const ShownModel& model);

  /// The coarsest first.
  [[nodiscard]] const std::vector<LevelLook>& levels() const { return levels_; }

  /// Of all levels.
  [[nodiscard]] const Vec3& middle() const { return middle_; }

  /// How far from the middle any part reaches when the places of all are moved away from it by so many times
  /// what they are away.
  [[nodiscard]] float reach(float apart) const;

  [[nodiscard]] double diagonal() const { return diagonal_; }  ///< Of the mesh; 0 without one.
  [[nodiscard]] double scaleEnd() const { return scaleEnd_; }  ///< The largest of all levels.

 private:
  std::vector<LevelLook> levels_;
  Vec3 middle_{0.0F};
  double diagonal_ = 0.0;
  double scaleEnd_ = 0.0;
};

}  // namespace scatter::viewer
