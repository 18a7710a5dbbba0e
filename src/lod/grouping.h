#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lod/situation.h"

namespace scatter::lod {

/// Two or more bodies that pairs connect. World axes, SI units.
struct Group {
  std::uint32_t first = 0;  ///< Of its members, in the order of all groups' members.
  std::uint32_t count = 0;
  Vec3 center{0.0F};      ///< Mean of the members' centres.
  Vec3 velocity{0.0F};    ///< Mean of the members' velocities.
  float range = 0.0F;     ///< Largest distance of a member's centre from `center`.
  float reach = 0.0F;     ///< Radius of the ball around `center` that holds the members' balls.
  float volume = 0.0F;    ///< Of the members' balls together, as if they did not overlap.
  float approach = 0.0F;  ///< Mean speed of the members towards `center`; negative if they fly apart.
};

/// The clusters of a world: connected components of its bodies. A pair connects its bodies if it touches or
/// their balls overlap, and both can be moved: a floor makes no group of what lies on it. Groups are numbered
/// by their member of the lowest index, so that the same situations give the same numbers.
///
/// Policies that look at groups may share one: they all call observe(), and it works once. Groups are made
/// anew every kInterval steps; bodies that came since are in none.
class Grouping {
 public:
  static constexpr std::uint64_t kInterval = 8;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  /// Makes groups anew if they are kInterval steps old.
  void observe(const Situation& situation);

  /// How many times groups were made anew.
  [[nodiscard]] std::uint64_t generation() const { return generation_; }

  [[nodiscard]] std::span<const Group> groups() const { return groups_; }

  /// Indices into Situation::bodies, ascending.
  [[nodiscard]] std::span<const std::uint32_t> members(const Group& group) const {
    return std::span(members_).subspan(group.first, group.count);
  }

  /// Index of the group that a body is in, or kNone.
  [[nodiscard]] std::uint32_t groupOf(std::uint32_t body) const {
    return body < groupOf_.size() ? groupOf_[body] : kNone;
  }

  /// The group whose affair a pair is: of both bodies, or of the one that is in a group; kNone if they are in
  /// different ones.
  [[nodiscard]] std::uint32_t groupOf(const PairView& pair) const;

 private:
  void connect(const Situation& situation);
  void number(std::size_t bodies);
  void listMembers();
  void measure(const Situation& situation, Group& group) const;

  std::uint64_t generation_ = 0;
  std::uint64_t step_ = 0;             ///< When groups were last made.
  std::vector<std::uint32_t> parent_;  ///< Of the union-find forest; the root is a tree's lowest index.
  std::vector<std::uint32_t> groupOf_;
  std::vector<std::uint32_t> members_;
  std::vector<Group> groups_;
};

}  // namespace scatter::lod
