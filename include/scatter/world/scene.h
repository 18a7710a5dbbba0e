#pragma once

#include <scatter/result.h>
#include <scatter/world/world.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace scatter {

struct SceneOptions {
  std::uint64_t seed = 1;  ///< Same seed, same scene, bit for bit.
};

/// A set-up that isolates one behaviour (report, section 4.4).
class Scene {
 public:
  Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  virtual ~Scene() = default;

  /// Fills an empty world.
  [[nodiscard]] virtual Result<void> build(World& world, const SceneOptions& options) = 0;

  /// Called before every step, so that a scene can throw, break or knock something out.
  virtual void update(World& /*world*/) {}
};

struct SceneInfo {
  std::string name;     ///< What the command line calls it.
  std::string summary;  ///< One line.
  int frames = 1600;    ///< Steps of 1/60 s that tell its story.
  std::function<std::unique_ptr<Scene>()> make;
};

/// All scenes of the program, by name. Scenes add themselves before main() through SceneRegistration.
class SceneRegistry {
 public:
  static SceneRegistry& instance();

  void add(SceneInfo info);
  [[nodiscard]] std::vector<const SceneInfo*> all() const;  ///< Sorted by name.

  /// Fails with a line that lists the known names and the nearest one.
  [[nodiscard]] Result<const SceneInfo*> find(const std::string& name) const;

 private:
  std::vector<std::unique_ptr<SceneInfo>> scenes_;
};

/// Define one at namespace scope in a scene's source file.
struct SceneRegistration {
  explicit SceneRegistration(SceneInfo info) { SceneRegistry::instance().add(std::move(info)); }
};

}  // namespace scatter
