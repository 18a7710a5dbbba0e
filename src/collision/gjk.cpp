#include "collision/gjk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scatter {

namespace {

constexpr int kMaxIterations = 40;
constexpr float kTolerance = 1e-4F;        // of the distance
constexpr float kSupportRounding = 1e-6F;  // of the coordinates
constexpr float kContactRounding = 50.0F;  // below so many roundings the direction is not to be trusted

/// A point of A minus a point of B.
struct Difference {
  Vec3 w;
  Vec3 a;
  Vec3 b;
  std::uint16_t vertexA;
  std::uint16_t vertexB;
};

/// The corners whose hull holds the point nearest to the origin, and that point.
struct Nearest {
  Vec3 point{0.0F};
  int count = 0;
  int corner[3]{};
  float weight[3]{};
  bool inside = false;  ///< The origin is inside the tetrahedron.
};

// These fill in a result field by field, as does Gjk::propose(), and for the same reason.
void atCorner(const Difference* s, int i, Nearest& to) {
  to.point = s[i].w;
  to.count = 1;
  to.corner[0] = i;
  to.weight[0] = 1.0F;
}

void onSegment(const Difference* s, int i, int j, Nearest& to) {
  const Vec3 edge = s[j].w - s[i].w;
  const float along = -glm::dot(s[i].w, edge);
  const float length2 = glm::dot(edge, edge);
  if (along <= 0.0F || length2 < 1e-30F) return atCorner(s, i, to);
  if (along >= length2) return atCorner(s, j, to);
  const float t = along / length2;
  to.point = s[i].w + edge * t;
  to.count = 2;
  to.corner[0] = i;
  to.corner[1] = j;
  to.weight[0] = 1.0F - t;
  to.weight[1] = t;
}

// Of a triangle without an area.
void onLongSides(const Difference* s, int i, int j, int k, Nearest& to) {
  Nearest second;
  onSegment(s, i, j, to);
  onSegment(s, i, k, second);
  if (!(glm::dot(to.point, to.point) <= glm::dot(second.point, second.point))) to = second;
}

// Ericson, Real-Time Collision Detection, 5.1.5: the Voronoi regions of a triangle.
void onTriangle(const Difference* s, int i, int j, int k, Nearest& to) {
  const Vec3& p = s[i].w;
  const Vec3 ab = s[j].w - p;
  const Vec3 ac = s[k].w - p;
  const float d1 = -glm::dot(ab, p);
  const float d2 = -glm::dot(ac, p);
  if (d1 <= 0.0F && d2 <= 0.0F) return atCorner(s, i, to);
  const float d3 = -glm::dot(ab, s[j].w);
  const float d4 = -glm::dot(ac, s[j].w);
  if (d3 >= 0.0F && d4 <= d3) return atCorner(s, j, to);
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0F && d1 >= 0.0F && d3 <= 0.0F) return onSegment(s, i, j, to);
  const float d5 = -glm::dot(ab, s[k].w);
  const float d6 = -glm::dot(ac, s[k].w);
  if (d6 >= 0.0F && d5 <= d6) return atCorner(s, k, to);
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0F && d2 >= 0.0F && d6 <= 0.0F) return onSegment(s, i, k, to);
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0F && d4 - d3 >= 0.0F && d5 - d6 >= 0.0F) return onSegment(s, j, k, to);
  const float sum = va + vb + vc;
  if (!(sum > std::numeric_limits<float>::min())) return onLongSides(s, i, j, k, to);
  const float u = va / sum;
  const float v = vb / sum;
  const float w = vc / sum;
  to.point = p * u + s[j].w * v + s[k].w * w;
  to.count = 3;
  to.corner[0] = i;
  to.corner[1] = j;
  to.corner[2] = k;
  to.weight[0] = u;
  to.weight[1] = v;
  to.weight[2] = w;
}

