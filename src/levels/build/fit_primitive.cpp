#include "levels/build/fit_primitive.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include "levels/build/face_axes.h"
#include "levels/part_check.h"
#include "levels/part_geometry.h"

namespace scatter::levels {
namespace {

constexpr int kCenterRounds = 300;

/// Of only a hull's vertices: cylinders are too wide by less than a thousandth for it.
constexpr int kAxisRounds = 3000;

/// Rounded up, so that nothing is lost.
float toFloatAbove(double value) {
  const auto rounded = static_cast<float>(value);
  return std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

/// The middle of about the smallest ball around others: steps toward the furthest, ever shorter (Bădoiu and
/// Clarkson, 2003). `squash` is 1, or leaves out the direction in which distance does not count.
glm::dvec3 middleOf(std::span<const Ball> balls, const glm::dvec3& squash, int rounds = kCenterRounds) {
  glm::dvec3 middle{0.0};
  for (const Ball& ball : balls) middle += ball.center / static_cast<double>(balls.size());
  for (int round = 1; round <= rounds; ++round) {
    glm::dvec3 toFurthest{0.0};
    double furthest = -1.0;
    for (const Ball& ball : balls) {
      const glm::dvec3 offset = squash * (ball.center - middle);
      const double distance = glm::length(offset) + ball.radius;
      if (distance > furthest) {
        furthest = distance;
        toFurthest = offset;
      }
    }
    middle += toFurthest / (1.0 + round);
  }
  return middle;
}

/// The balls in the frame of a rotation, which is rounded as it will be stored.
struct Frame {
  Quat rotation;
  DoublePose pose;
  std::vector<Ball> balls;

  Frame(std::span<const Ball> source, const Quat& turn)
      : rotation(turn), pose({Vec3(0.0F), turn}), balls(source.begin(), source.end()) {
    for (Ball& ball : balls) ball.center = pose.toLocal(ball.center);
  }

  /// The place in the model's frame as it will be stored, and moves the balls to be relative to it. A
  /// mirror's axis is the frame's own.
  Vec3 place(glm::dvec3 localMiddle, const Vec3& origin, const std::optional<Mirror>& mirror) {
    if (mirror) localMiddle = mirror->flattened(localMiddle);
    const Vec3 position(glm::dvec3(origin) + pose(localMiddle));
    const glm::dvec3 exact = pose.toLocal(glm::dvec3(position) - glm::dvec3(origin));
    for (Ball& ball : balls) ball.center -= exact;
    return position;
  }
};

Quat toQuat(const glm::dmat3& axes) {
  return glm::normalize(Quat(glm::quat_cast(axes)));
}

/// The rotation that takes the y axis, along which capsules and cylinders lie, to one of three axes.
glm::dmat3 withYAlong(const glm::dmat3& axes, int axis) {
  const glm::dvec3 y = axes[axis];
  const glm::dvec3 x = axes[(axis + 1) % 3];
  return {x, y, glm::cross(x, y)};
}

glm::dmat3 axesWith(const glm::dvec3& first) {
  const glm::dvec3 second = anyAcross(first);
  return {first, second, glm::cross(first, second)};
}

/// Axes like these that are turned about the mirror's own: those of something that is its own image.
glm::dmat3 turnedAbout(const Mirror& mirror, const glm::dmat3& axes) {
  glm::dvec3 own{0.0};
  own[mirror.axis] = 1.0;
  // Of three axes at right angles, the one that is furthest from the mirror's.
  glm::dvec3 across = axes[0];
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(axes[axis][mirror.axis]) < std::abs(across[mirror.axis])) across = axes[axis];
  }
  across = glm::normalize(mirror.flattened(across));
  glm::dmat3 result(1.0);
  result[mirror.axis] = own;
  result[(mirror.axis + 1) % 3] = across;
  result[(mirror.axis + 2) % 3] = glm::cross(own, across);
  return result;
}

/// Of a hull; what has them is its own image if a mirror is given.
glm::dmat3 axesOf(const TriangleHull& hull, const std::optional<Mirror>& mirror) {
  return mirror ? turnedAbout(*mirror, faceAxes(hull)) : faceAxes(hull);
}

/// The rotation of a capsule or a cylinder along one of the axes; nothing if a mirror does not leave it as it
/// is.
std::optional<glm::dmat3> axialFrame(const glm::dmat3& axes, int axis, const std::optional<Mirror>& mirror) {
  if (!mirror) return withYAlong(axes, axis);
  if (axis == 1) return axes;
  const int own = mirror->axis;
  if (axis == own || own == 1) return std::nullopt;
  glm::dmat3 turned = axes;
  turned[(own + 1) % 3] = axes[(own + 2) % 3];
  turned[(own + 2) % 3] = -axes[(own + 1) % 3];
  return turned;
}

double ballVolume(double radius) {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

double cylinderVolume(double radius, double half) {
  return 2.0 * std::numbers::pi * radius * radius * half;
}

/// How far a ball's middle is from a line along y.
double widthOf(const Ball& ball, const glm::dvec3& line) {
  return std::hypot(ball.center.x - line.x, ball.center.z - line.z);
}

FittedPrimitive fitBox(std::span<const Ball> balls, const Quat& rotation, const Vec3& origin,
                       const PrimitiveDef& definition) {
  Frame frame(balls, rotation);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const Ball& ball : frame.balls) {
    low = glm::min(low, ball.center - ball.radius);
    high = glm::max(high, ball.center + ball.radius);
  }
  const Vec3 position = frame.place(0.5 * (low + high), origin, definition.mirror);
  glm::dvec3 half{0.0};
  for (const Ball& ball : frame.balls) half = glm::max(half, glm::abs(ball.center) + ball.radius);
  half = glm::max(half + definition.slack, glm::dvec3(0.5 * definition.thickness));
  const Box box{{toFloatAbove(half.x), toFloatAbove(half.y), toFloatAbove(half.z)}};
  return {{box, {position, rotation}}, 8.0 * half.x * half.y * half.z};
}

FittedPrimitive fitSphere(std::span<const Ball> balls, const Vec3& origin, const PrimitiveDef& definition) {
  Frame frame(balls, kNoRotation);
  const Vec3 position = frame.place(middleOf(frame.balls, glm::dvec3(1.0)), origin, definition.mirror);
  double radius = 0.0;
  for (const Ball& ball : frame.balls) radius = std::max(radius, glm::length(ball.center) + ball.radius);
  radius += definition.slack;
  return {{Sphere{toFloatAbove(radius)}, {position, kNoRotation}}, ballVolume(radius)};
}

FittedPrimitive fitCapsule(std::span<const Ball> balls, const Quat& rotation, const Vec3& origin,
                           const PrimitiveDef& definition) {
  Frame frame(balls, rotation);
  const glm::dvec3 across{1.0, 0.0, 1.0};
  glm::dvec3 middle = across * middleOf(frame.balls, across);
  if (definition.mirror) middle = definition.mirror->flattened(middle);
  double radius = 0.0;
  for (const Ball& ball : frame.balls) radius = std::max(radius, widthOf(ball, middle) + ball.radius);
  // A ball near the axis may lie in the round end.
  const auto reachIntoEnd = [&](const Ball& ball, const glm::dvec3& axis) {
    const double room = radius - ball.radius;
    const double width = widthOf(ball, axis);
    return std::sqrt(std::max(0.0, room * room - width * width));
  };
  double top = -std::numeric_limits<double>::infinity();
  double bottom = -top;
  for (const Ball& ball : frame.balls) {
    top = std::max(top, ball.center.y - reachIntoEnd(ball, middle));
    bottom = std::min(bottom, ball.center.y + reachIntoEnd(ball, middle));
  }
  middle.y = 0.5 * (top + bottom);

  // Once more around the place as it is stored.
  const Vec3 position = frame.place(middle, origin, definition.mirror);
  const glm::dvec3 axis{0.0};
  for (const Ball& ball : frame.balls) radius = std::max(radius, widthOf(ball, axis) + ball.radius);
  double half = 0.0;
  for (const Ball& ball : frame.balls) {
    half = std::max(half, std::abs(ball.center.y) - reachIntoEnd(ball, axis));
  }
  radius += definition.slack;
  half += definition.slack;
  return {{Capsule{toFloatAbove(radius), toFloatAbove(half)}, {position, rotation}},
          ballVolume(radius) + cylinderVolume(radius, half)};
}

/// Half the extents of corners along the axes of a frame.
glm::dvec3 halfExtents(std::span<const Ball> corners, const glm::dmat3& frame) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const Ball& corner : corners) {
    const glm::dvec3 local = corner.center * frame;
    low = glm::min(low, local);
    high = glm::max(high, local);
  }
  return 0.5 * (high - low);
}

