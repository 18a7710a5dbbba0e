#pragma once

#include <scatter/levels/level_set.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <string>
#include <vector>

namespace scatter::bench {

/// A mesh decomposed into convex parts by somebody else.
struct Decomposition {
  Level level;
  int flatParts = 0;     ///< Left out because they have no volume.
  double seconds = 0.0;  ///< Processor time.
};

/// Fails if no hull has a volume.
[[nodiscard]] Result<Decomposition> decompositionOf(std::vector<ConvexHull> hulls, double seconds);

/// What is asked of a decomposition.
struct DecompositionDef {
  int parts = 64;
  int maxVertices = 0;  ///< Of a hull; 0: as many as it has.
  int limitSeconds = 120;
};

/// By HACD (hierarchical approximate convex decomposition) of Bullet's extras, other settings as in Bullet's
/// own example. Fails if it takes longer or crashes, and if this was built without it.
[[nodiscard]] Result<Decomposition> decomposeByHacd(const SurfaceMesh& mesh,
                                                    const DecompositionDef& definition);

/// By a program that is installed: `command` is run by the shell in an empty folder, with {mesh} (an .obj
/// file) and {parts} filled in, and leaves hulls in {hulls}, an .obj file with an object for
/// each. Fails with what is wrong if it leaves none, or takes longer.
[[nodiscard]] Result<Decomposition> decomposeByProgram(const std::string& command, const SurfaceMesh& mesh,
                                                       const DecompositionDef& definition);

}  // namespace scatter::bench
