#include "collision/part_query.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/box_separation.h"
#include "collision/gjk.h"

namespace scatter {

namespace {

constexpr float kLargest = std::numeric_limits<float>::max();

bool areBoxes(const PartList::Part& a, const PartList::Part& b) {
  return a.kind == PartKind::kBox && b.kind == PartKind::kBox;
}

Vec3 column(const Frame& frame, int axis) {
  return {frame.row[0][axis], frame.row[1][axis], frame.row[2][axis]};
}

Frame placed(const Frame& body, const Frame& part) {
  Frame frame;
  for (int i = 0; i < 3; ++i) {
    frame.row[i] = body.row[i].x * part.row[0] + body.row[i].y * part.row[1] + body.row[i].z * part.row[2];
  }
  frame.origin = body(part.origin);
  return frame;
}

// Of the boxes around the parts.
float separationOfBoxes(const PartList::Part& a, const PartList::Part& b, const Frame& frameB, float enough) {
  const Frame boxB = relativeFrame(a.boxFrame, placed(frameB, b.boxFrame));
  return boxSeparation(Vec3(0.0F), a.boxHalf, Vec3(0.0F), b.boxHalf, boxB, enough);
}

// A sphere against a box; `centre` is in the box's frame.
float depthInBox(const Vec3& centre, float radius, const Vec3& half) {
  const Vec3 beyond = glm::abs(centre) - half;
  const Vec3 outside = glm::max(beyond, Vec3(0.0F));
  const float distance = glm::length(outside);
  if (distance > 0.0F) return radius - distance;
  return radius - std::max(beyond.x, std::max(beyond.y, beyond.z));
}

// How far the parts overlap along an axis of length 1, given in A's frame.
float overlapAlong(const PartList::Part& a, const PartList::Part& b, const Frame& frameB, const Vec3& axis) {
  const float reachA = reach(a.core, axis) + a.margin;
  const float reachB = reach(b.core, frameB.rotateBack(-axis)) + b.margin;
  return reachA + reachB - glm::dot(axis, frameB.origin);
}

// The least overlap along the axes of both parts' boxes, both ways, and along the line between the centres.
float leastOverlap(const PartList::Part& a, const PartList::Part& b, const Frame& frameB) {
  const Frame boxB = placed(frameB, b.boxFrame);
  const Vec3 between = boxB.origin - a.boxFrame.origin;
  float least = kLargest;
  const auto take = [&](const Vec3& axis) {
    least = std::min(least, overlapAlong(a, b, frameB, axis));
    least = std::min(least, overlapAlong(a, b, frameB, -axis));
  };
  for (int i = 0; i < 3; ++i) {
    take(column(a.boxFrame, i));
    take(column(boxB, i));
  }
  const float length = glm::length(between);
  if (length > 1e-6F) least = std::min(least, overlapAlong(a, b, frameB, between / length));
  return least;
}

struct Proof {
  float proven;    ///< What a plane shows to lie between them, margins off.
  float distance;  ///< As near as it is known; no less than `proven`.
};

// As far as GJK can tell; boxes by their 15 axes.
Proof separationOf(const PartList::Part& a, const PartList::Part& b, const Frame& frameB, const Vec3& axis,
                   float enough) {
  if (areBoxes(a, b)) {
    const float separation = separationOfBoxes(a, b, frameB, enough);
    if (separation <= 0.0F || separation > enough) return {separation, separation};
    // The axes of boxes that are apart need not give the distance.
    WarmSimplex fresh;
    const GjkResult result = gjkDistance(a.sharp, b.sharp, frameB, axis, enough, 1e-4F, fresh);
    const bool converged = result.state == GjkResult::State::kConverged;
    return {separation, std::max(separation, converged ? result.distance : result.provenDistance)};
  }
  const float margin = a.margin + b.margin;
  WarmSimplex fresh;
  const GjkResult result = gjkDistance(a.core, b.core, frameB, axis, enough + margin, 1e-4F, fresh);
  if (result.provenDistance == std::numeric_limits<float>::lowest()) return {-margin, -margin};
  const bool converged = result.state == GjkResult::State::kConverged;
  const float distance = std::max(converged ? result.distance : result.provenDistance, 0.0F);
  return {result.provenDistance - margin, distance - margin};
}

}  // namespace

float partDepth(const PartList::Part& a, const PartList::Part& b, const Frame& frameB) {
  const bool roundA = a.kind == PartKind::kSphere;
  const bool roundB = b.kind == PartKind::kSphere;
  float depth = 0.0F;
  if (areBoxes(a, b)) {
    depth = -separationOfBoxes(a, b, frameB, kLargest);
  } else if (roundA && roundB) {
    depth = a.margin + b.margin - glm::length(frameB(b.center) - a.center);
  } else if (roundA && b.kind == PartKind::kBox) {
    depth = depthInBox(b.boxFrame.toLocal(frameB.toLocal(a.center)), a.margin, b.boxHalf);
  } else if (roundB && a.kind == PartKind::kBox) {
    depth = depthInBox(a.boxFrame.toLocal(frameB(b.center)), b.margin, a.boxHalf);
  } else {
    // What the boxes' edges show as well, so that the depth has no jump where the boxes come apart.
    depth = -separationOfBoxes(a, b, frameB, 0.0F);
    if (depth > 0.0F) depth = std::min(depth, leastOverlap(a, b, frameB));
  }
  return std::max(depth, 0.0F);
}

bool PartQuery::isSeparated(const PartList& a, const PartList& b, const Frame& frameB, float gap) {
  if (boxSeparation(a.center(), a.half(), b.center(), b.half(), frameB, gap) > gap) return true;
  search_.byPartBoxes(a, b, frameB, gap);
  return std::all_of(search_.found().begin(), search_.found().end(), [&](const Neighbours& near) {
    if (near.separation > gap) return true;
    return separationOf(a.part(near.a), b.part(near.b), frameB, near.axis, gap).proven > gap;
  });
}

float PartQuery::distance(const PartList& a, const PartList& b, const Frame& frameB, float limit) {
  search_.byPartBoxes(a, b, frameB, limit);
  const std::vector<Neighbours>& found = search_.found();
  if (found.empty()) return limit;
  float least = limit;
  const auto look = [&](const Neighbours& near) {
    least = std::min(least, separationOf(a.part(near.a), b.part(near.b), frameB, near.axis, least).distance);
  };
  // What is nearest first, so that most of the others need no look.
  const auto nearest = std::min_element(
      found.begin(), found.end(),
      [](const Neighbours& one, const Neighbours& other) { return one.separation < other.separation; });
  look(*nearest);
  for (const Neighbours& near : found) {
    if (near.separation < least && &near != &*nearest) look(near);
  }
  return least;
}

const std::vector<PartQuery::Overlap>& PartQuery::overlaps(const PartList& a, const PartList& b,
                                                           const Frame& frameB) {
  overlaps_.clear();
  search_.byPartBoxes(a, b, frameB, 0.0F);
  for (const Neighbours& near : search_.found()) {
    const float depth = partDepth(a.part(near.a), b.part(near.b), frameB);
    if (depth > 0.0F) overlaps_.push_back({near.a, near.b, depth});
  }
  return overlaps_;
}

}  // namespace scatter
