#pragma once

#include <scatter/io/model.h>
#include <scatter/levels/convex_part.h>
#include <scatter/levels/level_set.h>
#include <scatter/math.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace scatter {

/// What a surface is like where it touches another one.
struct DocumentMaterial {
  std::string name{};
  float staticFriction = 0.5F;
  float dynamicFriction = 0.5F;
  float restitution = 0.0F;  ///< 0 no bounce, 1 full bounce.
};

/// The half-space normal · x <= offset is solid.
struct DocumentPlane {
  Vec3 normal{0.0F, 1.0F, 0.0F};
  float offset = 0.0F;
};

/// One shape of a rigid body. Tapered capsules and cylinders are read as convex hulls.
struct DocumentShape {
  std::variant<ConvexShape, DocumentPlane, VisualMesh> geometry{};
  Transform pose{};  ///< In the body's frame.

  /// In PhysicsDocument::materials; the body's if absent.
  std::optional<std::size_t> material{};
  std::optional<float> density{};  ///< Kilograms per cubic metre.
  std::optional<float> mass{};     ///< Kilograms.
};

enum class DocumentMotion : std::uint8_t { kStatic, kKinematic, kDynamic };

/// Mass, centre and inertia given by hand.
struct DocumentMassFrame {
  Transform pose{};               ///< Of the principal axes, in the body's frame.
  std::optional<Vec3> inertia{};  ///< Principal moments, kg m²; from the shapes if absent.
};

/// A kind of rigid body, of which there may be many in the scene.
struct DocumentModel {
  std::string name{};
  std::vector<DocumentShape> shapes{};  ///< At least one. With levels: those of the finest one.

  /// Nested levels; null for a plain rigid body.
  std::shared_ptr<const LevelSet> levels{};
  VisualMesh mesh{};  ///< What is drawn, in the body's frame; may be empty.
  DocumentMotion motion = DocumentMotion::kDynamic;

  /// Kilograms; from the shapes' densities or masses if absent, 1 if they have none either.
  std::optional<float> mass{};
  std::optional<DocumentMassFrame> massFrame{};
  std::optional<std::size_t> material{};  ///< In PhysicsDocument::materials.
};

/// Who collides with whom: two bodies do if both allow it. At most one of the lists of others is not empty.
struct DocumentFilter {
  std::vector<std::string> systems{};         ///< Those that the body is of.
  std::vector<std::string> collideWith{};     ///< Only with bodies of one of these.
  std::vector<std::string> notCollideWith{};  ///< Not with bodies of any of these.

  friend bool operator==(const DocumentFilter&, const DocumentFilter&) = default;
};

/// A rigid body in the scene.
struct DocumentBody {
  std::string name{};     ///< Unique in the document.
  std::size_t model = 0;  ///< In PhysicsDocument::models.
  Transform pose{};       ///< Of the body's frame in the world.
  Vec3 linearVelocity{0.0F};
  Vec3 angularVelocity{0.0F};  ///< Radians per second, world axes.

  /// Instead of the model's, if given.
  std::optional<DocumentMotion> motion{};
  std::optional<float> mass{};

  float gravityFactor = 1.0F;           ///< Of the scene's gravity.
  std::optional<std::size_t> filter{};  ///< In PhysicsDocument::filters; collides with all if absent.
};

/// Limits of one axis: locked if lower == upper, free if lower > upper.
struct DocumentLimit {
  float lower = 1.0F;
  float upper = -1.0F;
};

/// A rigid constraint. `frameA` and `frameB` coincide where nothing has moved.
struct DocumentJoint {
  std::string name{};
  std::optional<std::size_t> bodyA{};  ///< In PhysicsDocument::bodies; the world if absent.
  std::optional<std::size_t> bodyB{};
  Transform frameA{};                      ///< In body A's frame, or in the world.
  Transform frameB{};                      ///< In body B's frame, or in the world.
  std::array<DocumentLimit, 3> linear{};   ///< Metres, along the joint's x, y and z axes.
  std::array<DocumentLimit, 3> angular{};  ///< Radians, about them.
  bool enabled = true;
  bool bodiesCollide = false;
};

/// A constant acceleration toward `center` within `radius`.
struct DocumentField {
  std::string name{};
  Vec3 center{0.0F};
  float acceleration = 0.0F;  ///< m/s².
  float radius = 0.0F;
};

/// A physics scene, whatever file it came from. Metres, kilograms, seconds, radians, y up.
struct PhysicsDocument {
  std::string name{};
  std::vector<DocumentMaterial> materials{};
  std::vector<DocumentModel> models{};
  std::vector<DocumentBody> bodies{};
  std::vector<DocumentJoint> joints{};
  std::vector<DocumentFilter> filters{};
  std::vector<DocumentField> fields{};
  Vec3 gravity{0.0F};
  bool saysGravity = true;          ///< Else `gravity` is what readers assume.
  std::optional<float> timeStep{};  ///< Seconds.

  /// What the file has and the reader leaves out or mends, one line each, beginning "FILE:LINE:" or the like.
  std::vector<std::string> warnings{};
};

}  // namespace scatter
