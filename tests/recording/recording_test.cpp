#include <scatter/recording/recording.h>
#include <scatter/recording/recording_writer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/io/file.h>
#include <sys/resource.h>

#include <csignal>
#include <random>

#include "io/temporary_folder.h"
#include "recording/samples.h"

namespace scatter {
namespace {

using test::sampleFrames;
using test::TemporaryFolder;
using testing::HasSubstr;

constexpr std::uint32_t kBlock = 10;

void expectSame(const RecordedFrame& read, const FrameSample& written) {
  ASSERT_EQ(read.number, written.number);
  ASSERT_EQ(read.bodies.size(), written.bodies.size());
  for (std::size_t i = 0; i < read.bodies.size(); ++i) {
    const RecordedBody& body = read.bodies[i];
    const SampledBody& sample = written.bodies[i];
    EXPECT_EQ((*read.roster)[i], sample.body);
    EXPECT_EQ(body.level, sample.level);
    EXPECT_EQ(body.asleep, sample.asleep);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(body.pose.position[axis], sample.pose.position[axis], 0.51F * kRecordedMetres);
    }
    const Quat turn = glm::conjugate(body.pose.rotation) * glm::normalize(sample.pose.rotation);
    EXPECT_LT(2.0F * glm::length(Vec3(turn.x, turn.y, turn.z)), 2.2e-4F);
  }
  ASSERT_EQ(read.events.size(), written.events.size());
  for (std::size_t i = 0; i < read.events.size(); ++i) {
    EXPECT_EQ(read.events[i].kind, written.events[i].kind);
    EXPECT_EQ(read.events[i].scope, written.events[i].scope);
    EXPECT_EQ(read.events[i].body, written.events[i].body);
    EXPECT_EQ(read.events[i].other, written.events[i].other);
    EXPECT_EQ(read.events[i].from, written.events[i].from);
    EXPECT_EQ(read.events[i].to, written.events[i].to);
    EXPECT_EQ(read.events[i].onCredit, written.events[i].onCredit);
    EXPECT_EQ(read.events[i].policy, written.events[i].policy);
  }
  ASSERT_EQ(read.pairs.size(), 1U);
  EXPECT_EQ(read.pairs[0].b, written.pairs[0].b);
  EXPECT_EQ(read.pairs[0].level, written.pairs[0].level);
  ASSERT_EQ(read.contacts.size(), 1U);
  EXPECT_EQ(read.contacts[0].pointA, written.contacts[0].pointA);
  EXPECT_EQ(read.contacts[0].normal, written.contacts[0].normal);
  EXPECT_EQ(read.contacts[0].distance, written.contacts[0].distance);
  EXPECT_EQ(read.contacts[0].impulse, written.contacts[0].impulse);
  EXPECT_EQ(read.values, written.values);
}

TEST(Recording, GivesBackEveryFrameForwardsBackwardsAndAtRandom) {
  const TemporaryFolder folder;
  const auto samples = sampleFrames(97);
  test::writeRecording(folder / "run.rec", samples, kBlock);
  const auto recording = Recording::open(folder / "run.rec");
  ASSERT_TRUE(recording) << recording.error().message;
  const Recording& run = **recording;
  EXPECT_EQ(run.damage(), "");
  EXPECT_EQ(run.first(), 0U);
  EXPECT_EQ(run.last(), 96U);
  EXPECT_EQ(run.seekPoints(), 10U);
  std::vector<std::uint64_t> order;
  for (std::uint64_t frame = 0; frame < 97; ++frame) order.push_back(frame);
  for (std::uint64_t frame = 97; frame > 0; --frame) order.push_back(frame - 1);
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) order.push_back(random() % 97);
  for (const std::uint64_t frame : order) {
    SCOPED_TRACE(frame);
    const auto read = run.frame(frame);
    ASSERT_TRUE(read) << read.error().message;
    expectSame(**read, samples[frame]);
  }
}

TEST(Recording, SaysWhatItIsOfAndWhatBodiesAreMadeFrom) {
  const TemporaryFolder folder;
  test::writeRecording(folder / "run.rec", sampleFrames(50), kBlock);
  const auto run = Recording::open(folder / "run.rec").value();
  EXPECT_EQ(run->info().scene, "sample");
  EXPECT_EQ(run->info().channel("state_hash"), 1U);
  EXPECT_EQ(run->info().notes.at("build"), "a \"quoted\" one");
  ASSERT_NE(run->def(BodyId{1}), nullptr);
  const auto& levels = std::get<std::shared_ptr<const LevelSet>>(run->def(BodyId{1})->shape);
  EXPECT_EQ(levels->name(), "pair");
  EXPECT_EQ(levels->count(), 2);
  EXPECT_EQ(levels->finest().parts.size(), 2U);
  // Bodies that share a model when they are stored share it when they are read.
  EXPECT_EQ(std::get<std::shared_ptr<const LevelSet>>(run->def(BodyId{4})->shape), levels);
  EXPECT_EQ(std::get<Cylinder>(run->def(BodyId{2})->shape).halfHeight, 0.4F);
  EXPECT_EQ(run->def(BodyId{3})->motion, Motion::kStatic);
  EXPECT_EQ(std::get<std::shared_ptr<const TriangleMesh>>(run->def(BodyId{3})->shape)->triangles.size(), 1U);
  EXPECT_EQ(run->nameOf(BodyId{9}), "body-8");
  EXPECT_EQ(run->nameOf(BodyId{77}), "body 77");
}

