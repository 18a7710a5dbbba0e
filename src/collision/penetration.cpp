#include "collision/penetration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace scatter {

namespace {

using Point = glm::dvec3;

/// A polytope of so many corners has at most twice as many faces; hulls of 64 points need about 20 corners.
constexpr int kMaxCorners = 64;
constexpr int kMaxFaces = 2 * kMaxCorners;
constexpr int kMaxRim = 3 * kMaxFaces;
/// Of the largest coordinate: coordinates are floats, so that less than this is not known of a corner.
constexpr double kRounding = 1e-7;

/// A vertex of A minus a vertex of B, `b`.
struct Corner {
  Point w;
  Vec3 b;
  int vertexA;
  int vertexB;
};

struct Face {
  std::array<std::int16_t, 3> corner;  ///< Counter-clockwise seen from outside.
  Point normal;                        ///< Outwards, of length 1; zero if the face has no area.
  double distance;                     ///< Of its plane, from the origin.
  bool isUsable;                       ///< It has an area, and what lies beyond it is not known yet.
};

struct Edge {
  std::int16_t from;
  std::int16_t to;
};

class Expansion {
 public:
  // Corners and faces fill as it grows.  NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  Expansion(const PolytopeView& a, const PolytopeView& b, const Frame& frameB)
      : a_(a), b_(b), frameB_(frameB) {}

  std::optional<Penetration> run(const OverlapSimplex& overlap, double tolerance) {
    for (int i = 0; i < overlap.count; ++i) addCorner(overlap.a[i], overlap.b[i]);
    if (!spanSpace()) return flat();
    closeTetrahedron();
    while (expand(tolerance)) {
    }
    return found();
  }

 private:
  void addCorner(int vertexA, int vertexB) {
    const Vec3 p = a_.vertex(vertexA);
    const Vec3 q = frameB_(b_.vertex(vertexB));
    corners_[cornerCount_++] = {Point(p) - Point(q), q, vertexA, vertexB};
    const Point size = glm::abs(Point(p)) + glm::abs(Point(q)) + glm::abs(Point(frameB_.origin));
    rounding_ = std::max(rounding_, kRounding * (size.x + size.y + size.z));
  }

  void addSupport(const Point& direction) {
    const Vec3 along(direction);
    addCorner(support(a_, along).vertex, support(b_, frameB_.rotateBack(-along)).vertex);
    ++iterations_;
  }

  // Adds the furthest corner along a direction or against it, if that is off what there is.
  bool extendAlong(const Point& direction) {
    const double length = glm::length(direction);
    if (!(length > 0.0)) return false;
    const Point normal = direction / length;
    for (const double sign : {1.0, -1.0}) {
      addSupport(sign * normal);
      const Point& furthest = corners_[cornerCount_ - 1].w;
      if (std::abs(glm::dot(normal, furthest - corners_[0].w)) > 4.0 * rounding_) return true;
      --cornerCount_;
    }
    return false;
  }

  // Completes what GJK left, of which some may be all but in one plane, to a tetrahedron.
  bool spanSpace() {
    if (cornerCount_ == 0) addSupport({1.0, 0.0, 0.0});
    if (cornerCount_ == 4 && isFlat()) cornerCount_ = 3;
    if (cornerCount_ == 3 && !(glm::length(areaOf(0, 1, 2)) > rounding_ * rounding_)) cornerCount_ = 2;
    if (cornerCount_ == 2 && !(glm::length(corners_[1].w - corners_[0].w) > 4.0 * rounding_))
      cornerCount_ = 1;
    if (cornerCount_ == 1) {
      if (!extendAlong({1.0, 0.0, 0.0}) && !extendAlong({0.0, 1.0, 0.0}) && !extendAlong({0.0, 0.0, 1.0}))
        return false;
    }
    if (cornerCount_ == 2) {
      const Point along = corners_[1].w - corners_[0].w;
      const Point least = leastAxis(along);
      const Point across = glm::cross(along, least);
      if (!extendAlong(across) && !extendAlong(glm::cross(along, across))) return false;
    }
    return cornerCount_ == 4 || extendAlong(areaOf(0, 1, 2));
  }

