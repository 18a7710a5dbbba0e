#include <scatter/lab/output_folder.h>

#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace scatter {
namespace {

namespace fs = std::filesystem;
using test::contentOf;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

void put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

TEST(OutputFolder, PreparingLeavesNothingBehind) {
  TemporaryFolder folder;
  EXPECT_TRUE(prepareOutputFolder(folder.path() / "a" / "b"));
  EXPECT_TRUE(prepareOutputFolder(folder.path()));
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(OutputFolder, AFileInTheWayIsOneClearLine) {
  TemporaryFolder folder;
  put(folder.path() / "plain", "x");
  for (const fs::path& bad :
       {folder.path() / "plain", folder.path() / "plain" / "below", fs::path("/proc/none")}) {
    const auto prepared = prepareOutputFolder(bad);
    ASSERT_FALSE(prepared) << bad;
    EXPECT_THAT(prepared.error().message, HasSubstr(bad.string()));
    EXPECT_THAT(prepared.error().message, HasSubstr("choose another folder"));
    EXPECT_THAT(prepared.error().message, Not(HasSubstr("\n")));
  }
  EXPECT_FALSE(prepareOutputFolder(""));
}

TEST(StagedFolder, AppearsWholeAtCommit) {
  TemporaryFolder folder;
  const fs::path target = folder.path() / "deep" / "out";
  auto staged = StagedFolder::create(target);
  ASSERT_TRUE(staged);
  put(staged->path() / "sub" / "file", "new");
  EXPECT_FALSE(fs::exists(target));
  ASSERT_TRUE(staged->commit());
  EXPECT_EQ(contentOf(target / "sub" / "file"), "new");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(StagedFolder, KeepsOtherFilesOfAFolderThatExists) {
  TemporaryFolder folder;
  put(folder.path() / "mine", "keep");
  put(folder.path() / "sub" / "mine", "keep");
  put(folder.path() / "sub" / "file", "old");
  auto staged = StagedFolder::create(folder.path());
  ASSERT_TRUE(staged);
  put(staged->path() / "sub" / "file", "new");
  ASSERT_TRUE(staged->commit());
  EXPECT_EQ(contentOf(folder.path() / "mine"), "keep");
  EXPECT_EQ(contentOf(folder.path() / "sub" / "mine"), "keep");
  EXPECT_EQ(contentOf(folder.path() / "sub" / "file"), "new");
  EXPECT_EQ(folder.entries(), 2U);
}

TEST(StagedFolder, WhatIsNotCommittedIsRemoved) {
  TemporaryFolder folder;
  {
    auto staged = StagedFolder::create(folder.path() / "out");
    ASSERT_TRUE(staged);
    put(staged->path() / "file", "x");
  }
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(StagedFolder, ATrailingSlashIsTheSameFolder) {
  TemporaryFolder folder;
  auto staged = StagedFolder::create(folder.path().string() + "/out/");
  ASSERT_TRUE(staged);
  put(staged->path() / "file", "x");
  ASSERT_TRUE(staged->commit());
  EXPECT_EQ(contentOf(folder.path() / "out" / "file"), "x");
}

}  // namespace
}  // namespace scatter
