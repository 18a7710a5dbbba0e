#include "pairs/passage.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace scatter::pairs {

namespace {

/// Of the radius: a shorter way does not need to fit the velocity, which knows nothing of how engines push
/// bodies out of each other. (Thin bodies on steep hills, `Hills` in btHybridGroundTest: with 0.1, two of 576
/// were pushed through.)
constexpr float kShortWay = 0.5F;
/// The cosine of the largest angle between the way and the velocity. Bodies turn and bounce meanwhile.
constexpr float kAlong = 0.7F;

Vec3 meanOf(const PolytopeView& polytope) {
  Vec3 sum(0.0F);
  for (int i = 0; i < polytope.count; ++i) sum += polytope.vertex(i);
  return sum / static_cast<float>(polytope.count);
}

// Inside of a part, and of all parts' middles the one nearest to that of the body.
Vec3 middleOf(const PartList& parts) {
  Vec3 best = parts.center();
  float least = std::numeric_limits<float>::max();
  for (int i = 0; i < parts.count(); ++i) {
    const Vec3 middle = meanOf(parts.part(i).core);
    const float distance = glm::length(middle - parts.center());
    if (distance >= least) continue;
    least = distance;
    best = middle;
  }
  return best;
}

// Whether bodies have come a way in motion. Along the velocity they go `ahead`.
bool fits(const Vec3& way, const Vec3& ahead, float radius) {
  const float length = glm::length(way);
  return length < kShortWay * radius || glm::dot(way, ahead) > kAlong * length * glm::length(ahead);
}

/// Of a triangle's size: so far beyond its edges it still is one, so that no way slips between two.
constexpr double kSlack = 1e-4;

struct Triangle {
  explicit Triangle(std::span<const Vec3> points)
      : corner{glm::dvec3(points[0]), glm::dvec3(points[1]), glm::dvec3(points[2])},
        normal(glm::cross(corner[1] - corner[0], corner[2] - corner[0])) {}

  [[nodiscard]] double heightOf(const glm::dvec3& point) const { return glm::dot(normal, point - corner[0]); }

  // Of a point in its plane.
  [[nodiscard]] bool holds(const glm::dvec3& point) const {
    const double area = glm::dot(normal, normal);
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 edge = corner[(i + 1) % 3] - corner[i];
      if (glm::dot(normal, glm::cross(edge, point - corner[i])) < -kSlack * area) return false;
    }
    return true;
  }

  [[nodiscard]] glm::dvec3 nearestTo(const glm::dvec3& point) const {
    const glm::dvec3 below = point - heightOf(point) / glm::dot(normal, normal) * normal;
    if (holds(below)) return below;
    glm::dvec3 best = corner[0];
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 edge = corner[(i + 1) % 3] - corner[i];
      const double share = glm::dot(point - corner[i], edge) / glm::dot(edge, edge);
      const glm::dvec3 near = corner[i] + std::clamp(share, 0.0, 1.0) * edge;
      if (glm::distance(near, point) < glm::distance(best, point)) best = near;
    }
    return best;
  }

  [[nodiscard]] bool hasArea() const { return glm::dot(normal, normal) > 0.0; }

  glm::dvec3 corner[3];
  glm::dvec3 normal;
};

// Most pieces are not, and are told so in no time.
bool isNear(const GroundPieces::Piece& piece, const Vec3& low, const Vec3& high) {
  for (int axis = 0; axis < 3; ++axis) {
    if (piece.low[axis] > high[axis] || piece.high[axis] < low[axis]) return false;
  }
  return true;
}

/// The first piece on a way.
struct Crossing {
  double side = 0.0;  ///< On which the way begins; 0: there is none.
  std::size_t piece = 0;
  glm::dvec3 normal{0.0};  ///< To that side, not of length 1.
};

Crossing firstCrossing(const glm::dvec3& from, const glm::dvec3& to, const GroundPieces& pieces) {
  Crossing first;
  double least = std::numeric_limits<double>::infinity();
  const Vec3 low = glm::min(Vec3(from), Vec3(to));
  const Vec3 high = glm::max(Vec3(from), Vec3(to));
  const float slack = 1e-3F * glm::length(high - low);
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    if (!isNear(pieces.pieces[i], low - slack, high + slack)) continue;
    const Triangle triangle(pieces.pointsOf(pieces.pieces[i]));
    const double before = triangle.heightOf(from);
    const double after = triangle.heightOf(to);
    if (before == 0.0 || (before > 0.0) == (after > 0.0)) continue;
    const double share = before / (before - after);
    if (!(share < least) || !triangle.holds(from + share * (to - from))) continue;
    least = share;
    first.side = before > 0.0 ? 1.0 : -1.0;
    first.piece = i;
    first.normal = first.side * triangle.normal;
  }
  return first;
}