TEST(Recording, ChecksTellStatesApartThatDifferInAnyOneBit) {
  const TemporaryFolder folder;
  const auto samples = sampleFrames(1);
  for (std::size_t quantity = 0; quantity < kStateQuantityCount; ++quantity) {
    const std::size_t words = quantity == 1 ? 9 : 3;
    for (std::size_t bit = 0; bit < 32 * words; bit += 7) {
      auto changed = samples;
      StateBits& bits = changed[0].bodies[4].bits;
      auto* word = quantity == 0   ? bits.position.data()
                   : quantity == 1 ? bits.orientation.data()
                   : quantity == 2 ? bits.linearVelocity.data()
                                   : bits.angularVelocity.data();
      word[bit / 32] ^= 1U << (bit % 32);
      test::writeRecording(folder / "a.rec", samples, kBlock);
      test::writeRecording(folder / "b.rec", changed, kBlock);
      const auto a = Recording::open(folder / "a.rec").value()->frame(0).value();
      const auto b = Recording::open(folder / "b.rec").value()->frame(0).value();
      for (std::size_t other = 0; other < kStateQuantityCount; ++other) {
        EXPECT_EQ(a->hashes[other] == b->hashes[other], other != quantity);
        EXPECT_EQ(a->bodies[4].checks[other] == b->bodies[4].checks[other], other != quantity);
      }
    }
  }
}

// What a killed program, or a disk that is full, leaves.
TEST(Recording, TornAtEveryByteOfTheLastBlockKeepsAllBlocksBefore) {
  const TemporaryFolder folder;
  const auto samples = sampleFrames(40);
  test::writeRecording(folder / "whole.rec", samples, kBlock);
  test::writeRecording(folder / "shorter.rec", {samples.begin(), samples.begin() + 30}, kBlock);
  const std::string whole = readFile(folder / "whole.rec").value();
  const std::size_t end = 40;  // the end block has a header alone
  const std::size_t before = readFile(folder / "shorter.rec").value().size() - end;
  const std::size_t last = whole.size() - end;
  ASSERT_GT(last, before + 200);
  for (std::size_t size = before; size < whole.size(); ++size) {
    SCOPED_TRACE(size);
    ASSERT_TRUE(writeFile(folder / "torn.rec", std::string_view(whole).substr(0, size)));
    const auto torn = Recording::open(folder / "torn.rec");
    ASSERT_TRUE(torn) << torn.error().message;
    EXPECT_EQ((*torn)->last(), size < last ? 29U : 39U);
    EXPECT_NE((*torn)->damage(), "");
    for (const std::uint64_t frame : {std::uint64_t{0}, (*torn)->last()}) {
      const auto read = (*torn)->frame(frame);
      ASSERT_TRUE(read) << read.error().message;
      expectSame(**read, samples[frame]);
    }
  }
}

TEST(Recording, ALastBlockWithAWrongByteIsLeftOut) {
  const TemporaryFolder folder;
  const auto samples = sampleFrames(40);
  test::writeRecording(folder / "whole.rec", samples, kBlock);
  std::string bytes = readFile(folder / "whole.rec").value();
  bytes.resize(bytes.size() - 40);
  for (const std::size_t back : {1U, 100U, 400U}) {
    std::string damaged = bytes;
    damaged[damaged.size() - back] ^= 0x10;
    ASSERT_TRUE(writeFile(folder / "damaged.rec", damaged));
    const auto run = Recording::open(folder / "damaged.rec");
    ASSERT_TRUE(run) << run.error().message;
    EXPECT_EQ((*run)->last(), 29U);
    EXPECT_THAT((*run)->damage(), HasSubstr("no whole block"));
  }
}

TEST(Recording, ABlockInTheMiddleThatIsDamagedIsNamedAndOthersAreRead) {
  const TemporaryFolder folder;
  const auto samples = sampleFrames(60);
  test::writeRecording(folder / "a.rec", {samples.begin(), samples.begin() + 20}, kBlock);
  test::writeRecording(folder / "whole.rec", samples, kBlock);
  std::string bytes = readFile(folder / "whole.rec").value();
  bytes[readFile(folder / "a.rec").value().size() - 40 - 50] ^= 1;
  ASSERT_TRUE(writeFile(folder / "damaged.rec", bytes));
  const auto run = Recording::open(folder / "damaged.rec").value();
  EXPECT_TRUE(run->frame(5));
  EXPECT_TRUE(run->frame(25));
  const auto damaged = run->frame(15);
  ASSERT_FALSE(damaged);
  EXPECT_THAT(damaged.error().message, HasSubstr("frames 10 to 19 are damaged"));
}

