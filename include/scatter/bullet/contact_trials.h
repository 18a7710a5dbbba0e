#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scatter {

/// How the contacts of hybrid bodies compared with the engine's, in worlds of one kind of shape.
struct ContactTrial {
  std::string shape;
  std::uint64_t worlds = 0;
  std::uint64_t childPairs = 0;  ///< That the engine's midphase has let through.
  std::uint64_t expected = 0;    ///< In contact in the engine.
  std::uint64_t missed = 0;
  std::uint64_t extra = 0;
  std::uint64_t doubtful = 0;    ///< Differences that rounding decides.
  std::uint64_t engineErrs = 0;  ///< Differences in which the engine is proven wrong.

  ContactTrial& operator+=(const ContactTrial& other);
};

/// The convex shapes that trials are made of: every kind that Bullet has, and one of a program's own.
[[nodiscard]] std::vector<std::string> contactTrialShapes();

/// A random world of hybrids of one kind of shape, alone and in compounds, from 1 cm to 100 m, needles and
/// plates among them, with other bodies of any kind, moved through each other: slow and fast, grazing and
/// deep. The same for the same shape (of contactTrialShapes()) and seed.
[[nodiscard]] ContactTrial runContactTrial(const std::string& shape, std::uint64_t seed);

}  // namespace scatter
