#pragma once

#include "io/collada/frame.h"
#include "io/document_check.h"

namespace scatter::io {

/// What the COLLADA reader takes.
inline constexpr DocumentBounds kColladaBounds{.maxDistance = static_cast<float>(ColladaFrame::kMaxLength),
                                               .maxHalfExtent = static_cast<float>(ColladaFrame::kMaxLength),
                                               .minSize = static_cast<float>(ColladaFrame::kMinLength),
                                               .minShapeWeight = 1e-12F,
                                               .maxShapeWeight = 1e18F,
                                               .minInertia = 1e-18F,
                                               .maxInertia = 1e18F,
                                               .maxSpeed = static_cast<float>(ColladaFrame::kMaxLength),
                                               .maxGravity = 1e9F,
                                               .minTimeStep = 1e-9F,
                                               .maxFieldAcceleration = 1e12F,
                                               .maxFieldRadius = 1e12F,
                                               .maxLinearLimit = static_cast<float>(ColladaFrame::kMaxLength),
                                               .maxAngularLimit = 6.28319F,
                                               .keepsNames = false,
                                               .needsVolume = false,
                                               .needsModel = true,
                                               .finestIsShapes = true};

}  // namespace scatter::io
