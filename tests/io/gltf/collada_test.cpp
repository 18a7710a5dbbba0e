#include <gtest/gtest.h>
#include <scatter/io/collada.h>
#include <scatter/io/gltf.h>

#include <string>

#include "io/gltf/comparison.h"
#include "io/gltf/random.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

/// What is read after writing.
template <class Write, class Read>
PhysicsDocument pass(const PhysicsDocument& document, const Write& write, const Read& read,
                     const std::filesystem::path& path) {
  const auto written = write(document, path);
  EXPECT_TRUE(written.has_value()) << written.error().message;
  auto result = read(path);
  EXPECT_TRUE(result.has_value()) << result.error().message;
  return result.value_or(PhysicsDocument{});
}

TEST(GltfAndCollada, HoldTheSameDocuments) {
  const test::TemporaryFolder folder;
  test::RandomDocuments documents(23);
  for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("document " + std::to_string(i));
    PhysicsDocument document = documents.next();
    // COLLADA has no file without a model.
    while (document.models.empty()) {
      document = documents.next();
    }
    // COLLADA first: it keeps fewer characters of names.
    const PhysicsDocument start =
        pass(document, writeColladaDocument, readColladaDocument, folder / "start.dae");
    const PhysicsDocument binary = pass(start, writeGltfDocument, readGltfDocument, folder / "there.glb");
    EXPECT_EQ(test::findDifference(start, binary), "");
    EXPECT_TRUE(binary.warnings.empty()) << binary.warnings.front();
    const PhysicsDocument text = pass(binary, writeGltfDocument, readGltfDocument, folder / "there.gltf");
    EXPECT_EQ(test::findDifference(start, text), "");
    const PhysicsDocument back = pass(text, writeColladaDocument, readColladaDocument, folder / "back.dae");
    EXPECT_EQ(test::findDifference(start, back), "");
  }
}

}  // namespace
}  // namespace scatter
