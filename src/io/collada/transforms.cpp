#include "io/collada/transforms.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace scatter::io {
namespace {

Result<Transform> readTransform(const ColladaFrame& frame, const pugi::xml_node& node) {
  if (std::string_view(node.name()) == "translate") {
    return frame.vector(node).map([](const Vec3& offset) { return Transform{offset, kNoRotation}; });
  }
  const auto values = frame.numbers(node, 4);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const std::vector<double>& v = *values;
  const double length = std::hypot(v[0], v[1], v[2]);
  if (v[3] != 0.0 && !(length > 1e-9 && length < 1e9)) {
    return frame.xml().failAt(node, "the axis of rotation should have length 1");
  }
  return Transform{Vec3(0.0F),
                   v[3] == 0.0 ? kNoRotation : withoutNoise(rotationFromDegrees(v[0], v[1], v[2], v[3]))};
}

Result<glm::dmat4> readMatrix(const ColladaFrame& frame, const pugi::xml_node& node) {
  const auto values = frame.numbers(node, 16);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const std::vector<double>& v = *values;
  if (v[12] != 0.0 || v[13] != 0.0 || v[14] != 0.0 || v[15] != 1.0) {
    frame.note(node, "the last row is not 0 0 0 1 and is ignored");
  }
  glm::dmat4 matrix(1.0);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const double value = v[4 * row + column];
      matrix[static_cast<int>(column)][static_cast<int>(row)] =
          column == 3 ? value * frame.metersPerUnit() : value;
    }
  }
  return matrix;
}

/// The eye's frame: it looks along its negative z axis.
Result<glm::dmat4> readLookAt(const ColladaFrame& frame, const pugi::xml_node& node) {
  const auto values = frame.numbers(node, 9);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const std::vector<double>& v = *values;
  const glm::dvec3 eye(v[0], v[1], v[2]);
  const glm::dvec3 back = eye - glm::dvec3(v[3], v[4], v[5]);
  const glm::dvec3 right = glm::cross(glm::dvec3(v[6], v[7], v[8]), back);
  if (!(glm::length(right) > 1e-12 && glm::length(right) < 1e12)) {
    return frame.xml().failAt(node, "the direction of view has no length or is along the up direction");
  }
  const glm::dvec3 z = glm::normalize(back);
  const glm::dvec3 x = glm::normalize(right);
  return glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0), glm::dvec4(z, 0.0),
                    glm::dvec4(eye * frame.metersPerUnit(), 1.0));
}

Result<glm::dmat4> readScale(const ColladaFrame& frame, const pugi::xml_node& node) {
  return frame.numbers(node, 3).map(
      [](const std::vector<double>& v) { return glm::scale(glm::dmat4(1.0), glm::dvec3(v[0], v[1], v[2])); });
}

/// The placement of one element of a stack, in the file's axes.
Result<Placement> readStep(const ColladaFrame& frame, const pugi::xml_node& node) {
  const std::string_view name = node.name();
  if (name == "translate" || name == "rotate") {
    return readTransform(frame, node).map([](const Transform& pose) {
      return Placement{pose, matrixOf(pose), true};
    });
  }
  Result<glm::dmat4> matrix = glm::dmat4(1.0);
  if (name == "matrix") {
    matrix = readMatrix(frame, node);
  } else if (name == "lookat") {
    matrix = readLookAt(frame, node);
  } else if (name == "scale") {
    matrix = readScale(frame, node);
  } else if (name == "skew") {
    frame.note(node, "is not supported and is ignored");
  }
  return matrix.map([](const glm::dmat4& m) { return Placement{{}, m, m == glm::dmat4(1.0)}; });
}

Placement turnedYUp(const ColladaFrame& frame, const Placement& placement) {
  if (frame.toYUp() == kNoRotation) {
    return placement;
  }
  const glm::dmat4 up(glm::mat4_cast(glm::dquat(frame.toYUp())));
  return {frame.toYUp(placement.pose), up * placement.matrix * glm::transpose(up), placement.rigid};
}

}  // namespace

