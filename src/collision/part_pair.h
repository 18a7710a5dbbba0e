#pragma once

#include <scatter/collision/pair_algorithm.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <memory_resource>
#include <span>
#include <vector>

#include "collision/gjk.h"
#include "collision/neighbour_search.h"
#include "collision/part_body.h"

namespace scatter {

PairWork& operator+=(PairWork& work, const PairWork& other);
[[nodiscard]] PairWork operator-(const PairWork& work, const PairWork& other);

/// Two parts, one of each body, that are near each other.
struct ChildPair {
  std::uint16_t a = 0;
  std::uint16_t b = 0;
  WarmSimplex simplex{};
  bool hasAxis : 1 = false;
  bool touching : 1 = false;  ///< Kept by the adapter: `contact` holds contact points.
  bool settled : 1 = false;   ///< Kept by the adapter: its last look found no contact that it had not had.
  bool stale : 1 = false;     ///< Kept by the adapter: its contacts must be found anew.
  Vec3 axis{0.0F};            ///< From A to B, in A's frame, of length 1: the last that told them apart.
  float reachA = 0.0F;        ///< Of A's part along `axis`; infinite if not known.
  float turnAt = 0.0F;        ///< PartPair::turn() at its last look.
  void* contact = nullptr;    ///< The adapter's: its record of contacts. Not owned.

  /// They cannot be in contact while the motion of the pair's listed parts is less than this.
  double wake = std::numeric_limits<double>::lowest();
};

enum class ChildVerdict : std::uint8_t {
  kApart,      ///< No new contact.
  kContact,    ///< A contact that is known exactly.
  kAskEngine,  ///< The engine's own detector must look.
};

/// Of a child pair that is wakeful, what tells whether it sleeps: side by side, as a pile's child pairs do
/// not fit into a cache, and most that are wakeful sleep for the moment.
struct WakefulChild {
  double wake = 0.0;  ///< ChildPair::wake and `touching`, when it was last awake.
  int index = 0;      ///< Of the child pair.
  bool touching = false;
};

/// In A's frame. `distance` is from surface to surface, margins included; negative if deep.
struct PartContact {
  Vec3 axis{0.0F};    ///< From A to B, of length 1.
  Vec3 pointB{0.0F};  ///< On B's surface.
  float distance = 0.0F;
};

/// What the adapter knows of contacts.
class ContactKeeper {
 public:
  ContactKeeper() = default;
  ContactKeeper(const ContactKeeper&) = delete;
  ContactKeeper& operator=(const ContactKeeper&) = delete;
  virtual ~ContactKeeper() = default;

  /// Whether any contact of a child pair is left where the bodies are now.
  virtual bool outlasts(void* contact) const = 0;
};

/// Memory that pairs use in turn.
struct PairScratch {
  /// Of the pair at work, in advance(); without it, contacts of child pairs that are no neighbours are
  /// dropped.
  const ContactKeeper* keeper = nullptr;

  NeighbourSearch search{};
  std::vector<ChildPair> merged{};

  /// After PartPair::advance(): the contacts of child pairs that are not neighbours any more.
  std::vector<void*> dropped{};
};

/// What two bodies, each a list of convex parts, know about which of their parts are near each other, from
/// step to step. Each step: advance(); then, for each child pair that is awake, judge(); then settle().
///
/// The motion bound: between two looks at the pair, no point of B, seen from A, moves further than
/// displacementBound(). What was proven to be d apart stays apart until the sum of these, the motion, has
/// grown by d. A distance counts as proven only when it was just computed and a plane shows it. The same
/// bound tells when a look is needed at all: bodies that move together do not move against each other.
class PartPair {
 public:
  using Children = std::pmr::vector<ChildPair>;

  /// Where the child pairs are from now on; it must outlive the pair, which must have none yet.
  void useMemory(std::pmr::memory_resource& memory) {
    std::destroy_at(&children_);
    std::construct_at(&children_, &memory);
    std::destroy_at(&wakeful_);
    std::construct_at(&wakeful_, &memory);
  }

  /// Forgets everything, but keeps its memory. `threshold`: parts closer than this are in contact, metres.
  void reset(float threshold);

