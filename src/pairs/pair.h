#pragma once

#include <cstdint>

#include "collision/part_pair.h"
#include "lod/credit.h"
#include "pairs/foresight.h"
#include "pairs/held_contacts.h"

namespace scatter::pairs {

/// Which overlap of a level's shapes is no reason to press the bodies apart.
enum class CreditKind : std::uint8_t {
  kNone,     ///< None: contacts are what the shapes of the level have.
  kFinest,   ///< Of the finest shapes, a little, when the pair came back to them.
  kCoarser,  ///< Of coarser shapes: contacts are those of the finest ones, which are held.
};

/// The penetration credit of a pair.
struct CreditState {
  CreditKind kind = CreditKind::kNone;
  lod::CreditAccount account{};

  /// Of a pair at a coarser level, in metres of its motion: up to where the held contacts are good and no
  /// others can have come up; how much later an audit may come; and how far it had come when it was last
  /// asked for.
  double freshUntil = 0.0;
  double latest = 0.0;
  double seenMotion = 0.0;

  float gap =
      0.0F;  ///< Between the finest shapes, when it was last measured; negative if they overlap. Metres.

  int landing = 0;  ///< Steps after a switch to the finest level on credit in which bodies may still settle.

  /// Of the finest shapes, what their contacts did not press when the pair left its finest level, metres.
  float easedOverlap = 0.0F;

  /// Whether contacts that are held are of use: on credit, and after its end until the pair has moved.
  [[nodiscard]] bool keepsHeld(double motion) const {
    if (!account.empty()) return true;
    return isCoarser() && motion >= seenMotion && motion < freshUntil;
  }

  /// Of a pair at a coarser level, where contacts that are held stand for those of its own shapes: whose
  /// audits come with motion.
  [[nodiscard]] bool isOpen() const { return isCoarser() && !account.empty(); }

  /// Of a pair at a coarser level.
  [[nodiscard]] bool isCoarser() const { return kind == CreditKind::kCoarser; }
};

/// How a pair came by its contacts in its last step.
enum class ContactOrigin : std::uint8_t {
  kFound,
  kKept,       ///< Those of the step before, where the bodies are now.
  kRecycled,   ///< Moved along with the bodies, all of them or some.
  kGivenBack,  ///< Those of the finest level that were held, with others that were found.
};

/// Two bodies whose bounds overlap, and what they know of each other from step to step. Its level, and what
/// is wanted of it, is the planner's. Owns its manifolds; they are the engine's to free, which must have
/// happened before its end.
struct alignas(64) Pair {
  /// Nothing can be in contact while the bodies' travels add up to less than `quietUntil`, and neither has
  /// jumped. Here, as most pairs are left with no look at more.
  double quietUntil = kAwake;
  int jumps = 0;
  int versions[2]{kNoParts, kNoParts};  ///< Of the bodies' parts that the child pairs are of.
  ContactOrigin origin = ContactOrigin::kFound;
  bool hasFallenBack = false;  ///< The engine's own algorithm collides the bodies.
  bool restarted = false;      ///< It began without contacts when it last looked for some.

  /// Of the step under way, until it has been made use of: what was found out about it.
  Foresight* foresight = nullptr;

  PartPair parts{};  ///< At the pair's level.

  CreditState credit{};
  HeldContacts held{};

  static constexpr double kAwake = -1e18;
  static constexpr int kNoParts = -1;

  /// Whether the bodies have the parts that the child pairs are of.
  [[nodiscard]] bool isOf(const PlacedBodies& bodies) const {
    return versions[0] == bodies.versions[0] && versions[1] == bodies.versions[1];
  }

  /// Gives the child pairs' manifolds back to the engine, and forgets the child pairs; dropAll() those that
  /// are held, too.
  void dropContacts(PairEngine& engine);
  void dropAll(PairEngine& engine);

  /// Takes in what became of contacts in the foresight, if there is one; there is none any more.
  void closeForesight(PairEngine& engine);

  /// Calls `use(manifold)` for those that are held, then for those of the child pairs.
  template <class Use>
  void forEachManifold(Use&& use) const {
    for (void* manifold : held.manifolds()) use(manifold);
    for (const ChildPair& child : parts.children()) {
      if (child.contact != nullptr) use(child.contact);
    }
    for (void* manifold :
         foresight != nullptr ? std::span<void* const>(foresight->dropped) : std::span<void* const>())
      use(manifold);
  }

  /// Calls `use(contact)` for those of the child pairs that have one, which may be changed.
  template <class Use>
  void forEachContact(Use&& use) {
    for (ChildPair& child : parts.children()) {
      if (child.contact != nullptr) use(child.contact);
    }
  }

  /// As new, but with the memory that it has.
  void renew();
};

}  // namespace scatter::pairs
