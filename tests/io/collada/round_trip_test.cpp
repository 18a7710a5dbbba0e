#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "io/collada/frame.h"
#include "io/collada/samples.h"
#include "io/gltf/comparison.h"
#include "io/gltf/random.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

using test::findDifference;
using test::TemporaryFolder;

PhysicsDocument writtenAndRead(const PhysicsDocument& document, const TemporaryFolder& folder) {
  const auto written = writeColladaDocument(document, folder / "scene.dae");
  EXPECT_TRUE(written.has_value()) << written.error().message;
  auto read = readColladaDocument(folder / "scene.dae");
  EXPECT_TRUE(read.has_value()) << read.error().message;
  return read ? *read : PhysicsDocument{};
}

void tidy(Transform& pose) {
  pose.rotation = io::unitRotation(pose.rotation);
}

/// The levels as the reader makes them of the finest shapes.
std::shared_ptr<const LevelSet> tidyLevels(const DocumentModel& model) {
  LevelSetDef def;
  def.name = model.name;
  def.hullMargin = model.levels->hullMargin();
  for (int index = 1; index <= model.levels->count(); ++index) {
    def.levels.push_back(model.levels->level(index));
    for (ConvexPart& part : def.levels.back().parts) {
      tidy(part.pose);
    }
  }
  return LevelSet::create(std::move(def)).value();
}

/// The document with names that COLLADA allows, rotations that are their own axis and angle, and no masses of
/// levels given by hand: what is left can be written without loss.
PhysicsDocument tidied(PhysicsDocument document) {
  const auto rename = [](auto& items, const char* kind) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      items[i].name = kind + std::to_string(i);
    }
  };
  document.name = "scene";
  rename(document.materials, "material");
  rename(document.models, "model");
  rename(document.bodies, "body");
  rename(document.joints, "joint");
  rename(document.fields, "field");
  for (DocumentModel& model : document.models) {
    for (DocumentShape& shape : model.shapes) {
      tidy(shape.pose);
    }
    if (model.levels) {
      model.levels = tidyLevels(model);
    }
    if (model.massFrame) {
      tidy(model.massFrame->pose);
    }
  }
  for (DocumentBody& body : document.bodies) {
    tidy(body.pose);
  }
  for (DocumentJoint& joint : document.joints) {
    tidy(joint.frameA);
    tidy(joint.frameB);
  }
  return document;
}

TEST(ColladaRoundTrip, KeepsAnyDocumentToTheLastBit) {
  const TemporaryFolder folder;
  test::RandomDocuments documents(3);
  int count = 0;
  while (count < 300) {
    const PhysicsDocument random = documents.next();
    if (random.models.empty()) {
      continue;
    }
    const PhysicsDocument document = tidied(random);
    const PhysicsDocument read = writtenAndRead(document, folder);
    ASSERT_EQ(findDifference(document, read), "") << "document " << count;
    ASSERT_THAT(read.warnings, testing::IsEmpty()) << "document " << count;
    ++count;
  }
}

TEST(ColladaRoundTrip, IsStableFromTheFirstReadingOn) {
  const TemporaryFolder folder;
  test::RandomDocuments documents(4);
  for (int count = 0; count < 100; ++count) {
    const PhysicsDocument random = documents.next();
    if (random.models.empty()) {
      continue;
    }
    const PhysicsDocument once = writtenAndRead(random, folder);
    const PhysicsDocument twice = writtenAndRead(once, folder);
    ASSERT_EQ(findDifference(once, twice), "") << "document " << count;
    ASSERT_TRUE(writeColladaDocument(once, folder / "again.dae"));
    ASSERT_EQ(readFile(folder / "scene.dae").value(), readFile(folder / "again.dae").value());
  }
}

class ColladaSample : public testing::TestWithParam<test::Sample> {};

