#include "solver/island_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "../trials.h"

namespace scatter::solver {
namespace {

using Link = IslandGroups::Link;

struct Contacts {
  int bodies = 0;
  std::vector<Link> links;
  std::vector<int> apart;
};

Contacts randomContacts(std::uint64_t seed) {
  std::mt19937 engine(static_cast<std::mt19937::result_type>(seed));
  const auto below = [&](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); };
  Contacts contacts;
  contacts.bodies = 1 + below(80);
  for (int i = below(120); i > 0; --i) {
    const int a = below(contacts.bodies);
    const int b = below(4) == 0 ? below(contacts.bodies) : IslandGroups::kNone;
    if (a != b) contacts.links.push_back({a, b, 1 + below(30)});
  }
  for (int i = below(4); i > 0; --i) contacts.apart.push_back(below(contacts.bodies));
  return contacts;
}

/// The group of each link, each of which is in one.
std::vector<int> groupsOf(const IslandGroups& groups, std::size_t links) {
  std::vector<int> result(links, -1);
  for (int group = 0; group < groups.count(); ++group) {
    const auto own = groups.linksOf(group);
    EXPECT_TRUE(std::is_sorted(own.begin(), own.end()));
    for (const int link : own) {
      EXPECT_EQ(result[static_cast<std::size_t>(link)], -1) << "link " << link << " is in two groups";
      result[static_cast<std::size_t>(link)] = group;
    }
  }
  EXPECT_EQ(std::count(result.begin(), result.end(), -1), 0);
  return result;
}

class IslandGroupsSeeds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(IslandGroupsSeeds, HaveEveryLinkOnceAndNoBodyInTwo) {
  const Contacts contacts = randomContacts(GetParam());
  IslandGroups groups;
  groups.group(contacts.bodies, contacts.links, contacts.apart, 40);
  const std::vector<int> of = groupsOf(groups, contacts.links.size());
  std::map<int, int> groupOfBody;
  for (std::size_t i = 0; i < of.size(); ++i) {
    for (const int body : {contacts.links[i].a, contacts.links[i].b}) {
      if (body == IslandGroups::kNone) continue;
      EXPECT_EQ(groupOfBody.try_emplace(body, of[i]).first->second, of[i]) << "body " << body;
    }
  }
  for (const int body : contacts.apart) {
    if (groupOfBody.contains(body)) {
      EXPECT_EQ(groupOfBody[body], 0) << "body " << body;
    }
  }
}

TEST_P(IslandGroupsSeeds, TakeNoMoreIslandsThanTheirShareNeeds) {
  const Contacts contacts = randomContacts(GetParam());
  IslandGroups groups;
  groups.group(contacts.bodies, contacts.links, contacts.apart, 40);
  for (int group = 1; group < groups.count(); ++group) {
    int count = 0;
    for (const int link : groups.linksOf(group))
      count += contacts.links[static_cast<std::size_t>(link)].count;
    EXPECT_GT(count, 0);
    if (group + 1 < groups.count()) {
      EXPECT_GE(count, 40) << "group " << group;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Random, IslandGroupsSeeds, testing::ValuesIn(test::seeds(1, 300)));

TEST(IslandGroups, KeepAnIslandTogetherHoweverLargeItIs) {
  std::vector<Link> chain;
  for (int i = 0; i < 99; ++i) chain.push_back({i, i + 1, 4});
  IslandGroups groups;
  groups.group(100, chain, {}, 40);
  EXPECT_EQ(groups.count(), 2);
  EXPECT_TRUE(groups.linksOf(0).empty());
  EXPECT_EQ(groups.linksOf(1).size(), 99U);
}

TEST(IslandGroups, PartIslandsThatOnlyLieOnTheSameGround) {
  std::vector<Link> links;
  for (int i = 0; i < 30; ++i) links.push_back({i, IslandGroups::kNone, 4});
  IslandGroups groups;
  groups.group(30, links, {}, 40);
  EXPECT_EQ(groups.count(), 1 + 3);
  groups.group(30, links, std::vector<int>{7}, 40);
  ASSERT_EQ(groups.linksOf(0).size(), 1U);
  EXPECT_EQ(groups.linksOf(0)[0], 7);
}

TEST(IslandGroups, AreNoneWithoutContacts) {
  IslandGroups groups;
  EXPECT_EQ(groups.count(), 1);
  groups.group(0, {}, {}, 40);
  EXPECT_EQ(groups.count(), 1);
  EXPECT_TRUE(groups.linksOf(0).empty());
}

}  // namespace
}  // namespace scatter::solver
