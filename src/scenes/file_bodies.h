#pragma once

#include <scatter/io/scene_file.h>
#include <scatter/result.h>
#include <scatter/world/body.h>

#include <memory>
#include <vector>

#include "scenes/placement.h"
#include "scenes/region_placement.h"
#include "scenes/scene_models.h"
#include "scenes/shape_measures.h"

namespace scatter {

/// Makes the bodies of a scene file, in its order. The random numbers of a body are drawn in this order:
/// size, place, orientation, velocity, spin.
class FileBodies {
 public:
  /// All must outlive this.
  FileBodies(const SceneFile& file, SceneModels& models, Random& random);

  /// The bodies of an object. Fails on a model or mesh that cannot be read, and on a shape without volume;
  /// the message begins with the file and line of the object.
  [[nodiscard]] Result<std::vector<BodyDef>> make(const SceneFileObject& object);

 private:
  /// What the bodies of an object share.
  struct Common {
    BodyDef def;
    float volume = 0.0F;          ///< Unless the radius is random.
    float boundingRadius = 0.0F;  ///< Unless the radius is random.
    Heights heights;              ///< For stacks.
  };

  [[nodiscard]] Result<Common> common(const SceneFileObject& object);
  [[nodiscard]] Result<void> setShape(const SceneFileObject& object, Common& common);
  [[nodiscard]] Result<void> setModel(const SceneFileObject& object, const SceneFileModel& named,
                                      Common& common);
  [[nodiscard]] Result<void> setConvex(const SceneFileObject& object, const ConvexShape& shape,
                                       Common& common);
  void setSize(const SceneFileObject& object, BodyDef& def, float& radius);
  [[nodiscard]] Vec3 place(const SceneFileObject& object, const Common& common, float radius,
                           std::size_t index);
  [[nodiscard]] Quat orient(const SceneFileOrientation& orientation);
  [[nodiscard]] Vec3 velocity(const SceneFileVelocity& velocity, const Vec3& position);

  const SceneFile& file_;
  SceneModels& models_;
  Random& random_;
  std::vector<RegionPlacement> regions_;
};

}  // namespace scatter