TEST_P(ColladaSample, GivesTheSameDocumentWhenWrittenAndReadAgain) {
  const TemporaryFolder folder;
  const auto document = parseColladaDocument(GetParam().text, "sample.dae");
  ASSERT_TRUE(document.has_value()) << document.error().message;
  const PhysicsDocument read = writtenAndRead(*document, folder);
  EXPECT_EQ(findDifference(*document, read), "");
  EXPECT_THAT(read.warnings, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Exporters, ColladaSample, testing::ValuesIn(test::exporterSamples()),
                         [](const auto& sample) { return sample.param.name; });

TEST(ColladaRoundTrip, ShowsOtherReadersAPlainRigidBody) {
  const TemporaryFolder folder;
  test::RandomDocuments documents(5);
  PhysicsDocument document;
  while (document.models.empty() || !document.models[0].levels) {
    document = documents.next();
  }
  ASSERT_TRUE(writeColladaDocument(document, folder / "scene.dae"));
  std::string text = readFile(folder / "scene.dae").value();
  for (std::size_t at = text.find("SCATTER"); at != std::string::npos; at = text.find("SCATTER", at)) {
    text.replace(at, 7, "UNKNOWN");
  }
  const auto plain = parseColladaDocument(text, "plain.dae");
  ASSERT_TRUE(plain.has_value()) << plain.error().message;
  ASSERT_EQ(plain->models.size(), document.models.size());
  EXPECT_EQ(plain->models[0].levels, nullptr);
  EXPECT_EQ(plain->models[0].shapes.size(), document.models[0].shapes.size());
}

/// A document that can be written.
PhysicsDocument soundDocument() {
  return parseColladaDocument(test::exporterSample("Bullet"), "sound.dae").value();
}

TEST(ColladaRoundTrip, RefusesADocumentThatCouldNotBeReadBack) {
  const TemporaryFolder folder;
  const auto messageFor = [&](const auto& spoil) {
    PhysicsDocument document = soundDocument();
    spoil(document);
    const auto written = writeColladaDocument(document, folder / "bad.dae");
    return written ? "no error" : written.error().message;
  };
  using testing::HasSubstr;
  using D = PhysicsDocument;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(messageFor([](D& d) { d.models.clear(); }), HasSubstr("it has no model"));
  EXPECT_THAT(messageFor([&](D& d) { d.gravity.y = nan; }), HasSubstr("gravity is not finite"));
  EXPECT_THAT(messageFor([](D& d) { d.timeStep = 0.0F; }), HasSubstr("time step"));
  EXPECT_THAT(messageFor([](D& d) { d.models[0].shapes.clear(); }), HasSubstr("it has no shapes"));
  EXPECT_THAT(messageFor([](D& d) { d.models[0].shapes[0].geometry = ConvexShape(Sphere{0.0F}); }),
              HasSubstr("a sphere has no sound size"));
  EXPECT_THAT(messageFor([](D& d) { d.models[0].shapes[0].geometry = VisualMesh{}; }),
              HasSubstr("has no triangles"));
  EXPECT_THAT(messageFor([](D& d) { d.models[0].shapes[0].material = 7; }), HasSubstr("does not exist"));
  EXPECT_THAT(messageFor([](D& d) { d.models[0].shapes[0].density = -1.0F; }), HasSubstr("density"));
  EXPECT_THAT(messageFor([&](D& d) { d.models[0].mass = nan; }), HasSubstr("mass of nan kg"));
  EXPECT_THAT(messageFor([](D& d) { d.models[0].massFrame->inertia = Vec3(0.0F); }),
              HasSubstr("its inertia is not positive"));
  EXPECT_THAT(messageFor([](D& d) {
                d.materials.push_back({"m", 0.5F, 0.5F, 2.0F});
              }),
              HasSubstr("restitution"));
  EXPECT_THAT(messageFor([](D& d) { d.bodies[0].model = 7; }), HasSubstr("model that does not exist"));
  EXPECT_THAT(messageFor([&](D& d) { d.bodies[0].pose.position.x = nan; }), HasSubstr("a position is not"));
  EXPECT_THAT(messageFor([](D& d) { d.bodies[0].pose.rotation = Quat(0.0F, 0.0F, 0.0F, 0.0F); }),
              HasSubstr("a rotation is not"));
  EXPECT_THAT(messageFor([](D& d) { d.joints[0].bodyB = 7; }), HasSubstr("body that does not exist"));
  EXPECT_THAT(messageFor([](D& d) { d.joints[0].bodyB.reset(); }), HasSubstr("to itself"));
  EXPECT_THAT(messageFor([&](D& d) { d.joints[0].linear[1] = {nan, 0.0F}; }), HasSubstr("a limit is not"));
  EXPECT_THAT(messageFor([&](D& d) {
                d.fields.push_back({"f", Vec3(0.0F), nan, 1.0F});
              }),
              HasSubstr("field"));
  EXPECT_TRUE(folder.isEmpty());
}

}  // namespace
}  // namespace scatter
