#pragma once

#include <LinearMath/btTransform.h>

#include <cmath>

#include "RandomShapes.h"

namespace scatter::test {

/// How a scripted body moves from step to step, in lengths of the body.
enum class Motion { kDrift, kSpin, kDash, kTeleport, kRest, kJitter, kSlide, kGrowingLeaps };
constexpr int kMotions = 8;

/// A body's path: the poses of a motion around a centre, never further than `reach` lengths from it for long.
class ScriptedMotion {
 public:
  ScriptedMotion(Motion motion, Random& random, float size, float reach, const btVector3& centre)
      : motion_(motion),
        size_(size),
        reach_(reach),
        centre_(centre),
        turn_(random.rotation()),
        offset_(random.inCube(reach * size)),
        direction_(random.direction()),
        axis_(random.direction()),
        speed_(random.between(0.3F, 1)) {}

  btTransform next(Random& random) {
    ++step_;
    switch (motion_) {
      case Motion::kDrift:
        advance(0.01F * speed_, 0.01F * speed_);
        break;
      case Motion::kSpin:
        advance(0.002F, 2.5F * speed_);
        break;
      case Motion::kDash:
        advance(4 * speed_, 0.5F);
        break;
      case Motion::kTeleport:
        if (random.chance(0.3F)) jump(random);
        break;
      case Motion::kRest:
        break;
      case Motion::kJitter:
        return placed(offset_ + random.inCube(1e-4F * size_), turn_ * random.rotation(1e-4F));
      case Motion::kSlide:
        advance(0.05F * speed_, 0);
        break;
      case Motion::kGrowingLeaps:
        advance(1e-4F * std::pow(1.4F, static_cast<float>(step_ % 32)), 0.001F);
        break;
    }
    return placed(offset_, turn_);
  }

 private:
  void advance(float lengths, float angle) {
    offset_ += direction_ * (lengths * size_);
    turn_ = (btQuaternion(axis_, angle) * turn_).normalized();
    // Back through the middle, so that the paths keep crossing.
    if (offset_.length() > reach_ * size_) direction_ = -(offset_ + axis_ * (0.3F * size_)).normalized();
  }

  void jump(Random& random) {
    offset_ = random.inCube(reach_ * size_);
    turn_ = random.rotation();
  }

  btTransform placed(const btVector3& offset, const btQuaternion& turn) const {
    return btTransform(turn, centre_ + offset);
  }

  Motion motion_;
  float size_;
  float reach_;
  btVector3 centre_;
  btQuaternion turn_;
  btVector3 offset_;
  btVector3 direction_;
  btVector3 axis_;
  float speed_;
  int step_ = 0;
};

}  // namespace scatter::test
