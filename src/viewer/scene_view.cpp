#include "viewer/scene_view.h"

#include <scatter/lab/selection.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "viewer/palette.h"

namespace scatter::viewer {
namespace {

using Levels = std::shared_ptr<const LevelSet>;

constexpr float kGhost = 0.16F;  // alpha
constexpr float kLevelGround = 0.99F;
constexpr float kMarkGlow = 0.25F;     // little enough that the body's form is still seen
constexpr float kCutAway = 0.05F;      // alpha of what is cut away,
constexpr float kCutAwayEdge = 0.18F;  // and of its edges
constexpr int kInsets = 8;
constexpr float kInset = 0.003F;     // metres
constexpr float kMostInset = 0.02F;  // by half of the thinnest side
constexpr Color kStaticColor{0.40F, 0.43F, 0.48F, 1.0F};
constexpr Color kEdgeColor{0.75F, 0.82F, 0.9F, 1.0F};

const std::vector<Color>& kindColors() {
  static const std::vector<Color> kColors{{0.55F, 0.66F, 0.80F, 1.0F}, {0.86F, 0.58F, 0.36F, 1.0F},
                                          {0.58F, 0.55F, 0.52F, 1.0F}, {0.62F, 0.74F, 0.52F, 1.0F},
                                          {0.78F, 0.70F, 0.45F, 1.0F}, {0.70F, 0.55F, 0.70F, 1.0F},
                                          {0.50F, 0.70F, 0.70F, 1.0F}, {0.80F, 0.80F, 0.80F, 1.0F}};
  return kColors;
}

bool isLevelGround(const BodyDef& def) {
  const auto* plane = std::get_if<Plane>(&def.shape);
  return plane != nullptr && plane->normal.y > kLevelGround * glm::length(plane->normal);
}

Transform between(const Transform& from, const Transform& to, float share) {
  return {glm::mix(from.position, to.position, share), glm::slerp(from.rotation, to.rotation, share)};
}

Color mixed(const Color& color, const glm::vec3& other, float share) {
  return {glm::mix(glm::vec3(color), other, share), color.a};
}

const ObservedBody* observedOf(const Observation* observed, BodyId body) {
  if (observed == nullptr) return nullptr;
  const auto found = std::lower_bound(observed->bodies.begin(), observed->bodies.end(), body,
                                      [](const ObservedBody& one, BodyId id) { return one.body < id; });
  return found != observed->bodies.end() && found->body == body ? &*found : nullptr;
}

/// Scenes build rooms of boxes whose faces lie in one plane; drawn so, they would flicker against each other.
Vec3 insetOf(const Box& box, int number) {
  const float thinnest = std::min({box.halfExtents.x, box.halfExtents.y, box.halfExtents.z});
  return Vec3(std::min(kInset * static_cast<float>(number % kInsets), kMostInset * thinnest));
}

/// A box that lies flat.
bool isSlab(const Box& box, const Transform& pose) {
  const Vec3& half = box.halfExtents;
  const bool flat = 2.0F * half.y < std::min(half.x, half.z);
  return flat && (pose.rotation * Vec3(0.0F, 1.0F, 0.0F)).y > kLevelGround;
}

/// Of several slabs, such as a floor and a ceiling, shadows fall on the lowest.
void keepLowestFloor(std::vector<Item>& items) {
  Item* lowest = nullptr;
  for (Item& item : items) {
    if (!std::exchange(item.isFloor, false)) continue;
    if (lowest == nullptr || item.pose.position.y < lowest->pose.position.y) lowest = &item;
  }
  if (lowest != nullptr) lowest->isFloor = true;
}

/// What each body took of the last step, units: half of what its pairs did, all of it where the other body
/// cannot move.
std::map<BodyId, float> costOfBodies(const Moment& moment) {
  std::map<BodyId, float> costs;
  const auto moves = [&moment](BodyId body) {
    const BodyDef* def = moment.history->def(body);
    return def != nullptr && def->motion != Motion::kStatic;
  };
  for (const ObservedPair& pair : moment.observed->pairs) {
    const float share = moves(pair.a) && moves(pair.b) ? 0.5F : 1.0F;
    for (const BodyId body : {pair.a, pair.b}) costs[body] += share * pair.units;
  }
  return costs;
}

void addEdges(const Item& item, float alpha, std::vector<Line>& lines) {
  const auto corner = [&](int bits) {
    return item.pose(item.scale * Vec3((bits & 1) != 0 ? 1.0F : -1.0F, (bits & 2) != 0 ? 1.0F : -1.0F,
                                       (bits & 4) != 0 ? 1.0F : -1.0F));
  };
  const Color color(glm::vec3(kEdgeColor), alpha);
  for (int from = 0; from < 8; ++from) {
    for (const int axis : {1, 2, 4}) {
      if ((from & axis) == 0) lines.push_back({corner(from), corner(from | axis), color});
    }
  }
}

/// Whether a ray meets a ball closer than `limit`.
bool mayMeet(const Ray& ray, const Vec3& center, float radius, float limit) {
  const Vec3 way = center - ray.origin;
  const float along = glm::dot(way, ray.direction);
  if (along < -radius || along > limit + radius) return false;
  return glm::dot(way, way) - along * along <= radius * radius;
}

}  // namespace

struct SceneView::Shown {
  BodyId body{};
  const BodyDef& def;
  Transform pose;
  int level = 1;
  bool asleep = false;
  bool picked = false;
  int staticNumber = 0;                    ///< Of those that cannot move, in the order of the scene.
  float cutAway = 0.0F;                    ///< As in Cutaway::share().
  const ObservedBody* observed = nullptr;  ///< Null of a moment that is past.
  LevelMark mark{};
  std::optional<float> cost{};  ///< Units of the last step, if they are shown.
};

Color SceneView::ownColor(const BodyDef& def) {
  if (def.motion == Motion::kStatic) return kStaticColor;
  const auto [kind, isNew] = kinds_.emplace(nameStem(def.name), kinds_.size());
  const Color color = kindColors()[kind->second % kindColors().size()];
  return def.motion == Motion::kDynamic ? color : mixed(color, glm::vec3(0.4F), 0.6F);
}

Color SceneView::colorOf(const Shown& shown, const DebugViewSet& views) {
  if (shown.cost) return costColor(*shown.cost);
  Color color = ownColor(shown.def);
  const auto* levels = std::get_if<Levels>(&shown.def.shape);
  if (views.has(DebugView::kIslands) && shown.observed != nullptr) {
    const std::int64_t island = shown.observed->island;
    color = island < 0 ? Color(0.3F, 0.3F, 0.32F, 1.0F) : distinctColor(static_cast<std::uint64_t>(island));
  } else if (views.has(DebugView::kLevels) && levels != nullptr && (*levels)->count() > 1) {
    color = levelColor(shown.observed != nullptr ? shown.observed->coarsestLevel : shown.level,
                       (*levels)->count());
  }
  if (views.has(DebugView::kSleeping)) {
    if (shown.asleep) color = mixed(color, glm::vec3(0.05F, 0.06F, 0.12F), 0.75F);
    if (shown.observed != nullptr && shown.observed->frozen)
      color = mixed(color, glm::vec3(0.7F, 0.85F, 1.0F), 0.7F);
  }
  const LevelMark& mark = shown.mark;
  color = mixed(color, glm::vec3(kRetractedColor), 0.8F * mark.retracted);
  color = mixed(color, glm::vec3(levelColor(1, 2)), 0.9F * mark.coarser);
  color = mixed(color, glm::vec3(levelColor(2, 2)), 0.9F * mark.finer);
  color = mixed(color, glm::vec3(kRequestColor), 0.7F * mark.requested);
  return shown.picked ? mixed(color, glm::vec3(1.0F), 0.35F) : color;
}

/// All levels of a body: the coarser ones as ghosts around the finer ones.
void SceneView::addLevels(const Shown& shown, View& view) {
  const auto* levels = std::get_if<Levels>(&shown.def.shape);
  if (levels == nullptr) return;
  const int count = (*levels)->count();
  const int inUse = shown.observed != nullptr ? shown.observed->coarsestLevel : shown.level;
  for (int level = count; level >= 1; --level) {
    Item item = looks_.level(*levels, level);
    item.pose = shown.pose;
    item.color = levelColor(level, count);
    item.wireframe = true;
    if (level != inUse) {
      item.color.a = 2.0F * kGhost;
    } else {
      item.glow = 1.0F;
    }
    view.items.push_back(item);
  }
}

void SceneView::addBody(const Shown& shown, const DebugViewSet& views, View& view) {
  if (isLevelGround(shown.def)) {
    view.scenery.ground = std::get<Plane>(shown.def.shape).offset;
    return;
  }
  const bool shapes = views.has(DebugView::kShapes);
  Item item = shapes ? looks_.shape(shown.body, shown.def) : looks_.drawn(shown.body, shown.def);
  item.pose = shown.pose;
  item.wireframe = shapes;
  item.color = colorOf(shown, views);
  item.glow = kMarkGlow * std::max({shown.mark.coarser, shown.mark.finer, shown.mark.requested});
  if (shown.def.motion == Motion::kStatic) {
    addWall(shown, item, view);
    return;
  }
  view.items.push_back(item);
  if (shown.picked && views.has(DebugView::kLevels)) addLevels(shown, view);
}

void SceneView::addWall(const Shown& shown, Item item, View& view) {
  const auto* box = std::get_if<Box>(&shown.def.shape);
  if (box != nullptr && !shown.def.mesh) item.scale -= insetOf(*box, shown.staticNumber);
  item.color.a = glm::mix(item.color.a, kCutAway, shown.cutAway);
  item.castsShadow = false;
  item.isFloor = box != nullptr && isSlab(*box, shown.pose) && !item.wireframe && item.color.a >= 1.0F;
  view.items.push_back(item);
  if (box != nullptr && shown.cutAway > 0.0F) addEdges(item, kCutAwayEdge * shown.cutAway, view.lines);
}

void SceneView::add(const Moment& moment, const DebugViewSet& views, const Cutaway& cutaway, View& view) {
  const RunHistory::Frame now = moment.history->frame(moment.frame);
  const bool moving = moment.fraction < 1.0F && moment.history->has(moment.frame - 1);
  const RunHistory::Frame before = moment.history->frame(moving ? moment.frame - 1 : moment.frame);
  std::map<BodyId, LevelMark> marks;
  if (views.has(DebugView::kMarks)) marks = levelMarks(*moment.history, moment.frame);
  std::optional<std::map<BodyId, float>> costs;
  if (views.has(DebugView::kCost) && moment.observed != nullptr) costs = costOfBodies(moment);
  int statics = 0;
  for (std::size_t i = 0; i < now.bodies().size(); ++i) {
    const BodyId body = now.bodies()[i];
    const BodyDef* def = moment.history->def(body);
    if (def == nullptr) continue;
    Shown shown{body, *def, now.pose(i)};
    shown.level = now.level(i);
    shown.asleep = now.asleep(i);
    shown.picked = moment.picked == body;
    if (def->motion == Motion::kStatic) shown.staticNumber = statics++;
    shown.cutAway = cutaway.share(body);
    shown.observed = observedOf(moment.observed, body);
    if (costs && def->motion != Motion::kStatic) shown.cost = (*costs)[body];
    // A floor has pairs with all that lies on it: it would flash all the time.
    const auto mark = def->motion != Motion::kStatic ? marks.find(body) : marks.end();
    if (mark != marks.end()) shown.mark = mark->second;
    if (const auto earlier = moving ? before.find(body) : std::nullopt) {
      shown.pose = between(before.pose(*earlier), shown.pose, moment.fraction);
    }
    addBody(shown, views, view);
  }
  keepLowestFloor(view.items);
}

std::vector<Actor> SceneView::actors(const Moment& moment) {
  const RunHistory::Frame now = moment.history->frame(moment.frame);
  const bool hasBefore = moment.frame > 0 && moment.history->has(moment.frame - 1);
  const RunHistory::Frame before = moment.history->frame(hasBefore ? moment.frame - 1 : moment.frame);
  std::vector<Actor> actors;
  for (std::size_t i = 0; i < now.bodies().size(); ++i) {
    const BodyId body = now.bodies()[i];
    const BodyDef* def = moment.history->def(body);
    if (def == nullptr || def->motion == Motion::kStatic) continue;
    Actor actor{now.pose(i).position, looks_.radius(body, *def), 0.0F, now.asleep(i)};
    // As long as no body comes or goes, all have the same places in both frames.
    const bool stayed = i < before.bodies().size() && before.bodies()[i] == body;
    if (stayed) actor.moved = glm::distance(actor.position, before.pose(i).position);
    actors.push_back(actor);
  }
  markMeetings(actors);
  return actors;
}

std::optional<BodyId> SceneView::pick(const Moment& moment, const Ray& ray, float limit) {
  const RunHistory::Frame now = moment.history->frame(moment.frame);
  std::optional<BodyId> nearest;
  for (std::size_t i = 0; i < now.bodies().size(); ++i) {
    const BodyId body = now.bodies()[i];
    const BodyDef* def = moment.history->def(body);
    if (def == nullptr || def->motion == Motion::kStatic) continue;
    const Transform& pose = now.pose(i);
    if (!mayMeet(ray, pose.position, looks_.radius(body, *def), limit)) continue;
    const glm::quat back = glm::conjugate(pose.rotation);
    const float hit = looks_.surface(body, *def)
                          .nearestHit(back * (ray.origin - pose.position), back * ray.direction, limit);
    if (!(hit < limit)) continue;
    limit = hit;
    nearest = body;
  }
  return nearest;
}

std::vector<Obstacle> SceneView::obstacles(const Moment& moment) {
  const RunHistory::Frame now = moment.history->frame(moment.frame);
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < now.bodies().size(); ++i) {
    const BodyId body = now.bodies()[i];
    const BodyDef* def = moment.history->def(body);
    if (def == nullptr || def->motion != Motion::kStatic || isLevelGround(*def)) continue;
    obstacles.push_back({body, now.pose(i), looks_.radius(body, *def), &looks_.surface(body, *def)});
  }
  return obstacles;
}

void finishScenery(float distance, View& view) {
  view.scenery.stars = !view.scenery.ground && std::none_of(view.items.begin(), view.items.end(),
                                                            [](const Item& item) { return item.isFloor; });
  view.scenery.fadeRadius = std::max(40.0F, 4.0F * distance);
}

}  // namespace scatter::viewer
