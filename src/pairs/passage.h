#pragma once

#include <cstddef>
#include <optional>

#include "collision/part_list.h"
#include "pairs/ground_pieces.h"

namespace scatter::pairs {

/// The way out for a body that is behind its ground: the plane across the shortest way from its middle to the
/// ground, in the ground's frame.
struct Passage {
  std::size_t piece = 0;  ///< That is nearest to the middle, of those that were told last.
  Vec3 normal{0.0F};      ///< Of length 1, the way out.
  float offset = 0.0F;

  [[nodiscard]] float heightOf(const Vec3& point) const { return glm::dot(normal, point) - offset; }
};

/// Watches whether a body passes through a ground of triangles between two looks. What lies with its middle
/// behind a triangle comes out soonest at the wrong side, so that engines that only know where bodies are
/// push a thin body through the ground that it fell upon. The middle is a point of the inmost part, so that
/// nothing may be where it is; that of a ring is in its rim.
class PassageWatch {
 public:
  /// The body has these parts from now on; a passage that is open stays open.
  void begin(const PartList& parts);

  /// Nothing is known of where the body was, or the ground is another one.
  void forget();

  /// Takes in where the body is in the ground's frame; `pieces` are all that are nearer to it than `reach`. A
  /// passage opens if the middle has come through a piece
  /// since it was last told, with the body in motion: against the ground at `velocity`, metres a second, for
  /// a way of more than half the body's radius, as programs place bodies elsewhere, too. It closes when
  /// the middle is in front of the piece that is nearest, which is known if the triangles of a ground have
  /// their corners in one order, or there is none.
  void follow(const Frame& body, const GroundPieces& pieces, float reach, const Vec3& velocity);

  [[nodiscard]] const std::optional<Passage>& open() const { return open_; }

  /// The way that the middle has come in motion since it was last told; zero if that is not known.
  [[nodiscard]] Vec3 wayTo(const Frame& body, const Vec3& velocity) const;

 private:
  void look(const Vec3& now, const Vec3& way, const GroundPieces& pieces, float reach);

  Vec3 middle_{0.0F};  ///< In the body's frame.
  float radius_ = 0.0F;
  std::optional<Vec3> last_{};  ///< Where it was, in the ground's frame.
  float clear_ = 0.0F;          ///< A way so long cannot end behind a piece, metres.
  std::optional<Passage> open_{};
  double side_ = 0.0;  ///< In front, the corners are counter-clockwise (1) or clockwise (-1).
};

}  // namespace scatter::pairs
