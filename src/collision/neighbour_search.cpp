#include "collision/neighbour_search.h"

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

// The bounds, along the axes of the frame that `rows` lead to, of a box with these half extents.
Vec3 halfIn(const Vec3 (&rows)[3], const Vec3& half) {
  return {glm::dot(rows[0], half), glm::dot(rows[1], half), glm::dot(rows[2], half)};
}

// Rotation parts without signs; a little more, so that rounding does not narrow a box.
struct Spread {
  Vec3 toA[3]{};
  Vec3 toB[3]{};

  explicit Spread(const Frame& frameB) {
    for (int i = 0; i < 3; ++i) toA[i] = glm::abs(frameB.row[i]) + kAxisRounding;
    for (int i = 0; i < 3; ++i) toB[i] = Vec3(toA[0][i], toA[1][i], toA[2][i]);
  }
};

Vec3 at(const std::vector<float> (&arrays)[3], std::size_t i) {
  return {arrays[0][i], arrays[1][i], arrays[2][i]};
}

bool isFurther(const Vec3& offset, const Vec3& reach) {
  return std::abs(offset.x) > reach.x || std::abs(offset.y) > reach.y || std::abs(offset.z) > reach.z;
}

// How far boxes lie apart along one axis.
Lanes gap(const std::vector<float>& center, const std::vector<float>& half, std::size_t i, float otherCenter,
          float otherHalf) {
  return abs(load<Lanes>(center.data() + i) - Lanes(otherCenter)) -
         (load<Lanes>(half.data() + i) + Lanes(otherHalf));
}

}  // namespace

void NeighbourSearch::Candidates::clear() {
  part.clear();
  for (auto* arrays : {&centerInA, &halfInA, &centerInB, &halfInB}) {
    for (auto& array : *arrays) array.clear();
  }
}

void NeighbourSearch::Candidates::add(std::uint16_t index, const Vec3& centerA, const Vec3& halfA,
                                      const Vec3& centerB, const Vec3& halfB) {
  part.push_back(index);
  for (int axis = 0; axis < 3; ++axis) {
    centerInA[axis].push_back(centerA[axis]);
    halfInA[axis].push_back(halfA[axis]);
    centerInB[axis].push_back(centerB[axis]);
    halfInB[axis].push_back(halfB[axis]);
  }
}

void NeighbourSearch::Candidates::pad() {
  while (part.size() % kLaneCount != 0) add(0, Vec3(0.0F), Vec3(-kNoBox), Vec3(0.0F), Vec3(-kNoBox));
}

void NeighbourSearch::byPartBoxes(const PartList& a, const PartList& b, const Frame& frameB, float limit) {
  found_.clear();
  const Spread spread(frameB);
  const Box boxB{frameB(b.center()), halfIn(spread.toA, b.half())};
  collectNear(a, boxB, limit, nearA_);
  if (nearA_.empty()) return;
  const Box boxA{frameB.toLocal(a.center()), halfIn(spread.toB, a.half())};
  collectNear(b, boxA, limit, nearB_);
  if (nearB_.empty()) return;
  collectCandidates(a, b, frameB, limit);
  for (const std::uint16_t part : nearA_) {
    const Box inA{at(a.boxes().center, part), at(a.boxes().half, part)};
    const Box inB{frameB.toLocal(inA.center), halfIn(spread.toB, inA.half)};
    if (isFurther(inB.center - b.center(), inB.half + b.half() + limit)) continue;
    const std::size_t first = found_.size();
    pairUp(part, inA, inB, frameB, limit);
    if (a.part(part).kind == PartKind::kTriangle) cutByPlane(first, a.part(part), b, frameB, limit);
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

void NeighbourSearch::collectNear(const PartList& list, const Box& other, float limit,
                                  std::vector<std::uint16_t>& near) {
  near.clear();
  const PartList::Boxes& boxes = list.boxes();
  const Vec3 reach = other.half + limit;
  for (std::size_t i = 0; i < static_cast<std::size_t>(list.paddedCount()); i += kLaneCount) {
    Lanes apart = gap(boxes.center[0], boxes.half[0], i, other.center.x, reach.x);
    apart = max(apart, gap(boxes.center[1], boxes.half[1], i, other.center.y, reach.y));
    apart = max(apart, gap(boxes.center[2], boxes.half[2], i, other.center.z, reach.z));
    simd::forEachSet(apart <= Lanes(0.0F), [&](int lane) {
      near.push_back(static_cast<std::uint16_t>(i + static_cast<std::size_t>(lane)));
    });
  }
}

void NeighbourSearch::collectCandidates(const PartList& a, const PartList& b, const Frame& frameB,
                                        float limit) {
  candidates_.clear();
  const Spread spread(frameB);
  for (const std::uint16_t part : nearB_) {
    const Vec3 center = at(b.boxes().center, part);
    const Vec3 half = at(b.boxes().half, part);
    const Vec3 centerInA = frameB(center);
    const Vec3 halfInA = halfIn(spread.toA, half);
    if (isFurther(centerInA - a.center(), halfInA + a.half() + limit)) continue;
    candidates_.add(part, centerInA, halfInA, center, half);
  }
  candidates_.pad();
}

void NeighbourSearch::pairUp(std::uint16_t part, const Box& inA, const Box& inB, const Frame& frameB,
                             float limit) {
  const Candidates& others = candidates_;
  for (std::size_t i = 0; i < others.part.size(); i += kLaneCount) {
    Lanes gaps[6];
    for (int axis = 0; axis < 3; ++axis) {
      gaps[axis] = gap(others.centerInA[axis], others.halfInA[axis], i, inA.center[axis], inA.half[axis]);
    }
    Lanes apart = max(gaps[0], max(gaps[1], gaps[2]));
    if (simd::stdx::none_of(apart <= Lanes(limit))) continue;
    for (int axis = 0; axis < 3; ++axis) {
      gaps[3 + axis] = gap(others.centerInB[axis], others.halfInB[axis], i, inB.center[axis], inB.half[axis]);
    }
    apart = max(apart, max(gaps[3], max(gaps[4], gaps[5])));
    simd::forEachSet(apart <= Lanes(limit), [&](int laneIndex) {
      const auto lane = static_cast<std::size_t>(laneIndex);
      int best = 0;
      for (int axis = 1; axis < 6; ++axis) {
        if (gaps[axis][lane] > gaps[best][lane]) best = axis;
      }
      Vec3 axis(0.0F);
      if (best < 3) {
        axis[best] = others.centerInA[best][i + lane] < inA.center[best] ? -1.0F : 1.0F;
      } else {
        const int column = best - 3;
        const float sign = others.centerInB[column][i + lane] < inB.center[column] ? -1.0F : 1.0F;
        axis = sign * Vec3(frameB.row[0][column], frameB.row[1][column], frameB.row[2][column]);
      }
      found_.push_back({part, others.part[i + lane], gaps[best][lane], axis});
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