void onTetrahedron(const Difference* s, Nearest& to) {
  static constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
  float best2 = std::numeric_limits<float>::max();
  to.point = Vec3(0.0F);
  to.count = 0;
  to.inside = true;
  for (const auto& face : kFaces) {
    const Vec3& corner = s[face[0]].w;
    const Vec3 normal = glm::cross(s[face[1]].w - corner, s[face[2]].w - corner);
    const float origin = -glm::dot(normal, corner);
    const Vec3 across = s[face[3]].w - corner;
    const float opposite = glm::dot(normal, across);
    const bool isFlat = opposite * opposite <= 1e-10F * glm::dot(normal, normal) * glm::dot(across, across);
    if (origin * opposite > 0.0F && !isFlat) continue;
    Nearest nearest;
    onTriangle(s, face[0], face[1], face[2], nearest);
    to.inside = false;
    const float distance2 = glm::dot(nearest.point, nearest.point);
    if (distance2 < best2) {
      best2 = distance2;
      to = nearest;
    }
  }
}

void findNearest(const Difference* s, int count, Nearest& to) {
  to.inside = false;
  switch (count) {
    case 1:
      return atCorner(s, 0, to);
    case 2:
      return onSegment(s, 0, 1, to);
    case 3:
      return onTriangle(s, 0, 1, 2, to);
    default:
      return onTetrahedron(s, to);
  }
}

class Gjk {
 public:
  // The simplex fills as it grows.  NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  Gjk(const PolytopeView& a, const PolytopeView& b, const Frame& frameB, float tolerance, GjkResult& result)
      : a_(a),
        b_(b),
        frameB_(frameB),
        result_(result),
        tolerance_(tolerance),
        offset_(manhattan(frameB.origin)) {}

  void run(const Vec3& axis, float enough, WarmSimplex& warm) {
    result_.axis = axis;
    result_.provenDistance = std::numeric_limits<float>::lowest();
    result_.distance = std::numeric_limits<float>::max();
    if (warm.count > 0) {
      takeUp(warm);
      reduce();
    }
    if (!done_ && count_ > 0) confirm(enough);
    while (!done_ && result_.iterations < kMaxIterations) iterate(enough);
    keep(warm);
    if (result_.state == State::kConverged) findPoints();
    if (result_.state == State::kOverlap) showOverlap();
  }

 private:
  using State = GjkResult::State;

  // The corner behind the last one, which is none yet. Field by field, where it stays: to copy what has just
  // been written in parts makes a processor wait.
  const Difference& propose(int vertexA, int vertexB) {
    Difference& next = simplex_[count_];
    next.a = a_.vertex(vertexA);
    next.b = frameB_(b_.vertex(vertexB));
    next.w = next.a - next.b;
    next.vertexA = static_cast<std::uint16_t>(vertexA);
    next.vertexB = static_cast<std::uint16_t>(vertexB);
    return next;
  }

  void takeUp(const WarmSimplex& warm) {
    for (; count_ < warm.count; ++count_) propose(warm.a[count_], warm.b[count_]);
    ++result_.iterations;
  }

  void keep(WarmSimplex& warm) const {
    warm.count = count_ > 3 || result_.state == State::kOverlap ? 0 : static_cast<std::uint8_t>(count_);
    for (int i = 0; i < warm.count; ++i) {
      warm.a[i] = simplex_[i].vertexA;
      warm.b[i] = simplex_[i].vertexB;
    }
  }

  // The simplex taken up is often still the right one: then it needs no vertices, only how far they reach.
  void confirm(float enough) {
    const Vec3& axis = result_.axis;
    const float reachA = reach(a_, axis);
    const float reachB = reach(b_, frameB_.rotateBack(-axis));
    const float rounding = roundingAt(simplex_[0]);
    const float proven = glm::dot(axis, frameB_.origin) - reachB - reachA - rounding;
    if (conclude(proven, rounding, enough)) ++result_.iterations;
  }