/// The axis is that of the corners, whose hull holds the balls, about.
FittedPrimitive fitCylinder(std::span<const Ball> balls, std::span<const Ball> corners, const Quat& rotation,
                            const Vec3& origin, const PrimitiveDef& definition) {
  Frame frame(balls, rotation);
  const glm::dvec3 across{1.0, 0.0, 1.0};
  glm::dvec3 middle = across * middleOf(Frame(corners, rotation).balls, across, kAxisRounds);
  double top = -std::numeric_limits<double>::infinity();
  double bottom = -top;
  for (const Ball& ball : frame.balls) {
    top = std::max(top, ball.center.y + ball.radius);
    bottom = std::min(bottom, ball.center.y - ball.radius);
  }
  middle.y = 0.5 * (top + bottom);
  const Vec3 position = frame.place(middle, origin, definition.mirror);
  double radius = 0.0;
  double half = 0.0;
  for (const Ball& ball : frame.balls) {
    radius = std::max(radius, widthOf(ball, glm::dvec3(0.0)) + ball.radius);
    half = std::max(half, std::abs(ball.center.y) + ball.radius);
  }
  radius = std::max(radius + definition.slack, 0.5 * definition.thickness);
  half = std::max(half + definition.slack, 0.5 * definition.thickness);
  return {{Cylinder{toFloatAbove(radius), toFloatAbove(half)}, {position, rotation}},
          cylinderVolume(radius, half)};
}

