#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "io/collada/xml_mutator.h"
#include "io/documents.h"
#include "trials.h"

namespace scatter {
namespace {

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void expectSound(const Model& model) {
  ASSERT_NE(model.levels, nullptr);
  EXPECT_GE(model.levels->count(), 1);
  EXPECT_GT(model.mass, 0.0F);
  EXPECT_TRUE(std::all_of(model.mesh.vertices.begin(), model.mesh.vertices.end(), isFinite));
  for (const auto& triangle : model.mesh.triangles) {
    EXPECT_LT(*std::max_element(triangle.begin(), triangle.end()), model.mesh.vertices.size());
  }
}

void expectOneLine(const std::string& message) {
  EXPECT_EQ(message.rfind("fuzz.dae:", 0), 0U) << message;
  EXPECT_LT(message.size(), 400U) << message;
  EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20;
  })) << message;
}

/// Returns how many of the damaged files could still be read.
int fuzz(const std::string& text, std::uint64_t seed, int cases) {
  int readable = 0;
  for (int i = 0; i < cases; ++i) {
    test::XmlMutator mutator(seed + static_cast<std::uint64_t>(i));
    const std::string damaged = mutator.mutate(text);
    SCOPED_TRACE("case " + std::to_string(i));
    if (const auto model = parseCollada(damaged, "fuzz.dae")) {
      expectSound(*model);
      ++readable;
    } else {
      expectOneLine(model.error().message);
    }
    if (testing::Test::HasFailure()) {
      return readable;
    }
  }
  return readable;
}

TEST(ColladaFuzz, DamagedSmallFileIsReadOrRefused) {
  const int readable = fuzz(test::richDocument().text(), 1, test::trials(6000));
  // Both outcomes must occur, or the fuzzer tests nothing.
  EXPECT_GT(readable, test::trials(50));
  EXPECT_LT(readable, test::trials(5950));
}

TEST(ColladaFuzz, DamagedPlainFileIsReadOrRefused) {
  fuzz(test::Document{}.text(), 100000, test::trials(2000));
}

class ColladaFuzzModel : public testing::TestWithParam<const char*> {};

TEST_P(ColladaFuzzModel, DamagedModelIsReadOrRefused) {
  const auto text = readFile(std::string(SCATTER_TEST_MODEL_DIR "/") + GetParam() + ".dae");
  ASSERT_TRUE(text.has_value()) << text.error().message;
  fuzz(*text, 200000, test::trials(150));
}

INSTANTIATE_TEST_SUITE_P(Models, ColladaFuzzModel,
                         testing::Values("hunter", "fighter", "hunter_hulls", "fighter_hulls"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace scatter
