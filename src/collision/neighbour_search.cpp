#include "collision/neighbour_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace scatter {

namespace {

using simd::Lanes;
using simd::load;
using simd::stdx::abs;
using simd::stdx::max;

constexpr auto kLaneCount = Lanes::size();
constexpr float kNoBox = 1e18F;  // as a negative extent: no box is near
constexpr float kAxisRounding = 1e-6F;

Vec3 columnOf(const Frame& frame, int i) {
  return {frame.row[0][i], frame.row[1][i], frame.row[2][i]};
}

// How far boxes lie apart along one axis.
Lanes gap(const float* center, const float* half, float otherCenter, float otherHalf) {
  return abs(load<Lanes>(center) - Lanes(otherCenter)) - (load<Lanes>(half) + Lanes(otherHalf));
}

// How far boxes lie apart from one along the axis along which it is most.
Lanes apartFrom(const PartList::Boxes& boxes, std::size_t i, const Vec3& center, const Vec3& half) {
  Lanes apart(-kNoBox);
  for (int axis = 0; axis < 3; ++axis) {
    apart = max(apart, gap(&boxes.center[axis][i], &boxes.half[axis][i], center[axis], half[axis]));
  }
  return apart;
}

// In the order of operations of glm::dot.
Lanes dot(const Vec3& row, const Lanes (&v)[3]) {
  return Lanes(row.x) * v[0] + Lanes(row.y) * v[1] + Lanes(row.z) * v[2];
}

}  // namespace

NeighbourSearch::Passage NeighbourSearch::Passage::outOf(const Frame& frame) {
  Passage passage{{frame.row[0], frame.row[1], frame.row[2]}, Vec3(0.0F), frame.origin, {}};
  passage.findSpread();
  return passage;
}

NeighbourSearch::Passage NeighbourSearch::Passage::into(const Frame& frame) {
  Passage passage{
      {columnOf(frame, 0), columnOf(frame, 1), columnOf(frame, 2)}, -frame.origin, Vec3(0.0F), {}};
  passage.findSpread();
  return passage;
}

void NeighbourSearch::Passage::findSpread() {
  for (int axis = 0; axis < 3; ++axis) spread[axis] = glm::abs(row[axis]) + kAxisRounding;
}

NeighbourSearch::Box NeighbourSearch::Passage::operator()(const Box& box) const {
  Box there{};
  for (int axis = 0; axis < 3; ++axis) {
    there.center[axis] = glm::dot(row[axis], box.center + before) + after[axis];
    there.half[axis] = glm::dot(spread[axis], box.half);
  }
  return there;
}

NeighbourSearch::Faces::Faces(const Frame& frameB) {
  for (int i = 0; i < 3; ++i) {
    axis[0][i][i] = 1.0F;
    axis[0][3 + i] = columnOf(frameB, i);
  }
  for (int i = 0; i < 6; ++i) axis[1][i] = -axis[0][i];
}

NeighbourSearch::Plane::Plane(const PartList::Part& triangle, const Frame& frameB)
    : normal{triangle.normal, -triangle.normal},
      offset(triangle.offset),
      margin(triangle.margin),
      spread(glm::abs(frameB.rotateBack(triangle.normal)) + kAxisRounding) {}

void NeighbourSearch::Candidates::clear(std::size_t most) {
  part.clear();
  room = most + kLaneCount;
  if (numbers.size() < kArrays * room) numbers.resize(kArrays * room);
}

void NeighbourSearch::Candidates::pad() {
  for (int array = 0; array < kArrays; ++array) {
    const bool isHalf = array / 3 % 2 == 1;
    std::fill_n(of(array) + part.size(), kLaneCount, isHalf ? -kNoBox : 0.0F);
  }
}

void NeighbourSearch::byPartBoxes(const PartList& a, const PartList& b, const Frame& frameB, float limit) {
  found_.clear();
  const Passage toA = Passage::outOf(frameB);
  const Passage toB = Passage::into(frameB);
  collect<Candidates::kCenterInA, Candidates::kCenterInB>(a, b, toB, toA, limit, nearA_);
  if (nearA_.part.empty()) return;
  collect<Candidates::kCenterInB, Candidates::kCenterInA>(b, a, toA, toB, limit, nearB_);
  if (nearB_.part.empty()) return;
  const Faces faces(frameB);
  for (std::size_t i = 0; i < nearA_.part.size(); ++i) {
    const PartList::Part& part = a.part(nearA_.part[i]);
    const bool hasPlane = part.kind == PartKind::kTriangle && part.normal != Vec3(0.0F);
    const auto plane = hasPlane ? std::optional<Plane>(std::in_place, part, frameB) : std::nullopt;
    pairUp(i, faces, plane ? &*plane : nullptr, limit);
  }
}