  /// A's parts have been replaced by others, of which some are the same, in the same order: `to[i]` is the
  /// new index of part i, or -1. Nothing is known of distances any more, but where to look first.
  void remapA(std::span<const int> to);

  /// Takes in where the bodies are now. False if nothing can be in contact: the pair is done for this step.
  /// Child pairs that are not neighbours any more are gone; the contacts they had are in `scratch.dropped`.
  [[nodiscard]] bool advance(PartBody& a, PartBody& b, const PairSteps& steps, PairScratch& scratch,
                             PairWork& work);

  [[nodiscard]] Children& children() { return children_; }
  [[nodiscard]] std::span<const ChildPair> children() const { return children_; }

  /// The child pairs that may have to be looked at, in ascending order: those that touch, and those that are
  /// not asleep for a while to come. Good until the next advance().
  [[nodiscard]] std::span<const WakefulChild> wakeful() {
    if (!(listedMotion_ < wakefulUntil_)) findWakeful();
    return wakeful_;
  }

  /// Calls `use(index)` for each child pair that is to be looked at, in ascending order. Counts those that
  /// are wakeful, and of them those that sleep.
  template <class Use>
  void forEachAwake(PairWork& work, Use&& use) {
    for (const WakefulChild& one : wakeful()) {
      ++work.childPairs;
      if (isAsleep(one) || isAsleep(children_[static_cast<std::size_t>(one.index)])) {
        ++work.childPairsAsleep;
      } else {
        use(one.index);
      }
    }
  }

  /// What wakeful() told last.
  [[nodiscard]] std::span<const WakefulChild> lastWakeful() const { return wakeful_; }

  /// Other child pairs than those that wakeful() has told are touching now.
  void forgetWakeful() { wakefulUntil_ = std::numeric_limits<double>::lowest(); }

  /// Of a ChildPair, or of a WakefulChild, which may be told to be awake although it has fallen asleep.
  template <class Child>
  [[nodiscard]] bool isAsleep(const Child& child) const {
    return !child.touching && child.wake > listedMotion_;
  }

  /// Cached axis, then GJK: isToldApart(), then measure().
  [[nodiscard]] ChildVerdict judge(ChildPair& child, const PartBody& a, const PartBody& b,
                                   const PairSteps& steps, PartContact& contact, PairWork& work);
  [[nodiscard]] bool isToldApart(ChildPair& child, const PartBody& a, const PartBody& b,
                                 const PairSteps& steps, PairWork& work);
  [[nodiscard]] ChildVerdict measure(ChildPair& child, const PartBody& a, const PartBody& b,
                                     const PairSteps& steps, PartContact& contact, PairWork& work);

  /// Whether measure() needs no engine, whatever contacts the child pair has.
  [[nodiscard]] bool isExact(const ChildPair& child, const PartBody& a, const PartBody& b) const;

  /// Takes in an axis (from A to B, in A's frame, of length 1) that the engine's detector found.
  void learnAxis(ChildPair& child, const PartBody& a, const PartBody& b, const Vec3& axis);

  /// Ends the step: finds out how long the pair can be left alone.
  void settle(const PartBody& a, const PartBody& b, const PairSteps& steps);

  /// How far the bodies may have moved against each other in all, metres; starts again at 0 after a reset()
  /// or a move without a length.
  [[nodiscard]] double motion() const { return motion_; }

  /// At most so much it is going to be after advance() where the bodies are now, if neither has jumped.
  [[nodiscard]] double mostMotion(const PartBody& a, const PartBody& b) const;

  /// From now on A's parts are pieces of larger ones, whose bounds tell an engine what may meet: parts are
  /// near whose own come within the threshold.
  void followPieces() { boundsAreOfAll_ = false; }

  /// From now on the motion of the listed parts is that of the bodies: for wakeAt().
  void followWholeBodies(bool whole) { followsWhole_ = whole; }

  /// ChildPair::wake of a child pair that is to be looked at when the pair's motion() is `motion`.
  [[nodiscard]] double wakeAt(double motion) const { return listedMotion_ + (motion - motion_); }

  /// Nothing can be in contact while the bodies' travels add up to less, and neither has jumped.
  [[nodiscard]] double quietUntil() const { return quietUntil_; }

