#pragma once

#include <scatter/math.h>
#include <scatter/world/body.h>
#include <scatter/world/level_event.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace scatter {

/// What PhysicsDiagnostics::observe() is asked for; what is left out costs nothing.
struct ObservationParts {
  bool bodies = true;
  bool pairs = true;
  bool contacts = true;
};

/// How far a standing request has come.
enum class RequestState : std::uint8_t {
  kUntried,  ///< Nobody has tried it yet: it is new, or put off for want of budget.
  kBlocked,  ///< The last try was not safe; it will be repeated.
  kAsleep,   ///< Not tried as long as the bodies rest or are frozen.
};

/// A standing request for another level, of a body or of a pair.
struct ObservedRequest {
  int target = 0;
  Scope scope = Scope::kLocal;
  std::string_view policy{};  ///< Who asks: a policy's name, "governor", "program", "default"; never dangles.
  std::uint32_t waitingSteps = 0;  ///< Since it was made.
  RequestState state = RequestState::kUntried;

  /// The body that the last try found in the way, or whose pair holds up the request of a body; 0 if there is
  /// none.
  BodyId blockedBy{};
  std::uint32_t retrySteps = 0;  ///< Blocked: the next try is in so many steps, at least 1.
};

struct ObservedBody {
  BodyId body{};
  Vec3 boundsMin{0.0F};  ///< As the broadphase has them, with its margins; a hybrid's are those of level 1.
  Vec3 boundsMax{0.0F};
  bool asleep = false;  ///< Never of frozen and static bodies.
  bool frozen = false;
  bool held = false;

  /// The least id of the bodies that the engine solves, and puts to sleep, together with it: in contact,
  /// joined or, in Bullet, with overlapping bounds. -1 for what nothing moves: static, kinematic and frozen
  /// bodies.
  std::int64_t island = -1;

  /// Its levels in use: the body's own, or with pair switching the coarsest and the finest over its pairs;
  /// the finest of all if it is in none.
  int coarsestLevel = 1;
  int finestLevel = 1;

  std::optional<ObservedRequest> request{};  ///< For all its pairs, if pairs switch.
};

/// How near the shapes in use are to each other. Of pairs that do not collide, or both rest, as last seen.
enum class Nearness : std::uint8_t {
  kApart,     ///< No contact points.
  kNear,      ///< Contact points, none closer than 1 cm.
  kTouching,  ///< A contact closer than 1 cm, its penetration credit counted.
};

/// Two bodies whose broadphase bounds overlap.
struct ObservedPair {
  BodyId a{};
  BodyId b{};
  int level = 0;       ///< In use, 1 the coarsest; 0 if neither has levels that switch.
  int levelCount = 0;  ///< The finest that the pair could have; 0 as before.
  bool credited = false;
  Nearness nearness = Nearness::kApart;
  std::optional<ObservedRequest> request{};  ///< Pair switching: of this pair.

  /// What it took of the last step, in units of the budget (about microseconds): counted of pairs that
  /// switch, else of its contacts alone; 0 if both bodies rest.
  float units = 0.0F;
};

/// A contact point as the last step was solved with it; where bodies move, they have moved on since. World
/// axes.
struct ObservedContact {
  BodyId a{};
  BodyId b{};
  Vec3 pointA{0.0F};
  Vec3 pointB{0.0F};
  Vec3 normal{0.0F};      ///< From B to A, of length 1.
  float distance = 0.0F;  ///< Metres, negative if deep; `credit` is counted in.
  float credit = 0.0F;    ///< Metres of penetration credit.

  /// Of the finest shapes, kept while the pair is on credit at a coarser level.
  bool kept = false;
  float impulse = 0.0F;  ///< Along the normal in the last step, newton seconds.
};

/// What a debugger of a simulation draws. Bodies are in the order of their ids, pairs and contacts in the
/// engine's, the same run after run.
struct Observation {
  std::vector<ObservedBody> bodies;
  std::vector<ObservedPair> pairs;
  std::vector<ObservedContact> contacts;

  /// Keeps the memory.
  void clear() {
    bodies.clear();
    pairs.clear();
    contacts.clear();
  }
};

}  // namespace scatter
