#pragma once

#include <cstdint>
#include <vector>

#include "pairs/ground_pair.h"

namespace scatter::pairs {

/// Memory that looks for contacts with a ground use in turn.
struct GroundScratch {
  /// A piece and a part that may touch.
  struct Found {
    std::uint16_t piece = 0;
    std::uint16_t part = 0;
    float distance = 0.0F;  ///< Of the contact that is known; otherwise the engine's detector must look.
    bool isKnown = false;
    PartContact contact{};
  };

  /// Where the contacts of the level before press the body, and how deep.
  struct Press {
    Vec3 position{};
    float depth = 0.0F;
  };

  RegionScratch region{};
  std::vector<Found> found{};
  std::vector<int> near{};
  std::vector<Press> presses{};
  std::vector<float> allowed{};  ///< How deep each contact of a new level may press.
};

/// Whether the contacts of a body and its ground may move along with the body in the place of being found
/// anew (PairSteps::recycling): it has moved that little since the last look, and the ground has not. A
/// contact that begins may be found so late, at most a quarter of the distance at which contacts begin.
/// `body` has the parts of the last look.
[[nodiscard]] bool mayRecycle(const GroundPair& pair, const PartBody& body, const Frame& ground,
                              const PairSteps& steps);

/// Whether a body that has moved less than `furthest` (metres) since the last look, and has contacts without
/// credit, may keep them, where the body is now, if the plan would have it so.
[[nodiscard]] bool mayKeep(const GroundPair& pair, const PartBody& body, const Frame& ground, float furthest);

/// Looks up the pieces near the body if they are not known, and adds their number to `work`. False if there
/// are more than can be dealt with.
[[nodiscard]] bool findRegion(GroundPair& pair, const PartBody& body, const Frame& bodyInGround,
                              const Vec3& ahead, const PairSteps& steps, GroundEngine& engine,
                              RegionScratch& scratch, PairWork& work);

/// One look for the contacts of a body's parts with its ground.
class GroundLook {
 public:
  GroundLook(GroundPair& pair, const PairSteps& steps, GroundEngine& engine, PairScratch& parts,
             GroundScratch& scratch, PairWork& work)
      : pair_(pair), steps_(steps), engine_(engine), parts_(parts), scratch_(scratch), work_(work) {}

  /// With the body's shape of a level. The points that have come apart go first; parts that have none left
  /// have no contact any more.
  void atLevel(int level);

  /// The same, unless it mayKeep() the contacts of the step before. Whether it does.
  [[nodiscard]] bool keepsAtLevel(int level, float furthest);

 private:
  void look();
  bool place(int level);
  bool fallBack();
  void refresh();
  void releaseEmpty();
  void carry();
  [[nodiscard]] int countPoints() const;
  bool drop(const GroundContact& contact);
  void lookAtHalfSpace(const HalfSpace& solid);
  void lookAtPieces();
  bool hasRegion(const Frame& bodyInGround, const Vec3& ahead);
  [[nodiscard]] bool advance(PartBody& region);
  void judge(const PartBody& region);
  void consider(int index, ChildVerdict verdict, const PartContact& contact, const Frame& region);
  [[nodiscard]] bool isOfWhole(const ChildPair& child, const PartContact& contact) const;
  bool asks(const ChildPair& child, const Frame& region, PartContact& contact);
  void addFound(const Frame& region);
  void dropBehind(const PartBody& region);
  void holdInFront(const Passage& passage, const PartBody& region, const Frame& bodyInGround);
  [[nodiscard]] bool hasPoints(int part) const;
  void* manifoldOf(int part);
  void staysQuietFor(double metres);

  GroundPair& pair_;
  const PairSteps& steps_;
  GroundEngine& engine_;
  PairScratch& parts_;
  GroundScratch& scratch_;
  PairWork& work_;
  PartBody* body_ = nullptr;
  const Foresight* foresight_ = nullptr;
};

}  // namespace scatter::pairs
