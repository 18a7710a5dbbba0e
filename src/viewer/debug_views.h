#pragma once

#include <scatter/world/observation.h>
#include <scatter/world/world.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "viewer/renderer.h"

namespace scatter::viewer {

/// What can be shown of a simulation beside its bodies' meshes.
enum class DebugView : std::uint8_t {
  kBounds,      ///< Boxes that the broadphase has, orange around what waits for another level.
  kShapes,      ///< The finest collision shapes, as wireframes, instead of meshes.
  kLevels,      ///< The levels in use in their colours; of the picked body all levels, those not in use as
                ///< ghosts.
  kPairLevels,  ///< A line between bodies that meet, in the colour of the level that they meet with.
  kContacts,    ///< Contact points and normals.
  kCredit,      ///< Pairs and contacts on penetration credit.
  kIslands,     ///< Bodies that are solved together have one colour.
  kSleeping,    ///< What sleeps is dark, what is frozen is pale blue.
  kPairs,       ///< Pairs of the broadphase.
  kVelocities,  ///< The way of the next quarter of a second.
  kMarks,       ///< Requests flash, switches pulse, retractions fade.
  kCost,        ///< What bodies, and pairs of them, took of the last step.
};
inline constexpr std::size_t kDebugViewCount = 12;

/// Which views are shown.
struct DebugViewSet {
  std::array<bool, kDebugViewCount> shown{};

  [[nodiscard]] bool has(DebugView view) const { return shown[static_cast<std::size_t>(view)]; }
  void set(DebugView view, bool on) { shown[static_cast<std::size_t>(view)] = on; }
  void toggle(DebugView view) { set(view, !has(view)); }
  bool operator==(const DebugViewSet&) const = default;

  /// What they need to know of the physics.
  [[nodiscard]] ObservationParts parts() const;
};

/// Of a view: what commands and scripts call it, such as "contacts", and what it shows, in a line.
struct DebugViewInfo {
  DebugView view;
  std::string_view name;
  std::string_view shows;
};
[[nodiscard]] const std::array<DebugViewInfo, kDebugViewCount>& debugViews();

/// Adds the views that are made of lines: bounds, pair levels, contacts, credit, pairs, cost, velocities.
void addDebugLines(const DebugViewSet& views, const World& world, const Observation& observed, View& view);

/// Those of contacts and of their credit alone.
void addContactLines(const DebugViewSet& views, std::span<const ObservedContact> contacts, View& view);

}  // namespace scatter::viewer
