#include "pairs/passage.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../trials.h"
#include "collision/geometry.h"

namespace scatter::pairs {
namespace {

using testing::frameOf;
using testing::hullPart;
using testing::Random;

constexpr float kSize = 4.0F;
constexpr float kReach = 0.04F;

Frame at(const Vec3& place) {
  Frame frame;
  frame.origin = place;
  return frame;
}

/// Hills of cells of about 1 m, so steep; the corners are anywhere in their cells.
GroundPieces hills(Random& random, float steep) {
  constexpr int kCorners = 9;
  std::array<std::array<Vec3, kCorners>, kCorners> corner;
  for (int x = 0; x < kCorners; ++x) {
    for (int z = 0; z < kCorners; ++z) {
      const Vec3 off(random.uniform(-0.3F, 0.3F), random.uniform(-steep, steep), random.uniform(-0.3F, 0.3F));
      corner.at(static_cast<std::size_t>(x)).at(static_cast<std::size_t>(z)) =
          Vec3(static_cast<float>(x) - kSize, 0.0F, static_cast<float>(z) - kSize) + off;
    }
  }
  GroundPieces pieces;
  for (std::size_t x = 0; x + 1 < kCorners; ++x) {
    for (std::size_t z = 0; z + 1 < kCorners; ++z) {
      const auto number = static_cast<int>(2 * (x * kCorners + z));
      pieces.add(0, number, std::array{corner[x][z], corner[x][z + 1], corner[x + 1][z]});
      pieces.add(0, number + 1, std::array{corner[x + 1][z], corner[x][z + 1], corner[x + 1][z + 1]});
    }
  }
  return pieces;
}

const std::array kPlate{hullPart({{0.5F, 0.0F, 0.0F}, {-0.5F, 0.0F, 0.4F}, {-0.5F, 0.0F, -0.4F}}, 0.01F)};

/// A plate that begins at a place.
struct Plate {
  explicit Plate(const Vec3& from, const GroundPieces& pieces) : list(kPlate) {
    watch.begin(list);
    watch.follow(at(from), pieces, kReach, Vec3(0.0F));
  }

