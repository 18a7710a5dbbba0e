#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <pugixml.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "io/documents.h"

namespace scatter {
namespace {

/// Damages files in the ways that editors, exporters and disks do. The same seed, the same damage.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string mutate(std::string text) {
    for (std::size_t count = 1 + below(3); count > 0; --count) {
      text = mutateOnce(std::move(text));
    }
    return text;
  }

 private:
  std::size_t below(std::size_t limit) {
    return limit == 0 ? 0 : static_cast<std::size_t>(random_() % limit);
  }

  std::string mutateOnce(std::string text) {
    switch (below(6)) {
      case 0:
        return flipByte(std::move(text));
      case 1:
        return text.substr(0, below(text.size() + 1));
      case 2:
        return cutRange(std::move(text));
      case 3:
        return replaceNumber(std::move(text));
      case 4:
        return changeTree(text, false);
      default:
        return changeTree(text, true);
    }
  }

  std::string flipByte(std::string text) {
    if (!text.empty()) {
      text[below(text.size())] = static_cast<char>(random_());
    }
    return text;
  }

  std::string cutRange(std::string text) {
    const std::size_t begin = below(text.size());
    return text.erase(begin, below(200));
  }

  std::string replaceNumber(std::string text) {
    constexpr std::array<std::string_view, 14> kNumbers{
        "nan",   "inf", "-inf", "1e38", "-1e38",      "1e-45",
        "1e999", "",    "0",    "-1",   "4294967295", "99999999999999999999",
        "0x10",  "1,5"};
    constexpr std::string_view kDigits = "0123456789+-.eE";
    const std::size_t begin = text.find_first_of("0123456789", below(text.size()));
    if (begin != std::string::npos) {
      const std::size_t end = std::min(text.find_first_not_of(kDigits, begin), text.size());
      text.replace(begin, end - begin, kNumbers[below(kNumbers.size())]);
    }
    return text;
  }

  /// Removes an element, or puts a copy of it into another one.
  std::string changeTree(const std::string& text, bool duplicate) {
    pugi::xml_document document;
    document.load_buffer(text.data(), text.size());
    std::vector<pugi::xml_node> nodes;
    for (const pugi::xpath_node& found : document.select_nodes("//*")) {
      nodes.push_back(found.node());
    }
    if (nodes.empty()) {
      return text;
    }
    pugi::xml_node chosen = nodes[below(nodes.size())];
    if (duplicate) {
      nodes[below(nodes.size())].append_copy(chosen);
    } else {
      chosen.parent().remove_child(chosen);
    }
    struct : pugi::xml_writer {
      std::string text;
      void write(const void* data, std::size_t size) override {
        text.append(static_cast<const char*>(data), size);
      }
    } writer;
    document.save(writer, "", pugi::format_raw);
    return writer.text;
  }

  std::mt19937_64 random_;
};

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
    Mutator mutator(seed + static_cast<std::uint64_t>(i));
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
  const int readable = fuzz(test::richDocument().text(), 1, 6000);
  // Both outcomes must occur, or the fuzzer tests nothing.
  EXPECT_GT(readable, 50);
  EXPECT_LT(readable, 5950);
}

TEST(ColladaFuzz, DamagedPlainFileIsReadOrRefused) {
  fuzz(test::Document{}.text(), 100000, 2000);
}

class ColladaFuzzModel : public testing::TestWithParam<const char*> {};

TEST_P(ColladaFuzzModel, DamagedModelIsReadOrRefused) {
  const auto text = readFile(std::string(SCATTER_TEST_MODEL_DIR "/") + GetParam() + ".dae");
  ASSERT_TRUE(text.has_value()) << text.error().message;
  fuzz(*text, 200000, 150);
}

INSTANTIATE_TEST_SUITE_P(Models, ColladaFuzzModel,
                         testing::Values("hunter", "fighter", "hunter_hulls", "fighter_hulls"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace scatter
