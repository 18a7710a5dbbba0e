#include <scatter/io/file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "io/atomic_file.h"
#include "io/growing_file.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

std::size_t entries(const TemporaryFolder& folder) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder.path())) {
    ++count;
  }
  return count;
}

/// While it lives, no file can grow beyond `bytes`: a write then fails as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(File, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  const std::string content("a\0b\r\n\xFF", 6);
  ASSERT_TRUE(writeFile(folder / "file", content));
  EXPECT_EQ(readFile(folder / "file").value(), content);
  EXPECT_EQ(entries(folder), 1U);
}

TEST(File, ReplacesAnOlderFile) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFile(folder / "file", "a longer content"));
  ASSERT_TRUE(writeFile(folder / "file", "short"));
  EXPECT_EQ(readFile(folder / "file").value(), "short");
  EXPECT_EQ(entries(folder), 1U);
}

TEST(File, FollowsASymbolicLink) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFile(folder / "file", "old"));
  fs::create_symlink("file", folder / "link");
  ASSERT_TRUE(writeFile(folder / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(readFile(folder / "file").value(), "new");
}

TEST(File, LeavesNothingBehindWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const std::string large(100000, 'x');
  {
    const SmallDisk disk(4096);
    const auto written = writeFile(folder / "file", large);
    ASSERT_FALSE(written.has_value());
    EXPECT_THAT(written.error().message,
                testing::StartsWith("cannot write " + (folder / "file").string() + ": "));
  }
  EXPECT_TRUE(folder.isEmpty());
}

TEST(File, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFile(folder / "file", "old"));
  {
    const SmallDisk disk(4096);
    EXPECT_FALSE(writeFile(folder / "file", std::string(100000, 'x')).has_value());
  }
  EXPECT_EQ(readFile(folder / "file").value(), "old");
  EXPECT_EQ(entries(folder), 1U);
}

TEST(File, ReportsAFullDeviceAndLeavesItADevice) {
  struct stat status {};
  if (::stat("/dev/full", &status) != 0 || !S_ISCHR(status.st_mode)) {
    GTEST_SKIP() << "there is no /dev/full here";
  }
  const auto written = writeFile("/dev/full", "content");
  ASSERT_FALSE(written.has_value());
  EXPECT_THAT(written.error().message, testing::StartsWith("cannot write /dev/full: "));
  ASSERT_EQ(::stat("/dev/full", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
}

/// A message about a pipe that stands where a file was to be, and still stands there.
template <class Kind>
std::string refusalOfAPipe() {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  EXPECT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto made = Kind::create(pipe);
  EXPECT_FALSE(made.has_value());
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(entries(folder), 1U);
  return made ? "" : made.error().message;
}

// What is renamed would take its place: a program with the rights to do so would replace /dev/null.
TEST(File, NeverTakesThePlaceOfADeviceOrAPipe) {
  EXPECT_THAT(refusalOfAPipe<GrowingFile>(), testing::HasSubstr("is a device or a pipe"));
  EXPECT_THAT(refusalOfAPipe<AtomicFile>(), testing::HasSubstr("is a device or a pipe"));
}

TEST(File, GrowsBehindASymbolicLink) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFile(folder / "file", "old"));
  fs::create_symlink("file", folder / "link");
  const auto growing = GrowingFile::create(folder / "link");
  ASSERT_TRUE(growing);
  ASSERT_TRUE((*growing)->add("new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(readFile(folder / "file").value(), "new");
}

TEST(File, ReportsAPlaceThatCannotBeWritten) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFile(folder / "file", ""));
  EXPECT_FALSE(writeFile(folder / "none/file", "x").has_value());
  EXPECT_FALSE(writeFile(folder / "file/file", "x").has_value());
  EXPECT_FALSE(writeFile(folder.path(), "x").has_value());
  EXPECT_FALSE(writeFile("", "x").has_value());
  EXPECT_EQ(entries(folder), 1U);
}

}  // namespace
}  // namespace scatter
