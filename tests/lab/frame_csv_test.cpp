#include <scatter/lab/frame_csv.h>

#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <charconv>
#include <clocale>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace scatter {
namespace {

using test::contentOf;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

Result<std::vector<double>> columnOf(const std::filesystem::path& file, std::string_view name) {
  return FrameFile::read(file).and_then([name](const FrameFile& frames) { return frames.column(name); });
}

// One real, one integer and one hash channel.
class FrameCsvTest : public testing::Test {
 protected:
  void add(double value, double count, std::uint64_t hashBits) {
    data.beginFrame();
    data.set(real, value);
    data.set(integer, count);
    data.setHash(hash, hashBits);
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "frames.csv";
  FrameData data{4};
  ChannelId real = data.addChannel({"time_s", "s", ChannelKind::kReal});
  ChannelId integer = data.addChannel({"objects", "", ChannelKind::kInteger});
  ChannelId hash = data.addChannel({"state_hash", "", ChannelKind::kHash});
};

TEST_F(FrameCsvTest, WritesOneHeaderLineAndOneRowAFrame) {
  auto csv = FrameCsv::create(file, data);
  ASSERT_TRUE(csv);
  EXPECT_FALSE(std::filesystem::exists(file));
  add(0.1, 1, 0xABC);
  ASSERT_TRUE(csv->write(data));
  EXPECT_EQ(contentOf(file), "time_s,objects,state_hash\n0.1,1,0000000000000abc\n");
  add(-2.0, 3000000, 0xFEDCBA9876543210ULL);
  ASSERT_TRUE(csv->write(data));
  ASSERT_TRUE(csv->finish());
  EXPECT_EQ(contentOf(file),
            "time_s,objects,state_hash\n0.1,1,0000000000000abc\n-2,3000000,fedcba9876543210\n");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST_F(FrameCsvTest, EveryNumberReadsBackToTheSameBits) {
  std::mt19937_64 random(11);
  std::vector<double> values{0.0, -0.0, 1.0 / 3.0, 5e-324, std::numeric_limits<double>::max()};
  while (values.size() < 3000) {
    const double value = std::bit_cast<double>(random());
    if (value - value == 0.0) {
      values.push_back(value);
    }
  }
  auto csv = FrameCsv::create(file, data);
  ASSERT_TRUE(csv);
  for (const double value : values) {
    add(value, 0, 0);
    ASSERT_TRUE(csv->write(data));
  }
  ASSERT_TRUE(csv->finish());
  std::istringstream lines(contentOf(file));
  std::string line;
  std::getline(lines, line);
  for (const double value : values) {
    ASSERT_TRUE(std::getline(lines, line));
    double read = 0.0;
    std::from_chars(line.data(), line.data() + line.find(','), read);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(value)) << line;
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST_F(FrameCsvTest, FramesWithoutASampleHaveAnEmptyCell) {
  const ChannelId sampled =
      data.addChannel({.name = "gap", .unit = "m", .kind = ChannelKind::kReal, .sampled = true});
  const ChannelId count =
      data.addChannel({.name = "pairs", .unit = "", .kind = ChannelKind::kInteger, .sampled = true});
  auto csv = FrameCsv::create(file, data);
  ASSERT_TRUE(csv);
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), 0.5}) {
    add(value, 1, 0);
    data.set(sampled, value);
    data.set(count, value < 1.0 ? 3.0 : value);
    ASSERT_TRUE(csv->write(data));
  }
  ASSERT_TRUE(csv->finish());
  EXPECT_EQ(contentOf(file),
            "time_s,objects,state_hash,gap,pairs\nnan,1,0000000000000000,,\n0.5,1,0000000000000000,0.5,3\n");
}

TEST_F(FrameCsvTest, AColumnReadsBackToTheSameBits) {
  auto csv = FrameCsv::create(file, data);
  ASSERT_TRUE(csv);
  const std::vector<double> values{1.0 / 3.0, 5e-324, 0.0, 12345678.901234567};
  for (const double value : values) {
    add(value, 7, 1);
    ASSERT_TRUE(csv->write(data));
  }
  ASSERT_TRUE(csv->finish());
  const auto read = columnOf(file, "time_s");
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, values);
  EXPECT_EQ(*columnOf(file, "objects"), std::vector<double>(4, 7.0));
}

TEST_F(FrameCsvTest, AColumnThatCannotBeReadIsOneClearLine) {
  const auto expectRefused = [&](const std::string& content, const char* words) {
    std::ofstream(file, std::ios::trunc) << content;
    const auto read = columnOf(file, "budget_units");
    ASSERT_FALSE(read) << content;
    EXPECT_THAT(read.error().message, HasSubstr(words));
    EXPECT_THAT(read.error().message, HasSubstr(file.string()));
    EXPECT_THAT(read.error().message, Not(HasSubstr("\n")));
  };
  expectRefused("", "no column budget_units");
  expectRefused("frame,budget_ms\n1,2\n", "no column budget_units");
  expectRefused("frame,budget_units\n", "no frames");
  expectRefused("frame,budget_units\n1,2\n2\n", "line 3");
  expectRefused("frame,budget_units\n1,2x\n", "line 2");
  expectRefused("frame,budget_units\n1,nan\n", "line 2");
  expectRefused("frame,budget_units\n1,\n", "line 2");
  expectRefused("frame,budget_units\n\n1,3\n", "line 2");
  std::filesystem::remove(file);
  EXPECT_FALSE(columnOf(file, "budget_units"));
  EXPECT_FALSE(columnOf(folder.path(), "budget_units"));
}

