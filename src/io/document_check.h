#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/result.h>

#include <optional>
#include <string>

namespace scatter::io {

/// What a file format can hold and its reader takes, where formats differ. Metres, kilograms, seconds,
/// radians.
struct DocumentBounds {
  float maxDistance;  ///< Of a position from the origin; each coordinate is at most 1e5 anyway.
  float maxHalfExtent;
  float minSize;         ///< Of a shape.
  float minShapeWeight;  ///< Of the mass or density of a shape.
  float maxShapeWeight;
  float minInertia;
  float maxInertia;
  float maxSpeed;
  float maxGravity;
  float minTimeStep;
  float maxFieldAcceleration;
  float maxFieldRadius;
  float maxLinearLimit;  ///< Of joints.
  float maxAngularLimit;
  bool
      keepsNames;  ///< Names are written as they are, so that they must be UTF-8, and those of bodies differ.
  bool needsVolume;     ///< Refuses convex shapes without one.
  bool needsModel;      ///< Refuses documents without one.
  bool finestIsShapes;  ///< Has no other place for the parts of the finest level.
};

/// Whether a document can be written and read again: all indices exist, names of bodies are unique, numbers
/// are finite and within the bounds, every joint joins two things. The message names what is wrong, such as
/// "body 1 (\"ship\"): it is of a model that does not exist".
[[nodiscard]] Result<void> checkDocument(const PhysicsDocument& document, const DocumentBounds& bounds);

/// What is wrong with a shape, as a phrase; nothing if it can be written and read again.
[[nodiscard]] std::optional<std::string> findShapeDefect(const DocumentShape& shape,
                                                         const DocumentBounds& bounds);

}  // namespace scatter::io