  [[nodiscard]] bool isFlat() const {
    const Point area = areaOf(0, 1, 2);
    return !(std::abs(glm::dot(area, corners_[3].w - corners_[0].w)) > 4.0 * rounding_ * glm::length(area));
  }

  static Point leastAxis(const Point& v) {
    const Point size = glm::abs(v);
    if (size.x <= size.y && size.x <= size.z) return {1.0, 0.0, 0.0};
    return size.y <= size.z ? Point(0.0, 1.0, 0.0) : Point(0.0, 0.0, 1.0);
  }

  [[nodiscard]] Point areaOf(int i, int j, int k) const {
    const Point& p = corners_[i].w;
    return glm::cross(corners_[j].w - p, corners_[k].w - p);
  }

  void closeTetrahedron() {
    const bool isInsideOut = glm::dot(areaOf(0, 1, 2), corners_[3].w - corners_[0].w) > 0.0;
    const int second = isInsideOut ? 2 : 1;
    const int third = isInsideOut ? 1 : 2;
    addFace(0, second, third);
    addFace(0, 3, second);
    addFace(second, 3, third);
    addFace(third, 3, 0);
  }

  void addFace(int i, int j, int k) {
    Face& face = faces_[faceCount_++];
    face.corner = {static_cast<std::int16_t>(i), static_cast<std::int16_t>(j), static_cast<std::int16_t>(k)};
    const Point area = areaOf(i, j, k);
    const double length = glm::length(area);
    const bool isSliver = !(length > rounding_ * rounding_);
    face.normal = isSliver ? Point(0.0) : area / length;
    face.distance = glm::dot(face.normal, corners_[i].w);
    face.isUsable = !isSliver;
  }

  [[nodiscard]] Face* nearest() {
    Face* best = nullptr;
    for (int i = 0; i < faceCount_; ++i) {
      if (faces_[i].isUsable && (best == nullptr || faces_[i].distance < best->distance)) best = &faces_[i];
    }
    return best;
  }

  // One corner more, beyond the face that is nearest to the origin. False when nothing better can be found.
  bool expand(double tolerance) {
    Face* const face = nearest();
    if (face == nullptr || least_ - face->distance <= tolerance + rounding_) return false;
    addSupport(face->normal);
    const double reaches = glm::dot(face->normal, corners_[cornerCount_ - 1].w);
    if (reaches < least_) {
      least_ = reaches;
      best_ = *face;
    }
    if (least_ - face->distance <= tolerance + rounding_) return false;
    if (!isKnown(corners_[cornerCount_ - 1])) return cornerCount_ < kMaxCorners && bulge();
    // A normal that rounding has turned: the corner beyond it is there already.
    face->isUsable = false;
    --cornerCount_;
    return true;
  }

  [[nodiscard]] bool isKnown(const Corner& corner) const {
    for (int i = 0; i < cornerCount_ - 1; ++i) {
      if (corners_[i].vertexA == corner.vertexA && corners_[i].vertexB == corner.vertexB) return true;
    }
    return false;
  }

  // Replaces the faces that the newest corner sees with a cone from their rim to it. False if rounding leaves
  // no rim that is a ring.
  bool bulge() {
    const auto tip = static_cast<std::int16_t>(cornerCount_ - 1);
    rimCount_ = 0;
    for (int i = 0; i < faceCount_;) {
      const Face& face = faces_[i];
      const bool isSeen = glm::dot(face.normal, corners_[tip].w) > face.distance + 1e-3 * rounding_;
      if (!isSeen) {
        ++i;
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) cross({face.corner[k], face.corner[(k + 1) % 3]});
      faces_[i] = faces_[--faceCount_];
    }
    if (!isRing() || faceCount_ + rimCount_ > kMaxFaces) return false;
    for (int i = 0; i < rimCount_; ++i) addFace(rim_[i].from, rim_[i].to, tip);
    return true;
  }

  // An edge between two faces that go is not of the rim.
  void cross(const Edge& edge) {
    for (int i = 0; i < rimCount_; ++i) {
      if (rim_[i].from != edge.to || rim_[i].to != edge.from) continue;
      rim_[i] = rim_[--rimCount_];
      return;
    }
    rim_[rimCount_++] = edge;
  }

