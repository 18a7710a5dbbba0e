#include <gtest/gtest.h>
#include <scatter/bullet/bullet_physics.h>
#include <scatter/io/scene_file.h>
#include <scatter/lab/run.h>
#include <scatter/recording/export.h>
#include <scatter/recording/recording.h>

#include <array>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "lab/temporary_folder.h"
#include "scenes/file_scene.h"
#include "trials.h"

// Scenes of everything that a scene file can have, in every kind of world.

namespace scatter {
namespace {

/// A scene file with random content, the same for the same seed.
class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : random_(seed) {
    text_ << "[scene]\nframes = 120\nseed = " << seed << "\ngravity = [0, "
          << -oneOf(std::array{0.0, 9.81, 30.0}) << ", 0]\n";
    addMaterial();
    addFields();
    addRegion();
    addGround();
    for (int i = number(2, 7); i > 0; --i) addObject();
    for (int i = number(0, 4); i > 0; --i) addJoint();
    for (int i = number(0, 8); i > 0; --i) addEvent();
  }

  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  [[nodiscard]] int number(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random_);
  }
  [[nodiscard]] double between(double least, double most) {
    return 0.001 * std::uniform_int_distribution<int>(static_cast<int>(1000 * least),
                                                      static_cast<int>(1000 * most))(random_);
  }
  [[nodiscard]] bool chance(double share) { return between(0, 1) < share; }
  template <class T, std::size_t N>
  [[nodiscard]] T oneOf(const std::array<T, N>& all) {
    return all[static_cast<std::size_t>(number(0, static_cast<int>(N) - 1))];
  }
  [[nodiscard]] const std::string& oneOf(const std::vector<std::string>& all) {
    return all[static_cast<std::size_t>(number(0, static_cast<int>(all.size()) - 1))];
  }

  [[nodiscard]] std::string vector(double least, double most) {
    std::ostringstream out;
    out << '[' << between(least, most) << ", " << between(least, most) << ", " << between(least, most) << ']';
    return out.str();
  }
  [[nodiscard]] std::string direction() { return "[" + std::to_string(between(0.1, 1)) + ", 0.3, -0.5]"; }

  void addMaterial() {
    text_ << "[[material]]\nname = \"slippery\"\nfriction = " << between(0, 0.2)
          << "\nrestitution = " << between(0, 1) << "\nrolling_friction = " << between(0, 0.1)
          << "\nlinear_damping = " << between(0, 0.5) << '\n';
  }

  void addFields() {
    text_ << "[[field]]\nname = \"pull\"\nacceleration = " << between(-5, 15)
          << "\nradius = " << between(1, 100) << "\non = " << (chance(0.6) ? "true" : "false") << '\n';
    text_ << "[[field]]\nname = \"wind\"\nkind = \"uniform\"\nacceleration = " << between(0, 9)
          << "\ndirection = " << direction() << "\non = " << (chance(0.3) ? "true" : "false") << '\n';
  }

  void addRegion() {
    text_ << "[[region]]\nname = \"sky\"\nkind = \"ball\"\ncenter = [0, 4, 0]\nradius = " << between(1, 5)
          << "\nclearance = " << between(0, 0.3) << '\n';
  }

  void addGround() {
    text_ << "[[object]]\nname = \"ground\"\n";
    switch (number(0, 4)) {
      case 0:
        text_ << "plane = [" << oneOf(std::array{0.0, 0.2}) << ", 1, 0]\n";
        break;
      case 1:
        text_ << "box = [12, 1, 12]\nat = [0, -0.5, 0]\nmotion = \"" << (chance(0.5) ? "static" : "kinematic")
              << "\"\n";
        break;
      case 2:
        text_ << "model = \"table\"\nmotion = \"static\"\n";
        break;
      default:
        text_ << "terrain = { size = [14, 14], cells = [" << number(3, 30)
              << ", 20], relief = " << between(0, 3) << ", kind = \""
              << (chance(0.5) ? "mesh" : "height_field") << "\" }\n";
    }
  }

