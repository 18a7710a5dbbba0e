#include "levels/build/level_assembly.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>
#include <utility>
#include <variant>

#include "levels/build/enclosing_hull.h"
#include "levels/build/hull_gap.h"
#include "levels/build/thick_hull.h"
#include "levels/part_geometry.h"

namespace scatter::levels {
namespace {

/// Shares of the diagonal.
constexpr double kSpacing = 1.0 / 60.0;
constexpr double kNegligibleGap = 1e-4;
constexpr double kPrimitiveSlack = 2e-7;
constexpr double kThinnestBox = 2e-6;     // metres: files take none thinner
constexpr double kTightTolerance = 1e-5;  // a twentieth of the default margin: turns no face that counts
constexpr double kTightThickness = 1e-4;
/// By how much a primitive's gap may exceed the hull's.
constexpr double kPrimitiveGap = 1e-3;

/// Of the polytope by which a cylinder's gap is measured: a thousandth of the radius is lost.
constexpr int kCylinderSides = 64;

/// By what factor a primitive's volume may exceed the hull's.
constexpr double kPrimitiveVolume = 1.1;

/// More than rounding to single precision takes, as a share of the value.
constexpr double kFloatRounding = 1e-6;

/// How much the area of a part counts beside its gap; found by trial.
constexpr double kAreaPower = 0.25;

/// Below so many cells the grid is too coarse to tell a gap.
constexpr double kFineCells = 2.0;

ConvexPart toPart(const TriangleHull& hull, const Vec3& origin) {
  ConvexHull shape;
  shape.vertices.reserve(hull.vertices.size());
  for (const glm::dvec3& vertex : hull.vertices) shape.vertices.emplace_back(vertex);
  return {std::move(shape), Transform{origin, kNoRotation}};
}

/// Points whose hull holds what the part reaches beyond the margin that a hull around it has.
std::vector<glm::dvec3> outlineOf(const ConvexPart& part, const Vec3& origin, double hullMargin) {
  std::vector<glm::dvec3> points;
  for (const Ball& ball : ballsOf(part, origin, hullMargin)) {
    const double radius = ball.radius - hullMargin;
    if (!(radius > 0.0)) {
      points.push_back(ball.center);
      continue;
    }
    const ConvexPart sphere{Sphere{static_cast<float>(radius)}, {}};
    const Polytope around = outerPolytope(sphere, 0.0, {}, 0.0);
    for (const glm::dvec3& corner : around.vertices()) {
      points.push_back(ball.center + corner * (1.0 + kFloatRounding));
    }
  }
  return points;
}

/// Points whose hull is as near to the mesh as the part, about: around a cylinder it would be further away.
std::vector<glm::dvec3> surfacePointsOf(const ConvexPart& part, const Vec3& origin) {
  const auto* const cylinder = std::get_if<Cylinder>(&part.shape);
  if (cylinder == nullptr) return outlineOf(part, origin, 0.0);
  DoublePose pose(part.pose);
  pose.position -= glm::dvec3(origin);
  return prismIn(*cylinder, kCylinderSides, pose);
}

void add(Content& content, const Content& more) {
  content.points.insert(content.points.end(), more.points.begin(), more.points.end());
  content.balls.insert(content.balls.end(), more.balls.begin(), more.balls.end());
}

double volumeOf(const TriangleHull& hull) {
  double volume = 0.0;
  for (const Triangle& t : hull.triangles) {
    const glm::dvec3& a = hull.vertices.front();
    volume +=
        glm::dot(hull.vertices[t[0]] - a, glm::cross(hull.vertices[t[1]] - a, hull.vertices[t[2]] - a)) / 6.0;
  }
  return volume;
}

Content contentOf(std::vector<glm::dvec3> points) {
  Content content{std::move(points), {}};
  for (const glm::dvec3& point : content.points) content.balls.push_back({point, 0.0});
  return content;
}

/// How far the rim of a flat plate is from the sheet: half its thickness in two directions.
double rimOf(const AssemblyDef& definition) {
  return std::sqrt(0.5) * definition.thickness;
}

}  // namespace

LevelAssembler::Draft LevelAssembler::finest(const FinestDef& definition,
                                             const std::function<void(double)>& progress) {
  const double nearest = definition_.hullMargin + rimOf(definition_) + kNegligibleGap * space_.mesh.diagonal;
  // Many hulls in place of one primitive bring as little as a hull in its place would, unless a gap is asked
  // for.
  const double saved = definition.gap > 0.0 ? 0.0 : kPrimitiveGap * space_.mesh.diagonal;
  const auto nearEnough = [&](const PartDraft& part) {
    const bool isPrimitive = !std::holds_alternative<ConvexHull>(part.part.shape);
    return (nearest + (isPrimitive ? saved : 0.0)) * part.weight;
  };
  std::vector<std::pair<NodeIndex, PartDraft>> parts;
  // Importance and place in `parts`, the most important on top, the earliest of equals.
  using Entry = std::pair<double, std::size_t>;
  const auto isLess = [](const Entry& a, const Entry& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(isLess)> queue(isLess);
  Draft draft;
  const auto add = [&](std::size_t place, NodeIndex node, PartDraft made) {
    parts[place] = {node, std::move(made)};
    const PartDraft& part = parts[place].second;
    // Of two with the same gap, the larger part shows more of it.
    const double share = part.area / (space_.mesh.diagonal * space_.mesh.diagonal);
    if (tree_.isLeaf(node)) return;
    if (part.isMixed) {
      queue.emplace(std::numeric_limits<double>::infinity(), place);
    } else if (part.gap > std::max(definition.gap, nearEnough(part))) {
      queue.emplace(part.gap * std::pow(share, kAreaPower), place);
    }
  };
  parts.resize(1);
  std::size_t count = 1;
  add(0, tree_.root(), finestPart(tree_.root(), builder_));
  while (!queue.empty() && count < definition.maxParts) {
    const std::size_t place = queue.top().second;
    queue.pop();
    const std::vector<NodeIndex> splits = tree_.splitWith(parts[place].first);
    // Where two more are too many, another part may fall into one more.
    if (count + splits.size() > definition.maxParts) continue;
    count += splits.size();
    draft.splits.push_back(splits);
    std::vector<std::pair<NodeIndex, PartDraft>> pieces = piecesOf(splits.front());
    if (pieces.size() > 1) parts.emplace_back();
    add(place, pieces.front().first, std::move(pieces.front().second));
    if (pieces.size() > 1) add(parts.size() - 1, pieces.back().first, std::move(pieces.back().second));
    progress(static_cast<double>(count) / static_cast<double>(definition.maxParts));
  }
  fill(draft, std::move(parts));
  return draft;
}

std::vector<std::pair<NodeIndex, PartDraft>> LevelAssembler::piecesOf(NodeIndex node) {
  const std::vector<NodeIndex> nodes = tree_.piecesOf(node);
  if (nodes.size() == 1) return {{nodes.front(), finestPart(nodes.front(), builder_)}};
  std::future<PartDraft> right =
      std::async([this, &nodes] { return finestPart(nodes.back(), otherBuilder_); });
  PartDraft left = finestPart(nodes.front(), builder_);
  return {{nodes.front(), std::move(left)}, {nodes.back(), right.get()}};
}

void LevelAssembler::fill(Draft& draft, std::vector<std::pair<NodeIndex, PartDraft>> parts) const {
  const std::size_t count = parts.size();
  for (std::size_t i = 0; i < count; ++i) {
    const NodeIndex node = parts[i].first;
    if (tree_.isPair(node)) parts.emplace_back(tree_.image(node), imageOf(parts[i].second));
  }
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [node, part] : parts) {
    draft.nodes.push_back(node);
    draft.parts.push_back(std::move(part));
  }
}

PartDraft LevelAssembler::imageOf(const PartDraft& draft) const {
  const Mirror& mirror = definition_.symmetry->mirror;
  PartDraft image = draft;
  image.part = mirrored(draft.part, mirror, space_.mesh.origin);
  for (glm::dvec3& point : image.content.points) point = mirror(point);
  for (Ball& ball : image.content.balls) ball.center = mirror(ball.center);
  return image;
}

std::optional<Mirror> LevelAssembler::mirrorOf(NodeIndex node) const {
  if (definition_.symmetry == nullptr || tree_.isPair(node)) return std::nullopt;
  return definition_.symmetry->mirror;
}

EnclosingHullDef LevelAssembler::hullDef(const std::optional<Mirror>& mirror) const {
  return {space_.mesh.diagonal, definition_.maxVertices, mirror};
}

PartDraft LevelAssembler::finestPart(NodeIndex node, HullBuilder& builder) const {
  const Cluster triangles = tree_.trianglesUnder(node);
  const std::vector<glm::dvec3> points = pointsOf(triangles);
  const std::optional<Mirror> mirror = mirrorOf(node);
  PartDraft draft = definition_.thickness > 0.0 ? plateAround(points, mirror, builder)
                                                : partAround(contentOf(points), mirror, builder);
  setRegion(draft, triangles);
  return draft;
}

PartDraft LevelAssembler::plateAround(const std::vector<glm::dvec3>& points,
                                      const std::optional<Mirror>& mirror, HullBuilder& builder) const {
  // How well a plate follows a sheet is told without its thickness, which would hide how it bends.
  const TriangleHull thin = encloseInHull(builder, points, hullDef(mirror));
  const double gap = gapOf(thin, definition_.hullMargin + rimOf(definition_));
  std::vector<glm::dvec3> thick = thickenedTo(points, definition_.thickness);
  if (mirror) thick = withImages(thick, *mirror);
  PartDraft draft = partAround(contentOf(std::move(thick)), mirror, builder);
  draft.gap = std::max(gap, draft.gap);
  return draft;
}

LevelAssembler::Draft LevelAssembler::coarser(const Draft& finer, std::size_t count) {
  Draft draft;
  // The first splits are those that bring the most.
  std::vector<NodeIndex> splits;
  for (const std::vector<NodeIndex>& together : finer.splits) {
    if (splits.size() + together.size() >= count) break;
    splits.insert(splits.end(), together.begin(), together.end());
    draft.splits.push_back(together);
  }
  const std::vector<NodeIndex> nodes = tree_.nodesAfter(splits);
  const std::vector<std::size_t> places = tree_.ancestorPlaces(finer.nodes, nodes);
  std::vector<std::pair<NodeIndex, PartDraft>> parts;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (tree_.isImage(nodes[i])) continue;
    Content content;
    std::size_t children = 0;
    std::size_t child = 0;
    for (std::size_t j = 0; j < places.size(); ++j) {
      if (places[j] != i) continue;
      ++children;
      child = j;
      add(content, finer.parts[j].content);
    }
    parts.emplace_back(
        nodes[i], children == 1 ? finer.parts[child] : partAround(content, mirrorOf(nodes[i]), builder_));
  }
  fill(draft, std::move(parts));
  return draft;
}

