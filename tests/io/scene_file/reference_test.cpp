#include <scatter/io/file.h>
#include <scatter/io/scene_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "io/scene_file/keys.h"

namespace scatter {
namespace {

TEST(SceneReference, TheManualHasTheTablesOfTheReader) {
  const auto manual = readFile(SCATTER_TEST_DOC_DIR "/scene-files.md");
  ASSERT_TRUE(manual) << manual.error().message;
  // A key that was added, left out or changed: put this text into the manual.
  EXPECT_NE(manual->find(sceneFileReference()), std::string::npos) << sceneFileReference();
}

TEST(SceneReference, EveryKeyIsExplainedOnce) {
  for (const io::SceneSection& section : io::sceneSections()) {
    std::set<std::string_view> names;
    for (const io::SceneKey& key : section.keys) {
      EXPECT_TRUE(names.insert(key.name).second) << section.name << "." << key.name;
      EXPECT_NE(key.type, "") << section.name << "." << key.name;
      EXPECT_NE(key.standard, "") << section.name << "." << key.name;
      EXPECT_EQ(key.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string_view::npos);
    }
  }
}

TEST(SceneReference, EveryNumberHasARange) {
  for (const io::SceneSection& section : io::sceneSections()) {
    for (const io::SceneKey& key : section.keys) {
      const bool numeric =
          key.type.find("number") != std::string_view::npos || key.type.find('[') != std::string_view::npos;
      EXPECT_EQ(numeric, key.hasRange()) << section.name << "." << key.name;
    }
  }
}

}  // namespace
}  // namespace scatter
