#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "collision/geometry.h"
#include "collision/part_pair.h"
#include "collision/reference_distance.h"
#include "trials.h"

/// The law of the motion bound: whatever the bodies do, and whatever steps are left out, a child pair that is
/// in contact is listed, wakeful and awake, and it is judged not to be apart.
namespace scatter {
namespace {

using testing::anyInt;
using testing::anySize;
using testing::frameOf;
using testing::placed;
using testing::Random;
using testing::randomParts;
using testing::referenceDistance;

/// Where a body is: what a motion changes from step to step.
struct Place {
  Quat rotation = kNoRotation;
  Vec3 origin{0.0F};

  [[nodiscard]] Frame frame() const { return frameOf(rotation, origin); }
  void turn(float angle, const Vec3& axis) {
    rotation = glm::normalize(glm::angleAxis(angle, axis) * rotation);
  }
};

struct Scenario {
  const char* name;
  int steps;
  std::function<void(Random&, int step, float size, Place& a, Place& b)> move;
};

Place randomPlace(Random& random, float distance) {
  return {random.rotation(), random.direction() * distance};
}

void drift(Random&, int step, float size, Place& a, Place& b) {
  const float inwards = step < 150 ? -1.0F : 1.0F;
  b.origin += inwards * 0.015F * size * glm::normalize(b.origin - a.origin);
  b.turn(0.01F, Vec3(0, 1, 0));
  a.turn(0.007F, Vec3(1, 0, 0));
}

void spin(Random& random, int step, float size, Place& a, Place& b) {
  a.turn(random.uniform(0.0F, 1.0F), Vec3(0, 0, 1));
  b.turn(random.uniform(0.0F, 3.0F), Vec3(0, 1, 0));
  if (step % 20 == 0) b.origin = a.origin + random.direction() * size * random.uniform(0.5F, 3.0F);
}

void teleport(Random& random, int step, float size, Place& a, Place& b) {
  if (step % 7 == 0) b = randomPlace(random, size * anySize(random, -1.0F, 4.0F));
  if (step % 7 == 1)
    b = {random.rotation(), a.origin + random.direction() * size * random.uniform(0.3F, 2.5F)};
  if (step % 50 == 0) a.origin += random.direction() * size;
}

void jitter(Random& random, int step, float size, Place& a, Place& b) {
  if (step % 60 == 0) b.origin = a.origin + random.direction() * size * random.uniform(0.8F, 2.0F);
  if (step % 3 == 0) return;
  b.origin += random.inBox(Vec3(0.01F * size));
  b.turn(random.uniform(-0.01F, 0.01F), random.direction());
}

void bursts(Random& random, int step, float size, Place& a, Place& b) {
  // Long rests and creeping, then a sudden move: what was proven at rest must not outlive it.
  const bool isSudden = random.uniform(0.0F, 1.0F) < 0.1F;
  const float length = isSudden ? size * random.uniform(0.0F, 0.6F) : step % 4 == 0 ? 1e-5F * size : 0.0F;
  b.origin += length * glm::normalize(a.origin - b.origin + random.inBox(Vec3(size)));
  if (isSudden) a.turn(random.uniform(0.0F, 0.5F), random.direction());
}

void creep(Random&, int step, float size, Place& a, Place& b) {
  // 10^4 tiny steps, of which none alone is seen.
  const float inwards = step % 4800 < 2400 ? -1.0F : 1.0F;
  b.origin += inwards * 1e-3F * size * glm::normalize(b.origin - a.origin);
  b.turn(1e-4F, Vec3(0, 0, 1));
}

/// What ruleOf promises about two parts: which polytopes decide, and how near is a contact.
struct Truth {
  const PolytopeView& a;
  const PolytopeView& b;
  double contactBelow;  ///< This distance of the polytopes.
};

Truth truthOf(const PartList::Part& a, const PartList::Part& b, float threshold) {
  if (a.kind == PartKind::kBox && b.kind == PartKind::kBox) return {a.sharp, b.sharp, 0.0};
  const double margins = static_cast<double>(a.margin) + static_cast<double>(b.margin);
  if (a.kind == PartKind::kSphere && b.kind == PartKind::kSphere) return {a.core, b.core, margins};
  return {a.core, b.core, margins + static_cast<double>(threshold)};
}

class MotionLaw {
 public:
  MotionLaw(Random& random, float size, int partsA, int partsB)
      : random_(random),
        size_(size),
        threshold_(0.02F * size),
        listA_(randomParts(random, partsA, size, threshold_)),
        listB_(randomParts(random, partsB, size, threshold_)),
        a_(listA_),
        b_(listB_) {}

