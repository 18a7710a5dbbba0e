#include "scenes/rocks.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scenes/ground.h"

namespace scatter {
namespace {

constexpr int kForms = 4;
constexpr float kLeastRadius = 0.38F;     // of a rock's vertices, metres
constexpr float kLargestRadius = 0.5F;    // the collision margin comes on top
constexpr float kDensity = 1500.0F;       // kg/m³
constexpr float kHeapSpacing = 1.1F;      // of the heap's grid, metres
constexpr float kJitter = 0.02F;          // metres; keeps neighbours clear of one another
constexpr float kWallHalfHeight = 12.0F;  // far above the heap
constexpr float kWallHalfThickness = 0.5F;

/// A rock's vertex in each of the 26 directions whose coordinates are -1, 0 or 1.
class Vertices {
 public:
  explicit Vertices(Random& random) {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          const Vec3 direction(x, y, z);
          if (direction == Vec3(0.0F)) continue;  // the middle stays at the origin
          at(x, y, z) = glm::normalize(direction) * random.uniform(kLeastRadius, kLargestRadius);
        }
      }
    }
  }

  [[nodiscard]] Vec3& at(int x, int y, int z) {
    return vertices_[9 * static_cast<std::size_t>(x + 1) + 3 * static_cast<std::size_t>(y + 1) +
                     static_cast<std::size_t>(z + 1)];
  }

  /// The hull of the octant with these signs.
  [[nodiscard]] ConvexPart octant(int x, int y, int z) {
    ConvexHull hull;
    for (int corner = 0; corner < 8; ++corner) {
      hull.vertices.push_back(
          at((corner & 1) != 0 ? x : 0, (corner & 2) != 0 ? y : 0, (corner & 4) != 0 ? z : 0));
    }
    return {.shape = std::move(hull), .pose = {}};
  }

  /// Half the sides of a box around the origin that holds them all.
  [[nodiscard]] Vec3 reach() const {
    Vec3 reach(0.0F);
    for (const Vec3& vertex : vertices_) reach = glm::max(reach, glm::abs(vertex));
    return reach;
  }

 private:
  std::array<Vec3, 27> vertices_{};
};

Result<void> addPit(World& world, float halfWidth) {
  if (auto added = addGround(world); !added) return added;
  const float out = halfWidth + kWallHalfThickness;
  const Vec3 alongX(out + kWallHalfThickness, kWallHalfHeight, kWallHalfThickness);
  const Vec3 alongZ(kWallHalfThickness, kWallHalfHeight, out + kWallHalfThickness);
  for (const float side : {-1.0F, 1.0F}) {
    const std::string end = side < 0.0F ? "-1" : "-2";
    const float height = kWallHalfHeight;
    if (auto added = addWall(world, "wall-z" + end, {0.0F, height, side * out}, alongX); !added) return added;
    if (auto added = addWall(world, "wall-x" + end, {side * out, height, 0.0F}, alongZ); !added) return added;
  }
  return {};
}

}  // namespace

Result<std::shared_ptr<const LevelSet>> makeRock(std::string name, Random& random) {
  Vertices vertices(random);
  LevelSetDef def;
  def.name = std::move(name);
  Level finest;
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      for (const int z : {-1, 1}) finest.parts.push_back(vertices.octant(x, y, z));
    }
  }
  const Box around{vertices.reach() + Vec3(def.hullMargin)};
  def.levels = {Level{{{.shape = around, .pose = {}}}}, std::move(finest)};
  return LevelSet::create(std::move(def));
}

Result<std::vector<std::shared_ptr<const LevelSet>>> makeRocks(int forms, Random& random) {
  std::vector<std::shared_ptr<const LevelSet>> rocks;
  for (int i = 0; i < forms; ++i) {
    auto rock = makeRock("rock-" + std::to_string(i + 1), random);
    if (!rock) return fail(rock.error().message);
    rocks.push_back(std::move(*rock));
  }
  return rocks;
}

BodyDef rockBody(std::shared_ptr<const LevelSet> levels, std::string name, const Transform& pose) {
  BodyDef def;
  def.name = std::move(name);
  def.mass = kDensity * levels->mass().volume;
  def.shape = std::move(levels);
  def.pose = pose;
  def.material.friction = 0.8F;
  def.material.linearDamping = 0.1F;
  def.material.angularDamping = 0.8F;
  def.mayRest = false;
  return def;
}

Result<void> addHeap(World& world, const HeapDef& def, Random& random) {
  const auto forms = makeRocks(kForms, random);
  if (!forms) return fail(forms.error().message);
  if (auto added = addPit(world, 0.5F * kHeapSpacing * static_cast<float>(def.columns)); !added) return added;
  const float middle = 0.5F * static_cast<float>(def.columns - 1);
  for (int i = 0; i < def.rocks; ++i) {
    const int column = i % def.columns;
    const int row = i / def.columns % def.columns;
    const int layer = i / (def.columns * def.columns);
    const Vec3 cell(static_cast<float>(column) - middle, static_cast<float>(layer) + 0.5F,
                    static_cast<float>(row) - middle);
    const Transform pose{kHeapSpacing * cell + kJitter * random.insideUnitBall(), random.orientation()};
    const auto& form = (*forms)[static_cast<std::size_t>(i) % forms->size()];
    auto added = world.add(rockBody(form, "rock-" + std::to_string(i + 1), pose));
    if (!added) return fail(added.error().message);
  }
  return {};
}

}  // namespace scatter
