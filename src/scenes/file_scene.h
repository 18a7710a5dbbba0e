#pragma once

#include <scatter/io/scene_file.h>
#include <scatter/world/scene.h>

#include <map>
#include <memory>
#include <vector>

#include "scenes/breakable.h"
#include "scenes/fields.h"
#include "scenes/file_bodies.h"

namespace scatter {

/// The scene of a scene file.
class FileScene final : public Scene {
 public:
  explicit FileScene(std::shared_ptr<const SceneFile> file) : file_(std::move(file)) {}

  void configure(PhysicsDef& physics) const override;
  Result<void> build(World& world, const SceneOptions& options) override;
  void update(World& world) override;
  void forget(const WorldObject& object) override;

 private:
  Result<void> addObjects(World& world, SceneModels& models, Random& random);
  void addFields(World& world);
  Result<void> addJoints(World& world);
  Result<void> preparePieces(SceneModels& models);

  void perform(World& world, const SceneFileEvent& event);
  void perform(World& world, const SceneFileEvent& event, const SceneFileThrow& deed);
  void perform(World& world, const SceneFileEvent& event, const SceneFileKnock& deed);
  void perform(World& world, const SceneFileEvent& event, const SceneFileBreak& deed);
  void perform(World& world, const SceneFileEvent& event, const SceneFileRemove& deed);
  void perform(World& world, const SceneFileEvent& event, const SceneFileSwitch& deed);
  void breakBody(World& world, std::size_t body, const Breakable& kind, float burst);

  [[nodiscard]] tl::unexpected<Error> failAt(int line, const std::string& what) const;
  [[nodiscard]] std::size_t objectOf(std::size_t body) const;

  /// The bodies of the event that are there and dynamic.
  [[nodiscard]] std::vector<WorldObject*> movable(const SceneFileEvent& event) const;

  std::shared_ptr<const SceneFile> file_;
  std::vector<WorldObject*> bodies_;    ///< Null once removed; in the order of SceneFile::bodies.
  std::vector<SwitchedField*> fields_;  ///< In the order of SceneFile::fields.
  std::size_t nextEvent_ = 0;

  /// By object and the pieces' size.
  std::map<std::pair<std::size_t, float>, Breakable> pieces_;
};

}  // namespace scatter
