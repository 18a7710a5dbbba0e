#pragma once

#include <array>
#include <optional>

#include "collision/part_pair.h"
#include "pairs/manifolds.h"

namespace scatter::pairs {

/// Two bodies with their shapes of one level, where they are now. Not owned.
struct PlacedBodies {
  PartBody* a = nullptr;
  PartBody* b = nullptr;
  int versions[2]{};  ///< Change when a body's parts do.
};

/// What a pair needs of the engine that it lives in, in one step: its two bodies at any level, its manifolds,
/// and the detector for what scatter::PartPair does not decide.
class PairEngine : public Manifolds {
 public:
  /// The bodies with their shapes of a level; from now on contacts are those of these shapes. False if a
  /// shape is no list of parts (any more).
  [[nodiscard]] virtual bool place(int level, PlacedBodies& bodies) = 0;

  /// PlacedBodies::versions as place() would tell them; none if it would refuse. Where the
  /// bodies are now it need not take in.
  [[nodiscard]] virtual std::optional<std::array<int, 2>> versionsAt(int level) = 0;

  /// The parts of body 0 or 1 at a level, as they are now, and where the body is.
  [[nodiscard]] virtual const PartList& partsOf(int body, int level) = 0;
  [[nodiscard]] virtual Frame frameOf(int body) const = 0;

  /// Two points nearer to each other than this are one, metres.
  [[nodiscard]] virtual float pointDistance() const = 0;

  /// Lets the engine's own algorithm collide the bodies, instead of the pair; the pair has no manifolds then.
  virtual void fallBack() = 0;

  // Contacts of two parts of the bodies that were placed last. Both make the child's manifold when it is
  // needed.
  virtual void add(ChildPair& child, const PartContact& contact) = 0;
  virtual void detect(PartPair& parts, ChildPair& child) = 0;

  // What an engine may have of its own.

  /// A program's filter for two parts.
  [[nodiscard]] virtual bool letsThrough(const ChildPair& /*child*/) const { return true; }

  /// Whether two parts whose distance makes a contact may have one.
  [[nodiscard]] virtual bool mayBegin(const ChildPair& /*child*/) const { return true; }

  /// Whether two parts whose bounds are apart keep the contacts that they have.
  [[nodiscard]] virtual bool overlooks(const ChildPair& /*child*/) const { return false; }

  /// After a look at two parts that have a manifold.
  virtual void looked(const ChildPair& /*child*/) {}
};

}  // namespace scatter::pairs
