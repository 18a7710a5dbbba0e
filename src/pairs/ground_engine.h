#pragma once

#include <optional>

#include "pairs/ground_pieces.h"
#include "pairs/manifolds.h"

namespace scatter::pairs {

/// A body with its shape of one level, where it is now. Not owned.
struct PlacedBody {
  PartBody* body = nullptr;
  int version = 0;  ///< Changes when its parts do.
};

/// The half-space normal · x <= offset is solid; the normal has length 1.
struct HalfSpace {
  Vec3 normal{0.0F};
  float offset = 0.0F;
};

/// What a body and its ground need of the engine that they live in, in one step. A manifold has the contacts
/// of one of the body's parts with all of the ground.
class GroundEngine : public Manifolds {
 public:
  /// The body with its shape of a level; from now on contacts are those of this shape. False if the shape is
  /// no list of parts (any more), or the ground is none that is known.
  [[nodiscard]] virtual bool place(int level, PlacedBody& body) = 0;

  [[nodiscard]] virtual Frame groundFrame() const = 0;

  /// How far the body is about to move against the ground in this step at its velocity, in the ground's
  /// frame; zero if the engine does not know.
  [[nodiscard]] virtual Vec3 wayAhead() const = 0;

  /// Changes when the ground's shape does, as far as engines tell.
  [[nodiscard]] virtual int groundVersion() = 0;

  /// By which the ground's pieces are widened, metres.
  [[nodiscard]] virtual float groundMargin() const = 0;

  /// The ground is this, in its frame, and has no pieces.
  [[nodiscard]] virtual std::optional<HalfSpace> halfSpace() const = 0;

  /// The pieces that reach into a box in the ground's frame, in an order that is the same each time, or what
  /// of a large one is in the box. False if there are more than can be dealt with.
  [[nodiscard]] virtual bool collect(const Vec3& low, const Vec3& high, GroundPieces& pieces) = 0;

  /// How far a large convex ground reaches along a direction in its frame, without its margin: all of it, not
  /// only the piece that collect() tells.
  [[nodiscard]] virtual float reach(const Vec3& direction) const = 0;

  /// Lets the engine's own algorithm collide the two, instead of the pair. Whether it finds contacts; what it
  /// has found stays with it until the next place().
  virtual bool fallBack() = 0;

  /// After a look, of every manifold.
  virtual void looked(void* /*manifold*/) {}

  /// Whether a program lets a part meet the ground at all.
  [[nodiscard]] virtual bool letsMeet(int part) const = 0;

  /// Whether a part keeps the contacts that it has, as far as they are good.
  [[nodiscard]] virtual bool keeps(int part) = 0;

  /// Whether the engine lets a piece and a part come into contact: its bounds, a program's filter. `pieces`
  /// are those that were collected last; child pairs are of one of them and of a part of the body.
  [[nodiscard]] virtual bool mayMeet(const GroundPieces& pieces, const ChildPair& child) = 0;

  /// Adds a contact to a part's manifold; `contact` is in the frame `frame`, with the piece as A.
  virtual void add(void* manifold, const GroundPieces& pieces, const ChildPair& child,
                   const PartContact& contact, const Frame& frame) = 0;

  /// Lets the engine's own detector look at a triangle and a part, for at most one contact: false if there is
  /// none. The manifold is the part's, and stays as it is.
  [[nodiscard]] virtual bool find(void* manifold, const GroundPieces& pieces, const ChildPair& child,
                                  const Frame& frame, PartContact& contact) = 0;

  /// Lets the engine's own detector add what it finds of any other piece, or of the half-space.
  virtual void detect(void* manifold, const GroundPieces& pieces, const ChildPair& child) = 0;
};

}  // namespace scatter::pairs