TEST(Recording, FuzzedFilesAreReadOrRefusedInOneLine) {
  const TemporaryFolder folder;
  test::writeRecording(folder / "whole.rec", sampleFrames(45), kBlock);
  const std::string whole = readFile(folder / "whole.rec").value();
  std::mt19937 random(11);
  for (int round = 0; round < 1500; ++round) {
    std::string bytes = whole;
    for (auto left = 1 + random() % 4; left > 0; --left) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    if (random() % 8 == 0) bytes.insert(random() % bytes.size(), whole.substr(random() % whole.size(), 100));
    ASSERT_TRUE(writeFile(folder / "fuzzed.rec", bytes));
    const auto run = Recording::open(folder / "fuzzed.rec");
    if (!run) {
      EXPECT_EQ(run.error().message.find('\n'), std::string::npos);
      continue;
    }
    for (std::uint64_t frame = (*run)->first(); frame <= (*run)->last(); frame += 3) {
      if (const auto read = (*run)->frame(frame); !read) {
        EXPECT_THAT(read.error().message, HasSubstr("damaged"));
      }
    }
  }
}

TEST(Recording, RefusesWhatIsNone) {
  const TemporaryFolder folder;
  EXPECT_THAT(Recording::open(folder / "none.rec").error().message, HasSubstr("No such file"));
  ASSERT_TRUE(writeFile(folder / "text.rec", "frame,time_s\n1,0.02\n"));
  EXPECT_THAT(Recording::open(folder / "text.rec").error().message, HasSubstr("is no recording of a run"));
  ASSERT_TRUE(writeFile(folder / "empty.rec", ""));
  EXPECT_THAT(Recording::open(folder / "empty.rec").error().message, HasSubstr("is no recording of a run"));
  test::writeRecording(folder / "other.rec", sampleFrames(3), kBlock);
  std::string other = readFile(folder / "other.rec").value();
  other[12] = 9;
  ASSERT_TRUE(writeFile(folder / "other.rec", other));
  EXPECT_THAT(Recording::open(folder / "other.rec").error().message, HasSubstr("another version"));
  test::writeRecording(folder / "nothing.rec", {}, kBlock);
  EXPECT_THAT(Recording::open(folder / "nothing.rec").error().message, HasSubstr("no whole frame"));
}

TEST(RecordingWriter, ANumberThatIsNotFiniteIsStoredAsWhatItWasBefore) {
  const TemporaryFolder folder;
  auto samples = sampleFrames(3);
  samples[2].bodies[0].pose.position.x = std::numeric_limits<float>::quiet_NaN();
  samples[2].bodies[0].pose.rotation.w = std::numeric_limits<float>::infinity();
  samples[2].bodies[1].pose.position.y = 3e38F;
  test::writeRecording(folder / "run.rec", samples, kBlock);
  const auto run = Recording::open(folder / "run.rec").value();
  const auto frame = run->frame(2).value();
  EXPECT_NEAR(frame->bodies[0].pose.position.x, samples[1].bodies[0].pose.position.x, kRecordedMetres);
  EXPECT_GT(frame->bodies[1].pose.position.y, 1e10F);
}

TEST(RecordingWriter, ADiskThatIsFullKeepsWhatWasWrittenBefore) {
  const TemporaryFolder folder;
  const auto samples = sampleFrames(4000);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 60000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  auto writer = RecordingWriter::create(folder / "run.rec", test::sampleInfo(), {.blockFrames = kBlock});
  Result<void> added;
  for (std::size_t i = 0; i < samples.size() && added; ++i) {
    test::copyFrame(samples[i], (*writer)->next());
    added = (*writer)->add();
  }
  const auto finished = (*writer)->finish();
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().kind, ErrorKind::kDiskFull);
  EXPECT_THAT(finished.error().message, HasSubstr("run.rec"));
  const auto run = Recording::open(folder / "run.rec");
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_GT((*run)->last(), 100U);
  EXPECT_EQ((*run)->damage(), "it has no end: its program was killed, or still runs");
  expectSame(**(*run)->frame((*run)->last()), samples[(*run)->last()]);
}

TEST(RecordingWriter, WithoutAnEndHasAllThatWasAdded) {
  const TemporaryFolder folder;
  const auto samples = sampleFrames(25);
  {
    auto writer = RecordingWriter::create(folder / "run.rec", test::sampleInfo(), {.blockFrames = kBlock});
    for (const FrameSample& sample : samples) {
      test::copyFrame(sample, (*writer)->next());
      ASSERT_TRUE((*writer)->add());
    }
  }
  const auto run = Recording::open(folder / "run.rec").value();
  EXPECT_EQ(run->last(), 24U);
  EXPECT_NE(run->damage(), "");
}

}  // namespace
}  // namespace scatter
