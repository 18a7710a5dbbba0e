#include "collision/neighbour_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scatter {

namespace {

using simd::Lanes;
using simd::load;
using simd::stdx::abs;
using simd::stdx::max;

constexpr auto kLaneCount = Lanes::size();
constexpr float kNoBox = 1e18F;  // as a negative extent: no box is near
constexpr float kAxisRounding = 1e-6F;

Vec3 at(const std::vector<float> (&arrays)[3], std::size_t i) {
  return {arrays[0][i], arrays[1][i], arrays[2][i]};
}

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
    const std::size_t first = found_.size();
    pairUp(i, faces, limit);
    const PartList::Part& part = a.part(nearA_.part[i]);
    if (part.kind == PartKind::kTriangle) cutByPlane(first, part, b, frameB, limit);
  }
}

// The box around a triangle that leans is full of nothing: its plane tells more.
void NeighbourSearch::cutByPlane(std::size_t first, const PartList::Part& triangle, const PartList& b,
                                 const Frame& frameB, float limit) {
  if (triangle.normal == Vec3(0.0F)) return;
  const Vec3 spread = glm::abs(frameB.rotateBack(triangle.normal)) + kAxisRounding;
  std::size_t kept = first;
  for (std::size_t i = first; i < found_.size(); ++i) {
    Neighbours near = found_[i];
    const float height = glm::dot(triangle.normal, frameB(at(b.boxes().center, near.b))) - triangle.offset;
    const float apart = std::abs(height) - glm::dot(spread, at(b.boxes().half, near.b)) - triangle.margin;
    if (apart > limit) continue;
    if (apart > near.separation) {
      near.separation = apart;
      near.axis = height < 0.0F ? -triangle.normal : triangle.normal;
    }
    found_[kept++] = near;
  }
  found_.resize(kept);
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

void NeighbourSearch::pairUp(std::size_t ofA, const Faces& faces, float limit) {
  const Candidates& others = nearB_;
  const Box box[2]{{nearA_.at(Candidates::kCenterInA, ofA), nearA_.at(Candidates::kHalfInA, ofA)},
                   {nearA_.at(Candidates::kCenterInB, ofA), nearA_.at(Candidates::kHalfInB, ofA)}};
  const auto along = [&](int axis, std::size_t i) {
    const int frame = axis / 3;
    const int array = 6 * frame + axis % 3;
    return gap(others.of(array) + i, others.of(array + 3) + i, box[frame].center[axis % 3],
               box[frame].half[axis % 3]);
  };
  for (std::size_t i = 0; i < others.part.size(); i += kLaneCount) {
    Lanes gaps[6];
    for (int axis = 0; axis < 3; ++axis) gaps[axis] = along(axis, i);
    Lanes apart = max(gaps[0], max(gaps[1], gaps[2]));
    if (simd::stdx::none_of(apart <= Lanes(limit))) continue;
    for (int axis = 3; axis < 6; ++axis) gaps[axis] = along(axis, i);
    apart = max(apart, max(gaps[3], max(gaps[4], gaps[5])));
    const auto isNear = apart <= Lanes(limit);
    if (simd::stdx::none_of(isNear)) continue;
    Lanes best(5.0F);
    for (int axis = 4; axis >= 0; --axis) {
      simd::stdx::where(gaps[axis] == apart, best) = Lanes(static_cast<float>(axis));
    }
    simd::forEachSet(isNear, [&](int laneIndex) {
      const auto lane = static_cast<std::size_t>(laneIndex);
      const auto face = static_cast<int>(best[lane]);
      const int frame = face / 3;
      const bool isBelow = others.of(face + 3 * frame)[i + lane] < box[frame].center[face % 3];
      const Vec3& axis = faces.axis[isBelow ? 1 : 0][face];
      found_.push_back({nearA_.part[ofA], others.part[i + lane], apart[lane], axis});
    });
  }
}

void NeighbourSearch::byWorldBounds(PartBody& a, PartBody& b) {
  found_.clear();
  for (int i = 0; i < a.parts().count(); ++i) {
    const std::ptrdiff_t room = b.parts().paddedCount();
    const float* const boundsA = a.worldBounds().data() + i;
    const std::ptrdiff_t roomA = a.parts().paddedCount();
    const float* const boundsB = b.worldBounds().data();
    for (std::ptrdiff_t j = 0; j < room; j += static_cast<std::ptrdiff_t>(kLaneCount)) {
      auto overlap = load<Lanes>(boundsB + j) <= Lanes(boundsA[3 * roomA]);
      overlap = overlap && load<Lanes>(boundsB + 3 * room + j) >= Lanes(boundsA[0]);
      for (std::ptrdiff_t axis = 1; axis < 3; ++axis) {
        overlap = overlap && load<Lanes>(boundsB + axis * room + j) <= Lanes(boundsA[(axis + 3) * roomA]);
        overlap = overlap && load<Lanes>(boundsB + (axis + 3) * room + j) >= Lanes(boundsA[axis * roomA]);
      }
      simd::forEachSet(overlap, [&](int lane) {
        found_.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j + lane),
                          std::numeric_limits<float>::lowest(), Vec3(0.0F)});
      });
    }
  }
}

}  // namespace scatter
