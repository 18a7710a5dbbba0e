#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/result.h>

#include <optional>
#include <vector>

namespace scatter {

/// Kilograms: of the body, else of the model, else of its shapes by their masses and densities, else 1.
[[nodiscard]] Result<float> documentMass(const DocumentModel& model, const DocumentBody& body);

/// What a homogeneous solid of these parts does not have: a centre, inertia or distribution of mass given by
/// hand. Nothing if there is none. `parts` are the convex shapes of the model, and `mass` is that of
/// the body, kilograms.
[[nodiscard]] Result<std::optional<MassProperties>> documentMassProperties(
    const DocumentModel& model, const std::vector<ConvexPart>& parts, float mass);

}  // namespace scatter