  void addObject() {
    const std::string name = "o" + std::to_string(numObjects_++);
    text_ << "[[object]]\nname = \"" << name << "\"\n";
    const bool isModel = addShape();
    const bool isDynamic = chance(0.85);
    if (!isDynamic) text_ << "motion = \"" << (chance(0.5) ? "static" : "kinematic") << "\"\n";
    if (isDynamic && chance(0.5))
      text_ << (chance(0.5) ? "mass = " : "density = ") << between(0.05, 500) << '\n';
    if (chance(0.3)) text_ << "material = \"slippery\"\n";
    if (chance(0.3))
      text_ << "group = \"" << (groups_.emplace_back("g" + std::to_string(number(0, 2)))) << "\"\n";
    if (!groups_.empty() && chance(0.1)) text_ << "ignores = [\"" << oneOf(groups_) << "\"]\n";
    if (chance(0.15)) text_ << "may_rest = false\n";
    if (chance(0.06)) text_ << "sensor = true\n";
    const int count = addPlaces();
    if (isDynamic && chance(0.4)) text_ << "velocity = " << vector(-12, 12) << '\n';
    if (isDynamic && chance(0.2)) text_ << "spin = { random = 6 }\n";
    if (isDynamic && isModel) breakable_.push_back(name);
    for (int i = 1; isDynamic && i <= count; ++i)
      bodies_.push_back(count == 1 ? name : name + "-" + std::to_string(i));
  }

  /// Whether it is a model.
  bool addShape() {
    static constexpr std::array kModels{"hunter_hulls", "fighter_hulls", "mug",   "lamp",
                                        "chair",        "table",         "crate", "barrel"};
    switch (number(0, 7)) {
      case 0:
        text_ << "box = " << vector(0.1, 2) << '\n';
        return false;
      case 1:
        text_ << "sphere = " << between(0.05, 1) << '\n';
        return false;
      case 2:
        text_ << (chance(0.5) ? "capsule" : "cylinder") << " = { radius = " << between(0.05, 0.6)
              << ", length = 0.7 }\n";
        return false;
      case 3:
        text_ << "hull = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], " << vector(0.2, 1) << ", "
              << vector(-1, 0) << "]\n";
        return false;
      default:
        text_ << "model = \"" << oneOf(kModels) << "\"\n";
        return true;
    }
  }

  /// How many there are.
  int addPlaces() {
    switch (number(0, 3)) {
      case 0:
        text_ << "at = " << vector(-3, 5) << "\norientation = \"random\"\n";
        return 1;
      case 1:
        text_ << "grid = { count = [2, 2, 1], spacing = " << vector(0.3, 3) << ", center = [0, 3, 0] }\n";
        return 4;
      case 2:
        text_ << "stack = { count = 3, base = [" << between(-3, 3) << ", 0, 1], gap = " << between(0, 0.2)
              << " }\n";
        return 3;
      default:
        text_ << "in = \"sky\"\ncount = 5\norientation = \"random\"\n";
        return 5;
    }
  }

  void addJoint() {
    if (bodies_.size() < 2) return;
    const std::string a = oneOf(bodies_);
    const std::string b = oneOf(bodies_);
    static constexpr std::array kKinds{"point", "hinge", "slider", "fixed", "six_dof"};
    const std::string kind = oneOf(kKinds);
    text_ << "[[joint]]\nkind = \"" << kind << "\"\na = \"" << a << "\"\nat = " << vector(-2, 3) << '\n';
    if (a != b) text_ << "b = \"" << b << "\"\n";
    if (kind == "hinge" || kind == "slider") text_ << "axis = " << direction() << '\n';
    if (chance(0.3)) text_ << "collide = true\n";
  }

