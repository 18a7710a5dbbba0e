#pragma once

#include <scatter/math.h>

namespace scatter {

/// The frame in which an inertia tensor is diagonal.
struct PrincipalAxes {
  Quat rotation = kNoRotation;  ///< From the principal frame to the tensor's.
  Vec3 moments{0.0F};           ///< About the principal frame's axes.
};

/// Of a symmetric tensor, by Jacobi rotations. Products of inertia under 1e-4 of the largest moment are
/// ignored, so that the axes of a symmetric model stay its own.
[[nodiscard]] PrincipalAxes principalAxes(const Mat3& inertia);

}  // namespace scatter
