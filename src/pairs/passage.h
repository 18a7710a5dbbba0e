#pragma once

#include <cstddef>
#include <optional>

#include "collision/part_list.h"
#include "pairs/ground_pieces.h"

namespace scatter::pairs {

/// A plane in front of which a body is to be held, in the ground's frame.
struct Passage {
  std::size_t piece = 0;  ///< Whose contacts it makes, of those that were told last.
  Vec3 normal{0.0F};      ///< Of length 1, to where the body came from.
  float offset = 0.0F;
  float reach = 0.0F;  ///< How far the body is about to move towards it, metres; 0 if it is behind already.

  [[nodiscard]] float heightOf(const Vec3& point) const { return glm::dot(normal, point) - offset; }
};

/// Watches whether a body passes through a ground of triangles between two steps. What lies with its middle
/// behind a triangle comes out soonest at the wrong side, so that engines that only know where bodies are
/// push a thin body through the ground that it fell upon; and what is past the ground's bounds after a step
/// is not asked about any more. The middle is a point of the inmost part, so that nothing may be where it is;
/// that of a ring is in its rim.
class PassageWatch {
 public:
  /// The body has these parts from now on; a passage that is open stays open.
  void begin(const PartList& parts);

  /// Nothing is known of where the body was, or the ground is another one.
  void forget();

  /// Takes in where the body is in the ground's frame, and how far it is about to move in this step at its
  /// velocity, metres; `pieces` are all that are nearer than `reach` to it and to where it goes. A passage
  /// opens if the middle has come through a piece since it was last told, for a way of more than half the
  /// body's radius only if it is along the velocity, as programs place bodies elsewhere, too. It closes when
  /// the middle is in front of the piece that is nearest, which is known if the triangles of a ground have
  /// their corners in one order, or there is none.
  void follow(const Frame& body, const GroundPieces& pieces, float reach, const Vec3& ahead);

  /// The body is behind: the plane across the shortest way from its middle to the ground.
  [[nodiscard]] const std::optional<Passage>& open() const { return open_; }

  /// Its middle is about to pass through a piece: that piece's plane. Not while a passage is open.
  [[nodiscard]] const std::optional<Passage>& coming() const { return coming_; }

  [[nodiscard]] bool holds() const { return open_ || coming_; }

  /// The way that the middle has come in motion since it was last told; zero if that is not known.
  [[nodiscard]] Vec3 wayTo(const Frame& body, const Vec3& ahead) const;

 private:
  void look(const Vec3& now, const Vec3& way, const GroundPieces& pieces, float reach);

  Vec3 middle_{0.0F};  ///< In the body's frame.
  float radius_ = 0.0F;
  std::optional<Vec3> last_{};  ///< Where it was, in the ground's frame.
  float clear_ = 0.0F;          ///< A way so long cannot end behind a piece, metres.
  std::optional<Passage> open_{};
  std::optional<Passage> coming_{};
  double side_ = 0.0;  ///< In front, the corners are counter-clockwise (1) or clockwise (-1).
};

}  // namespace scatter::pairs
