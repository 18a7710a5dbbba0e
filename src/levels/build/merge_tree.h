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

  /// The image of a node that has none: half of a merge with both a part and its image.
  static constexpr NodeIndex kNoImage = ~NodeIndex{0};

  /// Every leaf is merged: there is one merge less than leaves. If the tree is its own mirror image, `images`
  /// has that of each node, which is the node itself if it is symmetric.
  MergeTree(std::vector<Cluster> leaves, std::vector<Merge> merges, std::vector<NodeIndex> images = {});

  [[nodiscard]] NodeIndex root() const { return static_cast<NodeIndex>(leaves_.size() + merges_.size() - 1); }
  [[nodiscard]] bool isLeaf(NodeIndex node) const { return node < leaves_.size(); }
  [[nodiscard]] const Merge& merge(NodeIndex node) const { return merges_[node - leaves_.size()]; }
  [[nodiscard]] std::size_t leafCount() const { return leaves_.size(); }

  /// Whether the node is the image of an earlier one.
  [[nodiscard]] bool isImage(NodeIndex node) const { return !images_.empty() && images_[node] < node; }

  /// Whether the node has an image that is another one.
  [[nodiscard]] bool isPair(NodeIndex node) const { return !images_.empty() && images_[node] != node; }
  [[nodiscard]] NodeIndex image(NodeIndex node) const { return images_[node]; }

  /// What is split together with a node, itself first, so that what is left is symmetric if the tree is. Each
  /// makes one node more.
  [[nodiscard]] std::vector<NodeIndex> splitWith(NodeIndex node) const;

  /// What a node falls into then, but for images of others.
  [[nodiscard]] std::vector<NodeIndex> piecesOf(NodeIndex node) const;

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
  std::vector<NodeIndex> images_;
};

}  // namespace scatter::levels