template <class Use>
void NeighbourSearch::forEachNear(const PartList& list, const Vec3& center, const Vec3& reach, Use&& use) {
  const auto count = static_cast<std::size_t>(list.paddedCount());
  const auto useAll = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; i += kLaneCount) use(i);
  };
  const PartList::Boxes& blocks = list.blocks();
  if (blocks.center[0].empty()) return useAll(0, count);
  for (std::size_t i = 0; i < blocks.center[0].size(); i += kLaneCount) {
    simd::forEachSet(apartFrom(blocks, i, center, reach) <= Lanes(0.0F), [&](int lane) {
      const std::size_t first = (i + static_cast<std::size_t>(lane)) * PartList::kBlock;
      useAll(first, std::min(first + PartList::kBlock, count));
    });
  }
}

// Near the box around all of the other body's parts, along the axes of either frame.
template <NeighbourSearch::Candidates::Array kCenterHere, NeighbourSearch::Candidates::Array kCenterThere>
void NeighbourSearch::collect(const PartList& list, const PartList& other, const Passage& there,
                              const Passage& back, float limit, Candidates& near) {
  near.clear(static_cast<std::size_t>(list.paddedCount()));
  const PartList::Boxes& boxes = list.boxes();
  const Box all = back({other.center(), other.half()});
  const Vec3 reach = all.half + limit;
  forEachNear(list, all.center, reach, [&](std::size_t i) {
    auto isNear = apartFrom(boxes, i, all.center, reach) <= Lanes(0.0F);
    if (simd::stdx::none_of(isNear)) return;
    Lanes center[3];
    Lanes half[3];
    for (int axis = 0; axis < 3; ++axis) {
      center[axis] = load<Lanes>(&boxes.center[axis][i]) + Lanes(there.before[axis]);
      half[axis] = load<Lanes>(&boxes.half[axis][i]);
    }
    alignas(Lanes) float moved[6][kLaneCount];
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes centerThere = dot(there.row[axis], center) + Lanes(there.after[axis]);
      const Lanes halfThere = dot(there.spread[axis], half);
      centerThere.copy_to(moved[axis], simd::stdx::vector_aligned);
      halfThere.copy_to(moved[3 + axis], simd::stdx::vector_aligned);
      isNear = isNear && abs(centerThere - Lanes(other.center()[axis])) <=
                             halfThere + Lanes(other.half()[axis]) + Lanes(limit);
    }
    simd::forEachSet(isNear, [&](int laneIndex) {
      const auto lane = static_cast<std::size_t>(laneIndex);
      const std::size_t to = near.part.size();
      near.part.push_back(static_cast<std::uint16_t>(i + lane));
      for (int axis = 0; axis < 3; ++axis) {
        near.of(kCenterHere + axis)[to] = boxes.center[axis][i + lane];
        near.of(kCenterHere + 3 + axis)[to] = boxes.half[axis][i + lane];
        near.of(kCenterThere + axis)[to] = moved[axis][lane];
        near.of(kCenterThere + 3 + axis)[to] = moved[3 + axis][lane];
      }
    });
  });
  near.pad();
}

/// How far boxes of B lie apart from one of A, along the six axes of their faces and the normal of a plane.
class NeighbourSearch::Axes {
 public:
  /// Of lanes of boxes.
  struct Apart {
    Lanes most;
    Lanes axis;    ///< The number of the one along which it is most.
    Lanes height;  ///< Over the plane.
  };

  Axes(const Candidates& nearA, std::size_t ofA, const Candidates& others, const Faces& faces,
       const Plane* plane)
      : box_{{nearA.at(Candidates::kCenterInA, ofA), nearA.at(Candidates::kHalfInA, ofA)},
             {nearA.at(Candidates::kCenterInB, ofA), nearA.at(Candidates::kHalfInB, ofA)}},
        others_(others),
        faces_(faces),
        plane_(plane) {}