  /// Whether nothing can be in contact where the bodies are now, by how far they have moved against each
  /// other since the last look. Of bodies that have jumped since then it must not be asked. Moves
  /// quietUntil().
  [[nodiscard]] bool staysQuiet(const PartBody& a, const PartBody& b);

  /// The same of all child pairs that are not touching: whether no others have to be looked at than those
  /// that are. Takes in how far the bodies have turned.
  [[nodiscard]] bool hasNoNewcomers(const PartBody& a, const PartBody& b);

  /// Whether parts were touching after the last look.
  [[nodiscard]] bool touches() const { return touches_; }

  /// How far A has turned in the world, or B against A, in all, radians: an upper bound.
  [[nodiscard]] float turn() const { return turn_ + turnSince_; }

  /// How far the listed parts have moved against each other at most since the last advance(), now that B is
  /// at `now` in A's frame; infinite if there is no list.
  [[nodiscard]] float movedSince(const Frame& now) const;

  [[nodiscard]] int jumps() const { return jumps_; }  ///< Of both bodies, at the last advance().

  [[nodiscard]] float threshold() const { return threshold_; }

  /// B's frame in A's, at the last advance().
  [[nodiscard]] const Frame& frameB() const { return frameB_; }

  /// Of its child pairs, room for growth included.
  [[nodiscard]] std::size_t childBytes() const {
    return sizeof(ChildPair) * children_.capacity() + sizeof(WakefulChild) * wakeful_.capacity();
  }

 private:
  void follow(const PartBody& a, const PartBody& b);
  void enclose(const PartList& parts, PairMidphase midphase);
  void findWakeful();
  /// Takes over from the child pairs what they have come to; none that is apart is to be looked at before
  /// `rest`. The least ChildPair::wake of those that do not touch.
  double renewWakeful(double rest);
  [[nodiscard]] float listedDisplacement(const Frame& now) const;
  [[nodiscard]] double slackLeft(const PartBody& a, const PartBody& b);
  void forgetList();
  void forgetProofs();
  void rebuild(PartBody& a, PartBody& b, const PairSteps& steps, PairScratch& scratch);
  void merge(PartBody& a, PartBody& b, std::span<const Neighbours> found, PairScratch& scratch);
  /// To `scratch.merged`, of both lists from their `first` on.
  void mergeFrom(std::size_t first, PartBody& a, PartBody& b, std::span<const Neighbours> found,
                 PairScratch& scratch);
  void takeSeparation(ChildPair& child, const Neighbours& near) const;
  [[nodiscard]] float skin() const;
  void wakeAfter(ChildPair& child, float separation, float threshold) const;

  // What staysQuiet() reads is first: of most pairs of a pile a step reads no more.
  Frame frameB_;
  Vec3 listedCenter_{0.0F};  ///< Of a ball around those of B in the list, in its frame.
  float listedRadius_ = 0.0F;
  double quietUntil_ = 0.0;    ///< Nothing can be in contact while the bodies' travels add up to less.
  double listSlack_ = -1.0;    ///< Nor, of parts that were apart, while the bodies have moved less against
  double listedSlack_ = -1.0;  ///< each other since the last look, and the parts in the list less than this.
  float turnSince_ = 0.0F;
  bool touches_ = false;  ///< There were others at the last look.
  bool followsWhole_ = false;
  bool boundsAreOfAll_ = true;
  bool listed_ = false;
  bool motionBound_ = true;

  Children children_;
  std::pmr::vector<WakefulChild> wakeful_;
  double wakefulUntil_ = std::numeric_limits<double>::lowest();  ///< A motion of the listed parts.
  double othersWake_ = 0.0;  ///< The least ChildPair::wake of those that are not wakeful.
  double motion_ = 0.0;
  double listedMotion_ = 0.0;  ///< Of the parts in the list alone: they are near each other, and all of the
                               ///< body may move far more where it turns.
  double listEnd_ = 0.0;       ///< The list is complete while the motion is less.
  Frame frameA_;               ///< A's, at the last advance().
  float threshold_ = 0.0F;
  float rounding_ = 0.0F;  ///< Taken off every proven distance.
  float lastMotion_ = 0.0F;
  float turn_ = 0.0F;  ///< At the last look.
  int jumps_ = 0;      ///< Of both bodies, at the last advance().
};

}  // namespace scatter
