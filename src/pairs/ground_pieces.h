#pragma once

#include <cstddef>
#include <glm/common.hpp>
#include <span>
#include <vector>

#include "collision/part_list.h"

namespace scatter::pairs {

/// The convex pieces of a ground near a body, all of one kind, in the ground's frame. Memory that is filled
/// again and again.
struct GroundPieces {
  /// A piece has the numbers by which the engine knows it, and so many of `points`, at least one.
  struct Piece {
    int part = -1;
    int index = -1;
    std::size_t first = 0;
    std::size_t count = 0;
    Vec3 low{0.0F};  ///< Of its points.
    Vec3 high{0.0F};
  };

  PartKind kind = PartKind::kTriangle;
  float margin = 0.0F;
  std::vector<Piece> pieces{};
  std::vector<Vec3> points{};

  void clear() {
    pieces.clear();
    points.clear();
  }
  void add(int part, int index, std::span<const Vec3> corners) {
    Piece piece{part, index, points.size(), corners.size(), corners[0], corners[0]};
    for (const Vec3& corner : corners) {
      piece.low = glm::min(piece.low, corner);
      piece.high = glm::max(piece.high, corner);
    }
    pieces.push_back(piece);
    points.insert(points.end(), corners.begin(), corners.end());
  }
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(Vec3) * points.capacity() + sizeof(Piece) * pieces.capacity();
  }
  [[nodiscard]] std::span<const Vec3> pointsOf(const Piece& piece) const {
    return {points.data() + piece.first, piece.count};
  }
};

}  // namespace scatter::pairs
