#pragma once

#include "collision/part_pair.h"
#include "pairs/contact_point.h"
#include "pairs/contact_tally.h"

namespace scatter::pairs {

/// The contact manifolds of two bodies in one step, as the engine has them. A manifold holds a few contact
/// points of two parts, and is known by an address. outlasts(manifold) takes in where the bodies are, and
/// drops the points that have come apart.
class Manifolds : public ContactKeeper {
 public:
  /// Parts closer than this are in contact, metres.
  [[nodiscard]] virtual float threshold() const = 0;

  [[nodiscard]] virtual void* newManifold() = 0;
  virtual void release(void* manifold) = 0;
  [[nodiscard]] virtual int countPoints(const void* manifold) const = 0;
  [[nodiscard]] virtual bool isFull(const void* manifold) const = 0;
  [[nodiscard]] virtual ContactPoint point(const void* manifold, int index) const = 0;

  /// Adds a manifold and its points.
  virtual void addTo(ContactTally& tally, const void* manifold) const = 0;

  /// Takes over distance and ease; the rest is as it was. What a program has made elastic is not eased.
  virtual void write(void* manifold, int index, const ContactPoint& point) = 0;

  /// As outlasts(). By how far the point that has slid least has done so since it was found, metres; infinite
  /// if none is left.
  [[nodiscard]] virtual float carry(void* manifold) = 0;

  /// The distance of a point where the bodies are now, without credit.
  [[nodiscard]] virtual float distanceNow(const void* manifold, int index) const = 0;

  /// Appends a copy of a point with all that the engine keeps with it; a program's data goes to the copy.
  virtual void move(void* from, int index, void* to) = 0;

  /// Adds the impulses that a point bears to those of another.
  virtual void addImpulses(const void* from, int index, void* to, int indexTo) = 0;

  /// A manifold is going to be looked at soon.
  virtual void prefetch(const void* /*manifold*/) const {}
};

}  // namespace scatter::pairs
