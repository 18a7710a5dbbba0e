#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "pairs/ground_engine.h"
#include "pairs/whole_ground.h"

namespace scatter::pairs {

/// Memory that regions use in turn.
struct RegionScratch {
  GroundPieces before{};
  std::vector<PartDef> parts{};
  std::vector<int> moved{};
};

/// How a body moves against its ground, in the ground's frame, metres.
struct GroundMotion {
  Vec3 since{0.0F};  ///< The way that it has come since the last look.
  Vec3 ahead{0.0F};  ///< The way that it is about to go in this step.
};

/// The pieces of a ground around a body, looked up with a skin, so that it need not be done in every step; or
/// all of a small ground. To the body's parts they are one more body.
class Region {
 public:
  void forget();

  /// From now on all pieces are known. `isNew`: they have just been looked up, for this region.
  void share(std::shared_ptr<const WholeGround> whole, bool isNew);

  /// Pieces that have been looked up since the last call.
  [[nodiscard]] int takeLookedUp() { return std::exchange(lookedUp_, 0); }

  /// How far the body may still go until the region has to be gathered anew, metres; negative: it has to be
  /// now; infinite: never. `body` is where it is in the ground's frame.
  [[nodiscard]] float room(const PartList& parts, const Frame& body) const;

  /// Whether all that is near, up to `reach`, is known also when the body has gone `ahead`.
  [[nodiscard]] bool holds(const PartList& parts, const Frame& body, const Vec3& ahead, float reach) const;

  /// Looks up the pieces around the body, up to `reach` further, and around its ways, as far as they are not
  /// longer than bodies that anybody sees move. `pair`, of this region and the body, goes on with those that
  /// it knows. False if the engine cannot tell them all.
  [[nodiscard]] bool gather(const PartList& parts, const Frame& body, const GroundMotion& motion, float reach,
                            GroundEngine& engine, PartPair& pair, RegionScratch& scratch);

  /// The pieces as a body, with the ground at `ground`. Not if there are none.
  [[nodiscard]] PartBody& moveTo(const Frame& ground);

  [[nodiscard]] bool empty() const { return pieces().pieces.empty(); }
  [[nodiscard]] const GroundPieces& pieces() const { return whole_ ? whole_->pieces() : pieces_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] bool collect(const GroundMotion& motion, float reach, float radius, GroundEngine& engine);
  void rebuild(RegionScratch& scratch);
  void remap(const GroundPieces& before, PartPair& pair, std::vector<int>& moved) const;

  GroundPieces pieces_{};
  std::unique_ptr<PartList> list_{};
  std::shared_ptr<const WholeGround> whole_{};  ///< In the place of these.
  std::unique_ptr<PartBody> body_{};
  Vec3 origin_{0.0F};  ///< Of the pieces' frame in the ground's: near the body, for precision.
  Vec3 low_{0.0F};     ///< The body's box may lie between these without another look, in the ground's frame.
  Vec3 high_{0.0F};
  float reach_ = 0.0F;  ///< Pieces that are further from the body's box are not known.
  bool gathered_ = false;
  int lookedUp_ = 0;
};

}  // namespace scatter::pairs