/// Spheres and capsules. They take longer to fit: first see from the box whether they can be small enough.
void addRound(std::span<const Ball> balls, const glm::dmat3& axes, const Vec3& origin,
              const PrimitiveDef& definition, std::vector<FittedPrimitive>& fitted) {
  const double slack = definition.slack;
  const glm::dvec3 half(std::get<Box>(fitted.front().part.shape).halfExtents);
  const double longest = std::max({half.x, half.y, half.z});
  if (ballVolume(longest - slack) <= definition.maxVolume)
    fitted.push_back(fitSphere(balls, origin, definition));
  for (int axis = 0; axis < 3; ++axis) {
    const double radius = std::max(half[(axis + 1) % 3], half[(axis + 2) % 3]) - slack;
    const double straight = std::max(0.0, half[axis] - slack - radius);
    if (ballVolume(radius) + cylinderVolume(radius, straight) > definition.maxVolume) continue;
    if (const std::optional<glm::dmat3> frame = axialFrame(axes, axis, definition.mirror))
      fitted.push_back(fitCapsule(balls, toQuat(*frame), origin, definition));
  }
}

/// Capsules and cylinders along the axes of the faces and along that of the largest one: of a cylinder as
/// wide as long, only flat faces tell where its axis is.
void addAxial(const FitInput& input, const Vec3& origin, const PrimitiveDef& definition,
              std::vector<FittedPrimitive>& fitted) {
  std::vector<Ball> corners;
  for (const glm::dvec3& vertex : input.tight->vertices) corners.push_back({vertex, 0.0});
  const auto add = [&](const glm::dmat3& axes, int axis) {
    const std::optional<glm::dmat3> frame = axialFrame(axes, axis, definition.mirror);
    if (!frame) return;
    // What is larger than wanted at least is not fitted.
    const glm::dvec3 half = halfExtents(corners, *frame);
    const double radius = std::max(half.x, half.z);
    if (cylinderVolume(radius, half.y) <= definition.maxVolume)
      fitted.push_back(fitCylinder(input.balls, corners, toQuat(*frame), origin, definition));
    const double straight = std::max(0.0, half.y - radius);
    if (ballVolume(radius) + cylinderVolume(radius, straight) <= definition.maxVolume)
      fitted.push_back(fitCapsule(input.balls, toQuat(*frame), origin, definition));
  };
  const glm::dmat3 axes = axesOf(*input.tight, definition.mirror);
  for (int axis = 0; axis < 3; ++axis) add(axes, axis);
  if (!definition.mirror) add(axesWith(largestFace(*input.tight)), 0);
}