PartDraft LevelAssembler::partAround(const Content& content, const std::optional<Mirror>& mirror,
                                     HullBuilder& builder) const {
  const TriangleHull hull = encloseInHull(builder, content.points, hullDef(mirror));
  PartDraft draft;
  draft.part = toPart(hull, space_.mesh.origin);
  draft.gap = gapOf(hull, definition_.hullMargin);
  draft.area = hull.area;
  if (definition_.fitPrimitives) {
    if (std::optional<PartDraft> primitive = primitiveAround(content, draft, hull, mirror, builder))
      draft = std::move(*primitive);
  }
  draft.content.points = outlineOf(draft.part, space_.mesh.origin, definition_.hullMargin);
  if (mirror) draft.content.points = withImages(draft.content.points, *mirror);
  draft.content.balls = ballsOf(draft.part, space_.mesh.origin, definition_.hullMargin);
  return draft;
}

std::optional<PartDraft> LevelAssembler::primitiveAround(const Content& content, const PartDraft& draft,
                                                         const TriangleHull& hull,
                                                         const std::optional<Mirror>& mirror,
                                                         HullBuilder& builder) const {
  const double diagonal = space_.mesh.diagonal;
  TriangleHull tight;
  buildThickHull(builder, content.points,
                 {kTightTolerance * diagonal, kTightThickness * diagonal, definition_.maxVertices}, tight);
  const PrimitiveDef wanted{kPrimitiveSlack * diagonal, kThinnestBox, kPrimitiveVolume * volumeOf(hull),
                            mirror};
  const FitInput input{content.balls, &hull, &tight};
  for (const FittedPrimitive& fitted : fitPrimitives(input, space_.mesh.origin, wanted)) {
    if (!suits(fitted.part, mirror)) continue;
    TriangleHull outline;
    if (!builder.build(surfacePointsOf(fitted.part, space_.mesh.origin), {}, outline)) continue;
    const double gap = gapOf(outline, 0.0);
    if (gap <= draft.gap + kPrimitiveGap * diagonal) return PartDraft{fitted.part, {}, gap, outline.area};
  }
  return std::nullopt;
}

