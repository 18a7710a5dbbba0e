#pragma once

#include <scatter/levels/convex_part.h>
#include <scatter/levels/level_set.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "levels/build/distance_grid.h"
#include "levels/build/enclosing_hull.h"
#include "levels/build/fit_primitive.h"
#include "levels/build/merge_tree.h"
#include "levels/build/mirror.h"
#include "levels/build/symmetric_mesh.h"
#include "levels/mesh/region_map.h"
#include "levels/mesh/shells.h"
#include "levels/mesh/triangle_hull.h"

namespace scatter::levels {

/// What a part must hold, relative to the mesh's origin.
struct Content {
  std::vector<glm::dvec3> points;  ///< For a hull, whose margin is not counted.
  std::vector<Ball> balls;         ///< For a box or a round part, which has no margin.
};

struct PartDraft {
  ConvexPart part;    ///< In the model's frame.
  Content content;    ///< What a part around this one must hold.
  double gap = 0.0;   ///< The largest distance from its surface, margin counted, to the mesh that was found;
                      ///< times the weight there.
  double area = 0.0;  ///< Of its surface, about.
  double weight = 1.0;   ///< The largest of what it was made for.
  bool isMixed = false;  ///< Holds what is to be kept apart.
};

struct AssemblyDef {
  int maxVertices = 16;
  double hullMargin = 0.02;
  bool fitPrimitives = true;
  double thickness = 0.0;  ///< Which parts of the finest level have at least, metres.

  /// What the tree is of, if that is its own mirror image: so are the levels then.
  const SymmetricMesh* symmetry = nullptr;
};

/// When to stop splitting parts of the finest level.
struct FinestDef {
  std::size_t maxParts = 64;
  double gap = 0.0;  ///< No part needs to be nearer to the mesh than this, metres; weights counted.
};

/// Makes the parts of levels from the nodes of a merge tree.
class LevelAssembler {
 public:
  LevelAssembler(const MeshSpace& space, const DistanceGrid& grid, const TriangleRegions& regions,
                 const MergeTree& tree, const AssemblyDef& definition)
      : space_(space), grid_(grid), regions_(regions), tree_(tree), definition_(definition) {}

  /// A level: nodes of the tree, ascending, and the part of each.
  struct Draft {
    std::vector<NodeIndex> nodes;
    std::vector<PartDraft> parts;

    /// What was split on the way from the root, in order; what was split together is one entry.
    std::vector<std::vector<NodeIndex>> splits;
  };

  /// The finest level: splits the part furthest from the mesh until all are near enough or there are
  /// enough of them, those first that hold what is to be kept apart; two threads, which make what one would.
  /// `progress` is given a share from 0 to 1.
  [[nodiscard]] Draft finest(const FinestDef& definition, const std::function<void(double)>& progress);

  /// The next coarser level, of at most `count` parts around those of `finer`.
  [[nodiscard]] Draft coarser(const Draft& finer, std::size_t count);

 private:
  /// The pieces that a node falls into, but for images of others; two threads.
  [[nodiscard]] std::vector<std::pair<NodeIndex, PartDraft>> piecesOf(NodeIndex node);

  /// Sorts the parts into the draft, and adds their images.
  void fill(Draft& draft, std::vector<std::pair<NodeIndex, PartDraft>> parts) const;
  [[nodiscard]] PartDraft imageOf(const PartDraft& draft) const;

  /// What the part of a node must be the image of itself in.
  [[nodiscard]] std::optional<Mirror> mirrorOf(NodeIndex node) const;
  [[nodiscard]] EnclosingHullDef hullDef(const std::optional<Mirror>& mirror) const;

  [[nodiscard]] PartDraft finestPart(NodeIndex node, HullBuilder& builder) const;
  [[nodiscard]] PartDraft partAround(const Content& content, const std::optional<Mirror>& mirror,
                                     HullBuilder& builder) const;
  [[nodiscard]] std::optional<PartDraft> primitiveAround(const Content& content, const PartDraft& draft,
                                                         const TriangleHull& hull,
                                                         const std::optional<Mirror>& mirror,
                                                         HullBuilder& builder) const;

  /// Whether levels can stay symmetric with this part.
  [[nodiscard]] bool suits(const ConvexPart& part, const std::optional<Mirror>& mirror) const;
  [[nodiscard]] PartDraft plateAround(const std::vector<glm::dvec3>& points,
                                      const std::optional<Mirror>& mirror, HullBuilder& builder) const;
  [[nodiscard]] double gapOf(const TriangleHull& hull, double margin) const;
  [[nodiscard]] double weightedGapOf(const TriangleHull& hull, double margin) const;
  void setRegion(PartDraft& draft, const Cluster& triangles) const;
  [[nodiscard]] std::vector<glm::dvec3> pointsOf(const Cluster& triangles) const;

  const MeshSpace& space_;
  const DistanceGrid& grid_;
  const TriangleRegions& regions_;
  const MergeTree& tree_;
  AssemblyDef definition_;
  HullBuilder builder_;
  HullBuilder otherBuilder_;  ///< Of a second thread.
};

}  // namespace scatter::levels
