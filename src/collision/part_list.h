#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "collision/frame.h"
#include "collision/support.h"

namespace scatter {

/// How the distance of two parts is decided.
enum class PartKind : std::uint8_t {
  kHull,      ///< Exactly the core, widened by the margin.
  kTriangle,  ///< The same, with a core of three points: a piece of a surface.
  kBox,       ///< Like kHull against others; two boxes meet with sharp edges.
  kSphere,    ///< The core is a point.
  kCapsule,   ///< The core is a segment.
  kEnclosed,  ///< Any convex shape: only known to lie inside the widened core.
  kOpaque,  ///< Only its bounds are known: the engine decides wherever they overlap. The core encloses those.
};

/// One convex part, in its body's frame.
struct PartDef {
  PartKind kind = PartKind::kHull;
  std::vector<Vec3> core{};  ///< At least one point; the part is their convex hull widened by `margin`.
  float margin = 0.0F;

  /// The box by which the engine bounds the part: its world bounds are those of this box, turned with the
  /// body, and `boundsMargin` more. Of a kBox it is the box itself.
  Vec3 boundsCenter{0.0F};
  Mat3 boundsAxes{1.0F};  ///< Columns.
  Vec3 boundsHalf{0.0F};
  float boundsMargin = 0.0F;

  /// The engine bounds the part in another way, which depends on the pose: EngineBounds tells its world
  /// bounds.
  bool asksBounds = false;
};

/// What only the engine knows of a body's parts.
class EngineBounds {
 public:
  EngineBounds() = default;
  EngineBounds(const EngineBounds&) = delete;
  EngineBounds& operator=(const EngineBounds&) = delete;
  virtual ~EngineBounds() = default;

  /// The world bounds of a part, with its body at `frame`.
  virtual void boundsOf(int part, const Frame& frame, Vec3& low, Vec3& high) const = 0;
};

/// The convex parts of a body as structure of arrays. Shared by all bodies of a model.
class PartList {
 public:
  /// At most 65535 parts of at most 65535 points each.
  explicit PartList(std::span<const PartDef> parts);
  PartList(const PartList&) = delete;  // its parts point into its vertices
  PartList& operator=(const PartList&) = delete;
  ~PartList() = default;

  /// Other parts in the same memory. Bodies that have the list must be given it again.
  void assign(std::span<const PartDef> parts);

  /// One array a coordinate; padded to a multiple of simd::kPadding with boxes that are nowhere near.
  struct Boxes {
    std::vector<float> center[3];
    std::vector<float> half[3];
  };

  /// What is needed of a part once a child pair is looked at.
  struct Part {
    PolytopeView core;
    PolytopeView sharp;  ///< Of a kBox, its corners.
    float margin = 0.0F;
    PartKind kind = PartKind::kHull;
    Vec3 center{0.0F};

    /// The box that bounds it, margin included: its own frame, centred, in the body's. Of a kBox the box
    /// itself.
    Frame boxFrame{};
    Vec3 boxHalf{0.0F};

    /// Of a kTriangle its plane, normal · x = offset. No normal: it has no area.
    Vec3 normal{0.0F};
    float offset = 0.0F;
  };

  [[nodiscard]] int count() const { return static_cast<int>(parts_.size()); }
  [[nodiscard]] int paddedCount() const { return simd::padded(count()); }
  [[nodiscard]] const Part& part(int i) const { return parts_[static_cast<std::size_t>(i)]; }

  /// Whether there is a kOpaque part, of which only the world bounds tell what is near.
  [[nodiscard]] bool hasOpaque() const { return hasOpaque_; }

  /// Around each part, in the body's frame, margins included.
  [[nodiscard]] const Boxes& boxes() const { return boxes_; }

  /// Of a list of many parts, around each kBlock that follow each other, in the same way; else none. What
  /// follows each other is mostly near each other: triangles come as the engine's tree of bounds has them.
  static constexpr int kBlock = 8 * simd::kPadding;
  [[nodiscard]] const Boxes& blocks() const { return blocks_; }

  /// Around all parts: a box in the body's frame, and the radius of the ball around its centre.
  [[nodiscard]] const Vec3& center() const { return center_; }
  [[nodiscard]] const Vec3& half() const { return half_; }
  [[nodiscard]] float radius() const { return radius_; }

  /// The world bounds of all parts of a body at `frame`: least x, y, z and largest x, y, z, paddedCount()
  /// each, one array after the other. Those of parts that ask for them are not the engine's.
  template <class L = simd::Lanes>
  void worldBounds(const Frame& frame, std::vector<float>& bounds) const;

  /// Overwrites the world bounds of the parts that ask for them with what the engine says.
  void askBounds(const EngineBounds& engine, const Frame& frame, std::vector<float>& bounds) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  void addPolytopes(std::span<const PartDef> parts);
  [[nodiscard]] static PolytopeView addPolytope(std::span<const Vec3> points, float*& next);
  void addBoxes(std::span<const PartDef> parts);
  void addEngineAxes(std::span<const PartDef> parts);
  void addBlocks();
  void boundAll();

  std::vector<Part> parts_;
  std::vector<float> vertices_;  ///< Of all polytopes: x, y and z, padded, one polytope after the other.
  Boxes boxes_;
  Boxes blocks_;
  Boxes engineBoxes_;
  std::vector<float> engineMargin_;
  std::vector<float> engineAxes_[3][3];  ///< Of each axis its x, y and z; empty if all are the body's axes.
  std::vector<std::size_t> asking_;      ///< Parts whose world bounds only the engine knows.
  Vec3 center_{0.0F};
  Vec3 half_{0.0F};
  float radius_ = 0.0F;
  bool hasOpaque_ = false;
};

}  // namespace scatter
