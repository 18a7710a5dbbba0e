#include <gmock/gmock.h>
#include <scatter/io/file.h>
#include <scatter/io/level_export.h>

#include <array>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "io/temporary_folder.h"
#include "levels/part_builders.h"
#include "levels/part_geometry.h"

namespace scatter {
namespace {

/// As the files have it: y becomes z.
glm::dvec3 upright(const glm::dvec3& v) {
  return {v.x, -v.z, v.y};
}

Quat someTurn(float angle, const Vec3& axis) {
  return glm::angleAxis(angle, glm::normalize(axis));
}

/// A part of each kind, turned and moved.
Level everyKind() {
  ConvexHull hull{{{0, 0, 0}, {0.5F, 0, 0}, {0, 0.7F, 0}, {0, 0, 0.9F}, {0.3F, 0.4F, 0.5F}}};
  return {{{Box{{0.2F, 0.3F, 0.4F}}, {{1.0F, 0.5F, -0.3F}, someTurn(0.7F, {1, 2, 3})}},
           {Sphere{0.3F}, {{-1.0F, 0.2F, 0.4F}, kNoRotation}},
           {Capsule{0.1F, 0.4F}, {{0.0F, 1.0F, 0.2F}, someTurn(1.9F, {-1, 0.3F, 0.5F})}},
           {Cylinder{0.2F, 0.3F}, {{0.3F, -1.0F, 0.6F}, someTurn(-1.1F, {0.2F, 1, 0.4F})}},
           {std::move(hull), {{0.0F, 0.1F, 1.0F}, someTurn(2.4F, {1, -1, 0.2F})}}}};
}

Model modelOf(Level level) {
  LevelSetDef definition;
  definition.name = "every kind";
  definition.hullMargin = 0.0F;
  definition.levels = {{{{Box{{3.0F, 3.0F, 3.0F}}, {}}}}, std::move(level)};
  auto levels = LevelSet::create(std::move(definition));
  EXPECT_TRUE(levels.has_value()) << (levels ? "" : levels.error().message);
  Model model;
  model.name = "every kind";
  model.levels = levels.value_or(nullptr);
  model.mass = 12.0F;
  model.friction = 0.7F;
  model.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  return model;
}

std::vector<double> numbersIn(const char* text) {
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;) numbers.push_back(number);
  return numbers;
}

glm::dvec3 vectorIn(const pugi::xml_attribute& attribute) {
  const std::vector<double> n = numbersIn(attribute.value());
  return n.size() == 3 ? glm::dvec3(n[0], n[1], n[2]) : glm::dvec3(1e9);
}

struct Placed {
  glm::dvec3 position{0.0};
  glm::dmat3 turn{1.0};
};

/// How far a shape whose axis is z reaches along a direction in its own frame.
double reachOfRound(double radius, double halfHeight, const glm::dvec3& d, bool hasRoundEnds) {
  const double up = halfHeight * std::abs(d.z);
  return up + radius * (hasRoundEnds ? 1.0 : std::hypot(d.x, d.y));
}

class LevelExport : public ::testing::Test {
 protected:
  pugi::xml_document load(const char* name) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_file((folder_ / name).c_str()));
    return document;
  }

  /// Compares how far what was written reaches with the parts, in many directions.
  template <class Reach>
  void expectSameReach(const Reach& reach) {
    scatter::testing::Random random(11);
    for (std::size_t part = 0; part < model_.levels->finest().parts.size(); ++part) {
      for (int i = 0; i < 60; ++i) {
        const glm::dvec3 direction(random.direction());
        const double expected = levels::support(model_.levels->finest().parts[part], 0.0, direction);
        EXPECT_NEAR(reach(part, upright(direction)), expected, 1e-5) << "part " << part + 1;
      }
    }
  }

  Model model_ = modelOf(everyKind());
  test::TemporaryFolder folder_;
};

TEST_F(LevelExport, ObjHasAnObjectForEachPart) {
  ASSERT_TRUE(writeObj(model_, 2, folder_ / "kinds.obj"));
  std::istringstream text(readFile(folder_ / "kinds.obj").value_or(""));
  std::vector<std::string> names;
  std::vector<glm::dvec3> vertices;
  std::vector<double> volumes;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line.substr(std::min<std::size_t>(line.size(), 2)));
    if (line.starts_with("o ")) {
      names.push_back(line.substr(2));
      volumes.push_back(0.0);
    } else if (line.starts_with("v ")) {
      glm::dvec3 v;
      words >> v.x >> v.y >> v.z;
      vertices.push_back(v);
    } else if (line.starts_with("f ")) {
      std::array<std::size_t, 3> f{};
      words >> f[0] >> f[1] >> f[2];
      ASSERT_LE(f[2], vertices.size());
      volumes.back() +=
          glm::dot(vertices[f[0] - 1], glm::cross(vertices[f[1] - 1], vertices[f[2] - 1])) / 6.0;
    }
  }
  ASSERT_EQ(names.size(), 5U);
  EXPECT_EQ(names[0], "every_kind_level2_part1");
  EXPECT_NEAR(volumes[0], 0.4 * 0.6 * 0.8, 1e-5);
  // Around the round ones, so no smaller, and hardly larger.
  const double ball = 4.0 / 3.0 * glm::pi<double>() * 0.027;
  EXPECT_GT(volumes[1], ball);
  EXPECT_LT(volumes[1], 1.03 * ball);
  EXPECT_GT(volumes[4], 0.0);
}

