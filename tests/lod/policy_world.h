#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "lod/policy.h"

namespace scatter::lod::testing {

/// A ball of 1 m and 1 kg.
inline BodyView ball(const Vec3& center, const Vec3& velocity = Vec3(0.0F)) {
  return {.center = center, .velocity = velocity, .radius = 1.0F, .mass = 1.0F, .present = true};
}

/// Bodies and pairs for policies to look at, made by hand.
struct PolicyWorld {
  std::vector<BodyView> bodies;
  std::vector<PairView> pairs;
  std::optional<Focus> focus;
  Load load;
  std::uint64_t step = 0;

  /// A ball(), unless it is changed.
  std::uint32_t addBody(const Vec3& center, const Vec3& velocity = Vec3(0.0F)) {
    bodies.push_back(ball(center, velocity));
    return static_cast<std::uint32_t>(bodies.size() - 1);
  }

  /// At the finest of three levels, apart.
  PairView& addPair(std::uint32_t a, std::uint32_t b) {
    pairs.push_back({.a = a, .b = b, .level = 3, .finest = 3});
    return pairs.back();
  }

  [[nodiscard]] Situation situation() const {
    Situation situation;
    situation.bodies = bodies;
    situation.pairs = pairs;
    situation.focus = focus;
    situation.load = load;
    situation.step = step;
    return situation;
  }

  /// What a policy says of a pair now.
  [[nodiscard]] Wish ask(Policy& policy, std::size_t pair = 0) const {
    const Situation now = situation();
    policy.observe(now);
    Wish wish;
    policy.advise(now, pairs[pair], wish);
    return wish;
  }

  /// Two bodies at rest, 3 m apart along x.
  static PolicyWorld twoBodies() {
    PolicyWorld world;
    world.addBody(Vec3(0.0F));
    world.addBody(Vec3(3.0F, 0.0F, 0.0F));
    world.addPair(0, 1);
    return world;
  }
};

inline constexpr std::uint8_t kNothingAsked = std::numeric_limits<std::uint8_t>::max();

/// The same numbers on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] float between(float low, float high) {
    return low + (high - low) * static_cast<float>(static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
  }
  [[nodiscard]] std::uint32_t below(std::uint32_t limit) {
    return static_cast<std::uint32_t>(engine_() % limit);
  }
  [[nodiscard]] Vec3 point(float size) {
    const float x = between(-size, size);
    const float y = between(-size, size);
    return {x, y, between(-size, size)};
  }

 private:
  std::mt19937_64 engine_;
};

/// Bodies at random in a cube, some of which nothing moves, and pairs at random among them.
inline PolicyWorld randomWorld(std::uint64_t seed, std::uint32_t bodies, std::uint32_t pairs) {
  Dice dice(seed);
  PolicyWorld world;
  for (std::uint32_t i = 0; i < bodies; ++i) {
    const Vec3 center = dice.point(10.0F);
    BodyView& body = world.bodies[world.addBody(center, dice.point(10.0F))];
    body.radius = dice.between(0.2F, 2.0F);
    body.mass = dice.below(10) == 0 ? 0.0F : dice.between(0.1F, 10.0F);
    body.held = dice.below(10) == 0;
  }
  for (std::uint32_t i = 0; i < pairs; ++i) {
    const std::uint32_t a = dice.below(bodies);
    const std::uint32_t b = (a + 1 + dice.below(bodies - 1)) % bodies;
    PairView& pair = world.addPair(a, b);
    pair.touching = dice.below(4) == 0;
    pair.contactSteps = pair.touching ? static_cast<std::uint16_t>(dice.below(100)) : std::uint16_t{0};
    pair.level = static_cast<std::uint8_t>(dice.below(4));
  }
  return world;
}

}  // namespace scatter::lod::testing
