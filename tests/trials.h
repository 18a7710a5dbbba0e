#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace scatter::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// How many of `n` alike trials a test makes: all, but under sanitizers a quarter, as memory errors show in
/// the first trials and each takes ten times as long there; what is found only now and then is for the
/// optimised build to find. Bars that depend on the number of trials are scaled with it.
constexpr int trials(int n) {
  return kSanitized ? std::max(1, n / 4) : n;
}

/// The first of trials that are listed.
template <class T>
std::vector<T> trials(std::vector<T> all) {
  all.resize(static_cast<std::size_t>(trials(static_cast<int>(all.size()))));
  return all;
}

/// A seed for each of `n` random trials.
inline std::vector<std::uint64_t> seeds(std::uint64_t first, int n) {
  std::vector<std::uint64_t> all(static_cast<std::size_t>(trials(n)));
  std::iota(all.begin(), all.end(), first);
  return all;
}

/// So many seeds as usual, from 1 on; where the environment has these variables, as many as the first says,
/// and from what the second says on.
inline std::vector<std::uint64_t> seedsOr(const char* countVariable, const char* firstVariable, int usual) {
  const char* count = std::getenv(countVariable);
  const char* first = std::getenv(firstVariable);
  const std::uint64_t from = first == nullptr ? 1 : std::strtoull(first, nullptr, 10);
  if (count == nullptr) return seeds(from, usual);
  std::vector<std::uint64_t> all(std::strtoull(count, nullptr, 10));
  std::iota(all.begin(), all.end(), from);
  return all;
}

}  // namespace scatter::test
