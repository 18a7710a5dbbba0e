#include <scatter/io/file.h>
#include <scatter/io/model_library.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "io/documents.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

using test::TemporaryFolder;

/// Sets $SCATTER_MODEL_PATH for a test.
class ModelPath {
 public:
  explicit ModelPath(const std::string& value) { ::setenv("SCATTER_MODEL_PATH", value.c_str(), 1); }
  ModelPath(const ModelPath&) = delete;
  ModelPath& operator=(const ModelPath&) = delete;
  ~ModelPath() { ::unsetenv("SCATTER_MODEL_PATH"); }
};

TEST(ModelLibrary, KnowsTheShips) {
  EXPECT_THAT(modelNames(), testing::IsSupersetOf({"fighter", "fighter_hulls", "hunter", "hunter_hulls"}));
  EXPECT_EQ(findModel("hunter").value(), std::filesystem::path(SCATTER_TEST_MODEL_DIR) / "hunter.dae");
}

TEST(ModelLibrary, LoadsAModelByName) {
  const auto model = loadModel("fighter");
  ASSERT_TRUE(model.has_value()) << model.error().message;
  EXPECT_EQ((*model)->name, "fighter");
}

TEST(ModelLibrary, ListsTheKnownNamesForAnUnknownOne) {
  const auto model = loadModel("huntr");
  ASSERT_FALSE(model.has_value());
  EXPECT_THAT(model.error().message,
              testing::AllOf(testing::StartsWith("unknown model \"huntr\"; known are "),
                             testing::HasSubstr("fighter, fighter_hulls, hunter, hunter_hulls")));
}

TEST(ModelLibrary, TakesNoPathsForNames) {
  EXPECT_FALSE(findModel("../models/hunter").has_value());
  EXPECT_FALSE(findModel("").has_value());
  EXPECT_FALSE(findModel("/etc/passwd").has_value());
}

TEST(ModelLibrary, PrefersTheFoldersOfTheEnvironmentInTheirOrder) {
  const TemporaryFolder first;
  const TemporaryFolder second;
  const std::string text = test::Document{}.text();
  ASSERT_TRUE(writeFile(first / "hunter.dae", text));
  ASSERT_TRUE(writeFile(second / "hunter.dae", text));
  ASSERT_TRUE(writeFile(second / "brick.dae", text));
  const ModelPath path("/nowhere::" + first.path().string() + ":" + second.path().string());
  EXPECT_EQ(findModel("hunter").value(), first / "hunter.dae");
  EXPECT_EQ(findModel("brick").value(), second / "brick.dae");
  EXPECT_EQ(loadModel("brick").value()->name, "brick");
}

TEST(ModelLibrary, NamesTheFileOfABrokenModel) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFile(folder / "broken.dae", "<COLLADA>"));
  const ModelPath path(folder.path().string());
  const auto model = loadModel("broken");
  ASSERT_FALSE(model.has_value());
  EXPECT_THAT(model.error().message, testing::StartsWith((folder / "broken.dae").string() + ":1: "));
}

}  // namespace
}  // namespace scatter
