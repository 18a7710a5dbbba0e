#pragma once

#include "io/collada/frame.h"

#include <glm/gtc/constants.hpp>
#include <glm/mat4x4.hpp>

namespace scatter::io {

inline constexpr double kDegreesToRadians = glm::pi<double>() / 180.0;

/// The rotation that a `<rotate>` holds: an axis and an angle in degrees. The axis must not be zero.
[[nodiscard]] Quat rotationFromDegrees(double x, double y, double z, double degrees);

/// The product, that leaves one factor's rotation as it is where the other does not turn.
[[nodiscard]] Transform composed(const Transform& outer, const Transform& inner);

/// The `<translate>` and `<rotate>` children in the order in which they stand, each in the frame of the one
/// before; in the file's axes.
[[nodiscard]] Result<Transform> readPose(const ColladaFrame& frame, const pugi::xml_node& parent);

/// Where a frame stands in another one, y up, metres.
struct Placement {
  Transform pose{};        ///< Exact if `rigid`.
  glm::dmat4 matrix{1.0};  ///< The same with scale and shear.
  bool rigid = true;       ///< The matrix moves and turns only.
};

/// `inner`, given in the frame that `outer` places, in the frame around that.
[[nodiscard]] Placement operator*(const Placement& outer, const Placement& inner);

/// What the transform stack of a `<node>` says.
[[nodiscard]] Result<Placement> readNodePlacement(const ColladaFrame& frame, const pugi::xml_node& node);

/// A matrix taken apart: first scaled along the axes, then turned and moved.
struct RigidAndScale {
  Transform pose{};
  Vec3 scale{1.0F};
  bool sheared = false;  ///< The matrix also has a shear, which is left out.
};

/// Fails, with a phrase, if the matrix flattens space or is not finite.
[[nodiscard]] Result<RigidAndScale> takeApart(const glm::dmat4& matrix);

[[nodiscard]] glm::dmat4 matrixOf(const Transform& transform);

}  // namespace scatter::io
