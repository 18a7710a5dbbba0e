#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "collision/part_list.h"

namespace scatter::pairs {

/// The convex pieces of a ground near a body, all of one kind, in the ground's frame. Memory that is filled
/// again and again.
struct GroundPieces {
  /// A piece has the numbers by which the engine knows it, and so many of `points`.
  struct Piece {
    int part = -1;
    int index = -1;
    std::size_t first = 0;
    std::size_t count = 0;
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
    pieces.push_back({part, index, points.size(), corners.size()});
    points.insert(points.end(), corners.begin(), corners.end());
  }
  [[nodiscard]] std::span<const Vec3> pointsOf(const Piece& piece) const {
    return {points.data() + piece.first, piece.count};
  }
};

}  // namespace scatter::pairs
