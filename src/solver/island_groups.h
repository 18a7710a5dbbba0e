#pragma once

#include <span>
#include <vector>

namespace scatter::solver {

/// Which contacts can be solved beside each other. Bodies that touch, directly or through others, are an
/// island, whose contacts stay together; small islands share a group. Depends on the contacts alone, and not
/// on who solves them.
class IslandGroups {
 public:
  /// Contacts of two bodies, or of a body and something that no contact moves.
  struct Link {
    int a;
    int b;      ///< kNone: does not move.
    int count;  ///< Of the contacts.
  };
  static constexpr int kNone = -1;

  /// Every a and b is less than `bodies`. The islands of the bodies `apart` are the first group, which may be
  /// empty; each of the others takes islands, in the order of their first links, until it has `share`
  /// contacts.
  void group(int bodies, std::span<const Link> links, std::span<const int> apart, int share);

  [[nodiscard]] int count() const { return static_cast<int>(starts_.size()) - 1; }

  /// Indices of its links, in ascending order.
  [[nodiscard]] std::span<const int> linksOf(int group) const;

 private:
  void unite(std::span<const Link> links);
  [[nodiscard]] int chooseGroups(int share);
  void sortLinks(int groups);

  std::vector<int> parents_;  ///< Of each body, towards its island's root, which is the least of its bodies.
  std::vector<int> roots_;    ///< Of each link.
  std::vector<int> sizes_;    ///< Of a root's island, in contacts.
  std::vector<int> groups_;   ///< Of a root's island.
  std::vector<int> starts_{0, 0};
  std::vector<int> next_;
  std::vector<int> sorted_;
};

}  // namespace scatter::solver
