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

  /// Called before the physics is made, for what can be set only then.
  virtual void configure(PhysicsDef& /*physics*/) const {}

  /// Fills an empty world.
  [[nodiscard]] virtual Result<void> build(World& world, const SceneOptions& options) = 0;

  /// Called before every step, so that a scene can throw, break or knock something out.
  virtual void update(World& /*world*/) {}

  /// Called before an object is taken out of the world by somebody else than the scene, which must let go of
  /// every pointer to it.
  virtual void forget(const WorldObject& /*object*/) {}
};

struct SceneInfo {
  std::string name;     ///< What the command line calls it.
  std::string summary;  ///< One line.
  int frames = 1600;    ///< Steps of 1/60 s that tell its story.
  std::function<std::unique_ptr<Scene>()> make;
  std::uint64_t seed = 1;               ///< Used if none is asked for.
  std::vector<std::string> warnings{};  ///< What the scene's file has and the scene leaves out, a line each.
};

/// Scenes that are not compiled in, such as files.
class SceneSource {
 public:
  SceneSource() = default;
  SceneSource(const SceneSource&) = delete;
  SceneSource& operator=(const SceneSource&) = delete;
  virtual ~SceneSource() = default;

  /// Of the scenes that it knows.
  [[nodiscard]] virtual std::vector<std::string> names() const = 0;

  /// Whether the name can only mean a scene of this source, such as that of a file, which may not exist.
  [[nodiscard]] virtual bool claims(const std::string& name) const = 0;

  /// A scene that it knows or claims. Fails if it cannot be read.
  [[nodiscard]] virtual Result<SceneInfo> find(const std::string& name) const = 0;
};

/// All scenes of the program, by name. Scenes add themselves before main() through SceneRegistration.
class SceneRegistry {
 public:
  static SceneRegistry& instance();

  void add(SceneInfo info);
  void addSource(std::unique_ptr<SceneSource> source);

  /// Sorted by name. A source's scene that cannot be read says so in its summary, and fails when it is built.
  [[nodiscard]] std::vector<std::shared_ptr<const SceneInfo>> all() const;

  /// A scene that was added, or else one of a source, read anew each time. Fails with a line that lists the
  /// known names and the nearest one, or says why the scene cannot be read.
  [[nodiscard]] Result<std::shared_ptr<const SceneInfo>> find(const std::string& name) const;

 private:
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] std::shared_ptr<const SceneInfo> findAdded(const std::string& name) const;
  [[nodiscard]] const SceneSource* sourceOf(const std::string& name) const;

  std::vector<std::shared_ptr<const SceneInfo>> scenes_;
  std::vector<std::unique_ptr<SceneSource>> sources_;
};

/// Define one at namespace scope in a scene's source file.
struct SceneRegistration {
  explicit SceneRegistration(SceneInfo info) { SceneRegistry::instance().add(std::move(info)); }
  explicit SceneRegistration(std::unique_ptr<SceneSource> source) {
    SceneRegistry::instance().addSource(std::move(source));
  }
};

}  // namespace scatter