  [[nodiscard]] bool isRing() const {
    if (rimCount_ < 3) return false;
    int at = 0;
    for (int steps = 1; steps <= rimCount_; ++steps) {
      int next = 0;
      while (next < rimCount_ && rim_[next].from != rim_[at].to) ++next;
      if (next == rimCount_) return false;
      if (next == 0) return steps == rimCount_;
      at = next;
    }
    return false;
  }

  // The difference has no inside: it is left across its plane.
  std::optional<Penetration> flat() {
    if (cornerCount_ < 3) return std::nullopt;
    const Point area = areaOf(0, 1, 2);
    const Point normal = area / glm::length(area);
    for (const double sign : {1.0, -1.0}) {
      addSupport(sign * normal);
      const double reaches = sign * glm::dot(normal, corners_[cornerCount_ - 1].w);
      if (reaches < least_) {
        least_ = reaches;
        best_ = {{0, 1, 2}, sign * normal, reaches, true};
      }
    }
    return found();
  }

  [[nodiscard]] std::optional<Penetration> found() const {
    if (!std::isfinite(least_)) return std::nullopt;
    const std::optional<Vec3> point = pointOfB();
    if (!point) return std::nullopt;
    Penetration penetration{Vec3(best_.normal), static_cast<float>(least_), *point, {}, iterations_};
    penetration.face.count = 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner& corner = corners_[best_.corner[i]];
      penetration.face.a[i] = static_cast<std::uint16_t>(corner.vertexA);
      penetration.face.b[i] = static_cast<std::uint16_t>(corner.vertexB);
    }
    return penetration;
  }

  // Of the point of the best face that is nearest to the origin. If that is beyond the face's edges, then the
  // face is a piece of a larger one.
  [[nodiscard]] std::optional<Vec3> pointOfB() const {
    const Corner& p = corners_[best_.corner[0]];
    const Corner& q = corners_[best_.corner[1]];
    const Corner& r = corners_[best_.corner[2]];
    Point weights(glm::dot(best_.normal, glm::cross(q.w, r.w)), glm::dot(best_.normal, glm::cross(r.w, p.w)),
                  glm::dot(best_.normal, glm::cross(p.w, q.w)));
    weights /= weights.x + weights.y + weights.z;
    if (!(glm::min(weights.x, glm::min(weights.y, weights.z)) >= -kRounding)) return pointOfBApart();
    return static_cast<float>(weights.x) * p.b + static_cast<float>(weights.y) * q.b +
           static_cast<float>(weights.z) * r.b;
  }

  // GJK finds the point once B has been moved out of A, and on, far enough for exact distances.
  [[nodiscard]] std::optional<Vec3> pointOfBApart() const {
    constexpr double kClear = 1e5;
    const Vec3 shift(best_.normal * (least_ + kClear * rounding_));
    Frame apart = frameB_;
    apart.origin += shift;
    WarmSimplex cold;
    const GjkResult nearest =
        gjkDistance(a_, b_, apart, Vec3(best_.normal), std::numeric_limits<float>::max(),
                    static_cast<float>(rounding_), cold);
    if (nearest.state != GjkResult::State::kConverged) return std::nullopt;
    return nearest.pointB - shift;
  }

  const PolytopeView& a_;
  const PolytopeView& b_;
  const Frame& frameB_;
  std::array<Corner, kMaxCorners + 2> corners_;
  std::array<Face, kMaxFaces> faces_;
  std::array<Edge, kMaxRim> rim_;
  int cornerCount_ = 0;
  int faceCount_ = 0;
  int rimCount_ = 0;
  int iterations_ = 0;
  double rounding_ = 0.0;
  double least_ = std::numeric_limits<double>::infinity();
  Face best_;
};

}  // namespace

std::optional<Penetration> penetrationOf(const PolytopeView& a, const PolytopeView& b, const Frame& frameB,
                                         const OverlapSimplex& overlap, float tolerance) {
  return Expansion(a, b, frameB).run(overlap, static_cast<double>(tolerance));
}

}  // namespace scatter