  // Takes in what a plane across the axis proves. True if that settles it.
  bool conclude(float proven, float rounding, float enough) {
    if (proven > result_.provenDistance) {
      result_.provenDistance = proven;
      result_.provenAxis = result_.axis;
    }
    if (proven > enough) {
      finish(State::kApart);
    } else if (count_ > 0 && result_.distance <= kContactRounding * rounding) {
      finish(State::kOverlap);
    } else if (count_ > 0 && result_.distance - proven <= tolerance() + 2.0F * rounding) {
      finish(State::kConverged);
    }
    return done_;
  }

  [[nodiscard]] static float manhattan(const Vec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
  }

  // Coordinates in B's own frame are at most those in A's and the offset of the frames.
  [[nodiscard]] float roundingAt(const Difference& d) const {
    return kSupportRounding * (manhattan(d.a) + manhattan(d.b) + offset_);
  }

  void iterate(float enough) {
    ++result_.iterations;
    const Vec3 axis = result_.axis;
    const int vertexA = support(a_, axis).vertex;
    const int vertexB = support(b_, frameB_.rotateBack(-axis)).vertex;
    const Difference& next = propose(vertexA, vertexB);
    const float rounding = roundingAt(next);
    if (conclude(-glm::dot(axis, next.w) - rounding, rounding, enough)) return;
    for (int i = 0; i < count_; ++i) {
      const bool again = simplex_[i].vertexA == next.vertexA && simplex_[i].vertexB == next.vertexB;
      if (again) return finish(isTight(rounding) ? State::kConverged : State::kUndecided);
    }
    ++count_;
    reduce();
  }

  // Without a tight bound the distance might be too large.
  [[nodiscard]] bool isTight(float rounding) const {
    return result_.distance - result_.provenDistance <= 100.0F * tolerance() + 8.0F * rounding;
  }

  [[nodiscard]] float tolerance() const { return std::min(kTolerance * result_.distance, tolerance_); }

  // Keeps the corners that hold the nearest point, which gives the next axis.
  void reduce() {
    findNearest(simplex_, count_, nearest_);
    if (nearest_.inside) return finish(State::kOverlap);
    for (int i = 0; i < nearest_.count; ++i) {
      // Corners come in ascending order, so that none is overwritten before it is moved.
      if (nearest_.corner[i] != i) simplex_[i] = simplex_[nearest_.corner[i]];
    }
    count_ = nearest_.count;
    const float distance = glm::length(nearest_.point);
    if (!(distance > 0.0F)) return finish(State::kOverlap);
    // Where rounding hides the way on, what is known may be all that can be.
    if (distance >= result_.distance && ++stalled_ > 3) {
      return finish(isTight(roundingAt(simplex_[0])) ? State::kConverged : State::kUndecided);
    }
    result_.distance = distance;
    result_.axis = nearest_.point * (-1.0F / distance);
  }

  void findPoints() {
    result_.pointA = Vec3(0.0F);
    result_.pointB = Vec3(0.0F);
    for (int i = 0; i < nearest_.count; ++i) {
      result_.pointA += simplex_[i].a * nearest_.weight[i];
      result_.pointB += simplex_[i].b * nearest_.weight[i];
    }
  }

  void showOverlap() {
    result_.overlap.count = static_cast<std::uint8_t>(count_);
    for (int i = 0; i < count_; ++i) {
      result_.overlap.a[i] = simplex_[i].vertexA;
      result_.overlap.b[i] = simplex_[i].vertexB;
    }
  }

  void finish(State state) {
    result_.state = state;
    done_ = true;
  }

  const PolytopeView& a_;
  const PolytopeView& b_;
  const Frame& frameB_;
  Difference simplex_[4];
  int count_ = 0;
  int stalled_ = 0;
  Nearest nearest_;
  GjkResult& result_;
  float tolerance_;
  float offset_;
  bool done_ = false;
};

}  // namespace

GjkResult gjkDistance(const PolytopeView& a, const PolytopeView& b, const Frame& frameB, const Vec3& axis,
                      float enough, float tolerance, WarmSimplex& warm) {
  GjkResult result;
  Gjk(a, b, frameB, tolerance, result).run(axis, enough, warm);
  return result;
}

}  // namespace scatter
