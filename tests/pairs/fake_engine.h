#pragma once

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <set>
#include <vector>

#include "collision/part_query.h"
#include "pairs/pair_engine.h"

namespace scatter::testing {

/// An engine of a page: two bodies whose levels are lists of upright boxes; the second one is moved along x,
/// away from the first. Two boxes that overlap have one point. At its end no manifold may be left.
class FakeEngine : public pairs::PairEngine {
 public:
  explicit FakeEngine(const std::vector<std::vector<PartDef>>& levels) {
    for (const auto& level : levels) {
      lists_.push_back(std::make_unique<PartList>(level));
      for (auto& body : bodies_) body.emplace_back(*lists_.back());
    }
  }
  FakeEngine(const FakeEngine&) = delete;
  FakeEngine& operator=(const FakeEngine&) = delete;
  ~FakeEngine() override { EXPECT_TRUE(manifolds_.empty()) << "manifolds were left to the engine"; }

  float x = 0.0F;        ///< Of the second body; the first one is at 0.
  bool refuses = false;  ///< The shapes are no lists of parts.
  int version = 0;       ///< Of both bodies' parts.
  int fallbacks = 0;

  [[nodiscard]] int manifolds() const { return static_cast<int>(manifolds_.size()); }

  bool place(int level, pairs::PlacedBodies& placed) override {
    level_ = level;
    placed = {&bodyAt(0, level), &bodyAt(1, level), {version, version}};
    placed.a->moveTo(frameOf(0));
    placed.b->moveTo(frameOf(1));
    return !refuses;
  }
  const PartList& partsOf(int /*body*/, int level) override {
    return *lists_.at(static_cast<std::size_t>(level - 1));
  }
  [[nodiscard]] Frame frameOf(int body) const override {
    Frame frame;
    frame.origin.x = body == 0 ? 0.0F : x;
    return frame;
  }
  [[nodiscard]] float threshold() const override { return 0.02F; }
  [[nodiscard]] float pointDistance() const override { return 0.02F; }
  void fallBack() override { ++fallbacks; }

  void* newManifold() override { return *manifolds_.insert(new Manifold).first; }
  void release(void* manifold) override {
    ASSERT_EQ(manifolds_.erase(at(manifold)), 1U) << "was released before";
    delete at(manifold);
  }
  bool outlasts(void* manifold) const override {
    std::erase_if(*at(manifold), [this](Point& point) {
      point.distance = point.foundDistance + x - point.foundX;
      return point.distance > threshold();
    });
    return !at(manifold)->empty();
  }
  int countPoints(const void* manifold) const override { return static_cast<int>(at(manifold)->size()); }
  bool isFull(const void* manifold) const override { return countPoints(manifold) == 4; }
  pairs::ContactPoint point(const void* manifold, int i) const override { return pointAt(manifold, i); }
  void write(void* manifold, int i, const pairs::ContactPoint& point) override {
    pointAt(manifold, i).distance = point.distance;
    pointAt(manifold, i).eased = point.eased;
    pointAt(manifold, i).presses = !point.eased;
  }
  float distanceNow(const void* manifold, int i) const override {
    return pointAt(manifold, i).foundDistance + x - pointAt(manifold, i).foundX;
  }
  void move(void* from, int i, void* to) override { at(to)->push_back(pointAt(from, i)); }
  void addImpulses(const void* from, int i, void* to, int j) override {
    pointAt(to, j).impulse += pointAt(from, i).impulse;
  }

  void add(ChildPair& /*child*/, const PartContact& /*contact*/) override {
    FAIL() << "boxes are the detector's";
  }
  void detect(PartPair& parts, ChildPair& child) override {
    const PartList& list = partsOf(0, level_);
    const float depth = partDepth(list.part(child.a), list.part(child.b), parts.frameB());
    if (depth <= 0.0F) return;
    if (child.contact == nullptr) child.contact = newManifold();
    Point found;
    found.position = Vec3(x, list.part(child.a).center.y, 0.0F);
    found.normal = Vec3(-1.0F, 0.0F, 0.0F);
    found.distance = found.foundDistance = -depth;
    found.foundX = x;
    found.partA = child.a;
    found.partB = child.b;
    at(child.contact)->assign(1, found);
  }

 private:
  struct Point : pairs::ContactPoint {
    float foundDistance = 0.0F;
    float foundX = 0.0F;
  };
  using Manifold = std::vector<Point>;

  static Manifold* at(const void* manifold) { return static_cast<Manifold*>(const_cast<void*>(manifold)); }
  static Point& pointAt(const void* manifold, int i) { return at(manifold)->at(static_cast<std::size_t>(i)); }
  PartBody& bodyAt(std::size_t body, int level) {
    return bodies_[body].at(static_cast<std::size_t>(level - 1));
  }

  std::vector<std::unique_ptr<PartList>> lists_;
  std::array<std::vector<PartBody>, 2> bodies_;
  std::set<Manifold*> manifolds_;
  int level_ = 1;
};

}  // namespace scatter::testing
