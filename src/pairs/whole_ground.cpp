#include "pairs/whole_ground.h"

#include <glm/common.hpp>
#include <utility>

namespace scatter::pairs {

namespace {

/// An engine's bounds of a piece are those of its points, widened by the margin.
void describe(const GroundPieces& pieces, const GroundPieces::Piece& piece, const Vec3& origin,
              PartDef& part) {
  const auto points = pieces.pointsOf(piece);
  part.kind = pieces.kind;
  part.margin = pieces.margin;
  part.core.clear();
  for (const Vec3& point : points) part.core.push_back(point - origin);
  part.boundsCenter = 0.5F * (piece.low + piece.high) - origin;
  part.boundsHalf = 0.5F * (piece.high - piece.low);
  part.boundsMargin = pieces.kind == PartKind::kBox ? 0.0F : pieces.margin;
  if (pieces.kind == PartKind::kBox) part.boundsHalf += Vec3(pieces.margin);
}

Vec3 middleOf(const GroundPieces& pieces) {
  Vec3 low = pieces.pieces.front().low;
  Vec3 high = pieces.pieces.front().high;
  for (const GroundPieces::Piece& piece : pieces.pieces) {
    low = glm::min(low, piece.low);
    high = glm::max(high, piece.high);
  }
  return 0.5F * (low + high);
}

std::vector<PartDef> partsOf(const GroundPieces& pieces, const Vec3& origin) {
  std::vector<PartDef> parts;
  static_cast<void>(describePieces(pieces, origin, parts));
  return parts;
}

}  // namespace

std::span<const PartDef> describePieces(const GroundPieces& pieces, const Vec3& origin,
                                        std::vector<PartDef>& parts) {
  const std::size_t count = pieces.pieces.size();
  if (parts.size() < count) parts.resize(count);
  for (std::size_t i = 0; i < count; ++i) describe(pieces, pieces.pieces[i], origin, parts[i]);
  return {parts.data(), count};
}

WholeGround::WholeGround(GroundPieces pieces)
    : pieces_(std::move(pieces)), origin_(middleOf(pieces_)), parts_(partsOf(pieces_, origin_)) {}

std::size_t WholeGround::bytes() const {
  return sizeof(*this) + pieces_.bytes() + parts_.bytes();
}

}  // namespace scatter::pairs
