#include <scatter/io/mesh_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <string_view>

#include "io/mesh/files.h"
#include "io/mesh/packed_gltf.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

/// Damages files, text or not. The same seed, the same damage.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string mutate(std::string bytes) {
    for (std::size_t count = 1 + below(4); count > 0; --count) bytes = mutateOnce(std::move(bytes));
    return bytes;
  }

 private:
  std::size_t below(std::size_t limit) {
    return limit == 0 ? 0 : static_cast<std::size_t>(random_() % limit);
  }

  std::string mutateOnce(std::string bytes) {
    switch (below(7)) {
      case 0:
        if (!bytes.empty()) bytes[below(bytes.size())] = static_cast<char>(random_());
        return bytes;
      case 1:
        return bytes.substr(0, below(bytes.size() + 1));
      case 2:
        return bytes.erase(below(bytes.size()), below(60));
      case 3:
      case 4:
        return replaceNumber(std::move(bytes));
      case 5:
        return overwriteInteger(std::move(bytes));
      default:
        return duplicateRange(std::move(bytes));
    }
  }

  std::string replaceNumber(std::string text) {
    constexpr std::array<std::string_view, 14> kNumbers{
        "nan",   "inf",       "-inf", "1e38", "-1e38",      "1e-45",
        "1e999", "",          "0",    "-1",   "4294967295", "99999999999999999999",
        "65536", "2147483647"};
    const std::size_t begin = text.find_first_of("0123456789", below(text.size()));
    if (begin != std::string::npos) {
      const std::size_t end = std::min(text.find_first_not_of("0123456789+-.eE", begin), text.size());
      text.replace(begin, end - begin, kNumbers.at(below(kNumbers.size())));
    }
    return text;
  }

  /// As a count or an offset in a binary file.
  std::string overwriteInteger(std::string bytes) {
    constexpr std::array<std::uint32_t, 6> kIntegers{0, 1, 0x7fffffffU, 0xffffffffU, 0x10000U, 0x80000000U};
    if (bytes.size() < 4) return bytes;
    const std::uint32_t value = kIntegers.at(below(kIntegers.size()));
    std::copy_n(reinterpret_cast<const char*>(&value), 4,
                bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size() - 3)));
    return bytes;
  }

  std::string duplicateRange(std::string bytes) {
    const std::string piece = bytes.substr(below(bytes.size()), below(120));
    return bytes.insert(below(bytes.size() + 1), piece);
  }

  std::mt19937_64 random_;
};

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

struct Seed {
  const char* name;
  std::string bytes;
};

SurfaceMesh octahedron() {
  return {
      .vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      .triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

std::vector<Seed> seeds() {
  return {
      {"fuzz.obj", test::objBox() + "l 1 2\nf -1 -2 -3 -4 -5\nvn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1/1\n"},
      {"fuzz.stl", test::asciiStlBox()},
      {"binary.stl", test::binaryStlBox()},
      {"fuzz.ply", test::plyBox()},
      {"fuzz.dae", test::daeBox("<unit meter=\"0.1\"/>", "<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>")},
      {"fuzz.gltf", test::gltfBox(R"("matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],)")},
      {"fuzz.glb", test::glbBox()},
      {"quantized.gltf", test::packGltf(octahedron(), {.component = 5122, .stride = 8}).gltf()},
      {"compressed.glb",
       test::packGltf(octahedron(),
                      {.component = 5121, .isNormalized = true, .stride = 4, .isCompressed = true})
           .glb()},
      {"exponential.glb", test::packGltf(octahedron(), {.isCompressed = true, .isExponential = true}).glb()},
      {"fuzz.fbx", test::fbxBox("P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",10\n")},
      {"fuzz.off", test::offBox()}};
}

class MeshFuzz : public testing::Test {
 protected:
  /// A mesh that is sound, or one line. Returns whether it could be read.
  bool tryOne(const Seed& seed, std::uint64_t number) {
    const std::filesystem::path path = folder_ / seed.name;
    test::writeText(path, Mutator(number).mutate(seed.bytes));
    MeshOptions options;
    options.maxSeconds = 1;
    const auto file = readMesh(path, options);
    if (!file) {
      const std::string& message = file.error().message;
      EXPECT_EQ(message.find(path.string()), message.rfind("cannot read ", 0) == 0 ? 12U : 0U) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_LT(message.size(), path.string().size() + 300);
      crashes_ += message.find("crashed") != std::string::npos ? 1 : 0;
      return false;
    }
    const SurfaceMesh& mesh = file->mesh;
    EXPECT_FALSE(mesh.triangles.empty());
    EXPECT_TRUE(std::all_of(mesh.vertices.begin(), mesh.vertices.end(), isFinite));
    for (const auto& t : mesh.triangles)
      EXPECT_LT(*std::max_element(t.begin(), t.end()), mesh.vertices.size());
    return true;
  }

  test::TemporaryFolder folder_;
  int crashes_ = 0;
};

TEST_F(MeshFuzz, DamagedFilesAreReadOrRefused) {
  for (const Seed& seed : seeds()) {
    int readable = 0;
    for (std::uint64_t i = 0; i < 60 && !HasFailure(); ++i) {
      SCOPED_TRACE(std::string(seed.name) + " " + std::to_string(i));
      readable += tryOne(seed, i) ? 1 : 0;
    }
    // Both outcomes must occur, or the fuzzer tests nothing.
    EXPECT_GT(readable, 0) << seed.name;
    EXPECT_LT(readable, 60) << seed.name;
  }
}

/// For as long as SCATTER_FUZZ_SECONDS says.
TEST_F(MeshFuzz, Long) {
  const char* seconds = std::getenv("SCATTER_FUZZ_SECONDS");
  if (seconds == nullptr) GTEST_SKIP() << "SCATTER_FUZZ_SECONDS is not set";
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(std::atoi(seconds));
  const std::vector<Seed> all = seeds();
  std::uint64_t count = 0;
  int readable = 0;
  for (; Clock::now() < end && !HasFailure(); ++count) {
    const Seed& seed = all[count % all.size()];
    SCOPED_TRACE(std::string(seed.name) + " " + std::to_string(count));
    readable += tryOne(seed, 1000 + count) ? 1 : 0;
  }
  std::cout << count << " inputs, " << readable << " readable, " << crashes_ << " crashes contained\n";
}

}  // namespace
}  // namespace scatter
