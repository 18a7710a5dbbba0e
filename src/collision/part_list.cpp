#include "collision/part_list.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace scatter {

namespace {

constexpr float kNowhere = 1e18F;  // as a negative extent: no box is near

// The corners of a kBox, which its engine box is.
std::array<Vec3, 8> cornersOf(const PartDef& box) {
  std::array<Vec3, 8> corners{};
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    Vec3 local = box.boundsHalf;
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1U) == 0) local[axis] = -local[axis];
    }
    corners[corner] = box.boundsCenter + box.boundsAxes * local;
  }
  return corners;
}

// Floats that a polytope takes.
std::size_t roomOf(std::size_t points) {
  return 3 * static_cast<std::size_t>(simd::padded(static_cast<int>(points)));
}

void setPlane(PartList::Part& part, std::span<const Vec3> corners) {
  part.normal = Vec3(0.0F);
  part.offset = 0.0F;
  if (part.kind != PartKind::kTriangle) return;
  const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const float length = glm::length(normal);
  constexpr float kLeastArea = 1e-12F;
  if (!(length > kLeastArea)) return;
  part.normal = normal / length;
  part.offset = glm::dot(part.normal, corners[0]);
}

// What is beyond `used` is nowhere.
void resize(PartList::Boxes& boxes, std::size_t used, std::size_t count) {
  const auto fill = [used, count](std::vector<float>& values, float value) {
    values.resize(count);
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(used), values.end(), value);
  };
  for (int axis = 0; axis < 3; ++axis) {
    fill(boxes.center[axis], 0.0F);
    fill(boxes.half[axis], -kNowhere);
  }
}

void setBox(PartList::Boxes& boxes, std::size_t i, const Vec3& center, const Vec3& half) {
  for (int axis = 0; axis < 3; ++axis) {
    boxes.center[axis][i] = center[axis];
    boxes.half[axis][i] = half[axis];
  }
}

struct Range {
  Vec3 low{std::numeric_limits<float>::max()};
  Vec3 high{std::numeric_limits<float>::lowest()};
};

/// Around the boxes from `first` on, before `end`.
Range rangeOf(const PartList::Boxes& boxes, std::size_t first, std::size_t end) {
  Range range;
  for (std::size_t i = first; i < end; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      range.low[axis] = std::min(range.low[axis], boxes.center[axis][i] - boxes.half[axis][i]);
      range.high[axis] = std::max(range.high[axis], boxes.center[axis][i] + boxes.half[axis][i]);
    }
  }
  return range;
}

}  // namespace

PartList::PartList(std::span<const PartDef> parts) {
  assign(parts);
}

void PartList::assign(std::span<const PartDef> parts) {
  assert(!parts.empty() && parts.size() <= std::numeric_limits<std::uint16_t>::max());
  parts_.resize(parts.size());
  addPolytopes(parts);
  addBoxes(parts);
  addEngineAxes(parts);
  addBlocks();
  boundAll();
}

void PartList::addPolytopes(std::span<const PartDef> parts) {
  std::size_t room = 0;
  for (const PartDef& part : parts) {
    assert(!part.core.empty() && part.core.size() <= std::numeric_limits<std::uint16_t>::max());
    room += roomOf(part.core.size()) + (part.kind == PartKind::kBox ? roomOf(8) : 0);
  }
  vertices_.resize(room);
  hasOpaque_ = false;
  float* next = vertices_.data();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PartDef& def = parts[i];
    Part& part = parts_[i];
    part.kind = def.kind;
    hasOpaque_ = hasOpaque_ || def.kind == PartKind::kOpaque;
    part.margin = def.margin;
    part.core = addPolytope(def.core, next);
    part.sharp = def.kind == PartKind::kBox ? addPolytope(cornersOf(def), next) : PolytopeView();
    setPlane(part, def.core);
  }
}

PolytopeView PartList::addPolytope(std::span<const Vec3> points, float*& next) {
  const auto room = static_cast<std::size_t>(simd::padded(static_cast<int>(points.size())));
  for (int axis = 0; axis < 3; ++axis) {
    float* const values = next + static_cast<std::size_t>(axis) * room;
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i][axis];
    std::fill(values + points.size(), values + room, points.back()[axis]);
  }
  const PolytopeView view{next, next + room, next + 2 * room, static_cast<int>(points.size())};
  next += 3 * room;
  return view;
}

void PartList::addBoxes(std::span<const PartDef> parts) {
  const auto room = static_cast<std::size_t>(paddedCount());
  resize(boxes_, parts.size(), room);
  resize(engineBoxes_, parts.size(), room);
  engineMargin_.assign(room, 0.0F);
  asking_.clear();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PartDef& part = parts[i];
    Vec3 low = part.core[0];
    Vec3 high = part.core[0];
    const auto include = [&](const Vec3& point) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    };
    const bool isBox = part.kind == PartKind::kBox;
    if (isBox) low = high = cornersOf(part)[0];
    if (isBox) std::ranges::for_each(cornersOf(part), include);
    if (!isBox) std::ranges::for_each(part.core, include);
    const float margin = isBox ? 0.0F : part.margin;
    parts_[i].center = 0.5F * (low + high);
    setBox(boxes_, i, parts_[i].center, 0.5F * (high - low) + Vec3(margin));
    setBox(engineBoxes_, i, part.boundsCenter, part.boundsHalf);
    engineMargin_[i] = part.boundsMargin;
    for (int axis = 0; axis < 3; ++axis) {
      parts_[i].boxFrame.row[axis] = {part.boundsAxes[0][axis], part.boundsAxes[1][axis],
                                      part.boundsAxes[2][axis]};
    }
    parts_[i].boxFrame.origin = part.boundsCenter;
    parts_[i].boxHalf = part.boundsHalf + Vec3(part.boundsMargin);
    if (part.asksBounds) asking_.push_back(i);
  }
}

