#include "level_pile.h"

#include <scatter/bullet/bullet_physics.h>
#include <scatter/world/scene.h>

#include <algorithm>
#include <utility>

#include "scenes/placement.h"

namespace scatter::app {
namespace {

constexpr int kPitBodies = 30;
constexpr int kPitColumns = 3;
constexpr int kPitFrames = 400;
constexpr std::size_t kPitLast = 100;
constexpr float kPitRoom = 2.1F;  // metres, for a body with a diagonal of 2 m
constexpr float kPitWall = 10.0F;

class Pit final : public Scene {
 public:
  explicit Pit(std::shared_ptr<const LevelSet> levels) : levels_(std::move(levels)) {}

  void configure(PhysicsDef& physics) const override { physics.gravity = Vec3(0.0F, -9.81F, 0.0F); }

  Result<void> build(World& world, const SceneOptions& options) override {
    if (auto made = addWalls(world); !made) return made;
    Random random(options.seed);
    for (int i = 0; i < kPitBodies; ++i) {
      BodyDef def;
      def.name = "body-" + std::to_string(i + 1);
      def.shape = levels_;
      def.mass = 100.0F;
      def.mayRest = false;
      const auto place = [](int number) { return kPitRoom * static_cast<float>(number); };
      def.pose.position = {place(i % kPitColumns - 1), place(1 + i / (kPitColumns * kPitColumns)),
                           place(i / kPitColumns % kPitColumns - 1)};
      def.pose.rotation = random.orientation();
      if (auto added = world.add(std::move(def)); !added) return tl::unexpected(added.error());
    }
    return {};
  }

 private:
  static Result<void> addWalls(World& world) {
    const float inner = 0.5F * kPitRoom * kPitColumns;
    const std::vector<std::pair<Vec3, Vec3>> boxes{
        {{0.0F, -1.0F, 0.0F}, {kPitWall, 1.0F, kPitWall}},
        {{inner + 1.0F, kPitWall, 0.0F}, {1.0F, kPitWall, kPitWall}},
        {{-inner - 1.0F, kPitWall, 0.0F}, {1.0F, kPitWall, kPitWall}},
        {{0.0F, kPitWall, inner + 1.0F}, {kPitWall, kPitWall, 1.0F}},
        {{0.0F, kPitWall, -inner - 1.0F}, {kPitWall, kPitWall, 1.0F}}};
    int number = 0;
    for (const auto& [at, halfExtents] : boxes) {
      BodyDef def;
      def.name = "wall-" + std::to_string(++number);
      def.shape = Box{halfExtents};
      def.motion = Motion::kStatic;
      def.pose.position = at;
      if (auto added = world.add(std::move(def)); !added) return tl::unexpected(added.error());
    }
    return {};
  }

  std::shared_ptr<const LevelSet> levels_;
};

RunOptions pitRunOf(const PiledBody& body, WorldKind kind) {
  RunOptions options;
  options.scene = "pit";
  options.label = body.label + (kind == WorldKind::kStandard ? "-bullet" : "-ours");
  options.makeScene = [levels = body.levels] { return std::make_unique<Pit>(levels); };
  options.engine = [](const PhysicsDef& def) -> Result<std::unique_ptr<Physics>> {
    return makeBulletPhysics(def);
  };
  options.physics.world = kind;
  options.physics.profiling = false;
  options.frames = kPitFrames;
  return options;
}

double lastMean(const FrameTable& table, std::string_view column) {
  const std::vector<double>& values = table.values(column);
  const std::size_t count = std::min(kPitLast, values.size());
  double sum = 0.0;
  for (std::size_t i = values.size() - count; i < values.size(); ++i) sum += values[i];
  return sum / static_cast<double>(count);
}

PileCost costOf(const ComparedWorld& world) {
  std::vector<double> times;
  for (const Run& run : world.repeats) times.push_back(run.summary.physicsCpuMs.lastHundred);
  const auto [least, most] = std::minmax_element(times.begin(), times.end());
  const FrameTable& table = world.run().table;
  return {{medianOf(times), *least, *most}, lastMean(table, "contacts"), lastMean(table, "manifolds")};
}

}  // namespace

Result<std::vector<PileCosts>> pileUp(const std::vector<PiledBody>& bodies, int repeat,
                                      const std::function<void(const CompareProgress&)>& progress) {
  CompareOptions options;
  options.repeat = repeat;
  for (const PiledBody& body : bodies) {
    options.runs.push_back(pitRunOf(body, WorldKind::kStandard));
    options.runs.push_back(pitRunOf(body, WorldKind::kHybrid));
  }
  const auto comparison = compareWorlds(options, progress);
  if (!comparison) return fail(comparison.error().message);
  std::vector<PileCosts> costs;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    costs.push_back({costOf(comparison->worlds[2 * i]), costOf(comparison->worlds[2 * i + 1])});
  return costs;
}

}  // namespace scatter::app