  void run(const Scenario& scenario, const PairSteps& steps, const Vec3& origin) {
    Place placeA{random_.rotation(), origin};
    Place placeB{random_.rotation(), origin + random_.direction() * 2.5F * size_};
    pair_.reset(threshold_);
    for (int step = 0; step < scenario.steps; ++step) {
      scenario.move(random_, step, size_, placeA, placeB);
      a_.moveTo(placeA.frame());
      b_.moveTo(placeB.frame());
      check(step, steps);
      if (::testing::Test::HasFailure()) return;
    }
  }

  [[nodiscard]] int contacts() const { return contacts_; }
  [[nodiscard]] const PairWork& work() const { return work_; }

 private:
  void check(int step, const PairSteps& steps) {
    const bool isAwake = pair_.advance(a_, b_, steps, scratch_, work_);
    std::vector<bool> inContact = findContacts();
    std::vector<bool> isLooked(pair_.children().size(), false);
    PairWork uncounted;
    pair_.forEachAwake(uncounted,
                       [&isLooked](int child) { isLooked[static_cast<std::size_t>(child)] = true; });
    for (std::size_t i = 0; i < pair_.children().size(); ++i) {
      ChildPair& child = pair_.children()[i];
      const auto index = static_cast<std::size_t>(child.a * listB_.count() + child.b);
      const bool touches = inContact[index];
      inContact[index] = false;
      ++work_.childPairs;
      if (touches) {
        EXPECT_TRUE(isAwake) << "step " << step;
        EXPECT_TRUE(isLooked[i]) << "step " << step;
        EXPECT_FALSE(pair_.isAsleep(child)) << "step " << step;
      }
      if (!isAwake) continue;
      if (!isLooked[i]) {
        ++work_.childPairsAsleep;
        continue;
      }
      judge(child, touches, steps, step);
    }
    for (const bool missing : inContact) EXPECT_FALSE(missing) << "step " << step;
    if (isAwake) pair_.settle(a_, b_, steps);
  }

  // As an adapter does; contacts outlive their cause now and then, as manifolds do.
  void judge(ChildPair& child, bool touches, const PairSteps& steps, int step) {
    PartContact contact;
    const ChildVerdict verdict = pair_.judge(child, a_, b_, steps, contact, work_);
    EXPECT_TRUE(!touches || verdict != ChildVerdict::kApart) << "step " << step;
    child.touching = touches || (child.touching && random_.uniform(0.0F, 1.0F) < 0.5F);
    if (verdict != ChildVerdict::kAskEngine || touches || steps.ownGjk) return;
    const PartList::Part& partA = listA_.part(child.a);
    const PartList::Part& partB = listB_.part(child.b);
    const Truth truth = truthOf(partA, partB, threshold_);
    const auto found = referenceDistance(placed(Frame{}, truth.a), placed(pair_.frameB(), truth.b));
    if (found.lower > 0.0) pair_.learnAxis(child, a_, b_, Vec3(found.axis));
  }

  std::vector<bool> findContacts() {
    std::vector<bool> found(static_cast<std::size_t>(listA_.count() * listB_.count()), false);
    for (int i = 0; i < listA_.count(); ++i) {
      for (int j = 0; j < listB_.count(); ++j) {
        if (!areInContact(listA_.part(i), listB_.part(j))) continue;
        found[static_cast<std::size_t>(i * listB_.count() + j)] = true;
        ++contacts_;
      }
    }
    return found;
  }

  // GJK from nothing rules most pairs out; the reference has the last word.
  [[nodiscard]] bool areInContact(const PartList::Part& a, const PartList::Part& b) const {
    const Truth truth = truthOf(a, b, threshold_);
    const Frame frameB = relativeFrame(a_.frame(), b_.frame());
    const auto below = static_cast<float>(truth.contactBelow);
    const Vec3 between = frameB(b.center) - a.center;
    const float length = glm::length(between);
    WarmSimplex cold;
    const Vec3 start = length > 0.0F ? between / length : Vec3(1.0F, 0.0F, 0.0F);
    const GjkResult quick =
        gjkDistance(truth.a, truth.b, frameB, start, below + 1e-3F * size_ + 1e-5F * length, 1e9F, cold);
    if (quick.state == GjkResult::State::kApart) return false;
    const auto exact = referenceDistance(placed(a_.frame(), truth.a), placed(b_.frame(), truth.b));
    return exact.upper <= truth.contactBelow - 1e-7 * static_cast<double>(size_);
  }

