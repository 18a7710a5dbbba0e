#pragma once

#include <span>
#include <vector>

#include "pairs/ground_pieces.h"

namespace scatter::pairs {

/// The pieces as parts of a body, with `origin`, in the ground's frame, as the origin of its frame. `parts`
/// is memory that may be used again, and has more parts than there are pieces if it had before.
[[nodiscard]] std::span<const PartDef> describePieces(const GroundPieces& pieces, const Vec3& origin,
                                                      std::vector<PartDef>& parts);

/// All pieces of a small ground, at least one. Does not change: bodies on all threads may share it.
class WholeGround {
 public:
  explicit WholeGround(GroundPieces pieces);

  [[nodiscard]] const GroundPieces& pieces() const { return pieces_; }

  /// The same as a body, and the origin of its frame in the ground's: in their middle, for precision.
  [[nodiscard]] const PartList& parts() const { return parts_; }
  [[nodiscard]] const Vec3& origin() const { return origin_; }

  [[nodiscard]] std::size_t bytes() const;

 private:
  GroundPieces pieces_;
  Vec3 origin_;
  PartList parts_;
};

}  // namespace scatter::pairs
