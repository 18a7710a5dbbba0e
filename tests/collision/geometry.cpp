#include "collision/geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scatter::testing {

OwnedPolytope::OwnedPolytope(const std::vector<Vec3>& points) : count_(static_cast<int>(points.size())) {
  const auto room = static_cast<std::size_t>(simd::padded(count_));
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < room; ++i) {
      coordinates_[axis].push_back(points[std::min(i, points.size() - 1)][axis]);
    }
  }
}

PolytopeView OwnedPolytope::view() const {
  return {coordinates_[0].data(), coordinates_[1].data(), coordinates_[2].data(), count_};
}

Frame frameOf(const Quat& rotation, const Vec3& origin) {
  const Mat3 columns = glm::mat3_cast(rotation);
  Frame frame;
  for (int i = 0; i < 3; ++i) frame.row[i] = {columns[0][i], columns[1][i], columns[2][i]};
  frame.origin = origin;
  return frame;
}

Frame randomFrame(Random& random, float distance) {
  const Quat rotation = random.rotation();
  return frameOf(rotation, random.direction() * distance);
}

float anySize(Random& random, float low, float high) {
  return std::pow(10.0F, random.uniform(low, high));
}

int anyInt(Random& random, int low, int high) {
  return std::min(high, low + static_cast<int>(random.uniform(0.0F, static_cast<float>(high - low + 1))));
}

std::vector<Vec3> randomCore(Random& random, int most, float size) {
  const Mat3 turn = glm::mat3_cast(random.rotation());
  const int kind = anyInt(random, 0, 6);
  const int count = kind == 0 ? 1 : kind == 1 ? std::min(2, most) : anyInt(random, 1, most);
  Vec3 scale(size);
  if (kind == 2) scale.z = 0.0F;
  if (kind == 3) scale.z *= 1e-4F;
  if (kind == 4) scale.y *= 0.02F;
  if (kind == 5 && most >= 8) {
    std::vector<Vec3> corners = boxCorners(scale * Vec3(0.6F, 0.4F, 0.2F));
    for (Vec3& corner : corners) corner = turn * corner;
    return corners;
  }
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(turn * (random.direction() * scale));
  return points;
}

namespace {

void boundByCore(PartDef& part) {
  Vec3 low = part.core[0];
  Vec3 high = part.core[0];
  for (const Vec3& point : part.core) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  part.boundsCenter = 0.5F * (low + high);
  part.boundsHalf = 0.5F * (high - low);
  part.boundsMargin = part.margin;
}

}  // namespace

PartDef hullPart(std::vector<Vec3> core, float margin) {
  PartDef part;
  part.core = std::move(core);
  part.margin = margin;
  boundByCore(part);
  return part;
}

PartDef enclosedPart(std::vector<Vec3> core, float margin) {
  PartDef part = hullPart(std::move(core), margin);
  part.kind = PartKind::kEnclosed;
  return part;
}

PartDef boxPart(const Vec3& center, const Vec3& half, const Mat3& axes, float margin) {
  PartDef part;
  part.kind = PartKind::kBox;
  for (const Vec3& corner : boxCorners(half - margin)) part.core.push_back(center + axes * corner);
  part.margin = margin;
  part.boundsCenter = center;
  part.boundsAxes = axes;
  part.boundsHalf = half;
  return part;
}

PartDef spherePart(const Vec3& center, float radius) {
  PartDef part = hullPart({center}, radius);
  part.kind = PartKind::kSphere;
  return part;
}

PartDef capsulePart(const Vec3& from, const Vec3& to, float radius) {
  PartDef part = hullPart({from, to}, radius);
  part.kind = PartKind::kCapsule;
  return part;
}

PartDef randomPart(Random& random, float size, float slack) {
  const Vec3 center = random.inBox(Vec3(size));
  const float own = size * random.uniform(0.1F, 0.5F);
  const float margin = random.uniform(0.0F, 0.1F) * own;
  PartDef part;
  switch (anyInt(random, 0, 5)) {
    case 0: {
      const Vec3 half = own * Vec3(random.uniform(0.3F, 1.0F), random.uniform(0.3F, 1.0F), 0.3F);
      const bool turned = random.uniform(0.0F, 1.0F) < 0.5F;
      part = boxPart(center, half, turned ? glm::mat3_cast(random.rotation()) : Mat3(1.0F), margin);
      break;
    }
    case 1:
      part = spherePart(center, own);
      break;
    case 2:
      part = capsulePart(center, center + own * random.direction(), 0.3F * own);
      break;
    default: {
      std::vector<Vec3> core = randomCore(random, 20, own);
      for (Vec3& point : core) point += center;
      const bool known = random.uniform(0.0F, 1.0F) < 0.7F;
      part = known ? hullPart(std::move(core), margin) : enclosedPart(std::move(core), margin);
    }
  }
  part.boundsMargin += slack;
  return part;
}

std::vector<PartDef> randomParts(Random& random, int count, float size, float slack) {
  std::vector<PartDef> parts;
  for (int i = 0; i < count; ++i) parts.push_back(randomPart(random, size, slack));
  return parts;
}

}  // namespace scatter::testing