bool LevelAssembler::suits(const ConvexPart& part, const std::optional<Mirror>& mirror) const {
  if (definition_.symmetry == nullptr) return true;
  const Vec3& origin = space_.mesh.origin;
  return mirror ? isOwnImage(part, *mirror, origin)
                : isMirroredExactly(part, definition_.symmetry->mirror, origin);
}

double LevelAssembler::gapOf(const TriangleHull& hull, double margin) const {
  if (grid_.isWeighted()) return weightedGapOf(hull, margin);
  const double spacing = kSpacing * space_.mesh.diagonal;
  const auto roughly = [this](const glm::dvec3& point) { return grid_.value(point); };
  const auto exactly = [this](const glm::dvec3& point) {
    // Away from the mesh the grid knows the side, which saves the winding number.
    const double side = grid_.value(point);
    if (side < -grid_.step()) return 0.0;
    return side > grid_.step() ? space_.tree.distance(point) : space_.distance(point);
  };
  // Corners stick out most, but the middle of a face may lie over a hollow.
  double corners = 0.0;
  for (const glm::dvec3& vertex : hull.vertices) corners = std::max(corners, exactly(vertex));
  const double rough = largestGap(hull, spacing, roughly, corners);
  if (rough > kFineCells * grid_.step()) return rough + margin;
  return largestGap(hull, spacing, exactly, corners) + margin;
}

