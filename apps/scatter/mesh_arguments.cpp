#include "mesh_arguments.h"

#include <CLI/CLI.hpp>

namespace scatter::app {

void addMeshArguments(CLI::App& command, MeshArguments& arguments) {
  command
      .add_option(
          "--unit", arguments.unit,
          "Length of the mesh file's unit: metres, or m, cm, mm, km, in, ft [what the file says, else m]")
      ->type_name("LENGTH");
  command
      .add_option(
          "--up", arguments.up,
          "Axis that points up, of files that do not say it (all but dae, gltf, glb, fbx): x, y or z [y]")
      ->type_name("AXIS");
}

Result<MeshFile> readMesh(const std::string& path, const MeshArguments& arguments) {
  MeshOptions options;
  if (!arguments.unit.empty()) {
    const Result<double> unit = parseUnit(arguments.unit);
    if (!unit) return fail("--unit: " + unit.error().message);
    options.unit = *unit;
  }
  if (arguments.up == "x") {
    options.up = UpAxis::kX;
  } else if (arguments.up == "z") {
    options.up = UpAxis::kZ;
  } else if (!arguments.up.empty() && arguments.up != "y") {
    return fail("--up: \"" + arguments.up + "\" is no axis; give x, y or z");
  }
  return scatter::readMesh(path, options);
}

}  // namespace scatter::app
