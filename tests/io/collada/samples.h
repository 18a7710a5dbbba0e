#pragma once

#include <scatter/io/physics_document.h>

#include <string>
#include <vector>

namespace scatter::test {

/// Parts of a COLLADA file with a physics scene; a test replaces those that it is about. Without changes it
/// holds one box of half extents 1 2 3 and 5 kg, at (1, 2, 3).
struct SceneFile {
  std::string version = "1.4.1";
  std::string asset = "<up_axis>Y_UP</up_axis>";
  std::string libraries;
  std::string common = "<mass>5</mass><shape><box><half_extents>1 2 3</half_extents></box></shape>";
  std::string models;  ///< After the rigid body of the first physics model, whose id is "m" and sid "b".
  std::string nodes = "<node id=\"n\" name=\"thing\"><translate>1 2 3</translate></node>";
  std::string instances =
      "<instance_physics_model url=\"#m\">"
      "<instance_rigid_body body=\"b\" target=\"#n\"/></instance_physics_model>";
  std::string world;  ///< In the physics scene's technique_common.
  std::string scene =
      "<scene><instance_physics_scene url=\"#s\"/><instance_visual_scene url=\"#v\"/></scene>";

  [[nodiscard]] std::string text() const;
};

/// A file as an exporter writes it.
struct Sample {
  std::string name;
  std::string text;
};

/// Small scenes in the manner of several exporters, with what each gets wrong.
[[nodiscard]] std::vector<Sample> exporterSamples();
[[nodiscard]] std::string exporterSample(const std::string& name);

/// Reads a text that must be readable, as "test.dae".
[[nodiscard]] PhysicsDocument parsed(const std::string& text);

void expectNear(const Vec3& actual, const Vec3& expected, float tolerance = 1e-5F);

}  // namespace scatter::test
