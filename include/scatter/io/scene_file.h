#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/math.h>
#include <scatter/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scatter {

/// A model of the library by its name, or a model file relative to the scene file.
struct SceneFileModel {
  std::string name{};
  std::size_t levels = 0;  ///< How many of its levels, from the finest on; 0: all.
};

/// A ball whose radius is drawn evenly between two; the same twice: that one.
struct SceneFileBall {
  float minRadius = 0.5F;
  float maxRadius = 0.5F;
};

/// A half-space whose surface goes through the object's position.
struct SceneFilePlane {
  Vec3 normal{0.0F, 1.0F, 0.0F};
};

/// The triangles of a mesh file relative to the scene file.
struct SceneFileMesh {
  std::string file{};
};

/// A rolling ground, made of smooth noise around the object's position: its lowest point is at the object's
/// height.
struct SceneFileTerrain {
  std::array<float, 2> size{};           ///< Along x and z, metres.
  std::array<std::uint32_t, 2> cells{};  ///< Along x and z; each is two triangles.
  float relief = 0.0F;                   ///< From the lowest point to the highest, metres.
  float roughness = 0.5F;  ///< Height of waves of half the length, of that of the longer ones: 0 to 1.
  std::uint64_t seed = 1;
  bool isHeightField = false;  ///< Else a triangle mesh of the same surface.
};

using SceneFileShape = std::variant<SceneFileModel, SceneFileBall, Box, Capsule, Cylinder, ConvexHull,
                                    SceneFilePlane, SceneFileMesh, SceneFileTerrain>;

enum class SceneFileMotion : std::uint8_t { kStatic, kKinematic, kDynamic };

/// What is absent comes from the model, or is the default of a body.
struct SceneFileMaterial {
  std::optional<float> friction{};
  std::optional<float> rollingFriction{};
  std::optional<float> spinningFriction{};
  std::optional<float> restitution{};
  std::optional<float> linearDamping{};   ///< Share of velocity lost per second.
  std::optional<float> angularDamping{};  ///< Share of angular velocity lost per second.
};

/// Where bodies are placed at random, their bounding spheres clear of all others in the same region.
struct SceneFileRegion {
  enum class Kind : std::uint8_t {
    kShell,  ///< Between two radii; directions and distances are even.
    kBall,   ///< Even in volume.
    kBox,
  };
  std::string name{};
  Kind kind = Kind::kBall;
  Vec3 center{0.0F};
  float inner = 0.0F;      ///< Of a shell, metres.
  float outer = 0.0F;      ///< Of a shell or ball.
  Vec3 size{0.0F};         ///< Of a box, whole lengths.
  float clearance = 0.0F;  ///< Metres between bounding spheres.
};

/// Bodies above one another, each resting on the one below.
struct SceneFileStack {
  Vec3 base{0.0F};   ///< The middle of the lowest one's underside.
  float gap = 0.0F;  ///< Metres between them.
};

/// In SceneFile::regions.
struct SceneFileRandomPlaces {
  std::size_t region = 0;
};

/// The first alternative has a place for each body.
using SceneFilePlacement = std::variant<std::vector<Vec3>, SceneFileStack, SceneFileRandomPlaces>;

struct SceneFileOrientation {
  enum class Kind : std::uint8_t {
    kGiven,
    kRandom,   ///< Evenly over all rotations.
    kUpright,  ///< Turned at random about the y axis.
  };
  Kind kind = Kind::kGiven;
  Quat rotation = kNoRotation;
};

/// A velocity, or an angular velocity.
struct SceneFileVelocity {
  enum class Kind : std::uint8_t {
    kGiven,   ///< `vector`.
    kRandom,  ///< Anywhere in a ball of radius `amount`.
    kToward,  ///< To the point `vector` at the speed `amount`.
    kAway,    ///< From the point `vector`: `amount` per second times the distance.
  };
  Kind kind = Kind::kGiven;
  Vec3 vector{0.0F};
  float amount = 0.0F;
};

/// One or several bodies that are alike.
struct SceneFileObject {
  int line = 0;  ///< In the file.
  std::string name{};
  SceneFileShape shape{};
  SceneFileMotion motion = SceneFileMotion::kDynamic;
  std::optional<float> mass{};     ///< Kilograms; at most one of mass and density.
  std::optional<float> density{};  ///< Kilograms per cubic metre.
  SceneFileMaterial material{};
  std::uint32_t group = 1;  ///< Collision group bit.
  std::uint32_t collidesWith = ~0U;
  bool mayRest = true;
  bool inFields = true;
  bool sensor = false;
  std::size_t count = 1;
  std::size_t firstBody = 0;  ///< In SceneFile::bodies.
  SceneFilePlacement placement{};
  SceneFileOrientation orientation{};
  SceneFileVelocity velocity{};
  SceneFileVelocity spin{};

