#include "scenes/families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scenes/family_scene.h"

namespace scatter {
namespace {

// No expression here draws twice, unless its braces say in which order.

constexpr float kCircle = 2.0F * std::numbers::pi_v<float>;
constexpr double kMostScale = 10.0;
constexpr std::uint64_t kMostSeed = 9'000'000'000'000'000;  // of a scene file

using Models = std::vector<FamilyModel>;

Models addShips(FamilyScene& scene, int kinds) {
  Models models;
  for (int i = 0; i < kinds; ++i) {
    ClusterDef def;
    def.halfExtents = {scene.vary(0.6F), scene.vary(0.45F), scene.vary(1.8F)};
    def.groups = scene.varyWhole(8);
    def.hulls = scene.varyWhole(64);
    const HullGroups hulls = makeCluster(def, scene.random());
    models.push_back(scene.addModel("ship-" + std::to_string(i + 1), hulls, scene.vary(1500.0F)));
  }
  return models;
}

struct Wheels {
  Models models;
  float halfWidth = 0.0F;  ///< Of the widest rim, metres.
};

Wheels addWheels(FamilyScene& scene, int kinds) {
  Wheels wheels;
  for (int i = 0; i < kinds; ++i) {
    WheelBodyDef def;
    def.radius = scene.vary(0.8F);
    def.halfWidth = scene.vary(0.15F);
    def.segments = scene.varyWhole(27);
    def.spokes = scene.varyWhole(8);
    def.wedges = 4 + static_cast<int>(scene.random().below(3));
    const HullGroups hulls = makeWheel(def, scene.random());
    wheels.models.push_back(scene.addModel("wheel-" + std::to_string(i + 1), hulls, scene.vary(60.0F)));
    wheels.halfWidth = std::max(wheels.halfWidth, def.halfWidth);
  }
  return wheels;
}

std::string randomFriction(FamilyScene& scene) {
  return tomlNumber(scene.random().uniform(0.5F, 1.2F));
}

std::string randomVelocity(FamilyScene& scene, float most) {
  return "{ random = " + tomlNumber(scene.vary(most)) + " }";
}

void addPlane(FamilyScene& scene) {
  scene.add("[[object]]",
            {{"name", tomlText("ground")}, {"plane", "[0, 1, 0]"}, {"friction", randomFriction(scene)}});
}

void addStaticBox(FamilyScene& scene, std::string_view name, const Vec3& size, const Vec3& at) {
  scene.add("[[object]]", {{"name", tomlText(name)},
                           {"box", tomlVector(size)},
                           {"at", tomlVector(at)},
                           {"motion", tomlText("static")}});
}

struct Terrain {
  float side = 0.0F;
  float relief = 0.0F;
};

/// On a full ground 100 cells a side, which are 20 000 triangles.
Terrain addTerrain(FamilyScene& scene, std::string_view kind) {
  constexpr float kSide = 80.0F;
  constexpr float kLeastSide = 40.0F;
  constexpr float kCell = 0.8F;
  const Terrain terrain{.side = scene.side(kSide, kLeastSide), .relief = scene.vary(5.0F)};
  const std::string size = tomlNumber(terrain.side);
  const std::string cells = std::to_string(std::lround(terrain.side / kCell));
  const std::string roughness = tomlNumber(scene.random().uniform(0.3F, 0.5F));
  const std::string seed = std::to_string(1 + scene.random().below(1'000'000));
  scene.add("[[object]]",
            {{"name", tomlText("ground")},
             {"terrain", "{ size = [" + size + ", " + size + "], cells = [" + cells + ", " + cells +
                             "], relief = " + tomlNumber(terrain.relief) + ", roughness = " + roughness +
                             ", seed = " + seed + ", kind = " + tomlText(kind) + " }"},
             {"friction", randomFriction(scene)}});
  return terrain;
}

/// So many bodies of these models fall on the middle of a square ground.
void rain(FamilyScene& scene, const Models& models, int count, float side, float low) {
  scene.addRain("sky", models, count, side, low + scene.vary(2.0F));
  scene.addBodies("sky", models, count, randomVelocity(scene, 3.0F));
}

void makeShipsOn(FamilyScene& scene, std::string_view ground) {
  const Terrain terrain = addTerrain(scene, ground);
  const Models ships = addShips(scene, 4);
  constexpr float kEdge = 8.0F;  // metres, so that few roll off
  rain(scene, ships, scene.count(300), terrain.side - 2.0F * kEdge, terrain.relief);
}

void shipsOnMesh(FamilyScene& scene) {
  scene.begin("ships of some 64 hulls rain on a rolling ground of triangles", 420);
  makeShipsOn(scene, "mesh");
}

void shipsOnHeights(FamilyScene& scene) {
  scene.begin("ships of some 64 hulls rain on a rolling ground, a height field", 420);
  makeShipsOn(scene, "height_field");
}

void rainOfWheels(FamilyScene& scene, float side, float low) {
  const Wheels wheels = addWheels(scene, 4);
  rain(scene, wheels.models, scene.count(80), side, low);
}

void wheelsOnMesh(FamilyScene& scene) {
  scene.begin("wheels of some 40 hulls rain on a rolling ground of triangles", 480);
  const Terrain terrain = addTerrain(scene, "mesh");
  rainOfWheels(scene, 0.3F * terrain.side, terrain.relief);
}

void wheelsOnBox(FamilyScene& scene) {
  scene.begin("wheels of some 40 hulls rain on a large box", 480);
  addStaticBox(scene, "ground", Vec3(100.0F), {0.0F, -50.0F, 0.0F});
  rainOfWheels(scene, scene.vary(16.0F), 0.0F);
}

void wheelsOnPlane(FamilyScene& scene) {
  scene.begin("wheels of some 40 hulls rain on a plane", 480);
  addPlane(scene);
  rainOfWheels(scene, scene.vary(16.0F), 0.0F);
}

/// A paraboloid, its lowest point at the origin.
SurfaceMesh bowlMesh(float radius, float height) {
  constexpr std::uint32_t kRings = 16;
  constexpr std::uint32_t kPerRing = 48;
  SurfaceMesh mesh;
  mesh.vertices.emplace_back(0.0F);
  for (std::uint32_t ring = 1; ring <= kRings; ++ring) {
    const float share = static_cast<float>(ring) / static_cast<float>(kRings);
    const std::uint32_t first = 1 + (ring - 1) * kPerRing;
    for (std::uint32_t sector = 0; sector < kPerRing; ++sector) {
      const float angle = kCircle * static_cast<float>(sector) / static_cast<float>(kPerRing);
      mesh.vertices.emplace_back(radius * share * std::cos(angle), height * share * share,
                                 radius * share * std::sin(angle));
      const std::uint32_t a = first + sector;
      const std::uint32_t b = first + (sector + 1) % kPerRing;
      if (ring == 1) {
        mesh.triangles.push_back({0, b, a});
      } else {
        mesh.triangles.push_back({a - kPerRing, b - kPerRing, a});
        mesh.triangles.push_back({b - kPerRing, b, a});
      }
    }
  }
  return mesh;
}

void dropsIntoBowl(FamilyScene& scene) {
  scene.begin("ships and wheels drop into a bowl of triangles", 480);
  const float radius = scene.vary(20.0F);
  const float height = scene.vary(10.0F);
  scene.add("[[object]]", {{"name", tomlText("bowl")},
                           {"mesh", tomlText(scene.addMesh("bowl", bowlMesh(radius, height)))},
                           {"friction", randomFriction(scene)}});
  Models models = addShips(scene, 2);
  const Wheels wheels = addWheels(scene, 2);
  models.insert(models.end(), wheels.models.begin(), wheels.models.end());
  // Its corners lie within the rim.
  rain(scene, models, scene.count(120), 1.2F * radius, height);
}

void implosion(FamilyScene& scene) {
  scene.begin("ships are drawn to one point, and there is no ground", 480, false);
  const std::string acceleration = tomlNumber(scene.vary(5.0F));
  scene.add("[[field]]", {{"acceleration", acceleration}, {"radius", "1000"}});
  const Models ships = addShips(scene, 4);
  const int count = scene.count(200);
  const float outer = scene.vary(5.0F) * std::cbrt(static_cast<float>(count)) + 8.0F;
  scene.add("[[region]]", {{"name", tomlText("sky")},
                           {"kind", tomlText("shell")},
                           {"inner", tomlNumber(0.4F * outer)},
                           {"outer", tomlNumber(outer)}});
  scene.addBodies("sky", ships, count, randomVelocity(scene, 2.0F));
}

/// Boxes that stand on each other.
void addBlock(FamilyScene& scene, std::string_view name, const Vec3& size, const Vec3& counts,
              const Vec3& gaps, const Vec3& base) {
  const Vec3 spacing = size + gaps;
  const Vec3 center = base + Vec3(0.0F, 0.5F * size.y + 0.5F * (counts.y - 1.0F) * spacing.y, 0.0F);
  scene.add("[[object]]", {{"name", tomlText(name)},
                           {"box", tomlVector(size)},
                           {"density", "500"},
                           {"grid", "{ count = " + tomlVector(counts) + ", spacing = " + tomlVector(spacing) +
                                        ", center = " + tomlVector(center) + " }"}});
}

/// A count as a part of a vector, at least 1.
float asFloat(int number) {
  return static_cast<float>(std::max(1, number));
}

void shipsAtWall(FamilyScene& scene) {
  scene.begin("ships are thrown at a wall and a tower of boxes", 420);
  addPlane(scene);
  const Vec3 size{scene.vary(1.0F), scene.vary(0.5F), scene.vary(0.6F)};
  const int boxes = scene.count(240);
  const int layers = std::clamp(boxes / 12, 1, 12);
  addBlock(scene, "wall", size, {asFloat(boxes / layers), asFloat(layers), 1.0F}, {0.01F, 0.0F, 0.0F},
           Vec3(0.0F));
  addBlock(scene, "tower", size, {2.0F, asFloat(std::min(scene.count(16), 24)), 2.0F}, {0.01F, 0.0F, 0.01F},
           {0.0F, 0.0F, 6.0F});
  std::vector<Vec3> places;
  for (int i = scene.count(12); i > 0; --i) {
    const float x = scene.random().uniform(-5.0F, 5.0F);
    places.emplace_back(x, 2.0F + 0.1F * static_cast<float>(i), -12.0F - 6.0F * static_cast<float>(i));
  }
  const Models ships = addShips(scene, 2);
  scene.addBodiesAt(
      "ship", ships, places,
      {{"velocity", tomlVector({0.0F, 3.0F, scene.vary(22.0F)})}, {"orientation", tomlText("random")}});
}

void boxesAndShips(FamilyScene& scene) {
  scene.begin("a field of boxes, and ships of some 64 hulls that rain into it", 420);
  addPlane(scene);
  constexpr int kLayers = 10;
  const Vec3 size{scene.vary(0.7F), scene.vary(0.7F), scene.vary(0.7F)};
  const int row = static_cast<int>(std::lround(std::sqrt(static_cast<float>(scene.count(3000)) / kLayers)));
  const Vec3 gaps{scene.vary(0.3F), scene.vary(0.1F), scene.vary(0.3F)};
  addBlock(scene, "box", size, {asFloat(row), asFloat(kLayers), asFloat(row)}, gaps, {0.0F, 0.2F, 0.0F});
  const float side = std::max(8.0F, asFloat(row) * (size.x + gaps.x));
  const Models ships = addShips(scene, 4);
  rain(scene, ships, scene.count(50), side, asFloat(kLayers) * (size.y + gaps.y));
}

/// A part of a ragdoll and what holds it: at `joint` its part `parent`, of which there is none for the trunk.
struct Limb {
  const char* name;
  Vec3 halfExtents;
  Vec3 at;
  int parent;
  Vec3 joint;
};

constexpr int kNoParent = -1;

const std::array<Limb, 6>& limbs() {
  static const std::array<Limb, 6> all{{
      {"trunk", {0.3F, 0.5F, 0.2F}, {0.0F, 0.0F, 0.0F}, kNoParent, Vec3(0.0F)},
      {"head", {0.19F, 0.2F, 0.19F}, {0.0F, 0.77F, 0.0F}, 0, {0.0F, 0.53F, 0.0F}},
      {"arm-left", {0.45F, 0.12F, 0.12F}, {-0.82F, 0.35F, 0.0F}, 0, {-0.33F, 0.35F, 0.0F}},
      {"arm-right", {0.45F, 0.12F, 0.12F}, {0.82F, 0.35F, 0.0F}, 0, {0.33F, 0.35F, 0.0F}},
      {"leg-left", {0.12F, 0.5F, 0.12F}, {-0.18F, -1.07F, 0.0F}, 0, {-0.18F, -0.53F, 0.0F}},
      {"leg-right", {0.12F, 0.5F, 0.12F}, {0.18F, -1.07F, 0.0F}, 0, {0.18F, -0.53F, 0.0F}},
  }};
  return all;
}

Models addLimbs(FamilyScene& scene) {
  Models models;
  for (const Limb& limb : limbs()) {
    const bool isTrunk = limb.parent == kNoParent;
    const ClusterDef def{.halfExtents = limb.halfExtents,
                         .groups = scene.varyWhole(isTrunk ? 5 : 3),
                         .hulls = scene.varyWhole(isTrunk ? 25 : 12)};
    const HullGroups hulls = makeCluster(def, scene.random());
    models.push_back(scene.addModel(limb.name, hulls, scene.vary(isTrunk ? 35.0F : 8.0F)));
  }
  return models;
}

/// Their joints, where the first body of each model is 1.
void addLimbJoints(FamilyScene& scene, const std::vector<Vec3>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string number = places.size() > 1 ? "-" + std::to_string(i + 1) : "";
    for (const Limb& limb : limbs()) {
      if (limb.parent == kNoParent) continue;
      const Limb& parent = limbs()[static_cast<std::size_t>(limb.parent)];
      scene.add("[[joint]]", {{"kind", tomlText("point")},
                              {"a", tomlText(parent.name + number)},
                              {"b", tomlText(limb.name + number)},
                              {"at", tomlVector(places[i] + limb.joint)}});
    }
  }
}

/// Places in layers of square grids above `low`, `spacing` apart.
std::vector<Vec3> gridPlaces(int count, const Vec3& spacing, int layers, float low) {
  const int inLayer = (count + layers - 1) / layers;
  const int row = static_cast<int>(std::ceil(std::sqrt(static_cast<float>(inLayer))));
  const float middle = 0.5F * static_cast<float>(row - 1);
  std::vector<Vec3> places;
  for (int i = 0; i < count; ++i) {
    const int layer = i / inLayer;
    const int cell = i % inLayer;
    const int line = cell / row;
    places.emplace_back((static_cast<float>(cell % row) - middle) * spacing.x,
                        low + static_cast<float>(layer) * spacing.y,
                        (static_cast<float>(line) - middle) * spacing.z);
  }
  return places;
}

void ragdolls(FamilyScene& scene) {
  scene.begin("jointed figures fall on a rolling ground of triangles", 420);
  const Terrain terrain = addTerrain(scene, "mesh");
  const Models models = addLimbs(scene);
  const Vec3 spacing{scene.vary(4.0F), scene.vary(4.0F), scene.vary(3.0F)};
  const int count = scene.count(60);
  const auto places = gridPlaces(count, spacing, 3, terrain.relief + scene.vary(3.0F));
  for (std::size_t i = 0; i < models.size(); ++i) {
    std::string list;
    for (const Vec3& place : places) list += (list.empty() ? "" : ", ") + tomlVector(place + limbs()[i].at);
    scene.add("[[object]]", {{"name", tomlText(limbs()[i].name)},
                             {"model", tomlText(models[i].file)},
                             {"list", "[" + list + "]"},
                             {"velocity", randomVelocity(scene, 2.0F)},
                             {"angular_damping", "0.2"}});
  }
  addLimbJoints(scene, places);
}

void sleepers(FamilyScene& scene) {
  scene.begin("wheels that lie asleep, but for some that are thrown among them", 420);
  addPlane(scene);
  constexpr int kKinds = 4;
  const Wheels wheels = addWheels(scene, kKinds);
  const int count = scene.count(1000);
  const float spacing = scene.vary(3.0F);
  constexpr float kClearance = 0.03F;
  scene.addBodiesAt("wheel", wheels.models,
                    gridPlaces(count, Vec3(spacing), 1, wheels.halfWidth + kClearance),
                    {{"linear_damping", "0.05"}, {"angular_damping", "0.3"}});
  const int throws = std::max(1, count / 50);
  const int inKind = (count + kKinds - 1) / kKinds;
  for (int i = 0; i < throws; ++i) {
    const std::string number = inKind > 1 ? "-" + std::to_string(1 + i * inKind / throws) : "";
    const std::string frame = std::to_string(180 + scene.random().below(120));
    const Vec3 direction = scene.random().direction();
    const Vec3 velocity = scene.vary(8.0F) * direction + Vec3(0.0F, 6.0F, 0.0F);
    scene.add("[[event]]", {{"do", tomlText("throw")},
                            {"frame", frame},
                            {"target", tomlText("wheel-kind-1" + number)},
                            {"velocity", tomlVector(velocity)},
                            {"spin", "[0, 2, 5]"}});
  }
}

void wheelStack(FamilyScene& scene) {
  scene.begin("a stack of wheels", 420);
  addPlane(scene);
  const Wheels wheels = addWheels(scene, 1);
  scene.add("[[object]]", {{"name", tomlText("wheel")},
                           {"model", tomlText(wheels.models.front().file)},
                           {"friction", randomFriction(scene)},
                           {"may_rest", "false"},
                           {"stack", "{ count = " + std::to_string(std::max(2, scene.count(20))) + " }"}});
}

void addWalls(FamilyScene& scene, float side) {
  const float out = 0.5F * side;
  for (const float at : {-1.0F, 1.0F}) {
    const std::string end = at < 0.0F ? "-1" : "-2";
    addStaticBox(scene, "wall-x" + end, {0.4F, 12.0F, side}, {at * out, 6.0F, 0.0F});
    addStaticBox(scene, "wall-z" + end, {side, 12.0F, 0.4F}, {0.0F, 6.0F, at * out});
    addStaticBox(scene, "partition" + end, {0.3F, 3.0F, 0.35F * side}, {0.0F, 1.5F, at * 0.3F * side});
  }
}

void furnishedRooms(FamilyScene& scene) {
  scene.begin("ships and wheels rain into rooms with tables and bowls", 480);
  addPlane(scene);
  const float side = scene.side(26.0F, 20.0F);
  addWalls(scene, side);
  const Vec3 size{scene.vary(2.5F), scene.vary(1.0F), scene.vary(1.5F)};
  const FamilyModel table = scene.addModel("table", makeTable(size), 40.0F);
  const auto places = gridPlaces(16, Vec3(0.24F * side), 1, 0.0F);
  scene.addBodiesAt("table", {table}, places, {{"motion", tomlText("static")}});
  const float radius = scene.vary(1.6F);
  scene.add("[[object]]", {{"name", tomlText("bowl")},
                           {"mesh", tomlText(scene.addMesh("bowl", bowlMesh(radius, scene.vary(0.8F))))},
                           {"list", "[" + tomlVector({0.12F * side, 0.1F, 0.0F}) + ", " +
                                        tomlVector({-0.12F * side, 0.1F, 0.0F}) + "]"}});
  Models models = addShips(scene, 2);
  const Wheels wheels = addWheels(scene, 2);
  models.insert(models.end(), wheels.models.begin(), wheels.models.end());
  rain(scene, models, scene.count(100), 0.7F * side, 3.0F);
}

void quietShips(FamilyScene& scene) {
  scene.begin("ships that turn slowly and never meet", 300, false);
  const Models ships = addShips(scene, 4);
  const float spacing = scene.vary(9.0F);
  scene.addBodiesAt("ship", ships, gridPlaces(scene.count(300), Vec3(spacing), 4, 0.0F),
                    {{"spin", "{ random = 0.5 }"}, {"may_rest", "false"}});
}

struct Family {
  FamilyInfo info;
  void (*make)(FamilyScene& scene);
};

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {{"ships_mesh", "300 ships rain on a terrain of 20 000 triangles"}, shipsOnMesh},
      {{"ships_heights", "the same on a height field"}, shipsOnHeights},
      {{"wheels_mesh", "80 wheels rain on a terrain of triangles"}, wheelsOnMesh},
      {{"wheels_box", "80 wheels rain on a box of 100 m"}, wheelsOnBox},
      {{"wheels_plane", "80 wheels rain on a plane"}, wheelsOnPlane},
      {{"bowl", "120 ships and wheels drop into a bowl of triangles"}, dropsIntoBowl},
      {{"implosion", "200 ships are drawn to one point in space"}, implosion},
      {{"wall", "ships are thrown at a wall and a tower of boxes"}, shipsAtWall},
      {{"boxes_and_ships", "50 ships rain on 3000 boxes"}, boxesAndShips},
      {{"ragdolls", "60 jointed figures fall on a terrain of triangles"}, ragdolls},
      {{"sleepers", "1000 wheels, most of them asleep"}, sleepers},
      {{"wheel_stack", "a stack of 20 wheels"}, wheelStack},
      {{"rooms", "100 ships and wheels rain into furnished rooms"}, furnishedRooms},
      {{"quiet", "300 ships that never meet"}, quietShips},
  };
  return all;
}

}  // namespace

const std::vector<FamilyInfo>& sceneFamilies() {
  static const std::vector<FamilyInfo> infos = [] {
    std::vector<FamilyInfo> all;
    for (const Family& family : families()) all.push_back(family.info);
    return all;
  }();
  return infos;
}

Result<std::filesystem::path> writeFamily(std::string_view family, const FamilyOptions& options,
                                          const std::filesystem::path& folder) {
  const auto found = std::find_if(families().begin(), families().end(),
                                  [family](const Family& one) { return one.info.name == family; });
  if (found == families().end()) return fail("there is no family \"" + std::string(family) + "\"");
  if (!(options.scale > 0.0 && options.scale <= kMostScale)) {
    return fail("the scale of a family must be above 0 and at most " +
                std::to_string(static_cast<int>(kMostScale)));
  }
  if (options.seed > kMostSeed) {
    return fail("the seed of a family must be at most " + std::to_string(kMostSeed));
  }
  FamilyScene scene(found->info.name, options);
  found->make(scene);
  return scene.write(folder);
}

}  // namespace scatter