  /// From box `i` on; false if none is nearer than `limit`.
  [[nodiscard]] bool findNear(std::size_t i, float limit, Apart& apart) const {
    Lanes gaps[6];
    for (int axis = 0; axis < 3; ++axis) gaps[axis] = along(axis, i);
    apart.most = max(gaps[0], max(gaps[1], gaps[2]));
    if (simd::stdx::none_of(apart.most <= Lanes(limit))) return false;
    for (int axis = 3; axis < 6; ++axis) gaps[axis] = along(axis, i);
    apart.most = max(apart.most, max(gaps[3], max(gaps[4], gaps[5])));
    if (simd::stdx::none_of(apart.most <= Lanes(limit))) return false;
    apart.axis = Lanes(5.0F);
    for (int axis = 4; axis >= 0; --axis) {
      simd::stdx::where(gaps[axis] == apart.most, apart.axis) = Lanes(static_cast<float>(axis));
    }
    apart.height = Lanes(0.0F);
    if (plane_ != nullptr) addPlane(i, apart);
    return true;
  }

  /// From the part of A to one of B.
  [[nodiscard]] const Vec3& from(const Apart& apart, std::size_t i, std::size_t lane) const {
    const auto number = static_cast<int>(apart.axis[lane]);
    if (number == kPlane) return plane_->normal[apart.height[lane] < 0.0F ? 1 : 0];
    const int frame = number / 3;
    const bool isBelow = others_.of(number + 3 * frame)[i + lane] < box_[frame].center[number % 3];
    return faces_.axis[isBelow ? 1 : 0][number];
  }

 private:
  static constexpr int kPlane = 6;

  [[nodiscard]] Lanes along(int axis, std::size_t i) const {
    const int frame = axis / 3;
    const int array = 6 * frame + axis % 3;
    return gap(others_.of(array) + i, others_.of(array + 3) + i, box_[frame].center[axis % 3],
               box_[frame].half[axis % 3]);
  }

  [[nodiscard]] Lanes alongAll(const Vec3& direction, int array, std::size_t i) const {
    const Lanes v[3]{load<Lanes>(others_.of(array) + i), load<Lanes>(others_.of(array + 1) + i),
                     load<Lanes>(others_.of(array + 2) + i)};
    return dot(direction, v);
  }

  void addPlane(std::size_t i, Apart& apart) const {
    apart.height = alongAll(plane_->normal[0], Candidates::kCenterInA, i) - Lanes(plane_->offset);
    const Lanes reach = alongAll(plane_->spread, Candidates::kHalfInB, i);
    const Lanes above = abs(apart.height) - reach - Lanes(plane_->margin);
    simd::stdx::where(above > apart.most, apart.axis) = Lanes(static_cast<float>(kPlane));
    apart.most = max(apart.most, above);
  }

  Box box_[2];
  const Candidates& others_;
  const Faces& faces_;
  const Plane* plane_;
};

void NeighbourSearch::pairUp(std::size_t ofA, const Faces& faces, const Plane* plane, float limit) {
  const Axes axes(nearA_, ofA, nearB_, faces, plane);
  for (std::size_t i = 0; i < nearB_.part.size(); i += kLaneCount) {
    Axes::Apart apart{};
    if (!axes.findNear(i, limit, apart)) continue;
    simd::forEachSet(apart.most <= Lanes(limit), [&](int laneIndex) {
      const auto lane = static_cast<std::size_t>(laneIndex);
      found_.push_back(
          {nearA_.part[ofA], nearB_.part[i + lane], apart.most[lane], axes.from(apart, i, lane)});
    });
  }
}

void NeighbourSearch::byWorldBounds(PartBody& a, PartBody& b, float limit) {
  found_.clear();
  for (int i = 0; i < a.parts().count(); ++i) {
    const std::ptrdiff_t room = b.parts().paddedCount();
    const float* const boundsA = a.worldBounds().data() + i;
    const std::ptrdiff_t roomA = a.parts().paddedCount();
    const float* const boundsB = b.worldBounds().data();
    for (std::ptrdiff_t j = 0; j < room; j += static_cast<std::ptrdiff_t>(kLaneCount)) {
      auto overlap = load<Lanes>(boundsB + j) <= Lanes(boundsA[3 * roomA] + limit);
      overlap = overlap && load<Lanes>(boundsB + 3 * room + j) >= Lanes(boundsA[0] - limit);
      for (std::ptrdiff_t axis = 1; axis < 3; ++axis) {
        overlap =
            overlap && load<Lanes>(boundsB + axis * room + j) <= Lanes(boundsA[(axis + 3) * roomA] + limit);
        overlap =
            overlap && load<Lanes>(boundsB + (axis + 3) * room + j) >= Lanes(boundsA[axis * roomA] - limit);
      }
      simd::forEachSet(overlap, [&](int lane) {
        found_.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j + lane),
                          std::numeric_limits<float>::lowest(), Vec3(0.0F)});
      });
    }
  }
}

}  // namespace scatter