  /// Models of the pieces that it breaks into; empty: the parts of its finest level.
  std::vector<SceneFileModel> gibs{};
};

struct SceneFileJoint {
  enum class Kind : std::uint8_t { kPoint, kHinge, kSlider, kFixed, kSixDof };
  int line = 0;
  Kind kind = Kind::kPoint;
  std::size_t bodyA = 0;               ///< In SceneFile::bodies.
  std::optional<std::size_t> bodyB{};  ///< The world if absent.
  Transform frame{};                   ///< In the world, at the start.
  float lower = 1.0F;                  ///< Of a hinge (radians) or slider (metres); free if lower > upper.
  float upper = -1.0F;
  Vec3 linearLower{0.0F};  ///< Of a six-dof joint, metres.
  Vec3 linearUpper{0.0F};
  Vec3 angularLower{0.0F};  ///< Radians.
  Vec3 angularUpper{0.0F};
  bool bodiesCollide = false;
};

struct SceneFileField {
  enum class Kind : std::uint8_t {
    kPoint,    ///< Toward a point, inside a radius.
    kUniform,  ///< The same everywhere.
  };
  int line = 0;
  std::string name{};  ///< May be empty.
  Kind kind = Kind::kPoint;
  Vec3 center{0.0F};
  Vec3 direction{0.0F, 1.0F, 0.0F};  ///< Of a uniform field; a unit vector.
  float acceleration = 0.0F;         ///< m/s².
  float radius = 0.0F;
  bool on = true;  ///< At the start.
};

/// A given velocity, or a speed toward a point or a body.
struct SceneFileThrow {
  std::variant<Vec3, std::size_t> target{};  ///< The velocity or point, or a body in SceneFile::bodies.
  std::optional<float> speed{};              ///< Absent: the target is a velocity.
  std::optional<Vec3> spin{};                ///< Absent: kept as it is.
};

/// An impulse at the centre of mass.
struct SceneFileKnock {
  Vec3 direction{0.0F};            ///< A unit vector.
  std::optional<float> impulse{};  ///< Newton seconds; or
  std::optional<float> speed{};    ///< the change of speed, m/s.
  bool inBodyFrame = false;        ///< Whether the direction turns with the body.
};

struct SceneFileBreak {
  float burst = 0.0F;   ///< How fast the pieces fly apart, per second, times the distance from the middle.
  float shrink = 1.0F;  ///< Size of each piece, of the part's; parts that overlap would push each other away.
};

struct SceneFileRemove {};

struct SceneFileSwitch {
  std::size_t field = 0;  ///< In SceneFile::fields.
  bool on = true;
};

/// What happens before the step number `frame`, counted from 0.
struct SceneFileEvent {
  int line = 0;
  std::uint64_t frame = 0;
  std::vector<std::size_t> bodies{};  ///< In SceneFile::bodies, in ascending order, each once.
  std::variant<SceneFileThrow, SceneFileKnock, SceneFileBreak, SceneFileRemove, SceneFileSwitch> deed{};
};

/// A scene as a TOML file describes it (docs/scene-files.md), checked: names are resolved, numbers are finite
/// and in range. Models and meshes are not looked up. Metres, kilograms, seconds, radians.
struct SceneFile {
  std::filesystem::path path{};
  std::string summary{};
  int frames = 600;
  std::uint64_t seed = 1;
  Vec3 gravity{0.0F};
  std::optional<int> solverIterations{};  ///< Absent: the physics' default.
  std::vector<SceneFileRegion> regions{};
  std::vector<SceneFileObject> objects{};
  std::vector<std::string> bodies{};  ///< Names of all bodies, in order of creation.
  std::vector<SceneFileField> fields{};
  std::vector<SceneFileJoint> joints{};
  std::vector<SceneFileEvent> events{};  ///< In order of frames; those of a frame in the file's order.
};

/// The most bodies that a scene file may make, the pieces of broken ones not counted.
inline constexpr std::size_t kMostSceneBodies = 20000;

/// Reads a scene file of at most 1 MiB. Errors read `FILE:LINE: what is wrong and how to mend it`.
[[nodiscard]] Result<SceneFile> readSceneFile(const std::filesystem::path& path);

/// The same from text; `path` is for messages, and for models and meshes relative to it.
[[nodiscard]] Result<SceneFile> parseSceneFile(std::string_view toml, const std::filesystem::path& path);

/// The tables of all sections and keys, with units, ranges and defaults, in Markdown, as docs/scene-files.md
/// has them.
[[nodiscard]] std::string sceneFileReference();

}  // namespace scatter
