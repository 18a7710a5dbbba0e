#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "levels/build/pre_merge.h"

namespace scatter::levels {

/// A node of a merge tree: first the leaves, then the merges in the order they were made.
using NodeIndex = std::uint32_t;

/// Clusters merged two by two into one.
class MergeTree {
 public:
  struct Merge {
    NodeIndex left = 0;
    NodeIndex right = 0;
  };

  /// Every leaf is merged: there is one merge less than leaves.
  MergeTree(std::vector<Cluster> leaves, std::vector<Merge> merges);

  [[nodiscard]] NodeIndex root() const { return static_cast<NodeIndex>(leaves_.size() + merges_.size() - 1); }
  [[nodiscard]] bool isLeaf(NodeIndex node) const { return node < leaves_.size(); }
  [[nodiscard]] const Merge& merge(NodeIndex node) const { return merges_[node - leaves_.size()]; }
  [[nodiscard]] std::size_t leafCount() const { return leaves_.size(); }

  /// The triangles under a node.
  [[nodiscard]] Cluster trianglesUnder(NodeIndex node) const;

  /// What the root falls into when these nodes are split one after the other. Sorted.
  [[nodiscard]] std::vector<NodeIndex> nodesAfter(const std::vector<NodeIndex>& splits) const;

  /// For each node, the place in `ancestors` of the one that it is or is under.
  [[nodiscard]] std::vector<std::size_t> ancestorPlaces(const std::vector<NodeIndex>& nodes,
                                                        const std::vector<NodeIndex>& ancestors) const;

 private:
  std::vector<Cluster> leaves_;
  std::vector<Merge> merges_;
  std::vector<NodeIndex> parents_;
};

}  // namespace scatter::levels
