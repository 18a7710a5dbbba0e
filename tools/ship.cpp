#include "ship.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "boxes.h"

namespace scatter::tools {
namespace {

constexpr int kRingVertices = 16;
constexpr float kShipMargin = 0.02F;

/// From the first ring's centre to the last one's, but along the loft's axis if it hardly differs.
glm::dvec3 pieceDirection(const glm::dvec3& chord, const glm::dvec3& axis) {
  constexpr double kCosine = 0.9985;
  return glm::dot(glm::normalize(chord), glm::normalize(axis)) > kCosine ? axis : chord;
}

double superellipse(double cosine, double exponent) {
  // The sine of a half turn is not quite zero, and a root would magnify it.
  return std::abs(cosine) < 1e-12 ? 0.0 : std::copysign(std::pow(std::abs(cosine), 2.0 / exponent), cosine);
}

/// Counter-clockwise seen from ahead, in the loft's frame.
std::vector<glm::dvec3> ringPoints(const Section& section, double exponent) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < kRingVertices; ++i) {
    const double angle = 2.0 * glm::pi<double>() * i / kRingVertices;
    const double y = superellipse(std::cos(angle), exponent);
    const double z = superellipse(std::sin(angle), exponent);
    points.emplace_back(section.x, section.y + y * (y > 0.0 ? section.top : section.bottom),
                        section.z + z * section.halfWidth);
  }
  return points;
}

glm::dvec3 ringCenter(const std::vector<Vec3>& ring) {
  glm::dvec3 sum(0.0);
  for (const Vec3& point : ring) {
    sum += glm::dvec3(point);
  }
  return sum / static_cast<double>(ring.size());
}

Vec3 mirroredPoint(const Vec3& v) {
  return {v.x, v.y, -v.z};
}

template <class Ring>
std::vector<Vec3> joined(const std::vector<Ring>& rings) {
  std::vector<Vec3> points;
  for (const Ring& ring : rings) {
    points.insert(points.end(), ring.begin(), ring.end());
  }
  return points;
}

}  // namespace

void Ship::add(const Loft& loft) {
  const glm::dmat3 axes = axesAlong(loft.direction, loft.up);
  std::vector<Ring> rings;
  for (const Section& section : loft.sections) {
    Ring& ring = rings.emplace_back();
    for (const glm::dvec3& point : ringPoints(section, loft.exponent)) {
      ring.push_back(snapped(loft.origin + axes * point - center_));
    }
  }
  addRings(loft, std::move(rings), false);
}

void Ship::addPair(const Loft& loft, const std::vector<std::string>& shared) {
  const auto named = [&](const char* suffix) {
    Loft copy = loft;
    for (Cut& cut : copy.cuts) {
      if (std::find(shared.begin(), shared.end(), cut.group) == shared.end()) {
        cut.group += suffix;
      }
    }
    return copy;
  };
  const std::size_t first = pieces_.size();
  add(named("-right"));
  std::vector<Ring> rings;
  for (std::size_t i = first; i < pieces_.size(); ++i) {
    // Neighbouring pieces share a ring.
    const std::vector<Ring>& piece = pieces_[i].rings;
    rings.insert(rings.end(), piece.begin() + (i == first ? 0 : 1), piece.end());
  }
  for (Ring& ring : rings) {
    std::transform(ring.begin(), ring.end(), ring.begin(), mirroredPoint);
  }
  Loft left = named("-left");
  left.direction.z = -left.direction.z;
  left.up.z = -left.up.z;
  addRings(left, std::move(rings), true);
}

void Ship::addRings(const Loft& loft, std::vector<Ring> rings, bool mirrored) {
  addMesh(rings, mirrored);
  auto begin = rings.begin();
  for (const Cut& cut : loft.cuts) {
    const auto end = begin + cut.segments;
    Piece piece{{begin, end + 1},
                axesAlong(pieceDirection(ringCenter(*end) - ringCenter(*begin), loft.direction), loft.up),
                cut.group};
    pieces_.push_back(std::move(piece));
    if (std::find(groups_.begin(), groups_.end(), cut.group) == groups_.end()) {
      groups_.push_back(cut.group);
    }
    begin = end;
  }
}

void Ship::addMesh(const std::vector<Ring>& rings, bool mirrored) {
  const auto addTriangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.triangles.push_back(mirrored ? std::array{a, c, b} : std::array{a, b, c});
  };
  auto base = static_cast<std::uint32_t>(mesh_.vertices.size());
  const auto last = base + static_cast<std::uint32_t>((rings.size() - 1) * kRingVertices);
  for (const Vec3& point : joined(rings)) {
    mesh_.vertices.push_back(point);
  }
  for (std::uint32_t i = 1; i + 1 < kRingVertices; ++i) {
    addTriangle(base, base + i + 1, base + i);
    addTriangle(last, last + i, last + i + 1);
  }
  for (; base < last; base += kRingVertices) {
    for (std::uint32_t i = 0; i < kRingVertices; ++i) {
      const std::uint32_t next = (i + 1) % kRingVertices;
      addTriangle(base + i, base + next, base + kRingVertices + i);
      addTriangle(base + next, base + kRingVertices + next, base + kRingVertices + i);
    }
  }
}

void Ship::alignGroup(const std::string& group, const glm::dvec3& direction) {
  groupAxes_[group + "-right"] = axesAlong(direction, {0.0, 1.0, 0.0});
  groupAxes_[group + "-left"] = axesAlong({direction.x, direction.y, -direction.z}, {0.0, 1.0, 0.0});
}

Level Ship::finestLevel() const {
  Level level;
  for (const Piece& piece : pieces_) {
    level.parts.push_back(boxAround(joined(piece.rings), piece.axes, 0.0));
  }
  return level;
}

Level Ship::middleLevel() const {
  Level level;
  for (const std::string& group : groups_) {
    std::vector<Vec3> points;
    for (const Piece& piece : pieces_) {
      if (piece.group == group) {
        addCorners(boxAround(joined(piece.rings), piece.axes, 0.0), points);
      }
    }
    const auto axes = groupAxes_.find(group);
    level.parts.push_back(boxAround(points, axes == groupAxes_.end() ? glm::dmat3(1.0) : axes->second, 0.0));
  }
  return level;
}

Result<Model> Ship::build() const {
  Level middle = middleLevel();
  std::vector<Vec3> corners;
  for (const ConvexPart& part : middle.parts) {
    addCorners(part, corners);
  }
  Level coarsest{{boxAround(corners, glm::dmat3(1.0), 0.0)}};
  LevelSetDef def;
  def.name = name_;
  def.levels = {std::move(coarsest), std::move(middle), finestLevel()};
  def.hullMargin = kShipMargin;
  if (const Result<SolidMass> mass = massOfMesh(mesh_)) def.mass = mass->properties;
  return LevelSet::create(std::move(def)).map([&](std::shared_ptr<const LevelSet> levels) {
    return Model{name_, mesh_, std::move(levels), mass_, 0.5F, 0.1F};
  });
}

}  // namespace scatter::tools
