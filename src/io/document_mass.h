#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/result.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace scatter::io {

/// Kilograms: of the body, else of the model, else of its shapes by their masses and densities, else 1.
[[nodiscard]] Result<float> documentMass(const DocumentModel& model, const DocumentBody& body);

/// What a homogeneous solid of these parts does not have: a centre, inertia or distribution of mass given by
/// hand. Nothing if there is none. `parts` are the convex shapes of the model, and `mass` is that of
/// the body, kilograms.
[[nodiscard]] Result<std::optional<MassProperties>> documentMassProperties(
    const DocumentModel& model, const std::vector<ConvexPart>& parts, float mass);

/// What a file has to say of a mass other than that of a homogeneous solid of the finest level's parts;
/// `mass` in kilograms.
[[nodiscard]] std::optional<DocumentMassFrame> massFrameOf(const LevelSet& levels, float mass);

/// The model's levels, or `parts` as the only one, with this mass; that of a homogeneous solid if there is
/// none.
[[nodiscard]] Result<std::shared_ptr<const LevelSet>> levelsWithMass(
    const DocumentModel& model, const std::vector<ConvexPart>& parts,
    const std::optional<MassProperties>& mass);

/// In PhysicsDocument::materials: that of the model, else of the first of its shapes that has one.
[[nodiscard]] std::optional<std::size_t> documentMaterial(const DocumentModel& model);

}  // namespace scatter::io