  void addEvent() {
    static constexpr std::array kKinds{"throw", "knock", "break", "remove", "field"};
    const std::string kind = oneOf(kKinds);
    if (bodies_.empty() || (kind == "break" && breakable_.empty())) return;
    text_ << "[[event]]\ndo = \"" << kind << "\"\nframe = " << number(0, 110) << '\n';
    if (kind == "field") {
      text_ << "field = \"" << (chance(0.5) ? "pull" : "wind")
            << "\"\non = " << (chance(0.5) ? "true" : "false") << '\n';
      return;
    }
    text_ << "target = \"" << oneOf(kind == "break" ? breakable_ : bodies_) << "\"\n";
    if (kind == "throw") text_ << "toward = \"" << oneOf(bodies_) << "\"\nspeed = " << between(0, 40) << '\n';
    if (kind == "knock") text_ << "direction = " << direction() << "\nspeed = " << between(0, 20) << '\n';
    if (kind == "break") text_ << "burst = " << between(0, 10) << "\nshrink = " << between(0.5, 1) << '\n';
  }

  std::mt19937_64 random_;
  std::ostringstream text_;
  std::vector<std::string> bodies_;  ///< That are dynamic, by their names.
  std::vector<std::string> breakable_;
  std::vector<std::string> groups_;
  int numObjects_ = 0;
};

/// Worlds in which what happens is the same on one thread and on two.
std::vector<PhysicsDef> kindsOfWorlds() {
  std::vector<PhysicsDef> all(4);
  for (PhysicsDef& def : all) def.world = WorldKind::kHybrid;
  all[0].switching.budget.units = 150.0;
  all[1].switching.budget.units = 30.0;
  all[1].solver = ContactSolver::kWide;
  all[2].switching.policies = {"speed", "proximity"};
  all[3].switching.switching = Switching::kBody;
  all[3].switching.policy = Policy::kProximity;
  return all;
}

class RandomScenes : public testing::Test {
 protected:
  [[nodiscard]] std::uint64_t hashAfter(const std::shared_ptr<const SceneFile>& file,
                                        const PhysicsDef& physics, int threads) const {
    RunOptions options;
    options.scene = "random";
    options.makeScene = [file] { return std::make_unique<FileScene>(file); };
    options.engine = [](const PhysicsDef& def) {
      return Result<std::unique_ptr<Physics>>(makeBulletPhysics(def));
    };
    options.physics = physics;
    options.physics.threads = threads;
    options.frames = 120;
    if (threads == 1) options.record = RecordOptions{.file = folder_.path() / "run.rec", .contacts = true};
    auto made = runScene(options);
    EXPECT_TRUE(made) << made.error().message;
    return made ? made->summary.stateHash : 0;
  }

  void expectExports() const {
    const auto recording = Recording::open(folder_.path() / "run.rec");
    ASSERT_TRUE(recording) << recording.error().message;
    const ExportRange all{.first = (*recording)->first(), .last = (*recording)->last()};
    const auto animation = writeGltfAnimation(**recording, all, folder_.path() / "run.glb");
    EXPECT_TRUE(animation) << animation.error().message;
  }

 private:
  test::TemporaryFolder folder_;
};

/// SCATTER_RANDOM_SCENES and SCATTER_RANDOM_SCENE: how many, and the first.
TEST_F(RandomScenes, AreTheSameOnTwoThreadsAndCanBeExported) {
  for (const std::uint64_t seed : test::seedsOr("SCATTER_RANDOM_SCENES", "SCATTER_RANDOM_SCENE", 6)) {
    const std::string text = RandomScene(seed).text();
    SCOPED_TRACE("scene " + std::to_string(seed));
    auto parsed = parseSceneFile(text, "random.toml");
    ASSERT_TRUE(parsed) << parsed.error().message << '\n' << text;
    const auto file = std::make_shared<const SceneFile>(std::move(*parsed));
    for (const PhysicsDef& physics : kindsOfWorlds()) {
      const std::uint64_t one = hashAfter(file, physics, 1);
      expectExports();
      EXPECT_EQ(one, hashAfter(file, physics, 2));
      ASSERT_FALSE(HasFailure()) << text;
    }
    (void)hashAfter(file, {}, 1);
  }
}

}  // namespace
}  // namespace scatter
