#include "solver/contact_reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../trials.h"

namespace scatter::solver {
namespace {

ReducibleContact contactAt(float x, float z, float distance = 0, float impulse = 0) {
  return {{x, 0, z, distance}, {0, 1, 0, impulse}, -1};
}

/// A square of n by n contacts, a metre wide.
std::vector<ReducibleContact> square(int n) {
  std::vector<ReducibleContact> contacts;
  for (int i = 0; i < n * n; ++i)
    contacts.push_back(contactAt(static_cast<float>(i % n) / static_cast<float>(n - 1),
                                 static_cast<float>(i / n) / static_cast<float>(n - 1)));
  return contacts;
}

std::vector<int> keptOf(const std::vector<ReducibleContact>& contacts) {
  std::vector<int> kept;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].kept == static_cast<int>(i)) kept.push_back(contacts[i].kept);
  }
  return kept;
}

TEST(ContactReduction, KeepsTheCornersOfASquare) {
  std::vector<ReducibleContact> contacts = square(6);
  contacts[0].place.w = -0.001F;
  EXPECT_EQ(ContactReduction().reduce(contacts, 4), 4);
  EXPECT_EQ(keptOf(contacts), (std::vector<int>{0, 5, 30, 35}));
}

TEST(ContactReduction, KeepsTheDeepest) {
  std::vector<ReducibleContact> contacts = square(6);
  contacts[14].place.w = -0.01F;
  EXPECT_EQ(ContactReduction().reduce(contacts, 4), 4);
  EXPECT_EQ(contacts[14].kept, 14);
}

TEST(ContactReduction, KeepsAllOfFew) {
  std::vector<ReducibleContact> contacts = square(2);
  EXPECT_EQ(ContactReduction().reduce(contacts, 4), 4);
  EXPECT_EQ(keptOf(contacts).size(), 4U);
}

TEST(ContactReduction, KeepsSomeOfEachDirection) {
  std::vector<ReducibleContact> contacts = square(6);
  for (std::size_t i = 0; i < contacts.size(); i += 2) contacts[i].normal = {1, 0, 0, 0};
  EXPECT_EQ(ContactReduction().reduce(contacts, 4), 8);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    EXPECT_EQ(contacts[static_cast<std::size_t>(contacts[i].kept)].normal.x, contacts[i].normal.x);
}

// More directions than are looked for at once, in turns.
TEST(ContactReduction, TellsTheFacetsOfAWheelApart) {
  constexpr int kFacets = 23;
  std::vector<ReducibleContact> contacts;
  for (int i = 0; i < 5 * kFacets; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i % kFacets) / static_cast<float>(kFacets);
    const auto along = static_cast<float>(i / kFacets);
    contacts.push_back({{along, 0, 0, 0}, {0, std::cos(angle), std::sin(angle), 0}, -1});
  }
  EXPECT_EQ(ContactReduction().reduce(contacts, 3), 3 * kFacets);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    EXPECT_EQ(contacts[i].kept % kFacets, static_cast<int>(i) % kFacets) << i;
}

TEST(ContactReduction, TakesContactsAtOnePlaceForOne) {
  std::vector<ReducibleContact> contacts(20, contactAt(0.5F, 0.5F));
  EXPECT_EQ(ContactReduction().reduce(contacts, 8), 1);
}

TEST(ContactReduction, StaysWithThoseThatBore) {
  std::vector<ReducibleContact> contacts = square(6);
  // All but the corners, and as far as others are.
  for (const std::size_t i : {7U, 10U, 25U, 28U}) contacts[i].normal.w = 1;
  std::vector<ReducibleContact> again = contacts;
  ContactReduction reduction;
  EXPECT_EQ(reduction.reduce(contacts, 4), 4);
  EXPECT_TRUE(contacts[7].kept == 7 || contacts[10].kept == 10);
  EXPECT_EQ(reduction.reduce(again, 4), 4);
  EXPECT_EQ(keptOf(again), keptOf(contacts)) << "the same, whatever was reduced before";
}

TEST(ContactReduction, LetsWhatHasSunkTakeThePlaceOfWhatStandsForIt) {
  std::vector<ReducibleContact> contacts = square(6);
  contacts[0].place.w = -0.02F;
  contacts[28].place.w = -0.01F;  // beside the corner 35
  EXPECT_EQ(ContactReduction().reduce(contacts, 4), 4);
  EXPECT_EQ(keptOf(contacts), (std::vector<int>{0, 5, 28, 30}));
  EXPECT_EQ(contacts[35].kept, 28);
  contacts[28].place.w = -0.0005F;
  EXPECT_EQ(ContactReduction().reduce(contacts, 4), 4);
  EXPECT_EQ(keptOf(contacts), (std::vector<int>{0, 5, 30, 35})) << "no more than places tremble by";
}

class ReductionSeeds : public testing::TestWithParam<std::uint64_t> {
 protected:
  float unit() { return static_cast<float>(engine_() % 10007) / 10007.0F; }
  int below(unsigned long count) { return static_cast<int>(engine_() % count); }

  std::vector<ReducibleContact> randomContacts(float deepest) {
    std::vector<ReducibleContact> contacts;
    for (int i = 1 + below(60); i > 0; --i)
      contacts.push_back(contactAt(unit(), unit(), -deepest * unit(), unit() - 0.5F));
    return contacts;
  }

 private:
  std::mt19937 engine_{static_cast<std::mt19937::result_type>(GetParam())};
};

TEST_P(ReductionSeeds, LeaveNoContactThatIsMuchDeeperThanWhatStandsForIt) {
  std::vector<ReducibleContact> contacts = randomContacts(0.05F);
  ContactReduction().reduce(contacts, 1 + below(8));
  for (const ReducibleContact& contact : contacts) {
    const ReducibleContact& kept = contacts[static_cast<std::size_t>(contact.kept)];
    EXPECT_LE(kept.place.w, contact.place.w + 0.001F + 1e-6F);
  }
}

// By brute force: of contacts that are as deep, what was left out is nearest to what stands for it, and what
// stays is among all.
TEST_P(ReductionSeeds, LeaveEachContactToTheNearestThatStays) {
  std::vector<ReducibleContact> contacts = randomContacts(0.0009F);
  const int most = 1 + below(8);
  const int left = ContactReduction().reduce(contacts, most);
  const std::vector<int> kept = keptOf(contacts);
  ASSERT_EQ(static_cast<int>(kept.size()), left);
  EXPECT_LE(left, most);
  for (const ReducibleContact& contact : contacts) {
    const auto far = [&](int i) {
      const ReducibleContact& other = contacts[static_cast<std::size_t>(i)];
      return std::hypot(other.place.x - contact.place.x, other.place.z - contact.place.z);
    };
    ASSERT_TRUE(std::find(kept.begin(), kept.end(), contact.kept) != kept.end());
    for (const int other : kept) EXPECT_LE(far(contact.kept), far(other) + 1e-6F);
  }
}

INSTANTIATE_TEST_SUITE_P(Random, ReductionSeeds, testing::ValuesIn(test::seeds(1, 200)));

}  // namespace
}  // namespace scatter::solver
