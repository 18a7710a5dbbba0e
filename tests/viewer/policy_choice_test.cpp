#include "viewer/policy_choice.h"

#include <gmock/gmock.h>

#include <set>

namespace scatter::viewer {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> chosenOf(const SwitchingDef& def) {
  std::vector<std::string> names;
  for (const PolicyChoice& choice : policyChoices(def)) {
    if (choice.chosen) names.push_back(choice.name);
  }
  return names;
}

TEST(PolicyChoice, EachPolicyIsOfferedOnce) {
  for (const Switching switching : {Switching::kPair, Switching::kBody}) {
    SwitchingDef def;
    def.switching = switching;
    std::set<std::string> names;
    for (const PolicyChoice& choice : policyChoices(def))
      EXPECT_TRUE(names.insert(choice.name).second) << choice.name;
    EXPECT_TRUE(names.contains("proximity"));
    EXPECT_TRUE(names.contains("coarsest"));
    EXPECT_EQ(names.contains("speed"), switching == Switching::kPair);
  }
}

TEST(PolicyChoice, ThoseInUseAreMarkedWhicheverWayTheyWereAskedFor) {
  SwitchingDef def;
  def.policy = Policy::kCoarsest;
  def.policies = {"speed:from=5", "held"};
  EXPECT_THAT(chosenOf(def), ElementsAre("speed", "held", "coarsest"));
  def.switching = Switching::kBody;
  EXPECT_THAT(chosenOf(def), ElementsAre("coarsest"));
}

TEST(PolicyChoice, ChoosingAddsAndTakesAway) {
  SwitchingDef def;
  def.policy = Policy::kCoarsest;
  def.policies = {"speed:from=5", "held"};
  ChosenPolicies without = choosePolicy(def, "coarsest", false);
  EXPECT_EQ(without.policy, Policy::kNone);
  EXPECT_THAT(without.named, ElementsAre("speed:from=5", "held"));
  EXPECT_THAT(choosePolicy(def, "speed", false).named, ElementsAre("held"));
  EXPECT_THAT(choosePolicy(def, "mass", true).named, ElementsAre("speed:from=5", "held", "mass"));
}

TEST(PolicyChoice, BodiesHaveOne) {
  SwitchingDef def;
  def.switching = Switching::kBody;
  def.policy = Policy::kProximity;
  EXPECT_EQ(choosePolicy(def, "finest", true).policy, Policy::kFinest);
  EXPECT_EQ(choosePolicy(def, "none", true).policy, Policy::kNone);
  EXPECT_THAT(choosePolicy(def, "finest", true).named, IsEmpty());
}

}  // namespace
}  // namespace scatter::viewer
