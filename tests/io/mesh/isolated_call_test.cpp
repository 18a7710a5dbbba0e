#include "io/mesh/isolated_call.h"

#include <gmock/gmock.h>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace scatter::io {
namespace {

using testing::HasSubstr;

TEST(IsolatedCall, GivesWhatTheWorkReturns) {
  const std::string large(3'000'000, 'x');
  EXPECT_EQ(callIsolated([] { return std::string("a\0b", 3); }, {}).value_or(""), std::string("a\0b", 3));
  EXPECT_EQ(callIsolated([&] { return large; }, {}).value_or(""), large);
}

TEST(IsolatedCall, LeavesThisProcessUntouched) {
  int counter = 0;
  EXPECT_TRUE(callIsolated([&] { return std::to_string(++counter); }, {}).has_value());
  EXPECT_EQ(counter, 0);
}

TEST(IsolatedCall, SurvivesACrash) {
  const auto result = callIsolated(
      []() -> std::string {
        std::raise(SIGSEGV);
        return "";
      },
      {});
  ASSERT_FALSE(result.has_value());
}

TEST(IsolatedCall, EndsAnEndlessLoop) {
  IsolationLimits limits;
  limits.processorSeconds = 1;
  const auto result = callIsolated(
      []() -> std::string {
        const volatile bool forever = true;
        while (forever) {
        }
        return "";
      },
      limits);
  ASSERT_FALSE(result.has_value());
  EXPECT_THAT(result.error().message, HasSubstr("more than 1 s"));
}

TEST(IsolatedCall, PassesOnThatItThrew) {
  const auto result = callIsolated([]() -> std::string { throw std::runtime_error("x"); }, {});
  ASSERT_FALSE(result.has_value());
  EXPECT_THAT(result.error().message, HasSubstr("failed"));
}

TEST(IsolatedCall, LimitsTheAnswer) {
  IsolationLimits limits;
  limits.answerBytes = 1000;
  EXPECT_FALSE(callIsolated([] { return std::string(100'000, 'x'); }, limits).has_value());
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(IsolatedCall, LimitsTheMemory) {
  IsolationLimits limits;
  limits.memoryBytes = 64U << 20U;
  const auto result = callIsolated(
      [] { return std::to_string(std::vector<char>(std::size_t{1} << 30U, 'x').back()); }, limits);
  ASSERT_FALSE(result.has_value());
  EXPECT_THAT(result.error().message, HasSubstr("64 MiB"));
}
#endif

}  // namespace
}  // namespace scatter::io
