#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/io/file.h>
#include <scatter/io/gltf.h>
#include <scatter/io/model_file.h>

#include <string>

#include "io/documents.h"
#include "io/temporary_folder.h"

namespace scatter::test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

DocumentModel boxModel(const std::string& name, float halfExtent) {
  DocumentModel model;
  model.name = name;
  model.shapes.resize(1);
  model.shapes.front().geometry = ConvexShape{Box{Vec3(halfExtent)}};
  model.mass = 2.0F;
  return model;
}

DocumentBody placed(const std::string& name, std::size_t model, float x) {
  DocumentBody body;
  body.name = name;
  body.model = model;
  body.pose.position.x = x;
  return body;
}

/// Two crates, one of them heavier, and a ball.
PhysicsDocument yard() {
  PhysicsDocument document;
  document.name = "yard";
  document.models = {boxModel("crate", 0.5F), boxModel("dice", 0.1F)};
  document.bodies = {placed("left", 0, -2.0F), placed("right", 0, 2.0F), placed("small", 1, 0.0F)};
  return document;
}

/// readModelFile of a document that was written as glTF.
class ModelFileTest : public testing::Test {
 protected:
  Result<FileModel> readWritten(const PhysicsDocument& document, const std::string& body = "") {
    const auto written = writeGltfDocument(document, path_);
    EXPECT_TRUE(written) << written.error().message;
    return readModelFile(path_, body);
  }

  std::string errorOf(const PhysicsDocument& document, const std::string& body = "") {
    const auto read = readWritten(document, body);
    EXPECT_FALSE(read);
    return read ? "" : read.error().message;
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "yard.glb";
};

TEST_F(ModelFileTest, ReadsABodyByItsNameOrItsModels) {
  PhysicsDocument document = yard();
  EXPECT_EQ(readWritten(document, "small")->model.name, "dice");
  EXPECT_EQ(readWritten(document, "dice")->model.name, "dice");
  EXPECT_EQ(readWritten(document, "right")->model.name, "crate");
  document.bodies[1].mass = 7.0F;
  EXPECT_EQ(readWritten(document, "left")->model.mass, 2.0F);
  EXPECT_EQ(readWritten(document, "right")->model.mass, 7.0F);
}

TEST_F(ModelFileTest, NeedsNoNameWhereAllBodiesAreAlike) {
  PhysicsDocument document = yard();
  document.bodies.pop_back();
  document.models.pop_back();
  const auto crate = readWritten(document);
  ASSERT_TRUE(crate) << crate.error().message;
  EXPECT_EQ(crate->model.name, "crate");
  ASSERT_EQ(crate->model.levels->count(), 1);
  EXPECT_EQ(std::get<Box>(crate->model.levels->finest().parts.front().shape).halfExtents, Vec3(0.5F));
}

TEST_F(ModelFileTest, ListsTheBodiesIfItIsNotClearWhichIsMeant) {
  PhysicsDocument document = yard();
  EXPECT_EQ(errorOf(document),
            path_.string() + R"(: has several rigid bodies; name one of "left", "right", "small")");
  EXPECT_EQ(errorOf(document, "middle"),
            path_.string() + R"(: has no rigid body "middle"; it has "left", "right", "small")");
  document.bodies[1].mass = 7.0F;
  EXPECT_THAT(errorOf(document, "crate"), EndsWith(R"(name one of "left", "right")"));
  for (int i = 0; i < 9; ++i) document.bodies.push_back(placed("more-" + std::to_string(i), 1, 5.0F));
  EXPECT_THAT(errorOf(document), EndsWith(R"("more-4" and 4 more)"));
}

TEST_F(ModelFileTest, KnowsWhatDoesNotMove) {
  PhysicsDocument document = yard();
  document.bodies.front().motion = DocumentMotion::kStatic;
  EXPECT_EQ(readWritten(document, "left")->motion, DocumentMotion::kStatic);
  EXPECT_EQ(readWritten(document, "right")->motion, DocumentMotion::kDynamic);
}

TEST_F(ModelFileTest, RefusesShapesThatAreNotConvex) {
  PhysicsDocument document = yard();
  DocumentShape plane;
  plane.geometry = DocumentPlane{};
  document.models[1].motion = DocumentMotion::kStatic;
  document.models[1].shapes.push_back(plane);
  EXPECT_THAT(errorOf(document, "small"),
              AllOf(StartsWith(path_.string() + ": body \"small\": "), HasSubstr("convex")));
}

TEST_F(ModelFileTest, TakesTheMassThatTheFileGivesByHand) {
  Document file;
  file.mass =
      "<mass>12.5</mass><mass_frame><translate>0.1 0 0</translate></mass_frame><inertia>25 50 75</inertia>";
  const std::filesystem::path path = folder_ / "brick.DAE";
  ASSERT_TRUE(writeFile(path, file.text()));
  const auto brick = readModelFile(path);
  ASSERT_TRUE(brick) << brick.error().message;
  EXPECT_EQ(brick->model.mass, 12.5F);
  const MassProperties& mass = brick->model.levels->mass();
  EXPECT_EQ(mass.centerOfMass, Vec3(0.1F, 0.0F, 0.0F));
  EXPECT_EQ(mass.inertia[0][0], 2.0F);
  EXPECT_EQ(mass.inertia[1][1], 4.0F);
  EXPECT_EQ(mass.inertia[2][2], 6.0F);
}

TEST_F(ModelFileTest, SaysWhatIsWrongWithAFile) {
  const auto error = [](const std::filesystem::path& path) {
    const auto read = readModelFile(path);
    return read ? "" : read.error().message;
  };
  EXPECT_EQ(error("ship.obj"), "ship.obj: is no physics file by its extension; give it .dae, .gltf or .glb");
  EXPECT_EQ(error("nowhere.dae"), "cannot read nowhere.dae: No such file or directory");
  const std::filesystem::path broken = folder_ / "broken.dae";
  ASSERT_TRUE(writeFile(broken, "<COLLADA>"));
  EXPECT_THAT(error(broken), StartsWith(broken.string() + ":1: "));
}

}  // namespace
}  // namespace scatter::test