TEST_F(LevelExport, MjcfHasTheSameShapesAndMass) {
  ASSERT_TRUE(writeMjcf(model_, 2, folder_ / "kinds.xml"));
  const pugi::xml_document document = load("kinds.xml");
  const pugi::xml_node body = document.child("mujoco").child("worldbody").child("body");
  ASSERT_TRUE(body.child("freejoint"));
  std::vector<pugi::xml_node> geoms;
  for (const pugi::xml_node geom : body.children("geom")) geoms.push_back(geom);
  ASSERT_EQ(geoms.size(), 5U);
  expectSameReach([&](std::size_t part, const glm::dvec3& direction) {
    const pugi::xml_node geom = geoms[part];
    const std::vector<double> q = numbersIn(geom.attribute("quat").value());
    const std::vector<double> size = numbersIn(geom.attribute("size").value());
    const glm::dmat3 turn(glm::dquat(q.at(0), q.at(1), q.at(2), q.at(3)));
    const glm::dvec3 local = direction * turn;
    const std::string type = geom.attribute("type").value();
    double reach = -1e9;
    if (type == "box") {
      reach =
          size.at(0) * std::abs(local.x) + size.at(1) * std::abs(local.y) + size.at(2) * std::abs(local.z);
    } else if (type == "sphere") {
      reach = size.at(0);
    } else if (type == "capsule" || type == "cylinder") {
      reach = reachOfRound(size.at(0), size.at(1), local, type == "capsule");
    } else {
      const pugi::xml_node mesh = document.child("mujoco").child("asset").find_child_by_attribute(
          "mesh", "name", geom.attribute("mesh").value());
      const std::vector<double> n = numbersIn(mesh.attribute("vertex").value());
      for (std::size_t i = 0; i + 2 < n.size(); i += 3) {
        reach = std::max(reach, glm::dot(local, glm::dvec3(n[i], n[i + 1], n[i + 2])));
      }
    }
    return reach + glm::dot(direction, vectorIn(geom.attribute("pos")));
  });
  const pugi::xml_node inertial = body.child("inertial");
  EXPECT_EQ(inertial.attribute("mass").as_double(), 12.0);
  const MassProperties& mass = model_.levels->mass();
  EXPECT_LT(glm::length(vectorIn(inertial.attribute("pos")) - upright(glm::dvec3(mass.centerOfMass))), 1e-5);
  const std::vector<double> full = numbersIn(inertial.attribute("fullinertia").value());
  ASSERT_EQ(full.size(), 6U);
  const glm::dmat3 own(mass.inertia);
  // About z, x, and the product of x and the old -z.
  EXPECT_NEAR(full[2], 12.0 * own[1][1], 1e-4);
  EXPECT_NEAR(full[0], 12.0 * own[0][0], 1e-4);
  EXPECT_NEAR(full[3], -12.0 * own[0][2], 1e-4);
}

TEST_F(LevelExport, UrdfHasTheSameShapesAndItsMeshes) {
  ASSERT_TRUE(writeUrdf(model_, 2, folder_ / "kinds.urdf"));
  const pugi::xml_document document = load("kinds.urdf");
  const pugi::xml_node link = document.child("robot").child("link");
  EXPECT_STREQ(link.child("visual").child("geometry").child("mesh").attribute("filename").value(),
               "kinds_meshes/visual.obj");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "kinds_meshes" / "visual.obj"));
  std::vector<pugi::xml_node> collisions;
  for (const pugi::xml_node collision : link.children("collision")) collisions.push_back(collision);
  // The capsule is three of them.
  ASSERT_EQ(collisions.size(), 7U);
  const auto reachOf = [&](const pugi::xml_node& collision, const glm::dvec3& direction) {
    const glm::dvec3 rpy = vectorIn(collision.child("origin").attribute("rpy"));
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), rpy.z, {0, 0, 1}) *
                            glm::rotate(glm::dmat4(1.0), rpy.y, {0, 1, 0}) *
                            glm::rotate(glm::dmat4(1.0), rpy.x, {1, 0, 0});
    const glm::dvec3 local = direction * glm::dmat3(turn);
    const pugi::xml_node shape = collision.child("geometry").first_child();
    const std::string kind = shape.name();
    double reach = -1e9;
    if (kind == "box") {
      reach = 0.5 * glm::dot(vectorIn(shape.attribute("size")), glm::abs(local));
    } else if (kind == "mesh") {
      std::istringstream text(readFile(folder_ / shape.attribute("filename").value()).value_or(""));
      for (std::string line; std::getline(text, line);) {
        if (!line.starts_with("v ")) continue;
        const std::vector<double> n = numbersIn(line.c_str() + 2);
        reach = std::max(reach, glm::dot(local, glm::dvec3(n.at(0), n.at(1), n.at(2))));
      }
    } else {
      reach = reachOfRound(shape.attribute("radius").as_double(), 0.5 * shape.attribute("length").as_double(),
                           local, kind == "sphere");
    }
    return reach + glm::dot(direction, vectorIn(collision.child("origin").attribute("xyz")));
  };
  constexpr std::array<std::pair<std::size_t, std::size_t>, 5> kElements{
      {{0, 1}, {1, 2}, {2, 5}, {5, 6}, {6, 7}}};
  expectSameReach([&](std::size_t part, const glm::dvec3& direction) {
    double reach = -1e9;
    for (std::size_t i = kElements[part].first; i < kElements[part].second; ++i) {
      reach = std::max(reach, reachOf(collisions[i], direction));
    }
    return reach;
  });
  EXPECT_NEAR(link.child("inertial").child("inertia").attribute("izz").as_double(),
              12.0 * static_cast<double>(model_.levels->mass().inertia[1][1]), 1e-4);
}

TEST_F(LevelExport, ALevelThatIsNotThereIsRefused) {
  for (const auto write : {writeObj, writeUrdf, writeMjcf}) {
    const auto written = write(model_, 3, folder_ / "none.obj");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, "\"every kind\" has levels 1 to 2, and none 3");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "none.obj"));
  }
}

}  // namespace
}  // namespace scatter
