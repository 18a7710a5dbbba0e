#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "lod/grouping.h"
#include "lod/policy.h"

namespace scatter::lod {

/// Policies in an order, and what they want together. The order decides two things only: who is named when
/// two ask for the same level, and how the product of importances is rounded.
class PolicyList {
 public:
  /// The range that composed importances are brought into.
  static constexpr float kLeastImportance = 1.0F / 1024.0F;
  static constexpr float kMostImportance = 1024.0F;

  /// At most so many, because Wish::askedBy counts them.
  static constexpr std::size_t kMost = 256;

  void add(std::unique_ptr<Policy> policy);

  /// For the policies of this list that look at groups, so that groups are made once for all: to be given to
  /// makePolicy().
  [[nodiscard]] const std::shared_ptr<Grouping>& grouping() const { return grouping_; }

  /// Every planned step, before advise().
  void observe(const Situation& situation);

  /// The composition: importance is multiplied, the coarsest request counts and the finest promise; a promise
  /// wins over requests, so that 1 <= atLeast <= the pair's finest and atLeast <= atMost always.
  [[nodiscard]] Wish advise(const Situation& situation, const PairView& pair) const;

  [[nodiscard]] bool empty() const { return policies_.empty(); }
  [[nodiscard]] std::size_t size() const { return policies_.size(); }
  [[nodiscard]] const Policy& operator[](std::size_t index) const { return *policies_[index]; }

 private:
  std::vector<std::unique_ptr<Policy>> policies_;
  std::shared_ptr<Grouping> grouping_ = std::make_shared<Grouping>();
};

}  // namespace scatter::lod