TEST_F(FrameCsvTest, AFileFromAnotherSystemIsReadToo) {
  std::ofstream(file) << "budget_units,frame\r\n4.5,1\r\n5,2\r\n";
  EXPECT_EQ(*columnOf(file, "budget_units"), (std::vector<double>{4.5, 5.0}));
  EXPECT_EQ(*columnOf(file, "frame"), (std::vector<double>{1.0, 2.0}));
  EXPECT_TRUE(FrameFile::read(file)->has("frame"));
  EXPECT_FALSE(FrameFile::read(file)->has("settled_units"));
  EXPECT_FALSE(FrameFile::read(folder.path()));
}

TEST_F(FrameCsvTest, AFileThatIsReadWhileItGrowsHasColumnsOfOneLength) {
  auto csv = FrameCsv::create(file, data);
  ASSERT_TRUE(csv);
  add(1, 1, 1);
  ASSERT_TRUE(csv->write(data));
  const auto frames = FrameFile::read(file);
  ASSERT_TRUE(frames);
  EXPECT_EQ(frames->column("time_s")->size(), 1U);
  add(2, 1, 1);
  ASSERT_TRUE(csv->write(data));
  EXPECT_EQ(frames->column("objects")->size(), 1U);
  EXPECT_EQ(columnOf(file, "objects")->size(), 2U);
}

TEST_F(FrameCsvTest, AWholeTableGivesTheSameFile) {
  FrameTable table(data.channels());
  auto csv = FrameCsv::create(file, data);
  ASSERT_TRUE(csv);
  for (int frame = 0; frame < 5; ++frame) {
    add(frame / 7.0, frame, static_cast<std::uint64_t>(frame) << 60U);
    ASSERT_TRUE(csv->write(data));
    table.append(data);
  }
  ASSERT_TRUE(csv->finish());
  ASSERT_TRUE(writeFrameCsv(folder.path() / "table.csv", table));
  EXPECT_EQ(contentOf(folder.path() / "table.csv"), contentOf(file));
}

TEST_F(FrameCsvTest, WhatIsNotFinishedKeepsItsFrames) {
  for (const bool hasFrame : {false, true}) {
    auto csv = FrameCsv::create(file, data);
    ASSERT_TRUE(csv);
    EXPECT_EQ(folder.entries(), 1U);
    add(1, 1, 1);
    if (hasFrame) {
      ASSERT_TRUE(csv->write(data));
    }
    csv = FrameCsv::create(folder.path() / "other.csv", data);
    EXPECT_EQ(std::filesystem::exists(file), hasFrame);
  }
  EXPECT_EQ(columnOf(file, "objects")->size(), 1U);
}

TEST_F(FrameCsvTest, AFolderThatIsAFileIsOneClearLine) {
  std::ofstream(folder.path() / "plain") << "x";
  const auto csv = FrameCsv::create(folder.path() / "plain" / "frames.csv", data);
  ASSERT_FALSE(csv);
  EXPECT_THAT(csv.error().message, HasSubstr("cannot write"));
  EXPECT_THAT(csv.error().message, HasSubstr("frames.csv"));
  EXPECT_THAT(csv.error().message, Not(HasSubstr("\n")));
}

// Every write past this size fails as on a full disk, also for root.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(FrameCsvTest, AFullDiskIsReportedAndTheWholeFramesAreKept) {
  std::ofstream(file) << "an earlier run";
  auto csv = FrameCsv::create(file, data);
  ASSERT_TRUE(csv);
  EXPECT_EQ(contentOf(file), "an earlier run");
  Result<void> written;
  std::size_t frames = 0;
  {
    const FileSizeLimit limit(100000);
    for (; frames < 100000 && written; ++frames) {
      add(1.0 / 3.0, 1, 1);
      written = csv->write(data);
    }
  }
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::kDiskFull);
  EXPECT_THAT(written.error().message, HasSubstr(file.string()));
  EXPECT_THAT(written.error().message, Not(HasSubstr("\n")));
  EXPECT_EQ(folder.entries(), 1U);
  EXPECT_EQ(contentOf(file).back(), '\n');
  EXPECT_EQ(columnOf(file, "objects")->size(), frames - 1);
}

TEST_F(FrameCsvTest, AFullDiskAtTheFirstFrameChangesNothing) {
  auto csv = FrameCsv::create(file, data);
  ASSERT_TRUE(csv);
  add(1, 1, 1);
  {
    const FileSizeLimit limit(10);
    EXPECT_FALSE(csv->write(data));
  }
  csv = FrameCsv::create(file, data);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(FrameCsvTest, AWholeFileIsReadBackToTheSameBits) {
  auto csv = FrameCsv::create(file, data);
  ASSERT_TRUE(csv);
  FrameTable table(data.channels());
  for (const double value : {0.1, 1e-300, 12345678.9}) {
    add(value, 5, 0xfedcba9876543210U);
    ASSERT_TRUE(csv->write(data));
    table.append(data);
  }
  ASSERT_TRUE(csv->finish());
  const auto read = readFrameTable(file, data.channels());
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->frames(), 3U);
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    EXPECT_EQ(read->columns()[i].values, table.columns()[i].values);
    EXPECT_EQ(read->columns()[i].hashes, table.columns()[i].hashes);
  }
}

}  // namespace
}  // namespace scatter