struct BallsOf {
  DoublePose pose;
  double hullMargin = 0.0;

  std::vector<Ball> operator()(const Box& box) const {
    std::vector<Ball> balls;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const glm::dvec3 sign{(corner & 1U) != 0 ? 1.0 : -1.0, (corner & 2U) != 0 ? 1.0 : -1.0,
                            (corner & 4U) != 0 ? 1.0 : -1.0};
      balls.push_back({pose(sign * glm::dvec3(box.halfExtents)), 0.0});
    }
    return balls;
  }
  std::vector<Ball> operator()(const Sphere& sphere) const {
    return {{pose.position, static_cast<double>(sphere.radius)}};
  }
  std::vector<Ball> operator()(const Capsule& capsule) const {
    return onAxis(capsule.halfHeight, static_cast<double>(capsule.radius));
  }
  /// The corners of a prism around it.
  std::vector<Ball> operator()(const Cylinder& cylinder) const {
    std::vector<Ball> balls;
    for (const glm::dvec3& corner : prismAround(cylinder, pose)) balls.push_back({corner, 0.0});
    return balls;
  }
  std::vector<Ball> operator()(const ConvexHull& hull) const {
    std::vector<Ball> balls;
    for (const Vec3& vertex : hull.vertices) balls.push_back({pose(glm::dvec3(vertex)), hullMargin});
    return balls;
  }

 private:
  [[nodiscard]] std::vector<Ball> onAxis(float halfHeight, double radius) const {
    const glm::dvec3 end{0.0, static_cast<double>(halfHeight), 0.0};
    return {{pose(end), radius}, {pose(-end), radius}};
  }
};

}  // namespace

std::vector<FittedPrimitive> fitPrimitives(const FitInput& input, const Vec3& origin,
                                           const PrimitiveDef& definition) {
  const glm::dmat3 axes = axesOf(*input.few, definition.mirror);
  std::vector<FittedPrimitive> fitted{fitBox(input.balls, toQuat(axes), origin, definition),
                                      fitBox(input.balls, kNoRotation, origin, definition)};
  addRound(input.balls, axes, origin, definition, fitted);
  addAxial(input, origin, definition, fitted);
  // A wire has no capsule that a level takes.
  std::erase_if(fitted, [&](const FittedPrimitive& each) {
    return each.volume > definition.maxVolume || findDefect(each.part).has_value();
  });
  std::stable_sort(fitted.begin(), fitted.end(),
                   [](const FittedPrimitive& a, const FittedPrimitive& b) { return a.volume < b.volume; });
  return fitted;
}

std::vector<Ball> ballsOf(const ConvexPart& part, const Vec3& origin, double hullMargin) {
  DoublePose pose(part.pose);
  pose.position -= glm::dvec3(origin);
  return std::visit(BallsOf{pose, hullMargin}, part.shape);
}

}  // namespace scatter::levels
