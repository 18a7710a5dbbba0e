#pragma once

#include <scatter/result.h>
#include <scatter/world/body.h>
#include <scatter/world/joint.h>

namespace scatter {

/// The shortest text that reads back as `value`, such as "-1" or "nan".
[[nodiscard]] std::string numberText(float value);

/// All of `def` but its convex parts, which massProperties() checks. The message names the body.
[[nodiscard]] Result<void> validateBody(const BodyDef& def);

/// The joint's kind and frame, not its bodies; the message begins with `joint`.
[[nodiscard]] Result<void> validateJoint(const JointDef& def, const std::string& joint);

/// The wheels and the suspension, not the chassis; the message begins with `vehicle`.
[[nodiscard]] Result<void> validateVehicle(const VehicleDef& def, const std::string& vehicle);

}  // namespace scatter
