#pragma once

#include <cstdint>

#include "pairs/planned_body.h"

namespace scatter::pairs::testing {

/// A body as a planner sees it, in a world that has no other.
class FakeBody : public PlannedBody {
 public:
  explicit FakeBody(std::uint32_t index = 0) : index_(index) {}
  [[nodiscard]] const void* object() const override { return this; }
  [[nodiscard]] std::uint32_t index() const override { return index_; }
  [[nodiscard]] int askedLevel() const override { return asked; }
  [[nodiscard]] bool hasResponse() const override { return !isSensor; }
  [[nodiscard]] bool easesContacts() const override { return !hasSprings; }
  [[nodiscard]] bool isMovable() const override { return !isFixed; }

  int asked = 0;
  bool isSensor = false;
  bool hasSprings = false;
  bool isFixed = false;

 private:
  std::uint32_t index_;
};

}  // namespace scatter::pairs::testing