/// The piece that is nearest to a point.
struct NearestPiece {
  std::size_t piece = 0;
  glm::dvec3 normal{0.0};
  glm::dvec3 point{0.0};
  double distance = std::numeric_limits<double>::infinity();
  double height = 0.0;  ///< Over the piece's plane.

  [[nodiscard]] bool isFace() const { return std::abs(height) > (1.0 - kSame) * distance; }

  static constexpr double kSame = 1e-6;  ///< So much alike are distances by rounding.
};

// Of those within a distance; of those that share the nearest corner or edge, that which the point is
// furthest above or below: it alone tells the side for sure.
NearestPiece nearestPiece(const glm::dvec3& point, float within, const GroundPieces& pieces) {
  NearestPiece best;
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    if (!isNear(pieces.pieces[i], Vec3(point) - within, Vec3(point) + within)) continue;
    const Triangle triangle(pieces.pointsOf(pieces.pieces[i]));
    if (!triangle.hasArea()) continue;
    const glm::dvec3 near = triangle.nearestTo(point);
    const double distance = glm::distance(near, point);
    const glm::dvec3 normal = glm::normalize(triangle.normal);
    const double height = glm::dot(normal, point - near);
    const bool isNearer = distance < best.distance * (1.0 - NearestPiece::kSame);
    const bool isSame = !isNearer && distance <= best.distance * (1.0 + NearestPiece::kSame);
    if (isNearer || (isSame && std::abs(height) > std::abs(best.height)))
      best = {i, normal, near, distance, height};
  }
  return best;
}

// Nothing if the middle is in front of a face. Nearest to a corner or an edge, it is as far behind one piece
// as before another: then what it was last decides, and whether it has come back through a piece.
std::optional<Passage> passageOf(const glm::dvec3& last, const glm::dvec3& middle, double side,
                                 const GroundPieces& pieces) {
  const NearestPiece nearest = nearestPiece(middle, std::numeric_limits<float>::max(), pieces);
  if (!std::isfinite(nearest.distance)) return std::nullopt;
  const bool isInFront =
      nearest.isFace() ? side * nearest.height > 0.0 : firstCrossing(last, middle, pieces).side == -side;
  if (isInFront) return std::nullopt;
  // So near the surface the way there is lost in rounding.
  constexpr double kOnSurface = 1e-4;
  const glm::dvec3 way = nearest.point - middle;
  const Vec3 normal(nearest.distance > kOnSurface ? way / nearest.distance : side * nearest.normal);
  return Passage{nearest.piece, normal, glm::dot(normal, Vec3(nearest.point)), 0.0F};
}

std::optional<Passage> passageAhead(const Vec3& from, const Vec3& ahead, const GroundPieces& pieces) {
  const Crossing crossing = firstCrossing(glm::dvec3(from), glm::dvec3(from + ahead), pieces);
  if (crossing.side == 0.0) return std::nullopt;
  const Vec3 normal(glm::normalize(crossing.normal));
  const Vec3& corner = pieces.pointsOf(pieces.pieces[crossing.piece])[0];
  return Passage{crossing.piece, normal, glm::dot(normal, corner), -glm::dot(normal, ahead)};
}

}  // namespace

void PassageWatch::begin(const PartList& parts) {
  middle_ = middleOf(parts);
  radius_ = parts.radius();
  last_.reset();
}

void PassageWatch::forget() {
  last_.reset();
  open_.reset();
  coming_.reset();
}

void PassageWatch::follow(const Frame& body, const GroundPieces& pieces, float reach, const Vec3& ahead) {
  coming_.reset();
  if (pieces.kind != PartKind::kTriangle) return;
  const Vec3 now = body(middle_);
  const Vec3 way = wayTo(body, ahead);
  const bool isMotion = last_ && now - *last_ == way;
  clear_ = isMotion ? clear_ - glm::length(way) : 0.0F;
  if (open_ || !(clear_ > 0.0F)) look(now, way, pieces, reach);
  last_ = now;
  if (!open_ && glm::length(ahead) > clear_) coming_ = passageAhead(now, ahead, pieces);
}

void PassageWatch::look(const Vec3& now, const Vec3& way, const GroundPieces& pieces, float reach) {
  const glm::dvec3 from(open_ && last_ ? *last_ : now - way);
  if (!open_) side_ = firstCrossing(from, glm::dvec3(now), pieces).side;
  open_ = side_ != 0.0 ? passageOf(from, glm::dvec3(now), side_, pieces) : std::nullopt;
  // To a fast body the nearest piece would have to be found each time.
  const bool isSlow = glm::length(way) < 0.5F * reach;
  if (isSlow && !open_)
    clear_ = std::min(reach, static_cast<float>(nearestPiece(glm::dvec3(now), reach, pieces).distance));
}

Vec3 PassageWatch::wayTo(const Frame& body, const Vec3& ahead) const {
  const Vec3 way = last_ ? body(middle_) - *last_ : Vec3(0.0F);
  return fits(way, ahead, radius_) ? way : Vec3(0.0F);
}

}  // namespace scatter::pairs
