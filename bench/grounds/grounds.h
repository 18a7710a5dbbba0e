#pragma once

#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <memory>
#include <string_view>
#include <vector>

#include "random.h"

namespace scatter::bench {

enum class GroundKind { kMesh, kHeightField, kPlane, kBox, kHull };

/// Something to lie on, 100 m wide: rolling country of 20 000 triangles, or flat.
class Ground {
 public:
  Ground(GroundKind kind, float relief, Random& random);

  [[nodiscard]] btCollisionShape* shape() { return shape_.get(); }
  [[nodiscard]] btVector3 position() const {
    return position_;
  }  ///< Of the shape, so that it is about y = 0.
  [[nodiscard]] float highest() const { return highest_; }

  static constexpr float kWidth = 100.0F;

 private:
  void addHeights(float relief, Random& random);
  void addTriangles();

  std::vector<float> heights_;
  btTriangleMesh mesh_;
  std::unique_ptr<btCollisionShape> shape_;
  btVector3 position_{0, 0, 0};
  float highest_ = 0;
};

}  // namespace scatter::bench
