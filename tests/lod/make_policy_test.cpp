#include "lod/make_policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "lod/policy_world.h"

namespace scatter::lod {
namespace {

using ::testing::AllOf;
using testing::Dice;
using ::testing::HasSubstr;
using testing::PolicyWorld;

std::string errorOf(std::string_view spec) {
  const auto made = makePolicy(spec);
  return made ? "no error" : made.error().message;
}

bool isOneLine(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

TEST(MakePolicy, MakesEveryKnownPolicyByItsName) {
  for (const PolicyInfo& info : knownPolicies()) {
    const auto made = makePolicy(info.name);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ((*made)->name(), info.name);
    EXPECT_EQ((*made)->scope(), info.scope);
  }
}

TEST(MakePolicy, TakesEveryParameterAtItsStandardAndAtItsLimits) {
  for (const PolicyInfo& info : knownPolicies()) {
    for (const ParameterInfo& parameter : info.parameters) {
      const std::string start = std::string(info.name) + ":" + std::string(parameter.name) + "=";
      EXPECT_EQ(errorOf(start + std::to_string(parameter.standard)), "no error");
      const std::string below = std::to_string(parameter.least - 1.0);
      const std::string above = std::to_string(parameter.most * 2.0);
      for (const std::string& bad : {below, above}) {
        EXPECT_THAT(errorOf(start + bad), AllOf(HasSubstr("out of range"), HasSubstr(info.name)));
      }
      EXPECT_EQ(errorOf(start + "2.5").find("whole") != std::string::npos,
                parameter.whole && parameter.most > 2.0)
          << start;
    }
  }
}

TEST(MakePolicy, ParametersReachThePolicy) {
  PolicyWorld world = PolicyWorld::twoBodies();
  world.bodies[0].velocity = Vec3(2.5F, 0.0F, 0.0F);
  const auto plain = makePolicy("speed");
  const auto set = makePolicy("  speed : from = 2 ,to=3, least=0.2, coarse=2.4, level=2 ");
  ASSERT_TRUE(plain && set);
  EXPECT_EQ(world.ask(**plain).importance, 1.0F);
  EXPECT_FLOAT_EQ(world.ask(**set).importance, 0.6F);
  EXPECT_EQ(world.ask(**set).atMost, 2);
}

TEST(MakePolicy, NamesTheKnownPoliciesAndTheNearest) {
  const std::string error = errorOf("sped");
  EXPECT_THAT(error, AllOf(HasSubstr("\"sped\""), HasSubstr("did you mean \"speed\"?")));
  for (const PolicyInfo& info : knownPolicies()) EXPECT_THAT(error, HasSubstr(info.name));
  EXPECT_THAT(errorOf("grup-rang"), HasSubstr("did you mean \"group-range\"?"));
  EXPECT_THAT(errorOf("xyzzyplugh"), ::testing::Not(HasSubstr("did you mean")));
}

TEST(MakePolicy, NamesTheKnownParametersAndTheNearest) {
  EXPECT_THAT(errorOf("speed:form=5"), AllOf(HasSubstr("\"form\""), HasSubstr("did you mean \"from\"?"),
                                             HasSubstr("from, to, least, coarse, level")));
}

TEST(MakePolicy, SaysWhatIsWrongWithAValue) {
  EXPECT_EQ(errorOf("speed:from=fast"), "policy \"speed\": \"from\": \"fast\" is not a number");
  EXPECT_EQ(errorOf("speed:from=-1"),
            "policy \"speed\": \"from\": \"-1\" is out of range; it can be 0 to 1e+06 m/s");
  EXPECT_THAT(errorOf("speed:from=nan"), HasSubstr("out of range"));
  EXPECT_THAT(errorOf("speed:from=inf"), HasSubstr("out of range"));
  EXPECT_THAT(errorOf("speed:from=1e999"), HasSubstr("not a number"));
  EXPECT_THAT(errorOf("speed:from=5 m"), HasSubstr("not a number"));
  EXPECT_THAT(errorOf("speed:from="), HasSubstr("not a number"));
  EXPECT_THAT(errorOf("speed:level=1.5"), HasSubstr("not a whole number"));
  EXPECT_EQ(errorOf("speed:from"), "policy \"speed\": \"from\" has no value; write from=5");
  EXPECT_THAT(errorOf("speed:from=1,from=2"), HasSubstr("twice"));
  EXPECT_EQ(errorOf("held:x=1"), "policy \"held\": it has no parameters; leave out \"x=1\"");
}

TEST(MakePolicy, SaysWhenValuesDoNotGoTogether) {
  EXPECT_EQ(errorOf("speed:from=7,to=7"), "policy \"speed\": \"to\" must be above \"from\"");
  EXPECT_THAT(errorOf("load:fine=1,over=1"), HasSubstr("\"fine\" must be below \"over\""));
  EXPECT_THAT(errorOf("group-density:from=3,to=3"), HasSubstr("\"to\" must be above \"from\""));
  EXPECT_THAT(errorOf("group-range:packing=0"), HasSubstr("both be 0"));
}

TEST(MakePolicy, WhateverItIsGivenItMakesAPolicyOrSaysWhyInOneLine) {
  Dice dice(1);
  const std::vector<std::string> words{"speed", "group-range", "focus", "from", "to", "=",
                                       ":",     ",",           "5",     "-1e9", " ",  "level",
                                       "\n",    "nan",         "0x",    "é",    "\"", std::string(1, '\0')};
  int made = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string spec = round % 2 == 0 ? "speed:" : "";
    for (std::uint32_t i = dice.below(10); i > 0; --i) {
      if (dice.below(4) == 0) {
        spec += static_cast<char>(dice.below(256));
      } else {
        spec += words[dice.below(static_cast<std::uint32_t>(words.size()))];
      }
    }
    if (makePolicy(spec)) {
      ++made;
      continue;
    }
    const std::string error = errorOf(spec);
    ASSERT_TRUE(isOneLine(error)) << error;
    ASSERT_LT(error.size(), 400U) << error;
  }
  EXPECT_GT(made, 0);
}

TEST(MakePolicy, LongNonsenseIsQuotedInPart) {
  EXPECT_LT(errorOf(std::string(1000000, 'a')).size(), 400U);
  EXPECT_LT(errorOf("speed:" + std::string(1000000, 'b') + "=1").size(), 400U);
}

TEST(KnownPolicies, DescribeThemselves) {
  std::set<std::string_view> names;
  for (const PolicyInfo& info : knownPolicies()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.summary.empty());
    std::set<std::string_view> parameters;
    for (const ParameterInfo& parameter : info.parameters) {
      EXPECT_TRUE(parameters.insert(parameter.name).second) << info.name << " " << parameter.name;
      EXPECT_FALSE(parameter.meaning.empty());
      EXPECT_LE(parameter.least, parameter.standard);
      EXPECT_GE(parameter.most, parameter.standard);
    }
  }
  EXPECT_EQ(names.size(), 13U);
}

TEST(KnownPolicies, AreDocumentedWithTheirParameters) {
  const auto page = std::filesystem::path(SCATTER_TEST_MODEL_DIR).parent_path() / "docs" / "policies.md";
  std::ifstream file(page);
  ASSERT_TRUE(file) << page;
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  for (const PolicyInfo& info : knownPolicies()) {
    EXPECT_THAT(text, HasSubstr("| `" + std::string(info.name) + "` | " + std::string(nameOf(info.scope))));
    for (const ParameterInfo& parameter : info.parameters) {
      std::ostringstream entry;
      entry << "`" << parameter.name << "=" << parameter.standard << "`";
      EXPECT_THAT(text, HasSubstr(entry.str())) << info.name;
    }
  }
}

TEST(KnownPolicies, ComeInTheOrderOfTheirScopes) {
  EXPECT_TRUE(std::is_sorted(knownPolicies().begin(), knownPolicies().end(),
                             [](const PolicyInfo& a, const PolicyInfo& b) { return a.scope < b.scope; }));
}

TEST(MakePolicyList, KeepsTheOrderAndPassesErrorsOn) {
  const std::vector<std::string> specs{"speed", "held", "load:level=2"};
  const auto list = makePolicyList(specs);
  ASSERT_TRUE(list);
  ASSERT_EQ((*list)->size(), 3U);
  EXPECT_EQ((**list)[2].name(), "load");
  const std::vector<std::string> bad{"speed", "hold"};
  EXPECT_THAT(makePolicyList(bad).error().message, HasSubstr("did you mean \"held\"?"));
}

}  // namespace
}  // namespace scatter::lod
