#pragma once

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "collision/part_query.h"
#include "pairs/fake_manifolds.h"
#include "pairs/pair_engine.h"

namespace scatter::testing {

/// An engine of a page: two bodies whose levels are lists of upright boxes; the second one is moved along x,
/// away from the first. Two boxes that overlap have one point.
class FakeEngine : public FakeManifolds<pairs::PairEngine> {
 public:
  explicit FakeEngine(const std::vector<std::vector<PartDef>>& levels) {
    for (const auto& level : levels) {
      lists_.push_back(std::make_unique<PartList>(level));
      for (auto& body : bodies_) body.emplace_back(*lists_.back());
    }
  }

  float x = 0.0F;        ///< Of the second body, from the first one.
  float y = 0.0F;        ///< Of both.
  bool refuses = false;  ///< The shapes are no lists of parts.
  int version = 0;       ///< Of both bodies' parts.
  int fallbacks = 0;

  bool place(int level, pairs::PlacedBodies& placed) override {
    level_ = level;
    placed = {&bodyAt(0, level), &bodyAt(1, level), {version, version}};
    placed.a->moveTo(frameOf(0));
    placed.b->moveTo(frameOf(1));
    return !refuses;
  }
  std::optional<std::array<int, 2>> versionsAt(int /*level*/) override {
    if (refuses) return std::nullopt;
    return std::array<int, 2>{version, version};
  }
  const PartList& partsOf(int /*body*/, int level) override {
    return *lists_.at(static_cast<std::size_t>(level - 1));
  }
  [[nodiscard]] Frame frameOf(int body) const override {
    Frame frame;
    frame.origin = Vec3(body == 0 ? 0.0F : x, y, 0.0F);
    return frame;
  }
  [[nodiscard]] float pointDistance() const override { return 0.02F; }
  void fallBack() override { ++fallbacks; }

  void add(ChildPair& /*child*/, const PartContact& /*contact*/) override {
    FAIL() << "boxes are the detector's";
  }
  void detect(PartPair& parts, ChildPair& child) override {
    const PartList& list = partsOf(0, level_);
    const float depth = partDepth(list.part(child.a), list.part(child.b), parts.frameB());
    if (depth <= 0.0F) return;
    if (child.contact == nullptr) child.contact = newManifold();
    pairs::ContactPoint found;
    found.position = Vec3(x, list.part(child.a).center.y, 0.0F);
    found.normal = Vec3(-1.0F, 0.0F, 0.0F);
    found.distance = -depth;
    found.partA = child.a;
    found.partB = child.b;
    put(child.contact, found);
  }

 protected:
  [[nodiscard]] float along() const override { return x; }

 private:
  PartBody& bodyAt(std::size_t body, int level) {
    return bodies_[body].at(static_cast<std::size_t>(level - 1));
  }

  std::vector<std::unique_ptr<PartList>> lists_;
  std::array<std::vector<PartBody>, 2> bodies_;
  int level_ = 1;
};

}  // namespace scatter::testing