double LevelAssembler::weightedGapOf(const TriangleHull& hull, double margin) const {
  const auto valueAt = [this, margin](const glm::dvec3& point) {
    double value = grid_.value(point);
    // Further inside than a cell there is no gap, and further out the grid is good enough.
    const double step = grid_.step();
    if (value > -step && value < kFineCells * step)
      value = value > step ? space_.tree.distance(point) : space_.distance(point);
    return grid_.weight(point) * (value + margin);
  };
  double corners = 0.0;
  double weight = 1.0;
  for (const glm::dvec3& vertex : hull.vertices) {
    corners = std::max(corners, valueAt(vertex));
    weight = std::max(weight, grid_.weight(vertex));
  }
  const double spacing = kSpacing * space_.mesh.diagonal / std::sqrt(weight);
  return largestGap(hull, spacing, valueAt, corners, grid_.largestWeight());
}

void LevelAssembler::setRegion(PartDraft& draft, const Cluster& triangles) const {
  if (!grid_.isWeighted()) return;
  draft.weight = 0.0;
  for (const std::uint32_t triangle : triangles) {
    draft.weight = std::max(draft.weight, regions_.weightOf(triangle));
    draft.isMixed = draft.isMixed || regions_.keeperOf(triangle) != regions_.keeperOf(triangles.front());
  }
}

std::vector<glm::dvec3> LevelAssembler::pointsOf(const Cluster& triangles) const {
  const SymmetricMesh* symmetry = definition_.symmetry;
  const WorkMesh& mesh = symmetry != nullptr ? symmetry->mesh : space_.mesh;
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t triangle : triangles) {
    const Triangle& corners = mesh.triangles[triangle];
    indices.insert(indices.end(), corners.begin(), corners.end());
  }
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  std::vector<glm::dvec3> points;
  points.reserve(indices.size());
  for (const std::uint32_t i : indices) {
    if (symmetry == nullptr) {
      points.push_back(mesh.vertices[i]);
    } else {
      points.insert(points.end(), symmetry->places[i].begin(), symmetry->places[i].end());
    }
  }
  return points;
}

}  // namespace scatter::levels
