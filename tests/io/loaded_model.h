#pragma once

#include <gtest/gtest.h>
#include <scatter/io/model_library.h>

#include <memory>
#include <ostream>

namespace scatter::test {

/// What is expected of a model of the library; test programs print its name.
struct ExpectedModel {
  const char* name;
};

inline void PrintTo(const ExpectedModel& expected, std::ostream* out) {
  *out << expected.name;
}

/// The model that an Expected, derived from ExpectedModel, names.
template <class Expected>
class LoadedModel : public testing::TestWithParam<Expected> {
 protected:
  void SetUp() override {
    auto loaded = loadModel(this->GetParam().name);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    model_ = *loaded;
  }

  std::shared_ptr<const Model> model_;
};

}  // namespace scatter::test