  Random& random_;
  float size_;
  float threshold_;
  PartList listA_;
  PartList listB_;
  PartBody a_;
  PartBody b_;
  PartPair pair_;
  PairScratch scratch_;
  PairWork work_;
  int contacts_ = 0;
};

PairSteps stepsOf(int combination) {
  PairSteps steps;
  steps.midphase = static_cast<PairMidphase>(combination % 3);
  steps.motionBound = (combination / 3 & 1) != 0;
  steps.cachedAxis = (combination / 3 & 2) != 0;
  steps.ownGjk = (combination / 3 & 4) != 0;
  steps.warmSimplex = (combination / 3 & 8) != 0;
  return steps;
}

constexpr int kCombinations = 48;

const Scenario kScenarios[] = {{"drift", 300, drift},
                               {"spin", 200, spin},
                               {"teleport", 200, teleport},
                               {"jitter", 300, jitter},
                               {"bursts", 300, bursts}};

TEST(PartPairMotion, NoContactIsMissedWhateverStepsAreLeftOut) {
  constexpr int kRounds = test::kSanitized ? 1 : 3;
  int contacts = 0;
  for (int combination = 0; combination < kRounds * kCombinations; ++combination) {
    Random random(static_cast<std::uint64_t>(1000 + combination));
    for (const Scenario& scenario : kScenarios) {
      SCOPED_TRACE(std::string(scenario.name) + ", steps " + std::to_string(combination));
      MotionLaw law(random, 1.0F, anyInt(random, 1, 6), anyInt(random, 1, 6));
      law.run(scenario, stepsOf(combination % kCombinations), Vec3(0.0F));
      contacts += law.contacts();
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(contacts, kRounds * 20000 / 3);
}

TEST(PartPairMotion, NoContactIsMissedAtAnySize) {
  Random random(101);
  int contacts = 0;
  for (int round = 0; round < test::trials(150); ++round) {
    const float size = anySize(random, -3.0F, 3.0F);
    for (const Scenario& scenario : kScenarios) {
      SCOPED_TRACE(std::string(scenario.name) + ", round " + std::to_string(round));
      MotionLaw law(random, size, anyInt(random, 1, 6), anyInt(random, 1, 6));
      law.run(scenario, PairSteps{}, Vec3(0.0F));
      contacts += law.contacts();
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(contacts, test::trials(20000));
}

TEST(PartPairMotion, NoContactIsMissedFarFromTheWorldsOrigin) {
  Random random(102);
  int contacts = 0;
  for (int round = 0; round < test::trials(100); ++round) {
    const Vec3 origin = random.direction() * anySize(random, 1.0F, 4.0F);
    for (const Scenario& scenario : kScenarios) {
      SCOPED_TRACE(std::string(scenario.name) + ", round " + std::to_string(round));
      MotionLaw law(random, 1.0F, anyInt(random, 1, 6), anyInt(random, 1, 6));
      law.run(scenario, PairSteps{}, origin);
      contacts += law.contacts();
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(contacts, test::trials(10000));
}

TEST(PartPairMotion, NoContactIsMissedOverTenThousandTinySteps) {
  Random random(103);
  const Scenario scenario{"creep", 10000, creep};
  for (int round = 0; round < test::trials(4); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    MotionLaw law(random, 1.0F, 4, 4);
    law.run(scenario, PairSteps{}, Vec3(0.0F));
    EXPECT_GT(law.contacts(), 100);
    // What the bound is for: most of the time, nothing is looked at.
    EXPECT_GT(law.work().pairsSkipped + law.work().childPairsAsleep, scenario.steps / 4);
    EXPECT_LT(law.work().rebuilds, scenario.steps / 4);
    ASSERT_FALSE(HasFailure());
  }
}

}  // namespace
}  // namespace scatter