  PartList list;
  PassageWatch watch;
};

TEST(Passage, NoWaySlipsBetweenTriangles) {
  Random random(1);
  for (int i = 0; i < test::trials(5000); ++i) {
    const GroundPieces pieces = hills(random, i % 2 == 0 ? 0.0F : 0.8F);
    // Every other way is through a corner or the middle of an edge.
    const Vec3 a = pieces.points[static_cast<std::size_t>(random.uniform(0.0F, 1.0F) * 383.0F)];
    const Vec3 onto = i % 4 < 2 ? Vec3(random.uniform(-3.0F, 3.0F), 0.0F, random.uniform(-3.0F, 3.0F)) : a;
    if (std::abs(onto.x) > 3.2F || std::abs(onto.z) > 3.2F) continue;
    const Vec3 from = onto + Vec3(random.uniform(-0.5F, 0.5F), 3.0F, random.uniform(-0.5F, 0.5F));
    const Vec3 to = 2.0F * onto - from;
    Plate down(from, pieces);
    const Vec3 inside = (kPlate[0].core[0] + kPlate[0].core[1] + kPlate[0].core[2]) / 3.0F;
    down.watch.follow(at(to), pieces, kReach, to - from);
    ASSERT_TRUE(down.watch.open()) << i;
    EXPECT_LE(down.watch.open()->heightOf(to + inside), 0.0F);
  }
}

TEST(Passage, ClosesWhenTheMiddleIsBackOrTheTriangleIsGone) {
  Random random(2);
  const GroundPieces flat = hills(random, 0.0F);
  for (const float side : {1.0F, -1.0F}) {
    Plate plate(Vec3(0.1F, 0.3F * side, 0.2F), flat);
    const Vec3 onward(0.0F, -20.0F * side, 0.0F);
    plate.watch.follow(at(Vec3(0.1F, -0.1F * side, 0.2F)), flat, kReach, onward);
    ASSERT_TRUE(plate.watch.open());
    EXPECT_NEAR(plate.watch.open()->normal.y, side, 1e-6F) << "the side that it came from";
    plate.watch.follow(at(Vec3(0.1F, -0.2F * side, 0.2F)), flat, kReach, onward);
    EXPECT_TRUE(plate.watch.open());
    plate.watch.follow(at(Vec3(0.1F, 0.01F * side, 0.2F)), flat, kReach, -onward);
    EXPECT_FALSE(plate.watch.open());
    plate.watch.follow(at(Vec3(0.1F, -0.1F * side, 0.2F)), flat, kReach, onward);
    ASSERT_TRUE(plate.watch.open());
    plate.watch.follow(at(Vec3(0.1F, -0.1F * side, 0.2F)), GroundPieces(), kReach, onward);
    EXPECT_FALSE(plate.watch.open());
  }
}

TEST(Passage, IsOpenWhileABodyThatWandersSlowlyIsBehind) {
  Random random(5);
  const GroundPieces flat = hills(random, 0.0F);
  Vec3 place(0.1F, 0.02F, 0.2F);
  Plate plate(place, flat);
  int behind = 0;
  for (int i = 0; i < 5000; ++i) {
    place +=
        Vec3(random.uniform(-0.01F, 0.01F), random.uniform(-0.01F, 0.01F), random.uniform(-0.01F, 0.01F));
    place = glm::clamp(place, Vec3(-2.0F, -0.1F, -2.0F), Vec3(2.0F, 0.1F, 2.0F));
    plate.watch.follow(at(place), flat, kReach, Vec3(0.0F));
    ASSERT_EQ(plate.watch.open().has_value(), place.y < 0.0F) << i;
    behind += place.y < 0.0F ? 1 : 0;
  }
  EXPECT_GT(behind, 1000);
  EXPECT_LT(behind, 4000);
}

// Programs place bodies in cellars.
TEST(Passage, IsNotOfBodiesThatAreSetElsewhere) {
  Random random(3);
  const GroundPieces flat = hills(random, 0.0F);
  const Vec3 velocities[]{Vec3(0.0F), Vec3(5.0F, 0.0F, 0.0F), Vec3(0.0F, 5.0F, 0.0F)};
  for (const Vec3& velocity : velocities) {
    Plate plate(Vec3(0.1F, 1.0F, 0.2F), flat);
    plate.watch.follow(at(Vec3(0.1F, -1.0F, 0.2F)), flat, kReach, velocity);
    EXPECT_FALSE(plate.watch.open());
    EXPECT_EQ(plate.watch.wayTo(at(Vec3(9.0F)), velocity), Vec3(0.0F));
  }
  // What is pressed through little by little has no velocity to speak of.
  Plate sinking(Vec3(0.1F, 0.01F, 0.2F), flat);
  sinking.watch.follow(at(Vec3(0.1F, -0.01F, 0.2F)), flat, kReach, Vec3(0.0F));
  EXPECT_TRUE(sinking.watch.open());
}

TEST(Passage, IsOfWhatIsThereOfABody) {
  std::vector<PartDef> rim;
  for (int i = 0; i < 8; ++i) {
    const float angle = 0.7853982F * static_cast<float>(i);
    const Vec3 middle(2.0F * std::cos(angle), 0.0F, 2.0F * std::sin(angle));
    rim.push_back(testing::boxPart(middle, Vec3(0.2F), Mat3(1.0F), 0.0F));
  }
  const PartList ring(rim);
  // A post of a metre, round which the ring falls.
  GroundPieces post;
  post.add(0, 0, std::array{Vec3(-0.5F, 0.0F, -0.5F), Vec3(0.0F, 0.0F, 0.5F), Vec3(0.5F, 0.0F, -0.5F)});
  PassageWatch watch;
  watch.begin(ring);
  watch.follow(at(Vec3(0.0F, 0.2F, 0.0F)), post, kReach, Vec3(0.0F));
  watch.follow(at(Vec3(0.0F, -0.2F, 0.0F)), post, kReach, Vec3(0.0F, -24.0F, 0.0F));
  EXPECT_FALSE(watch.open());
}

TEST(Passage, IsForgottenWithTheGroundAndKeptWithOtherParts) {
  Random random(4);
  const GroundPieces flat = hills(random, 0.0F);
  Plate plate(Vec3(0.1F, 0.3F, 0.2F), flat);
  plate.watch.follow(at(Vec3(0.1F, -0.1F, 0.2F)), flat, kReach, Vec3(0.0F, -24.0F, 0.0F));
  plate.watch.begin(plate.list);
  EXPECT_TRUE(plate.watch.open());
  plate.watch.forget();
  EXPECT_FALSE(plate.watch.open());
}

}  // namespace
}  // namespace scatter::pairs
