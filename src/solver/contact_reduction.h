#pragma once

#include <span>
#include <vector>

#include "solver/lanes.h"

namespace scatter::solver {

/// A contact of two bodies that others of theirs may stand for.
struct ReducibleContact {
  Quad place{};   ///< w: distance, less than 0 in each other, metres.
  Quad normal{};  ///< w: above 0 for one that rather stays, as it bore something, or stayed, before.
  int kept = -1;  ///< Out: the contact that stands for it, its own index if it stays.
};

/// Leaves out contacts of two bodies that others stand for. Contacts whose normals are alike form a cluster;
/// of each cluster stay the deepest and those that are furthest from each other, which span nearly the same
/// area: [Moravanszky and Terdiman 2004, "Fast Contact Reduction for Dynamics Simulation"]. Those that bore
/// something a step before stay rather than others, so that the choice does not flicker; and what has sunk
/// further than the one that stands for it takes its place.
class ContactReduction {
 public:
  /// Sets ReducibleContact::kept. `most`: how many of each cluster may stay, at least 1. Returns how many do.
  int reduce(std::span<ReducibleContact> contacts, int most);

 private:
  void cluster(std::span<const ReducibleContact> contacts);
  [[nodiscard]] std::size_t findCluster(const Quad& normal) const;
  void addCluster(const Quad& normal);
  void sortByCluster();
  [[nodiscard]] int choose(std::span<ReducibleContact> contacts, std::span<const int> members, int most);

  // In memory that is used again.
  std::vector<LaneVector> clusters_;  ///< Normals, four at a time.
  std::vector<std::size_t> homes_;    ///< Of each contact, its cluster.
  std::vector<std::size_t> firsts_;   ///< Of each cluster, its first contact among the sorted; their number.
  std::vector<int> sorted_;           ///< Contacts, those of a cluster beside each other.

  /// Four members of a cluster.
  struct Members {
    LaneVector place;
    Lanes reach;       ///< What distances are multiplied by; 0 where there is none.
    Lanes distance2;   ///< From the nearest that was chosen.
    LaneMask nearest;  ///< That one, among the members.
  };

  static constexpr int kNone = -1;

  void gather(std::span<const ReducibleContact> contacts, std::span<const int> members);
  [[nodiscard]] int takeNext(int chosen);
  void settle(std::span<ReducibleContact> contacts, std::span<const int> members);
  [[nodiscard]] int nearest(int member) const {
    return members_[static_cast<std::size_t>(member / kLanes)].nearest[member % kLanes];
  }

  std::vector<Members> members_;
  std::vector<int> stands_;  ///< By the member that was chosen: the one that stays.
};

}  // namespace scatter::solver
