#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

#include "pairs/manifolds.h"

namespace scatter::testing {

/// The manifolds of an engine in which a body moves along one line, away from the other. At its end no
/// manifold may be left.
template <class Engine>
class FakeManifolds : public Engine {
 public:
  FakeManifolds() = default;
  FakeManifolds(const FakeManifolds&) = delete;
  FakeManifolds& operator=(const FakeManifolds&) = delete;
  ~FakeManifolds() override { EXPECT_TRUE(manifolds_.empty()) << "manifolds were left to the engine"; }

  float breaking = kThreshold;  ///< The distance at which points are dropped, metres.
  bool losesPoints = false;     ///< The bodies slide: no point lasts until the next step.

  [[nodiscard]] int manifolds() const { return static_cast<int>(manifolds_.size()); }

  [[nodiscard]] float threshold() const override { return breaking; }
  void* newManifold() override { return *manifolds_.insert(new Manifold).first; }
  void release(void* manifold) override {
    ASSERT_EQ(manifolds_.erase(at(manifold)), 1U) << "was released before";
    delete at(manifold);
  }
  bool outlasts(void* manifold) const override {
    std::erase_if(*at(manifold), [this](Point& point) {
      point.distance = distanceOf(point);
      return losesPoints || point.distance > threshold();
    });
    return !at(manifold)->empty();
  }
  int countPoints(const void* manifold) const override { return static_cast<int>(at(manifold)->size()); }
  bool isFull(const void* manifold) const override { return countPoints(manifold) == 4; }
  pairs::ContactPoint point(const void* manifold, int i) const override { return pointAt(manifold, i); }
  void addTo(pairs::ContactTally& tally, const void* manifold) const override {
    ++tally.manifolds;
    for (int i = 0; i < countPoints(manifold); ++i)
      tally.addPoint(point(manifold, i).distance, point(manifold, i).presses);
  }
  void write(void* manifold, int i, const pairs::ContactPoint& point) override {
    pointAt(manifold, i).distance = point.distance;
    pointAt(manifold, i).eased = point.eased;
    pointAt(manifold, i).presses = !point.eased;
  }
  float carry(void* manifold) override {
    if (!outlasts(manifold)) return std::numeric_limits<float>::infinity();
    return std::abs(along() - at(manifold)->front().foundAt);
  }
  /// What carry() is going to return.
  [[nodiscard]] float wouldSlide(const void* manifold) const {
    for (const Point& point : *at(manifold)) {
      if (!losesPoints && distanceOf(point) <= threshold()) return std::abs(along() - point.foundAt);
    }
    return std::numeric_limits<float>::infinity();
  }
  float distanceNow(const void* manifold, int i) const override { return distanceOf(pointAt(manifold, i)); }
  void move(void* from, int i, void* to) override { at(to)->push_back(pointAt(from, i)); }
  void addImpulses(const void* from, int i, void* to, int j) override {
    pointAt(to, j).impulse += pointAt(from, i).impulse;
  }

  static constexpr float kThreshold = 0.02F;

 protected:
  /// How far the body is along its line, metres.
  [[nodiscard]] virtual float along() const = 0;

  /// The last one stays, as engines have it with points near each other.
  void put(void* manifold, const pairs::ContactPoint& found) const {
    at(manifold)->assign(1, Point{found, found.distance, along()});
  }

 private:
  struct Point : pairs::ContactPoint {
    float foundDistance = 0.0F;
    float foundAt = 0.0F;
  };
  using Manifold = std::vector<Point>;

  static Manifold* at(const void* manifold) { return static_cast<Manifold*>(const_cast<void*>(manifold)); }
  static Point& pointAt(const void* manifold, int i) { return at(manifold)->at(static_cast<std::size_t>(i)); }
  [[nodiscard]] float distanceOf(const Point& point) const {
    return point.foundDistance + along() - point.foundAt;
  }

  std::set<Manifold*> manifolds_;
};

}  // namespace scatter::testing
