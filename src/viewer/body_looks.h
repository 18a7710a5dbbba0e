#pragma once

#include <scatter/world/body.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "viewer/drawing/ray_tree.h"
#include "viewer/renderer.h"

namespace scatter::viewer {

/// How bodies look: the renderer's meshes for them, each made when it is first asked for and shared by all
/// bodies of a model. The renderer must outlive it.
class BodyLooks {
 public:
  explicit BodyLooks(Renderer& renderer) : renderer_(renderer) {}

  /// Forgets all bodies, and takes their meshes from the renderer: others will have their ids.
  void clear();

  /// The body's mesh, or its shape where it has none; without pose and colour.
  [[nodiscard]] Item drawn(BodyId body, const BodyDef& def);

  /// What the body collides with at its finest level.
  [[nodiscard]] Item shape(BodyId body, const BodyDef& def);

  /// One level of a body with levels, 1 the coarsest.
  [[nodiscard]] Item level(const std::shared_ptr<const LevelSet>& levels, int level);

  /// Around the origin of the body, such that all of it is inside.
  [[nodiscard]] float radius(BodyId body, const BodyDef& def);

  /// Its finest shape, in its frame, to be asked what it hides; one for all bodies of a model. Lives as long
  /// as this.
  [[nodiscard]] const RayTree& surface(BodyId body, const BodyDef& def);

 private:
  [[nodiscard]] MeshId shared(const void* key, int variant, const std::shared_ptr<const void>& owner,
                              const MeshData& mesh);
  [[nodiscard]] std::optional<MeshId> find(const void* key, int variant) const;

  /// Keeps what the key points to, so that no other mesh can get its address.
  struct Known {
    MeshId mesh{};
    std::shared_ptr<const void> owner;
  };

  Renderer& renderer_;
  std::map<std::pair<const void*, int>, Known> known_;
  std::map<BodyId, MeshId> own_;  ///< Of bodies whose shape nobody shares.
  std::map<BodyId, float> radius_;
  std::map<const void*, float> modelRadius_;  ///< By level set.
  std::map<BodyId, std::unique_ptr<RayTree>> surfaces_;
  std::map<const void*, std::unique_ptr<RayTree>> modelSurfaces_;  ///< By level set.
  std::optional<MeshId> box_;
  std::optional<MeshId> sphere_;
};

}  // namespace scatter::viewer
