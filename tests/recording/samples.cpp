#include "recording/samples.h"

#include <gtest/gtest.h>
#include <scatter/recording/recording_writer.h>

#include <bit>
#include <cmath>
#include <random>

namespace scatter::test {
namespace {

constexpr std::uint32_t kBodies = 9;
constexpr std::size_t kGone = 40;   // the frame from which the third body is gone,
constexpr std::size_t kCome = 25;   // that in which the last one comes,
constexpr std::size_t kSleep = 30;  // and that from which the second one sleeps

std::array<std::uint32_t, 3> bitsOf(const Vec3& v) {
  return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
          std::bit_cast<std::uint32_t>(v.z)};
}

Transform poseAt(std::uint32_t body, std::size_t frame) {
  const auto t = static_cast<float>(frame) / 60.0F;
  const auto number = static_cast<float>(body);
  const float height = std::abs(5.0F * std::cos(3.0F * t + number));
  const Vec3 axis = glm::normalize(Vec3(1.0F, number, 0.3F));
  // The last one turns by more than a right angle a frame.
  const float spin = body == kBodies - 1 ? 110.0F : 2.0F * number;
  return {Vec3(number + t, height, -100.0F * number * t), glm::angleAxis(spin * t, axis)};
}

BodyDef defOf(std::uint32_t body) {
  static const auto levels = [] {
    LevelSetDef def{.name = "pair", .levels = {}, .mass = {}};
    def.levels.push_back({{{Box{Vec3(1.0F)}, {}}}});
    def.levels.push_back({{{Sphere{0.5F}, {}}, {Capsule{0.2F, 0.3F}, {Vec3(0.1F), kNoRotation}}}});
    return LevelSet::create(std::move(def)).value();
  }();
  BodyDef def;
  def.name = "body-" + std::to_string(body);
  if (body % 3 == 0) def.shape = levels;
  if (body % 3 == 1) def.shape = Cylinder{0.3F, 0.4F};
  if (body == 2) {
    def.motion = Motion::kStatic;
    def.shape = std::make_shared<const TriangleMesh>(
        TriangleMesh{{Vec3(0.0F), Vec3(1.0F, 0.0F, 0.0F), Vec3(0.0F, 0.0F, 1.0F)}, {{0, 2, 1}}});
  }
  return def;
}

}  // namespace

std::vector<FrameSample> sampleFrames(std::size_t frames, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<FrameSample> samples;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    FrameSample sample;
    sample.number = frame;
    for (std::uint32_t body = 0; body < kBodies; ++body) {
      if ((body == 3 && frame >= kGone) || (body == kBodies - 1 && frame < kCome)) continue;
      const bool rests = body == 2 || (body == 1 && frame >= kSleep);
      const std::size_t moment = body == 2 ? 0 : rests ? kSleep : frame;
      SampledBody sampled{.body = BodyId{body + 1}, .level = 1, .asleep = rests && body == 1};
      sampled.level = static_cast<std::uint8_t>(1 + (frame / 20 + body) % 2);
      sampled.pose = poseAt(body, moment);
      sampled.bits.position = bitsOf(sampled.pose.position);
      for (int i = 0; i < 4; ++i) {
        sampled.bits.orientation[static_cast<std::size_t>(i)] =
            std::bit_cast<std::uint32_t>(sampled.pose.rotation[i]);
      }
      sampled.bits.linearVelocity = {static_cast<std::uint32_t>(moment), body, 7};
      sampled.bits.angularVelocity = {body, static_cast<std::uint32_t>(moment), 9};
      sample.bodies.push_back(sampled);
      const bool isNew = body == kBodies - 1 ? frame == kCome : frame == 0;
      if (isNew) sample.added.emplace_back(sampled.body, defOf(body));
    }
    for (auto i = static_cast<std::uint32_t>(random() % 4); i > 0; --i) {
      sample.events.push_back({.kind = static_cast<LevelEventKind>(random() % 5),
                               .scope = static_cast<Scope>(random() % 3),
                               .body = BodyId{1 + i},
                               .from = 2,
                               .to = 1,
                               .other = BodyId{static_cast<std::uint32_t>(random() % 3)},
                               .onCredit = random() % 2 == 0,
                               .policy = random() % 2 == 0 ? "speed" : "governor"});
    }
    sample.pairs.push_back({BodyId{1}, BodyId{2}, 2});
    sample.contacts.push_back(
        {BodyId{2}, BodyId{1}, Vec3(0.5F, 0.25F, -3.0F), Vec3(0.0F, 1.0F, 0.0F), -0.125F, 0.0F, 3.5F});
    sample.values = {std::bit_cast<std::uint64_t>(static_cast<double>(frame) / 60.0), random()};
    samples.push_back(std::move(sample));
  }
  return samples;
}

RecordingInfo sampleInfo() {
  RecordingInfo info;
  info.scene = "sample";
  info.label = "hybrid";
  info.engine = "none";
  info.channels = {{"time_s", "s", RecordedKind::kReal}, {"state_hash", "", RecordedKind::kHash}};
  info.notes = {{"build", "a \"quoted\" one"}};
  return info;
}

void copyFrame(const FrameSample& from, FrameSample& to) {
  to = from;
}

void writeRecording(const std::filesystem::path& file, const std::vector<FrameSample>& frames,
                    std::uint32_t blockFrames) {
  auto writer =
      RecordingWriter::create(file, sampleInfo(), {.blockFrames = blockFrames, .blockSeconds = 1e9});
  ASSERT_TRUE(writer) << writer.error().message;
  for (const FrameSample& frame : frames) {
    copyFrame(frame, (*writer)->next());
    const auto added = (*writer)->add();
    ASSERT_TRUE(added) << added.error().message;
  }
  const auto finished = (*writer)->finish();
  ASSERT_TRUE(finished) << finished.error().message;
}

}  // namespace scatter::test
