#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "pairs/contact_recycling.h"
#include "pairs/ground_pair.h"
#include "pairs/pair.h"
#include "pairs/pair_engine.h"

namespace scatter::pairs {

/// Lets several threads ask for the world bounds of the same bodies.
class BoundsLocks {
 public:
  void compute(PartBody& body) {
    const std::scoped_lock lock(
        locks_[(reinterpret_cast<std::uintptr_t>(&body) / sizeof(PartBody)) % kLocks]);
    static_cast<void>(body.worldBounds());
  }
  void compute(const PlacedBodies& bodies) {
    compute(*bodies.a);
    compute(*bodies.b);
  }

 private:
  static constexpr std::size_t kLocks = 64;
  std::array<std::mutex, kLocks> locks_;
};

/// What a contact keeper can tell, or do, on any thread.
class ContactPeek {
 public:
  ContactPeek() = default;
  ContactPeek(const ContactPeek&) = delete;
  ContactPeek& operator=(const ContactPeek&) = delete;
  virtual ~ContactPeek() = default;

  /// What ContactKeeper::outlasts() is going to return for a contact of the pair at work. Changes nothing,
  /// unless carries().
  [[nodiscard]] virtual bool wouldOutlast(void* contact) const = 0;

  /// The same of Manifolds::carry().
  [[nodiscard]] virtual float wouldSlide(void* contact) const = 0;

  /// Whether these do what they tell, so that it is not done again.
  [[nodiscard]] virtual bool carries() const { return false; }

  /// Whether a contact of the pair that is held is going to have points where the bodies are. Changes
  /// nothing.
  [[nodiscard]] virtual bool keepsPoints(const void* contact) const = 0;

  /// Whether PairEngine::detect() works on any thread for these two parts.
  [[nodiscard]] virtual bool detectsAnywhere(const ChildPair& child) const = 0;
};

/// Memory of one thread.
struct ForesightScratch {
  PairScratch parts{};
  RecyclingScratch recycling{};
  std::vector<std::unique_ptr<Foresight>> pool{};
  std::size_t used = 0;
  std::vector<std::unique_ptr<StepAhead[]>> stepPool{};
  std::size_t stepsUsed = 0;

  /// Empty, but with the memory of an earlier one. Good until `used` is 0 again, or `stepsUsed`.
  [[nodiscard]] Foresight& take();
  [[nodiscard]] StepAhead& takeStep();

  /// The last one, which is not needed any more.
  void giveBackStep() { --stepsUsed; }
};

/// Whether what is found out about a pair is independent of the rest of its step: it looks for contacts of
/// its own level, whose shapes are those of `bodies`, and is not going to be audited.
[[nodiscard]] bool isForeseeable(const Pair& pair, const PlacedBodies& bodies, const ContactPeek& peek);

/// Finds it out, but for a pair whose contacts only move along: that has no foresight. Changes the pair and
/// nothing else but the bodies' bounds, so that any number of pairs can be foreseen at once, in any order;
/// the bodies must be where they are going to be in the step. Sets Pair::foresight. Returns whether the rest
/// of the step needs of the engine only manifolds and what works on any thread.
bool foresee(Pair& pair, const PlacedBodies& bodies, const PairSteps& steps, const ContactPeek& peek,
             BoundsLocks& locks, ForesightScratch& scratch);

/// The same of a body and its ground, which is at `ground`. `level`: that the pair is going to look at. Of a
/// half-space nothing is found out, but the step can be made on any thread. Nothing is to be found out of a
/// pair that onlyCarries() contacts along. `engine` is asked for pieces alone, where those near the body are
/// not known any more; `region`: memory for them.
[[nodiscard]] bool onlyCarries(const GroundPair& pair, const PlacedBody& placed, int level,
                               const Frame& ground, int groundVersion, const PairSteps& steps);

/// Nor of one that keeps the contacts of the step before, as its plan would have it.
[[nodiscard]] bool onlyKeeps(const GroundPair& pair, const PairPlan& plan, const PlacedBody& placed,
                             const Frame& ground, int groundVersion);
[[nodiscard]] bool isForeseeable(const GroundPair& pair, const PlacedBody& placed, int level,
                                 const Frame& ground, int groundVersion, const PairSteps& steps);
bool foresee(GroundPair& pair, const PlacedBody& placed, const Frame& ground, const PairSteps& steps,
             GroundEngine& engine, RegionScratch& region, BoundsLocks& locks, ForesightScratch& scratch);

}  // namespace scatter::pairs