void PartList::addEngineAxes(std::span<const PartDef> parts) {
  const auto isTurned = [](const PartDef& part) { return !part.asksBounds && part.boundsAxes != Mat3(1.0F); };
  for (std::vector<float>(&axis)[3] : engineAxes_) {
    for (std::vector<float>& values : axis) values.clear();
  }
  if (std::ranges::none_of(parts, isTurned)) return;
  const auto room = static_cast<std::size_t>(paddedCount());
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 3; ++k) {
      std::vector<float>& values = engineAxes_[axis][k];
      values.assign(room, axis == k ? 1.0F : 0.0F);
      for (std::size_t i = 0; i < parts.size(); ++i) values[i] = parts[i].boundsAxes[axis][k];
    }
  }
}

void PartList::addBlocks() {
  // With fewer, boxes of blocks are not worth a look of their own.
  constexpr int kMany = 4 * kBlock;
  const bool areMany = count() >= kMany;
  const std::size_t blocks = areMany ? (static_cast<std::size_t>(count()) + kBlock - 1) / kBlock : 0;
  resize(blocks_, blocks, static_cast<std::size_t>(simd::padded(static_cast<int>(blocks))));
  for (std::size_t i = 0; i < blocks; ++i) {
    const Range range = rangeOf(boxes_, i * kBlock, std::min((i + 1) * kBlock, parts_.size()));
    // Rounding must not make it smaller than what is in it.
    constexpr float kRounding = 1e-6F;
    const Vec3 widest = glm::max(glm::abs(range.low), glm::abs(range.high));
    setBox(blocks_, i, 0.5F * (range.low + range.high), 0.5F * (range.high - range.low) + kRounding * widest);
  }
}

void PartList::boundAll() {
  const Range range = rangeOf(boxes_, 0, parts_.size());
  center_ = 0.5F * (range.low + range.high);
  half_ = 0.5F * (range.high - range.low);
  radius_ = glm::length(half_);
}

// In the order of operations in which glm multiplies a vector and a matrix.
template <class L>
void PartList::worldBounds(const Frame& frame, std::vector<float>& bounds) const {
  constexpr auto kStep = L::size();
  const auto room = static_cast<std::size_t>(paddedCount());
  bounds.resize(6 * room);
  const bool areTurned = !engineAxes_[0][0].empty();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec3& row = frame.row[axis];
    const L turn[3]{L(row.x), L(row.y), L(row.z)};
    const L origin(frame.origin[static_cast<int>(axis)]);
    float* const low = bounds.data() + axis * room;
    float* const high = low + 3 * room;
    for (std::size_t i = 0; i < room; i += kStep) {
      const auto at = [i](const std::vector<float>& values) { return simd::load<L>(values.data() + i); };
      const auto along = [&](const std::vector<float>(&of)[3]) {
        return turn[0] * at(of[0]) + turn[1] * at(of[1]) + turn[2] * at(of[2]);
      };
      const auto spread = [&](int k) { return simd::stdx::abs(areTurned ? along(engineAxes_[k]) : turn[k]); };
      const L center = along(engineBoxes_.center) + origin;
      const L half = spread(0) * at(engineBoxes_.half[0]) + spread(1) * at(engineBoxes_.half[1]) +
                     spread(2) * at(engineBoxes_.half[2]) + at(engineMargin_);
      (center - half).copy_to(low + i, simd::stdx::element_aligned);
      (center + half).copy_to(high + i, simd::stdx::element_aligned);
    }
  }
}

template void PartList::worldBounds<simd::Lanes>(const Frame&, std::vector<float>&) const;
template void PartList::worldBounds<simd::OneLane>(const Frame&, std::vector<float>&) const;

void PartList::askBounds(const EngineBounds& engine, const Frame& frame, std::vector<float>& bounds) const {
  const auto room = static_cast<std::size_t>(paddedCount());
  for (const std::size_t part : asking_) {
    Vec3 low;
    Vec3 high;
    engine.boundsOf(static_cast<int>(part), frame, low, high);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds[axis * room + part] = low[static_cast<int>(axis)];
      bounds[(axis + 3) * room + part] = high[static_cast<int>(axis)];
    }
  }
}

std::size_t PartList::bytes() const {
  const std::size_t boxArrays = 2 * 6 + 1;
  return sizeof(*this) + parts_.size() * sizeof(Part) + asking_.size() * sizeof(std::size_t) +
         sizeof(float) * (vertices_.size() + boxArrays * static_cast<std::size_t>(paddedCount()) +
                          6 * blocks_.center[0].size() + 9 * engineAxes_[0][0].size());
}

}  // namespace scatter
