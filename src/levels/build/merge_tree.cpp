#include "levels/build/merge_tree.h"

#include <algorithm>
#include <set>
#include <utility>

namespace scatter::levels {

MergeTree::MergeTree(std::vector<Cluster> leaves, std::vector<Merge> merges, std::vector<NodeIndex> images)
    : leaves_(std::move(leaves)),
      merges_(std::move(merges)),
      parents_(leaves_.size() + merges_.size()),
      images_(std::move(images)) {
  parents_[root()] = root();
  for (std::size_t i = 0; i < merges_.size(); ++i) {
    const auto parent = static_cast<NodeIndex>(leaves_.size() + i);
    parents_[merges_[i].left] = parent;
    parents_[merges_[i].right] = parent;
  }
}

std::vector<NodeIndex> MergeTree::splitWith(NodeIndex node) const {
  if (images_.empty()) return {node};
  if (isPair(node)) return {node, images_[node]};
  const NodeIndex left = merge(node).left;
  if (images_[left] == kNoImage) return {node, left};
  return {node};
}

std::vector<NodeIndex> MergeTree::piecesOf(NodeIndex node) const {
  const Merge& halves = merge(node);
  if (images_.empty() || isPair(node)) return {halves.left, halves.right};
  if (images_[halves.left] == kNoImage) return {merge(halves.left).left, merge(halves.left).right};
  if (images_[halves.left] == halves.right) return {halves.left};
  return {halves.left, halves.right};
}

Cluster MergeTree::trianglesUnder(NodeIndex node) const {
  Cluster triangles;
  std::vector<NodeIndex> open{node};
  while (!open.empty()) {
    const NodeIndex next = open.back();
    open.pop_back();
    if (isLeaf(next)) {
      triangles.insert(triangles.end(), leaves_[next].begin(), leaves_[next].end());
    } else {
      open.push_back(merge(next).left);
      open.push_back(merge(next).right);
    }
  }
  return triangles;
}

std::vector<NodeIndex> MergeTree::nodesAfter(const std::vector<NodeIndex>& splits) const {
  std::set<NodeIndex> nodes{root()};
  for (const NodeIndex node : splits) {
    nodes.erase(node);
    nodes.insert(merge(node).left);
    nodes.insert(merge(node).right);
  }
  return {nodes.begin(), nodes.end()};
}

std::vector<std::size_t> MergeTree::ancestorPlaces(const std::vector<NodeIndex>& nodes,
                                                   const std::vector<NodeIndex>& ancestors) const {
  std::vector<std::size_t> places;
  places.reserve(nodes.size());
  for (NodeIndex node : nodes) {
    auto place = std::find(ancestors.begin(), ancestors.end(), node);
    while (place == ancestors.end()) {
      node = parents_[node];
      place = std::find(ancestors.begin(), ancestors.end(), node);
    }
    places.push_back(static_cast<std::size_t>(place - ancestors.begin()));
  }
  return places;
}

}  // namespace scatter::levels
