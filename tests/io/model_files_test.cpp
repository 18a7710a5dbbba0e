#include <scatter/io/collada.h>
#include <scatter/io/file.h>
#include <scatter/levels/level_check.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "io/loaded_model.h"
#include "io/temporary_folder.h"

namespace scatter {
namespace {

struct Expected : test::ExpectedModel {
  float mass;
  float length;
  std::size_t middleParts;
  std::size_t finestParts;
  bool hulls;
};

using Ship = test::LoadedModel<Expected>;

TEST_P(Ship, HasThreeLevelsOfTheSizesThatItsPageStates) {
  ASSERT_EQ(model_->levels->count(), 3);
  EXPECT_EQ(model_->levels->coarsest().parts.size(), 1U);
  EXPECT_EQ(model_->levels->level(2).parts.size(), GetParam().middleParts);
  EXPECT_EQ(model_->levels->finest().parts.size(), GetParam().finestParts);
  for (const ConvexPart& part : model_->levels->finest().parts) {
    const auto* hull = std::get_if<ConvexHull>(&part.shape);
    // Where a box fits as well as a hull, `scatter levels build` takes a box.
    ASSERT_TRUE(hull != nullptr ? GetParam().hulls : std::holds_alternative<Box>(part.shape));
    EXPECT_TRUE(hull == nullptr || hull->vertices.size() <= 32);
  }
}

TEST_P(Ship, HasItsMassAndItsCentreOfMassNearTheOrigin) {
  EXPECT_EQ(model_->mass, GetParam().mass);
  EXPECT_LT(glm::length(model_->levels->mass().centerOfMass), 0.15F);
  EXPECT_NEAR(model_->levels->mass().centerOfMass.z, 0.0F, GetParam().hulls ? 0.02F : 1e-3F);
}

TEST_P(Ship, IsAsLongAsItsPageStates) {
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();
  for (const Vec3& vertex : model_->mesh.vertices) {
    low = std::min(low, vertex.x);
    high = std::max(high, vertex.x);
  }
  EXPECT_NEAR(high - low, GetParam().length, 0.1F);
}

TEST_P(Ship, HasAMeshWithoutOpenEdges) {
  EXPECT_GT(model_->mesh.triangles.size(), 500U);
  EXPECT_LT(model_->mesh.triangles.size(), 5000U);
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& triangle : model_->mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.emplace(triangle[i], triangle[(i + 1) % 3]);
    }
  }
  for (const auto& [from, to] : edges) {
    ASSERT_EQ(edges.count({from, to}), 1U);
    ASSERT_EQ(edges.count({to, from}), 1U);
  }
}

TEST_P(Ship, HasAMeshThatFacesOutward) {
  float sixfoldVolume = 0.0F;
  for (const auto& [a, b, c] : model_->mesh.triangles) {
    const auto& v = model_->mesh.vertices;
    sixfoldVolume += glm::dot(v[a], glm::cross(v[b], v[c]));
  }
  EXPECT_GT(sixfoldVolume, 6.0F);
}

bool isInBox(const ConvexPart& part, const Vec3& point) {
  const Vec3 local = glm::abs(part.pose.inverse()(point));
  const Vec3& half = std::get<Box>(part.shape).halfExtents;
  return local.x <= half.x && local.y <= half.y && local.z <= half.z;
}

TEST_P(Ship, HasItsMeshInsideTheFinestLevelAndEachLevelInTheCoarserOne) {
  std::vector<Level> levels;
  for (int i = 1; i <= model_->levels->count(); ++i) levels.push_back(model_->levels->level(i));
  const SurfaceMesh mesh{model_->mesh.vertices, model_->mesh.triangles};
  const auto check = checkLevels(levels, model_->levels->hullMargin(), &mesh);
  ASSERT_TRUE(check.has_value()) << check.error().message;
  EXPECT_TRUE(check->passed());
}

INSTANTIATE_TEST_SUITE_P(Models, Ship,
                         testing::Values(Expected{"hunter", 1000.0F, 6.05F, 8, 18, false},
                                         Expected{"hunter_hulls", 1000.0F, 6.05F, 8, 64, true},
                                         Expected{"fighter", 600.0F, 5.27F, 8, 22, false},
                                         Expected{"fighter_hulls", 600.0F, 5.27F, 8, 64, true}),
                         [](const auto& test) { return std::string(test.param.name); });

/// A point of the Hunter's gap between the prongs, and one in a prong.
TEST(Hunter, HasAGapBetweenItsProngsAtTheTwoFinerLevels) {
  const auto model = loadModel("hunter").value();
  const Vec3 gap(2.5F, -0.12F, 0.0F);
  const Vec3 prong(1.98F, -0.12F, 1.5F);
  for (int level = 1; level <= 3; ++level) {
    const auto& parts = model->levels->level(level).parts;
    const auto holds = [&](const Vec3& point) {
      return std::any_of(parts.begin(), parts.end(),
                         [&](const ConvexPart& part) { return isInBox(part, point); });
    };
    EXPECT_TRUE(holds(prong)) << "level " << level;
    EXPECT_EQ(holds(gap), level == 1) << "level " << level;
  }
}

TEST(ModelFiles, AreWhatTheirToolMakes) {
  const test::TemporaryFolder folder;
  const std::string command = "'" SCATTER_MAKE_MODELS "' '" + folder.path().string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  for (const char* name : {"hunter.dae", "fighter.dae", "table.dae", "chair.dae", "shelf.dae", "crate.dae",
                           "barrel.dae", "lamp.dae", "mug.dae"}) {
    const auto made = readFile(folder / name);
    const auto committed = readFile(std::string(SCATTER_TEST_MODEL_DIR "/") + name);
    ASSERT_TRUE(made.has_value() && committed.has_value());
    EXPECT_TRUE(*made == *committed) << name << " differs; run make_models on the models folder";
  }
}

TEST(ModelFiles, ToolReportsAFolderThatCannotBeWritten) {
  const int status = std::system("'" SCATTER_MAKE_MODELS "' /nowhere/at/all 2>/dev/null");
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

}  // namespace
}  // namespace scatter
