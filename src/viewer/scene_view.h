#pragma once

#include <scatter/lab/run_history.h>
#include <scatter/world/observation.h>
#include <scatter/world/world.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viewer/action.h"
#include "viewer/body_looks.h"
#include "viewer/cutaway.h"
#include "viewer/debug_views.h"
#include "viewer/drawing/projection.h"
#include "viewer/level_marks.h"

namespace scatter::viewer {

/// A moment of a run, to be drawn.
struct Moment {
  const RunHistory* history = nullptr;
  std::uint64_t frame = 0;  ///< One that the history has.

  /// How far the bodies are on their way from the frame before to this one.
  float fraction = 1.0F;

  /// What the physics says of it; null of a moment that is past.
  const Observation* observed = nullptr;

  std::optional<BodyId> picked{};
};

/// The bodies of a run as items of a picture.
class SceneView {
 public:
  /// The looks must outlive it.
  explicit SceneView(BodyLooks& looks) : looks_(looks) {}

  /// Kinds of another scene get colours from the first on.
  void forgetKinds() { kinds_.clear(); }

  /// Adds items, and lines around what is picked; a level ground becomes part of the scenery. Of what is cut
  /// away, little more than the edges is left.
  void add(const Moment& moment, const DebugViewSet& views, const Cutaway& cutaway, View& view);

  /// The bodies that can move, with what meets what.
  [[nodiscard]] std::vector<Actor> actors(const Moment& moment);

  /// The body that can move and is met first by a ray, closer than `limit` metres.
  [[nodiscard]] std::optional<BodyId> pick(const Moment& moment, const Ray& ray, float limit);

  /// The bodies that cannot move, but for endless ones. Their surfaces live as long as the looks.
  [[nodiscard]] std::vector<Obstacle> obstacles(const Moment& moment);

 private:
  struct Shown;

  void addBody(const Shown& shown, const DebugViewSet& views, View& view);
  void addWall(const Shown& shown, Item item, View& view);
  void addLevels(const Shown& shown, View& view);
  [[nodiscard]] Color colorOf(const Shown& shown, const DebugViewSet& views);
  [[nodiscard]] Color ownColor(const BodyDef& def);

  BodyLooks& looks_;
  std::map<std::string, std::size_t> kinds_;  ///< Names without their numbers, in order of appearance.
};

/// Completes the scenery of a view that has its items: stars where there is no ground, and how far is seen.
/// `distance`: from the camera to what it looks at, metres.
void finishScenery(float distance, View& view);

}  // namespace scatter::viewer
