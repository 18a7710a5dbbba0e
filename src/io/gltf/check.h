#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/result.h>

#include <limits>

#include "io/document_check.h"

namespace scatter::io {

/// What the glTF reader takes.
inline constexpr DocumentBounds kGltfBounds{.maxDistance = std::numeric_limits<float>::infinity(),
                                            .maxHalfExtent = 0.5e5F,
                                            .minSize = 1e-6F,
                                            .minShapeWeight = 1e-9F,
                                            .maxShapeWeight = 1e12F,
                                            .minInertia = 1e-20F,
                                            .maxInertia = 1e20F,
                                            .maxSpeed = 1e6F,
                                            .maxGravity = 1e6F,
                                            .minTimeStep = 1e-6F,
                                            .maxFieldAcceleration = 1e6F,
                                            .maxFieldRadius = 1e5F,
                                            .maxLinearLimit = std::numeric_limits<float>::infinity(),
                                            .maxAngularLimit = std::numeric_limits<float>::infinity(),
                                            .keepsNames = true,
                                            .needsVolume = true,
                                            .needsModel = false,
                                            .finestIsShapes = false};

/// checkDocument, and whether the reader could afford the document and has a mass for each body.
[[nodiscard]] Result<void> checkGltfDocument(const PhysicsDocument& document);

}  // namespace scatter::io
