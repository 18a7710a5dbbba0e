// Damaged scenes are read or refused, in one line; nothing else happens. $SCATTER_FUZZ_SECONDS makes it go on
// for that long, with other damage.

#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "io/collada/samples.h"
#include "io/collada/xml_mutator.h"
#include "io/documents.h"
#include "io/gltf/comparison.h"
#include "io/gltf/random.h"
#include "io/temporary_folder.h"
#include "trials.h"

namespace scatter {
namespace {

void expectOneLine(const std::string& line) {
  EXPECT_TRUE(line.rfind("fuzz.dae:", 0) == 0 || line.rfind("and ", 0) == 0) << line;
  EXPECT_LT(line.size(), 500U) << line;
  EXPECT_TRUE(std::none_of(line.begin(), line.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20;
  })) << line;
}

void clearNames(PhysicsDocument& document) {
  const auto clear = [](auto& items) {
    for (auto& item : items) item.name.clear();
  };
  document.name.clear();
  clear(document.materials);
  clear(document.models);
  clear(document.bodies);
  clear(document.joints);
  clear(document.fields);
  for (DocumentModel& model : document.models) {
    model.levels = nullptr;
  }
}

/// What was read can be written, and reads back as the same.
void expectSound(const PhysicsDocument& document, const test::TemporaryFolder& folder) {
  const auto written = writeColladaDocument(document, folder / "fuzz.dae");
  ASSERT_TRUE(written.has_value()) << written.error().message;
  auto read = readColladaDocument(folder / "fuzz.dae");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  PhysicsDocument expected = document;
  clearNames(expected);
  clearNames(*read);
  EXPECT_EQ(test::findDifference(expected, *read), "");
}

/// Reads damaged copies of files, and counts what comes of it.
class Fuzzer {
 public:
  int inputs = 0;
  int readable = 0;

  void run(const std::string& text, std::uint64_t seed) {
    test::XmlMutator mutator(seed);
    const std::string damaged = mutator.mutate(text);
    SCOPED_TRACE("seed " + std::to_string(seed));
    ++inputs;
    const auto document = parseColladaDocument(damaged, "fuzz.dae");
    if (!document) {
      expectOneLine(document.error().message);
      return;
    }
    std::for_each(document->warnings.begin(), document->warnings.end(), expectOneLine);
    ++readable;
    // Writing waits for the disk.
    if (readable % 16 == 0) {
      expectSound(*document, folder_);
    }
  }

 private:
  test::TemporaryFolder folder_;
};

std::vector<std::string> seeds() {
  std::vector<std::string> texts{test::SceneFile{}.text(), test::richDocument().text()};
  for (const test::Sample& sample : test::exporterSamples()) {
    texts.push_back(sample.text);
  }
  test::RandomDocuments documents(11);
  const test::TemporaryFolder folder;
  while (texts.size() < 14) {
    const PhysicsDocument document = documents.next();
    if (writeColladaDocument(document, folder / "seed.dae")) {
      texts.push_back(readFile(folder / "seed.dae").value());
    }
  }
  return texts;
}

TEST(ColladaDocumentFuzz, DamagedScenesAreReadOrRefused) {
  const std::vector<std::string> texts = seeds();
  Fuzzer fuzzer;
  constexpr std::uint64_t kCases = test::trials(4000);
  for (std::uint64_t seed = 0; seed < kCases && !HasFailure(); ++seed) {
    fuzzer.run(texts[seed % texts.size()], seed);
  }
  // Both outcomes must occur, or the fuzzer tests nothing.
  EXPECT_GT(fuzzer.readable, test::trials(400));
  EXPECT_LT(fuzzer.readable, test::trials(3600));
}

TEST(ColladaDocumentFuzz, GoesOnForAsLongAsAsked) {
  const char* seconds = std::getenv("SCATTER_FUZZ_SECONDS");
  if (seconds == nullptr) {
    GTEST_SKIP() << "SCATTER_FUZZ_SECONDS is not set";
  }
  std::vector<std::string> texts = seeds();
  texts.push_back(readFile(SCATTER_TEST_MODEL_DIR "/fighter.dae").value());
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(std::atoi(seconds));
  Fuzzer fuzzer;
  for (std::uint64_t seed = 1000000; std::chrono::steady_clock::now() < end && !HasFailure(); ++seed) {
    fuzzer.run(texts[seed % texts.size()], seed);
  }
  std::cout << fuzzer.inputs << " inputs, " << fuzzer.readable << " of them readable\n";
}

}  // namespace
}  // namespace scatter
