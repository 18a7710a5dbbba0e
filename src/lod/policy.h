#pragma once

#include <scatter/lod/request.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>

#include "lod/situation.h"

namespace scatter::lod {

/// What is wanted of one pair. Each policy fills in one of its own; PolicyList composes them.
struct Wish {
  /// How much its detail is worth, 1 for an ordinary pair; multiplied by policies. The governor takes detail
  /// first where little is lost.
  float importance = 1.0F;

  /// A request: no finer than this. The coarsest that any policy asks for counts.
  std::uint8_t atMost = std::numeric_limits<std::uint8_t>::max();

  /// A promise: no coarser than this, budget or not; wins over `atMost`.
  std::uint8_t atLeast = 1;

  /// Which policy asked for `atMost`: its index in the list. Says nothing while no policy asks.
  std::uint8_t askedBy = 0;

  void scale(float factor) { importance *= factor; }
  void request(int level) {
    atMost = std::min(atMost, static_cast<std::uint8_t>(std::clamp(level, 1, kLevels)));
  }
  void promise(int level) {
    atLeast = std::max(atLeast, static_cast<std::uint8_t>(std::clamp(level, 1, kLevels)));
  }

 private:
  static constexpr int kLevels = std::numeric_limits<std::uint8_t>::max();
};

/// One heuristic about when detail matters (report, section 3.4.4 and Figure 3.7). Deterministic: what it
/// says depends on the situations it was shown only.
class Policy {
 public:
  Policy() = default;
  Policy(const Policy&) = delete;
  Policy& operator=(const Policy&) = delete;
  virtual ~Policy() = default;

  /// Lives as long as the program and ends with a 0: events name policies by it.
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// Whose knowledge it uses.
  [[nodiscard]] virtual Scope scope() const = 0;

  /// Every planned step, before advise(): looks at groups or at the whole world. Keeps nothing of the
  /// situation itself, whose bodies and pairs do not outlive the step.
  virtual void observe(const Situation& /*situation*/) {}

  /// About one pair of the situation that was last observed, or about a pair that is new in it. Called for
  /// thousands of pairs in a step. `wish` says nothing yet.
  virtual void advise(const Situation& situation, const PairView& pair, Wish& wish) const = 0;
};

/// A policy whose class `Derived` has its name and scope as `kName` and `kScope`.
template <class Derived>
class NamedPolicy : public Policy {
 public:
  [[nodiscard]] std::string_view name() const final { return Derived::kName; }
  [[nodiscard]] Scope scope() const final { return Derived::kScope; }
};

}  // namespace scatter::lod
