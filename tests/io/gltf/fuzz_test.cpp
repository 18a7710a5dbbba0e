#include <gtest/gtest.h>
#include <scatter/io/file.h>
#include <scatter/io/gltf.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/comparison.h"
#include "io/gltf/random.h"
#include "io/gltf/text.h"
#include "io/temporary_folder.h"
#include "trials.h"

namespace scatter {
namespace {

using nlohmann::json;

/// Damages glTF in the ways that editors, exporters and disks do. The same seed, the same damage.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  /// The JSON and the binary chunk, which may be empty.
  void mutate(std::string& text, std::string& binary) {
    for (std::size_t count = 1 + below(3); count > 0; --count) {
      mutateOnce(text, binary);
    }
  }

  std::size_t below(std::size_t limit) {
    return limit == 0 ? 0 : static_cast<std::size_t>(random_() % limit);
  }

  static std::string flipByte(std::string bytes, std::uint64_t random) {
    if (!bytes.empty()) {
      bytes[static_cast<std::size_t>(random >> 8U) % bytes.size()] = static_cast<char>(random);
    }
    return bytes;
  }

  std::uint64_t next() { return random_(); }

 private:
  void mutateOnce(std::string& text, std::string& binary) {
    switch (below(10)) {
      case 0:
        text = flipByte(std::move(text), random_());
        break;
      case 1:
        binary = flipByte(std::move(binary), random_());
        break;
      case 2:
        putFloat(binary);
        break;
      case 3:
        text.resize(text.size() - std::min(text.size(), below(40)));
        break;
      default:
        changeTree(text);
    }
  }

  void putFloat(std::string& binary) {
    constexpr std::array<float, 6> kFloats{INFINITY, NAN, -INFINITY, 3e38F, 1e-45F, -0.0F};
    if (binary.size() >= sizeof(float)) {
      std::memcpy(binary.data() + below(binary.size() / sizeof(float)) * sizeof(float), &kFloats[below(6)],
                  sizeof(float));
    }
  }

  void changeTree(std::string& text) {
    json root = json::parse(text, nullptr, false);
    std::vector<json*> values;
    collect(root, values);
    if (root.is_discarded() || values.size() < 2) {
      return;
    }
    json& chosen = *values[1 + below(values.size() - 1)];
    switch (below(4)) {
      case 0:
        chosen = *values[below(values.size())];
        break;
      case 1:
        removeFrom(chosen);
        break;
      case 2:
        if (chosen.is_array() && !chosen.empty()) {
          chosen.push_back(json(chosen[below(chosen.size())]));
          break;
        }
        [[fallthrough]];
      default:
        chosen = oddValue();
    }
    text = root.dump(-1, ' ', false, json::error_handler_t::replace);
  }

  static void collect(json& value, std::vector<json*>& values) {
    values.push_back(&value);
    if (value.is_structured()) {
      for (json& child : value) {
        collect(child, values);
      }
    }
  }

  void removeFrom(json& value) {
    if (value.is_array() && !value.empty()) {
      value.erase(below(value.size()));
    } else if (value.is_object() && !value.empty()) {
      value.erase(std::next(value.begin(), static_cast<std::ptrdiff_t>(below(value.size()))));
    }
  }

  json oddValue() {
    static const std::array<json, 22> kOdd{0,
                                           1,
                                           -1,
                                           2,
                                           3,
                                           0.5,
                                           -0.0,
                                           1e-9,
                                           1e9,
                                           1e38,
                                           1e300,
                                           -1e5,
                                           65535,
                                           99999,
                                           5125,
                                           5126,
                                           "",
                                           "box",
                                           true,
                                           json::array(),
                                           json::object(),
                                           18446744073709551615U};
    return kOdd[below(kOdd.size())];
  }

