#include "viewer/debug_views.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "viewer/palette.h"

namespace scatter::viewer {
namespace {

constexpr float kVelocitySeconds = 0.25F;
// Of a contact, by the distance from the camera to what it looks at: as large in every scene.
constexpr float kNormalLength = 0.012F;
constexpr float kCross = 0.0025F;
constexpr float kLeastLine = 8.0F;  // units; lines of all pairs would hide the bodies

void addBox(const Vec3& low, const Vec3& high, const Color& color, std::vector<Line>& lines) {
  const auto corner = [&](int bits) {
    return Vec3((bits & 1) != 0 ? high.x : low.x, (bits & 2) != 0 ? high.y : low.y,
                (bits & 4) != 0 ? high.z : low.z);
  };
  for (int from = 0; from < 8; ++from) {
    for (const int axis : {1, 2, 4}) {
      if ((from & axis) == 0) lines.push_back({corner(from), corner(from | axis), color});
    }
  }
}

void addCross(const Vec3& at, float size, const Color& color, std::vector<Line>& lines) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 arm(0.0F);
    arm[axis] = size;
    lines.push_back({at - arm, at + arm, color});
  }
}

void addBounds(const Observation& observed, std::vector<Line>& lines) {
  for (const ObservedBody& body : observed.bodies) {
    const bool finite = glm::length(body.boundsMax - body.boundsMin) < 1e6F;
    if (finite) addBox(body.boundsMin, body.boundsMax, body.request ? kRequestColor : kBoundsColor, lines);
  }
}

void addVelocities(const World& world, std::vector<Line>& lines) {
  for (const auto& object : world.objects()) {
    const BodyState state = object->state();
    const Vec3 way = kVelocitySeconds * state.linearVelocity;
    if (glm::length(way) > 1e-3F)
      lines.push_back({state.centerOfMass, state.centerOfMass + way, kVelocityColor});
  }
}

/// A contact's points at A and B, and its normal.
void addContact(const ObservedContact& contact, float distance, const Color& color,
                std::vector<Line>& lines) {
  addCross(contact.pointB, kCross * distance, color, lines);
  lines.push_back({contact.pointB, contact.pointB + kNormalLength * distance * contact.normal, color});
}

/// Lines between the centres of bodies. At floors and walls, and whatever else does not move, they end in the
/// nearest place of its bounds: its centre may be far off, or nowhere.
class PairLines {
 public:
  PairLines(const DebugViewSet& views, const World& world, const Observation& observed) : views_(views) {
    for (const auto& object : world.objects()) ends_[object->body()].center = object->state().centerOfMass;
    for (const ObservedBody& body : observed.bodies) {
      const auto end = ends_.find(body.body);
      if (body.island < 0 && end != ends_.end()) end->second.still = &body;
    }
  }

  void add(const ObservedPair& pair, std::vector<Line>& lines) const {
    const auto a = ends_.find(pair.a);
    const auto b = ends_.find(pair.b);
    if (a == ends_.end() || b == ends_.end()) return;
    if (const auto color = colorOf(pair)) {
      lines.push_back({a->second.nearTo(b->second.center), b->second.nearTo(a->second.center), *color});
    }
  }

 private:
  struct End {
    Vec3 center{0.0F};
    const ObservedBody* still = nullptr;  ///< If it is a body that nothing moves.

    [[nodiscard]] Vec3 nearTo(const Vec3& other) const {
      return still != nullptr ? glm::clamp(other, still->boundsMin, still->boundsMax) : center;
    }
  };

  [[nodiscard]] std::optional<Color> colorOf(const ObservedPair& pair) const {
    if (views_.has(DebugView::kCredit) && pair.credited) return kCreditColor;
    if (views_.has(DebugView::kPairLevels) && pair.level > 0 && pair.nearness != Nearness::kApart) {
      return levelColor(pair.level, pair.levelCount);
    }
    if (views_.has(DebugView::kCost) && pair.units >= kLeastLine) return costColor(pair.units);
    if (views_.has(DebugView::kPairs)) return kPairColor;
    return std::nullopt;
  }

  const DebugViewSet& views_;
  std::map<BodyId, End> ends_;
};

}  // namespace

const std::array<DebugViewInfo, kDebugViewCount>& debugViews() {
  static constexpr std::array<DebugViewInfo, kDebugViewCount> kViews{{
      {DebugView::kBounds, "bounds", "boxes of the broadphase; orange: waits for a level"},
      {DebugView::kShapes, "shapes", "finest collision shapes as wireframes"},
      {DebugView::kLevels, "levels", "level in use by colour; of the picked object all levels"},
      {DebugView::kPairLevels, "pair-levels", "lines in the colour of the level that two bodies meet with"},
      {DebugView::kContacts, "contacts", "contact points and normals"},
      {DebugView::kCredit, "credit", "pairs and contacts on penetration credit, violet"},
      {DebugView::kIslands, "islands", "bodies that are solved together have one colour"},
      {DebugView::kSleeping, "sleeping", "what sleeps is dark, what is frozen pale blue"},
      {DebugView::kPairs, "pairs", "lines between bodies whose broadphase boxes overlap"},
      {DebugView::kVelocities, "velocities", "the way of the next quarter of a second"},
      {DebugView::kMarks, "marks", "requests flash, switches pulse, retractions fade"},
      {DebugView::kCost, "cost", "what bodies and pairs took of the last step: blue little, white much"},
  }};
  return kViews;
}

ObservationParts DebugViewSet::parts() const {
  ObservationParts parts;
  parts.pairs = has(DebugView::kPairLevels) || has(DebugView::kPairs) || has(DebugView::kCredit) ||
                has(DebugView::kCost);
  parts.bodies = parts.pairs || has(DebugView::kBounds) || has(DebugView::kLevels) ||
                 has(DebugView::kIslands) || has(DebugView::kSleeping) || has(DebugView::kMarks);
  parts.contacts = has(DebugView::kContacts) || has(DebugView::kCredit);
  return parts;
}

void addDebugLines(const DebugViewSet& views, const World& world, const Observation& observed, View& view) {
  if (views.has(DebugView::kBounds)) addBounds(observed, view.lines);
  if (views.has(DebugView::kVelocities)) addVelocities(world, view.linesOnTop);
  if (!observed.pairs.empty()) {
    const PairLines pairs(views, world, observed);
    for (const ObservedPair& pair : observed.pairs) pairs.add(pair, view.linesOnTop);
  }
  addContactLines(views, observed.contacts, view);
}

void addContactLines(const DebugViewSet& views, std::span<const ObservedContact> contacts, View& view) {
  const float distance = glm::length(view.camera.target - view.camera.eye);
  for (const ObservedContact& contact : contacts) {
    const bool credited = contact.credit > 0.0F;
    if (credited && views.has(DebugView::kCredit)) {
      addContact(contact, distance, kCreditColor, view.linesOnTop);
    } else if (views.has(DebugView::kContacts)) {
      addContact(contact, distance, kContactColor, view.linesOnTop);
    }
  }
}

}  // namespace scatter::viewer