Transform composed(const Transform& outer, const Transform& inner) {
  Transform result = outer * inner;
  if (outer.rotation != kNoRotation && inner.rotation != kNoRotation) {
    result.rotation = unitRotation(result.rotation);
  }
  return result;
}

Quat rotationFromDegrees(double x, double y, double z, double degrees) {
  // Whole turns are taken out first: a huge angle would overflow the sine's argument reduction.
  const double half = 0.5 * std::fmod(degrees, 720.0) * kDegreesToRadians;
  const double scale = std::sin(half) / std::hypot(x, y, z);
  return {static_cast<float>(std::cos(half)), static_cast<float>(x * scale), static_cast<float>(y * scale),
          static_cast<float>(z * scale)};
}

Result<Transform> readPose(const ColladaFrame& frame, const pugi::xml_node& parent) {
  Transform pose;
  for (const pugi::xml_node& child : parent.children()) {
    const std::string_view name = child.name();
    if (name != "translate" && name != "rotate") {
      continue;
    }
    const auto step = readTransform(frame, child);
    if (!step) {
      return step;
    }
    pose = composed(pose, *step);
  }
  if (glm::length(pose.position) > static_cast<float>(ColladaFrame::kMaxLength)) {
    return frame.xml().failAt(parent, "is too far from the origin");
  }
  return pose;
}

glm::dmat4 matrixOf(const Transform& transform) {
  glm::dmat4 matrix = glm::mat4_cast(glm::normalize(glm::dquat(transform.rotation)));
  matrix[3] = glm::dvec4(glm::dvec3(transform.position), 1.0);
  return matrix;
}

Placement operator*(const Placement& outer, const Placement& inner) {
  Placement result{{}, outer.matrix * inner.matrix, outer.rigid && inner.rigid};
  if (result.rigid) {
    result.pose = composed(outer.pose, inner.pose);
  }
  return result;
}

Result<Placement> readNodePlacement(const ColladaFrame& frame, const pugi::xml_node& node) {
  Placement placement;
  for (const pugi::xml_node& child : node.children()) {
    const auto step = readStep(frame, child);
    if (!step) {
      return step;
    }
    placement = placement * *step;
  }
  return turnedYUp(frame, placement);
}

Result<RigidAndScale> takeApart(const glm::dmat4& matrix) {
  glm::dvec3 axes[3] = {glm::dvec3(matrix[0]), glm::dvec3(matrix[1]), glm::dvec3(matrix[2])};
  RigidAndScale result;
  for (int i = 0; i < 3; ++i) {
    const double length = glm::length(axes[i]);
    if (!(length > 1e-6 && length < 1e6)) {
      return fail("flattens its content or blows it up");
    }
    result.scale[i] = static_cast<float>(length);
    axes[i] /= length;
  }
  const auto slant = [&](int i, int k) { return std::abs(glm::dot(axes[i], axes[k])); };
  result.sheared = slant(0, 1) > 1e-4 || slant(0, 2) > 1e-4 || slant(1, 2) > 1e-4;
  const glm::dvec3 y = axes[1] - glm::dot(axes[0], axes[1]) * axes[0];
  const glm::dvec3 z = glm::cross(axes[0], y);
  if (!(glm::length(z) > 1e-6)) {
    return fail("flattens its content");
  }
  // A mirror image is turned as the original and scaled by a negative number.
  if (glm::dot(z, axes[2]) < 0.0) {
    result.scale.z = -result.scale.z;
  }
  const glm::dmat3 rotation(axes[0], glm::normalize(y), glm::normalize(z));
  result.pose.rotation = unitRotation(Quat(glm::quat_cast(rotation)));
  result.pose.position = Vec3(glm::dvec3(matrix[3]));
  if (!(glm::length(result.pose.position) <= static_cast<float>(ColladaFrame::kMaxLength))) {
    return fail("places it too far from the origin");
  }
  return result;
}

}  // namespace scatter::io