  std::mt19937_64 random_;
};

bool isOneLine(const std::string& message) {
  return message.rfind("fuzz.glb: ", 0) == 0 && message.size() < 600 &&
         std::none_of(message.begin(), message.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

/// Files of all kinds to begin with: what this library writes, and what others may write.
std::vector<std::pair<std::string, std::string>> seeds() {
  const test::TemporaryFolder folder;
  std::vector<std::pair<std::string, std::string>> result;
  test::RandomDocuments documents(11);
  while (result.size() < 24) {
    if (!writeGltfDocument(documents.next(), folder / "seed.glb")) {
      continue;
    }
    const std::string bytes = readFile(folder / "seed.glb").value();
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, sizeof length);
    const std::size_t binary = std::min<std::size_t>(bytes.size(), 20 + length + 8);
    result.emplace_back(bytes.substr(20, length), bytes.substr(binary));
  }
  test::GltfText other;
  other.shapes =
      R"({"type":"box"},{"type":"sphere"},{"type":"capsule","capsule":{"radiusTop":0.1}},{"type":"cylinder"},)"
      R"({"type":"plane","plane":{"sizeX":3,"sizeZ":2,"doubleSided":true}},{"type":"plane"})";
  other.materials = R"({"staticFriction":0.1,"frictionCombine":"maximum"})";
  other.filters = R"({"collisionSystems":["a"]})";
  other.joints =
      R"({"limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[0],"min":-1,"stiffness":3}],)"
      R"("drives":[{"type":"linear","mode":"force","axis":1}]})";
  other.nodes =
      R"({"scale":[2,1,1],"children":[1,4,5]},)" +
      test::physicsNode(R"("motion":{"mass":3,"inertiaDiagonal":[1,2,3],"linearVelocity":[1,2,3]},)"
                        R"("collider":{"geometry":{"shape":2},"physicsMaterial":0,"collisionFilter":0})",
                        R"("mesh":0,"rotation":[0.5,0.5,0.5,0.5],"children":[2,3])") +
      "," +
      test::physicsNode(R"("collider":{"geometry":{"node":6,"convexHull":true}})", R"("scale":[1,-1,2])") +
      "," + test::physicsNode(R"("joint":{"connectedNode":4,"joint":0})") + "," +
      test::physicsNode(R"("collider":{"geometry":{"node":6}},"trigger":{"geometry":{"shape":0}})") + "," +
      test::physicsNode(R"("collider":{"geometry":{"shape":4}})",
                        R"("matrix":[0,2,0,0,-3,0,0,0,0,0,4,0,5,6,7,1])") +
      R"(,{"mesh":0,"children":[7]},{"mesh":0,"translation":[0,0,5]})";
  other.more =
      R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1},{"attributes":{"POSITION":2},"mode":5}]}])"
      R"(,"buffers":[{"byteLength":76}],"bufferViews":[{"buffer":0,"byteLength":64,"byteStride":16},)"
      R"({"buffer":0,"byteOffset":64,"byteLength":12}],"accessors":[)"
      R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4},)"
      R"({"bufferView":1,"componentType":5123,"type":"SCALAR","count":6},)"
      R"({"bufferView":0,"componentType":5120,"normalized":true,"type":"VEC3","count":4,"sparse":{"count":2,)"
      R"("indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}}}])";
  const std::vector<float> points{0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9, 0, 0, 1, 9};
  const std::vector<std::uint16_t> corners{0, 2, 1, 0, 1, 3};
  for (int i = 0; i < 8; ++i) {
    result.emplace_back(other.text(), test::bytesOf(points) + test::bytesOf(corners));
  }
  return result;
}

class GltfFuzz : public testing::Test {
 protected:
  /// Whether the file could be read. What was read must be sound: it can be written, and read again.
  bool tryBytes(const std::string& bytes) {
    const auto document = parseGltfDocument(bytes, "fuzz.glb");
    if (!document) {
      EXPECT_TRUE(isOneLine(document.error().message)) << document.error().message;
      return false;
    }
    for (const std::string& warning : document->warnings) {
      EXPECT_TRUE(isOneLine(warning)) << warning;
    }
    const auto written = writeGltfDocument(*document, folder_ / "again.glb");
    EXPECT_TRUE(written.has_value()) << written.error().message;
    const auto again = readGltfDocument(folder_ / "again.glb");
    EXPECT_TRUE(again.has_value()) << again.error().message;
    EXPECT_EQ(test::findDifference(*document, again.value_or(PhysicsDocument{})), "");
    return true;
  }

  test::TemporaryFolder folder_;
};

/// SCATTER_FUZZ_SECONDS makes it run longer.
double secondsToRun() {
  const char* text = std::getenv("SCATTER_FUZZ_SECONDS");
  return text != nullptr ? std::atof(text) : 0.0;
}

TEST_F(GltfFuzz, DamagedFilesAreReadOrRefused) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const auto files = seeds();
  constexpr std::uint64_t kCases = test::trials(3000);
  std::uint64_t readable = 0;
  std::uint64_t cases = 0;
  for (; (cases < kCases || seconds() < secondsToRun()) && !HasFailure(); ++cases) {
    SCOPED_TRACE("case " + std::to_string(cases));
    Mutator mutator(cases);
    auto [text, binary] = files[cases % files.size()];
    mutator.mutate(text, binary);
    std::string bytes = test::glb(text, binary);
    if (mutator.below(16) == 0) {
      bytes = Mutator::flipByte(bytes.substr(0, 64), mutator.next()) + bytes.substr(64);
    }
    readable += tryBytes(bytes) ? 1 : 0;
    if (HasFailure()) {
      static_cast<void>(writeFile("gltf_fuzz_failure.glb", bytes));
    }
  }
  std::printf("%llu damaged files, %llu of them readable\n", static_cast<unsigned long long>(cases),
              static_cast<unsigned long long>(readable));
  // Both outcomes must occur, or the fuzzer tests nothing.
  EXPECT_GT(readable, cases / 20);
  EXPECT_LT(readable, cases - cases / 20);
}

}  // namespace
}  // namespace scatter
