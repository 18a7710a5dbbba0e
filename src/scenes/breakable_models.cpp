#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "scenes/breakable.h"
#include "scenes/hexahedron.h"

namespace scatter {
namespace {

constexpr float kMargin = 0.005F;  // of hulls, metres
constexpr float kInset = 0.006F;   // of a gib from its cell: the margin and a little room

/// What gibs are made of. A box has no room for hulls' margins to lose, and meets floors most reliably.
enum class Parts { kBoxes, kHulls };

/// A shard within a cell: level 1 fills it, level 2 has a broken edge.
Result<std::shared_ptr<const LevelSet>> makeGib(std::string name, const Hexahedron& cell, Parts kind,
                                                Random& random) {
  const auto part = [kind](const Hexahedron& solid) {
    return kind == Parts::kBoxes ? solid.boxPart() : solid.part();
  };
  const Hexahedron inside = cell.shrunk(kInset);
  const float middle = random.uniform(0.35F, 0.65F);
  const float tooth = random.uniform(0.15F, 0.4F);
  const float chip = random.uniform(0.0F, 0.25F);
  const bool left = random.below(2) == 0;
  Level finest;
  finest.parts.push_back(part(inside.cut({Vec3(0.0F), {1.0F, middle, 1.0F}})));
  const Vec3 from(left ? tooth : 0.0F, middle, 0.0F);
  const Vec3 to(left ? 1.0F : 1.0F - tooth, 1.0F, 1.0F - chip);
  finest.parts.push_back(part(inside.cut({from, to})));
  LevelSetDef def;
  def.name = std::move(name);
  def.levels = {Level{{part(inside)}}, std::move(finest)};
  def.hullMargin = kMargin;
  return LevelSet::create(std::move(def));
}

Result<void> addGib(Breakable& object, const std::string& name, const Hexahedron& cell, Parts kind,
                    Random& random) {
  auto gib = makeGib(name + "-gib-" + std::to_string(object.gibs.size() + 1), cell, kind, random);
  if (!gib) return fail(gib.error().message);
  object.gibs.push_back(std::move(*gib));
  return {};
}

/// Two gibs, from a cut across one edge of the cell.
Result<void> addHalves(Breakable& object, const std::string& name, const Hexahedron& cell, Parts kind,
                       int axis, Random& random) {
  Share low;
  Share high;
  low.to[axis] = high.from[axis] = random.uniform(0.4F, 0.6F);
  for (const Share& half : {low, high}) {
    if (auto added = addGib(object, name, cell.cut(half), kind, random); !added) return added;
  }
  return {};
}

Result<void> setWhole(Breakable& object, LevelSetDef def, float density) {
  def.hullMargin = kMargin;
  auto whole = LevelSet::create(std::move(def));
  if (!whole) return fail(whole.error().message);
  object.whole = std::move(*whole);
  object.mass = density * object.whole->mass().volume;
  return {};
}

/// The outer shape of the urn.
struct Profile {
  float y;
  float radius;
};
constexpr std::array kUrn{Profile{0.0F, 0.18F}, Profile{0.25F, 0.30F}, Profile{0.55F, 0.36F},
                          Profile{0.85F, 0.30F}, Profile{1.0F, 0.22F}};
constexpr int kSectors = 6;
constexpr float kWall = 0.09F;
constexpr float kClay = 1000.0F;  // kg/m³
constexpr float kPine = 500.0F;

Vec3 onCircle(float radius, float y, int sector) {
  const float angle =
      2.0F * std::numbers::pi_v<float> * static_cast<float>(sector % kSectors) / static_cast<float>(kSectors);
  return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

/// Edges: around, up, outward.
Hexahedron urnPanel(const Profile& low, const Profile& high, int sector) {
  std::array<Vec3, 8> corners{};
  for (unsigned i = 0; i < 8; ++i) {
    const Profile& end = (i & 2U) != 0 ? high : low;
    const float radius = (i & 4U) != 0 ? end.radius : end.radius - kWall;
    corners[i] = onCircle(radius, end.y, sector + ((i & 1U) != 0 ? 1 : 0));
  }
  return Hexahedron(corners);
}

/// A third of the base.
Hexahedron urnBase(int third) {
  const float radius = kUrn[0].radius - kWall - 0.005F;
  std::array<Vec3, 8> corners{};
  for (unsigned i = 0; i < 8; ++i) {
    const float y = (i & 4U) != 0 ? 0.09F : 0.0F;
    // A rhombus: the centre, and three corners of the hexagon.
    const int step = (i & 3U) == 1 ? 0 : (i & 3U) == 3 ? 1 : 2;
    corners[i] = (i & 3U) == 0 ? Vec3(0.0F, y, 0.0F) : onCircle(radius, y, 2 * third + step);
  }
  return Hexahedron(corners);
}

/// The hull of a ring of panels with what they enclose.
ConvexPart urnSlice(const Profile& low, const Profile& high) {
  ConvexHull hull;
  for (const Profile& end : {low, high}) {
    for (int sector = 0; sector < kSectors; ++sector) {
      hull.vertices.push_back(onCircle(end.radius, end.y, sector));
    }
  }
  return {.shape = std::move(hull), .pose = {}};
}

/// The two boards of a face of a box, given by the corners of the face's slab and the edge that they halve.
struct Face {
  Vec3 low;
  Vec3 high;
  int halved;  ///< 0 x, 1 y, 2 z
  int longest;
};

constexpr float kBoxSide = 0.4F;  // half a box's width
constexpr float kBoard = 0.08F;   // thickness

std::array<Face, 6> faces() {
  constexpr float kIn = kBoxSide - kBoard;
  return {{{{-kBoxSide, -kBoxSide, -kBoxSide}, {kBoxSide, -kIn, kBoxSide}, 2, 0},
           {{-kBoxSide, kIn, -kBoxSide}, {kBoxSide, kBoxSide, kBoxSide}, 2, 0},
           {{-kBoxSide, -kIn, -kBoxSide}, {kBoxSide, kIn, -kIn}, 1, 0},
           {{-kBoxSide, -kIn, kIn}, {kBoxSide, kIn, kBoxSide}, 1, 0},
           {{-kBoxSide, -kIn, -kIn}, {-kIn, kIn, kIn}, 1, 2},
           {{kIn, -kIn, -kIn}, {kBoxSide, kIn, kIn}, 1, 2}}};
}

ConvexPart boxBetween(const Vec3& low, const Vec3& high) {
  return {.shape = Box{0.5F * (high - low)}, .pose = {0.5F * (low + high), kNoRotation}};
}

}  // namespace

Result<Breakable> makeUrn(Random& random) {
  Breakable urn;
  urn.toughness = 3.0F;
  Level slices;
  Level finest;
  for (std::size_t ring = 1; ring < kUrn.size(); ++ring) {
    slices.parts.push_back(urnSlice(kUrn[ring - 1], kUrn[ring]));
    for (int sector = 0; sector < kSectors; ++sector) {
      const Hexahedron panel = urnPanel(kUrn[ring - 1], kUrn[ring], sector);
      finest.parts.push_back(panel.part());
      const int axis = (static_cast<int>(ring) + sector) % 2;
      if (auto added = addHalves(urn, "urn", panel, Parts::kHulls, axis, random); !added)
        return fail(added.error().message);
    }
  }
  ConvexHull base;
  for (const float y : {0.0F, 0.09F}) {
    for (int i = 0; i < kSectors; ++i) base.vertices.push_back(onCircle(kUrn[0].radius - kWall, y, i));
  }
  finest.parts.push_back({.shape = std::move(base), .pose = {}});
  for (int third = 0; third < 3; ++third) {
    if (auto added = addGib(urn, "urn", urnBase(third), Parts::kHulls, random); !added)
      return fail(added.error().message);
  }
  constexpr float kReach = 0.36F + 2.0F * kMargin;
  Level around{{boxBetween({-kReach, -2.0F * kMargin, -kReach}, {kReach, 1.0F + 2.0F * kMargin, kReach})}};
  LevelSetDef def;
  def.name = "urn";
  def.levels = {std::move(around), std::move(slices), std::move(finest)};
  if (auto set = setWhole(urn, std::move(def), kClay); !set) return fail(set.error().message);
  return urn;
}

Result<Breakable> makeBoardBox(Random& random) {
  Breakable box;
  box.toughness = 4.0F;
  Level panels;
  Level finest;
  for (const Face& face : faces()) {
    panels.parts.push_back(boxBetween(face.low, face.high));
    Vec3 lowEnd = face.high;
    Vec3 highStart = face.low;
    lowEnd[face.halved] = highStart[face.halved] = 0.5F * (face.low + face.high)[face.halved];
    for (const auto& [low, high] : {std::pair(face.low, lowEnd), std::pair(highStart, face.high)}) {
      finest.parts.push_back(boxBetween(low, high));
      const auto added =
          addHalves(box, "box", Hexahedron::box(low, high), Parts::kBoxes, face.longest, random);
      if (!added) return fail(added.error().message);
    }
  }
  LevelSetDef def;
  def.name = "box";
  def.levels = {Level{{boxBetween(Vec3(-kBoxSide), Vec3(kBoxSide))}}, std::move(panels), std::move(finest)};
  if (auto set = setWhole(box, std::move(def), kPine); !set) return fail(set.error().message);
  return box;
}

}  // namespace scatter
