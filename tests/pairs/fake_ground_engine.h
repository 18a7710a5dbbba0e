#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "pairs/fake_manifolds.h"
#include "pairs/ground_engine.h"

namespace scatter::testing {

/// An engine of a page: a body whose levels are lists of upright boxes, moved without turning, above the
/// plane y = 0, which is a half-space or a net of triangles of 1 m.
class FakeGroundEngine : public FakeManifolds<pairs::GroundEngine> {
 public:
  FakeGroundEngine(const std::vector<std::vector<PartDef>>& levels, bool isNet) : isNet_(isNet) {
    for (const auto& level : levels) {
      lists_.push_back(std::make_unique<PartList>(level));
      bodies_.emplace_back(*lists_.back());
    }
  }

  Vec3 position{0.0F};     ///< Of the body.
  Vec3 ahead{0.0F};        ///< How far it is about to move.
  bool refuses = false;    ///< The shape is no list of parts.
  int version = 0;         ///< Of the ground.
  bool isTooFine = false;  ///< There are too many triangles.
  int end = 1000;          ///< The net ends so many metres from the origin, along x and z.
  int fallbacks = 0;
  int lookups = 0;

  bool place(int level, pairs::PlacedBody& placed) override {
    level_ = level;
    PartBody& body = bodies_.at(static_cast<std::size_t>(level - 1));
    Frame frame;
    frame.origin = position;
    body.moveTo(frame);
    placed = {&body, 0};
    return !refuses;
  }
  [[nodiscard]] Frame groundFrame() const override { return {}; }
  [[nodiscard]] Vec3 wayAhead() const override { return ahead; }
  int groundVersion() override { return version; }
  [[nodiscard]] float groundMargin() const override { return 0.0F; }
  [[nodiscard]] std::optional<pairs::HalfSpace> halfSpace() const override {
    if (isNet_) return std::nullopt;
    return pairs::HalfSpace{Vec3(0.0F, 1.0F, 0.0F), 0.0F};
  }
  bool collect(const Vec3& low, const Vec3& high, pairs::GroundPieces& pieces) override {
    ++lookups;
    if (isTooFine) return false;
    if (low.y > 0.0F || high.y < 0.0F) return true;
    const auto first = [this](float at) { return std::max(static_cast<int>(std::floor(at)), -end); };
    const auto last = [this](float at) { return std::min(static_cast<int>(std::floor(at)), end - 1); };
    for (int x = first(low.x); x <= last(high.x); ++x) {
      for (int z = first(low.z); z <= last(high.z); ++z) addCell(x, z, pieces);
    }
    return true;
  }
  [[nodiscard]] float reach(const Vec3& /*direction*/) const override { return 0.0F; }
  bool fallBack() override {
    ++fallbacks;
    return position.y < 1.0F;
  }
  [[nodiscard]] bool letsMeet(int /*part*/) const override { return true; }
  bool keeps(int /*part*/) override { return true; }
  // Without this the triangles beside the one under a part would push it sideways.
  bool mayMeet(const pairs::GroundPieces& pieces, const ChildPair& child) override {
    if (!isNet_) return true;
    const PartList& list = *lists_.at(static_cast<std::size_t>(level_ - 1));
    const auto points = pieces.pointsOf(pieces.pieces.at(child.a));
    for (const int axis : {0, 2}) {
      const float middle = position[axis] + list.boxes().center[axis][child.b];
      const float half = list.boxes().half[axis][child.b];
      const auto [least, most] = std::minmax({points[0][axis], points[1][axis], points[2][axis]});
      if (least > middle + half || most < middle - half) return false;
    }
    return true;
  }

  void add(void* manifold, const pairs::GroundPieces& /*pieces*/, const ChildPair& child,
           const PartContact& contact, const Frame& frame) override {
    EXPECT_GT(frame.rotate(contact.axis).y, -1e-3F) << "from the ground to the part";
    put(manifold, child.b, contact.distance);
  }
  bool find(void* /*manifold*/, const pairs::GroundPieces& /*pieces*/, const ChildPair& child,
            const Frame& /*frame*/, PartContact& contact) override {
    contact.axis = Vec3(0.0F, 1.0F, 0.0F);
    contact.distance = heightOf(child.b);
    return contact.distance < kThreshold;
  }
  void detect(void* manifold, const pairs::GroundPieces& /*pieces*/, const ChildPair& child) override {
    if (heightOf(child.b) < kThreshold) put(manifold, child.b, heightOf(child.b));
  }

  /// Of the lowest point of a part of the level that was placed last.
  [[nodiscard]] float heightOf(int part) const {
    const PartList& list = *lists_.at(static_cast<std::size_t>(level_ - 1));
    const auto i = static_cast<std::size_t>(part);
    return position.y + list.boxes().center[1][i] - list.boxes().half[1][i];
  }
  [[nodiscard]] int countParts() const { return lists_.at(static_cast<std::size_t>(level_ - 1))->count(); }

 protected:
  [[nodiscard]] float along() const override { return position.y; }

 private:
  static void addCell(int x, int z, pairs::GroundPieces& pieces) {
    const auto corner = [x, z](int i, int k) {
      return Vec3(static_cast<float>(x + i), 0.0F, static_cast<float>(z + k));
    };
    pieces.add(x, 2 * z, std::vector<Vec3>{corner(0, 0), corner(0, 1), corner(1, 0)});
    pieces.add(x, 2 * z + 1, std::vector<Vec3>{corner(1, 0), corner(0, 1), corner(1, 1)});
  }

  void put(void* manifold, int part, float distance) const {
    pairs::ContactPoint found;
    const PartList& list = *lists_.at(static_cast<std::size_t>(level_ - 1));
    const auto i = static_cast<std::size_t>(part);
    found.position = position + Vec3(list.boxes().center[0][i], 0.0F, list.boxes().center[2][i]);
    found.normal = Vec3(0.0F, 1.0F, 0.0F);
    found.distance = distance;
    found.partA = part;
    FakeManifolds::put(manifold, found);
  }

  bool isNet_;
  std::vector<std::unique_ptr<PartList>> lists_;
  std::vector<PartBody> bodies_;
  int level_ = 1;
};

}  // namespace scatter::testing
