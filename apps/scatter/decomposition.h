#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <string>

namespace scatter::app {

/// A mesh decomposed into convex parts by somebody else.
struct Decomposition {
  Level level;
  double seconds = 0.0;  ///< Processor time.
};

/// What is asked of a decomposition.
struct DecompositionDef {
  std::string command;  ///< For the shell; see decompose().
  int parts = 64;
  int maxVertices = 0;  ///< Of a hull; 0: as many as it has.
  int limitSeconds = 120;
};

/// By a program that is installed: the command is run by the shell in an empty folder, with {mesh} (an .obj
/// file), {parts} and {vertices} filled in, and leaves hulls in {hulls}, an .obj file with an object for
/// each. Those that are boxes become boxes, and those without a volume are left out. Fails with what is wrong
/// if it leaves no other, or takes longer.
[[nodiscard]] Result<Decomposition> decompose(const SurfaceMesh& mesh, const DecompositionDef& definition);

}  // namespace scatter::app
