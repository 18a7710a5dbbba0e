#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <random>
#include <string>

#include "io/documents.h"
#include "io/temporary_folder.h"
#include "trials.h"

namespace scatter {
namespace {

using test::TemporaryFolder;

/// The numbers of a shape, after its kind.
struct Numbers {
  std::vector<float> operator()(const Box& box) const {
    return {0.0F, box.halfExtents.x, box.halfExtents.y, box.halfExtents.z};
  }
  std::vector<float> operator()(const Sphere& sphere) const { return {1.0F, sphere.radius}; }
  std::vector<float> operator()(const Capsule& capsule) const {
    return {2.0F, capsule.radius, capsule.halfHeight};
  }
  std::vector<float> operator()(const Cylinder& cylinder) const {
    return {3.0F, cylinder.radius, cylinder.halfHeight};
  }
  std::vector<float> operator()(const ConvexHull& hull) const {
    std::vector<float> numbers{4.0F};
    for (const Vec3& vertex : hull.vertices) {
      numbers.insert(numbers.end(), {vertex.x, vertex.y, vertex.z});
    }
    return numbers;
  }
};

void expectSameLevels(const LevelSet& a, const LevelSet& b) {
  ASSERT_EQ(a.count(), b.count());
  EXPECT_EQ(a.hullMargin(), b.hullMargin());
  for (int index = 1; index <= a.count(); ++index) {
    const auto& partsA = a.level(index).parts;
    const auto& partsB = b.level(index).parts;
    ASSERT_EQ(partsA.size(), partsB.size()) << "level " << index;
    for (std::size_t i = 0; i < partsA.size(); ++i) {
      SCOPED_TRACE("level " + std::to_string(index) + ", part " + std::to_string(i));
      EXPECT_EQ(std::visit(Numbers{}, partsA[i].shape), std::visit(Numbers{}, partsB[i].shape));
      EXPECT_EQ(partsA[i].pose.position, partsB[i].pose.position);
      EXPECT_EQ(partsA[i].pose.rotation, partsB[i].pose.rotation);
    }
  }
}

void expectSame(const Model& a, const Model& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.friction, b.friction);
  EXPECT_EQ(a.restitution, b.restitution);
  EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  expectSameLevels(*a.levels, *b.levels);
}

Model richModel() {
  return parseCollada(test::richDocument().text(), "rich.dae").value();
}

Model withParts(std::vector<ConvexPart> parts) {
  Model model;
  model.name = "parts";
  model.levels = LevelSet::create({"parts", {Level{std::move(parts)}}, 0.03F, {}}).value();
  return model;
}

Model writtenAndRead(const Model& model) {
  const TemporaryFolder folder;
  const auto written = writeCollada(model, folder / "model.dae");
  EXPECT_TRUE(written.has_value()) << written.error().message;
  auto read = readCollada(folder / "model.dae");
  EXPECT_TRUE(read.has_value()) << read.error().message;
  return read ? *read : Model{};
}

class ModelFile : public testing::TestWithParam<const char*> {};

TEST_P(ModelFile, ReadsBackTheSameAfterWriting) {
  const auto model = readCollada(std::string(SCATTER_TEST_MODEL_DIR "/") + GetParam() + ".dae");
  ASSERT_TRUE(model.has_value()) << model.error().message;
  expectSame(writtenAndRead(*model), *model);
}

INSTANTIATE_TEST_SUITE_P(ColladaWriter, ModelFile,
                         testing::Values("hunter", "fighter", "hunter_hulls", "fighter_hulls"),
                         [](const auto& test) { return std::string(test.param); });

TEST(ColladaWriter, KeepsEveryKindOfShape) {
  const Model model = richModel();
  expectSame(writtenAndRead(model), model);
}

TEST(ColladaWriter, KeepsTheMarginOfASingleLevel) {
  const Model model = withParts({{Sphere{0.25F}, {}}});
  expectSame(writtenAndRead(model), model);
}

TEST(ColladaWriter, KeepsAnyRotationToTheLastBitOrTwo) {
  std::mt19937_64 random(7);
  const auto number = [&] { return static_cast<float>(random() % 2001) / 1000.0F - 1.0F; };
  std::vector<ConvexPart> parts;
  for (int i = 0; i < test::trials(200); ++i) {
    const Quat rotation = glm::normalize(Quat(number(), number(), number(), number() + 1e-3F));
    parts.push_back({Box{}, {{number(), number(), number()}, rotation}});
  }
  const Model model = withParts(parts);
  const Model read = writtenAndRead(model);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Quat& back = read.levels->finest().parts.at(i).pose.rotation;
    // q and -q are the same rotation.
    EXPECT_GT(std::abs(glm::dot(glm::dquat(back), glm::dquat(parts[i].pose.rotation))), 1.0 - 1e-6);
    EXPECT_EQ(read.levels->finest().parts.at(i).pose.position, parts[i].pose.position);
  }
}

TEST(ColladaWriter, WritesTheSameBytesForTheSameModel) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeCollada(richModel(), folder / "a.dae"));
  ASSERT_TRUE(writeCollada(readCollada(folder / "a.dae").value(), folder / "b.dae"));
  EXPECT_EQ(readFile(folder / "a.dae").value(), readFile(folder / "b.dae").value());
}

TEST(ColladaWriter, ReplacesWhatColladaDoesNotAllowInNames) {
  Model model = richModel();
  model.name = "2 <ships> & \"more\"";
  EXPECT_EQ(writtenAndRead(model).name, "_2__ships_____more_");
}

TEST(ColladaWriter, RefusesAModelThatCouldNotBeReadBack) {
  const TemporaryFolder folder;
  const auto messageFor = [&](const auto& spoil) {
    Model model = richModel();
    spoil(model);
    const auto written = writeCollada(model, folder / "bad.dae");
    return written ? "no error" : written.error().message;
  };
  using testing::HasSubstr;
  EXPECT_THAT(messageFor([](Model& m) { m.levels = nullptr; }), HasSubstr("has no levels"));
  EXPECT_THAT(messageFor([](Model& m) { m.mass = -1.0F; }), HasSubstr("mass of -1 kg"));
  EXPECT_THAT(messageFor([](Model& m) { m.mass = std::nanf(""); }), HasSubstr("mass of nan kg"));
  EXPECT_THAT(messageFor([](Model& m) { m.restitution = 2.0F; }), HasSubstr("restitution"));
  EXPECT_THAT(messageFor([](Model& m) { m.mesh.vertices[0].x = std::numeric_limits<float>::infinity(); }),
              HasSubstr("not finite"));
  EXPECT_THAT(messageFor([](Model& m) { m.mesh.triangles[0][1] = 99; }), HasSubstr("does not exist"));
  EXPECT_TRUE(folder.isEmpty());
}

TEST(ColladaWriter, ReportsAPlaceThatCannotBeWritten) {
  const auto written = writeCollada(richModel(), "/nowhere/at/all/model.dae");
  ASSERT_FALSE(written.has_value());
  EXPECT_THAT(written.error().message, testing::StartsWith("cannot write /nowhere/at/all/model.dae: "));
}

}  // namespace
}  // namespace scatter
