#include <gtest/gtest.h>
#include <scatter/io/file.h>
#include <scatter/io/gltf.h>

#include <string>

#include "io/gltf/comparison.h"
#include "io/gltf/random.h"
#include "io/temporary_folder.h"
#include "trials.h"

namespace scatter {
namespace {

class GltfRoundTrip : public testing::TestWithParam<const char*> {
 protected:
  /// What is read of a file that was written of the document.
  [[nodiscard]] PhysicsDocument writeAndRead(const PhysicsDocument& document) const {
    const auto written = writeGltfDocument(document, folder_ / GetParam());
    EXPECT_TRUE(written.has_value()) << written.error().message;
    auto read = readGltfDocument(folder_ / GetParam());
    EXPECT_TRUE(read.has_value()) << read.error().message;
    return read.value_or(PhysicsDocument{});
  }

  test::TemporaryFolder folder_;
};

TEST_P(GltfRoundTrip, RandomDocumentsComeBackTheSame) {
  test::RandomDocuments documents(7, /*hasFilters=*/true);
  for (int i = 0; i < test::trials(100) && !HasFailure(); ++i) {
    SCOPED_TRACE("document " + std::to_string(i));
    const PhysicsDocument document = documents.next();
    const PhysicsDocument read = writeAndRead(document);
    EXPECT_EQ(test::findDifference(document, read), "");
    EXPECT_TRUE(read.warnings.empty()) << read.warnings.front();
    const auto first = readFile(folder_ / GetParam());
    static_cast<void>(writeAndRead(read));
    EXPECT_EQ(first.value(), readFile(folder_ / GetParam()).value());
  }
}

TEST_P(GltfRoundTrip, AnEmptyDocumentComesBack) {
  const PhysicsDocument read = writeAndRead({});
  EXPECT_EQ(test::findDifference(PhysicsDocument{}, read), "");
}

INSTANTIATE_TEST_SUITE_P(Formats, GltfRoundTrip, testing::Values("scene.gltf", "scene.glb"),
                         [](const auto& test) { return std::string(test.param).substr(6); });

}  // namespace
}  // namespace scatter
