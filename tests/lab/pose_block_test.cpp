#include "lab/page/pose_block.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "lab/page/contact_block.h"
#include "recording/bytes.h"

namespace scatter::lab {
namespace {

using recording::ByteReader;

constexpr float kQuantum = 1.0F / 1024.0F;

struct Decoded {
  std::uint8_t state = 0;
  std::array<float, 7> numbers{};
};

// As the page does it.
std::vector<std::vector<Decoded>> decode(std::string_view bytes, std::size_t frames, std::size_t bodies) {
  std::vector<std::vector<Decoded>> decoded(frames, std::vector<Decoded>(bodies));
  ByteReader in(bytes);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (std::size_t body = 0; body < bodies; ++body) {
      decoded[frame][body].state = in.byte() ^ (frame > 0 ? decoded[frame - 1][body].state : 0);
    }
  }
  for (std::size_t number = 0; number < 7; ++number) {
    for (std::size_t body = 0; body < bodies; ++body) {
      std::int32_t last = 0;
      std::int32_t step = 0;
      bool begun = false;
      for (auto& frame : decoded) {
        if (frame[body].state == 0) continue;
        const auto next = static_cast<std::int32_t>(step + in.difference());
        last += next;
        step = begun ? next : 0;
        begun = true;
        frame[body].numbers[number] = static_cast<float>(last) * (number < 3 ? kQuantum : 1.0F / 8192.0F);
      }
    }
  }
  EXPECT_FALSE(in.failed());
  EXPECT_EQ(in.left(), 0U);
  return decoded;
}

TEST(PoseBlock, KeepsWhereBodiesAreAndWhetherTheyAreThere) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> share(-1.0F, 1.0F);
  const auto any = [&] { return Vec3(share(random), share(random), share(random)); };
  constexpr std::size_t kBodies = 9;
  std::vector<std::vector<BlockBody>> frames;
  PoseBlock block(kBodies);
  for (int frame = 0; frame < 40; ++frame) {
    auto& bodies = block.addFrame();
    for (std::size_t i = 0; i < kBodies; ++i) {
      if ((static_cast<std::size_t>(frame) / 5 + i) % 4 == 0) continue;
      bodies[i].level = static_cast<std::uint8_t>(1 + i % 3);
      bodies[i].asleep = frame > 20;
      bodies[i].pose.position = 100.0F * any();
      bodies[i].pose.rotation = glm::angleAxis(3.0F * share(random), glm::normalize(any()));
    }
    frames.push_back(bodies);
  }
  const auto decoded = decode(block.encode(kQuantum), frames.size(), kBodies);
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    for (std::size_t i = 0; i < kBodies; ++i) {
      const BlockBody& body = frames[frame][i];
      const Decoded& found = decoded[frame][i];
      ASSERT_EQ(found.state, body.level | (body.asleep ? 128 : 0));
      if (body.level == 0) continue;
      const auto& n = found.numbers;
      EXPECT_LE(glm::distance(Vec3(n[0], n[1], n[2]), body.pose.position), kQuantum);
      const Quat turn = glm::normalize(Quat(n[6], n[3], n[4], n[5]));
      // Twice the sine of half the angle between them.
      const Quat other = glm::dot(turn, body.pose.rotation) < 0.0F ? -body.pose.rotation : body.pose.rotation;
      EXPECT_LT(2.0F * glm::length(turn - other), 3.0e-4F);
    }
  }
}

TEST(PoseBlock, TakesPlacesThatNoPageCanHold) {
  PoseBlock block(1);
  for (const float x : {1.0e30F, -1.0e30F, 0.0F}) {
    auto& body = block.addFrame().front();
    body.level = 1;
    body.pose.position = Vec3(x, 0.0F, 0.0F);
  }
  const auto decoded = decode(block.encode(kQuantum), 3, 1);
  EXPECT_FLOAT_EQ(decoded[0][0].numbers[0], 1.0e9F * kQuantum);
  EXPECT_FLOAT_EQ(decoded[1][0].numbers[0], -1.0e9F * kQuantum);
  EXPECT_FLOAT_EQ(decoded[2][0].numbers[0], 0.0F);
}

TEST(PoseBlock, WhatRestsTakesAByteForEachNumber) {
  PoseBlock block(1);
  for (int frame = 0; frame < 100; ++frame) {
    auto& body = block.addFrame().front();
    body.level = 1;
    body.pose.position = Vec3(3.0F);
  }
  EXPECT_LT(block.encode(kQuantum).size(), 100U * 8U + 20U);
}

TEST(ContactBlock, HasTheDeepestPointOfEachPairThatTouches) {
  const auto contact = [](std::uint32_t a, std::uint32_t b, float x, float distance) {
    RecordedContact made;
    made.a = BodyId{a};
    made.b = BodyId{b};
    made.pointA = Vec3(x, 2.0F, -1.0F);
    made.distance = distance;
    return made;
  };
  RecordedFrame frame;
  frame.contacts = {contact(2, 1, 5.0F, -0.01F), contact(1, 2, 6.0F, -0.02F), contact(1, 3, 7.0F, 0.05F),
                    contact(3, 4, 8.0F, 0.0F)};
  frame.pairs = {{BodyId{1}, BodyId{2}, 2}};
  ContactBlock block;
  block.addFrame(frame);
  const std::string bytes = block.take();
  ByteReader in(bytes);
  EXPECT_EQ(in.number(), 2U);
  EXPECT_EQ(in.byte(), 2U);
  EXPECT_EQ(in.difference(), 6 * 64);
  EXPECT_EQ(in.difference(), 2 * 64);
  EXPECT_EQ(in.difference(), -64);
  EXPECT_EQ(in.byte(), 0U);
  EXPECT_EQ(in.difference(), 2 * 64);
  EXPECT_EQ(in.difference(), 0);
  EXPECT_EQ(in.difference(), 0);
  EXPECT_EQ(in.left(), 0U);
}

}  // namespace
}  // namespace scatter::lab
