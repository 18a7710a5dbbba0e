#pragma once

#include <cstdint>
#include <vector>

#include "collision/part_body.h"

namespace scatter {

/// Two parts whose boxes are near each other.
struct Neighbours {
  std::uint16_t a;
  std::uint16_t b;
  float separation;  ///< Of the boxes along `axis`: a lower bound for the parts' distance.
  Vec3 axis;         ///< From A to B, in A's frame, of length 1.
};

/// Finds the pairs of parts that are near each other. Reuses its memory from search to search.
class NeighbourSearch {
 public:
  /// All pairs of parts whose boxes are not separated by more than `limit` along one of the six face axes of
  /// the two bodies, nor along the normal of a triangle of A, in ascending order of (a, b). `frameB` is B's
  /// frame in A's.
  void byPartBoxes(const PartList& a, const PartList& b, const Frame& frameB, float limit);

  /// All pairs of parts whose world bounds are no further apart than `limit` along any axis of the world, in
  /// ascending order, without an axis and with the lowest separation.
  void byWorldBounds(PartBody& a, PartBody& b, float limit);

  [[nodiscard]] const std::vector<Neighbours>& found() const { return found_; }

 private:
  struct Box {
    Vec3 center;
    Vec3 half;
  };

  /// The way of boxes from one frame to another, where they get bounds along the axes that are there.
  struct Passage {
    Vec3 row[3];
    Vec3 before;     ///< Added to a place before it is turned…
    Vec3 after;      ///< …and after that.
    Vec3 spread[3];  ///< The rows without signs; a little more, so that rounding does not narrow a box.

    [[nodiscard]] static Passage outOf(const Frame& frame);
    [[nodiscard]] static Passage into(const Frame& frame);
    [[nodiscard]] Box operator()(const Box& box) const;
    void findSpread();
  };

  /// The axes of A's three faces and of B's three, in A's frame; and their opposites.
  struct Faces {
    Vec3 axis[2][6]{};
    explicit Faces(const Frame& frameB);
  };

  /// Of a triangle of A, in A's frame: the box around one that leans is full of nothing, its plane tells
  /// more.
  struct Plane {
    Vec3 normal[2];  ///< And its opposite.
    float offset;
    float margin;
    Vec3 spread;  ///< What of the half extents of boxes of B reaches along it.

    Plane(const PartList::Part& triangle, const Frame& frameB);
  };

  /// Parts of one body that are near all of the other's, as boxes in both frames: one array a number in one
  /// block, padded with boxes that are nowhere near.
  struct Candidates {
    /// The first of three arrays.
    enum Array : std::uint8_t { kCenterInA = 0, kHalfInA = 3, kCenterInB = 6, kHalfInB = 9, kArrays = 12 };

    std::vector<std::uint16_t> part;
    std::vector<float> numbers;
    std::size_t room = 0;  ///< Of an array.

    void clear(std::size_t most);
    void pad();
    [[nodiscard]] float* of(int array) { return numbers.data() + static_cast<std::size_t>(array) * room; }
    [[nodiscard]] const float* of(int array) const {
      return numbers.data() + static_cast<std::size_t>(array) * room;
    }
    [[nodiscard]] Vec3 at(Array first, std::size_t i) const {
      return {of(first)[i], of(first + 1)[i], of(first + 2)[i]};
    }
  };

  class Axes;

  /// Calls `use` with where lanes of parts begin that may be near a box in their frame, in ascending order.
  template <class Use>
  static void forEachNear(const PartList& list, const Vec3& center, const Vec3& reach, Use&& use);

  template <Candidates::Array kCenterHere, Candidates::Array kCenterThere>
  static void collect(const PartList& list, const PartList& other, const Passage& there, const Passage& back,
                      float limit, Candidates& near);
  /// `plane`: of the part, or null.
  void pairUp(std::size_t ofA, const Faces& faces, const Plane* plane, float limit);

  Candidates nearA_;
  Candidates nearB_;
  std::vector<Neighbours> found_;
};

}  // namespace scatter
