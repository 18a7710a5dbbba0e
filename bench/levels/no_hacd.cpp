#include "parts.h"

namespace scatter::bench {

Result<Decomposition> decomposeByHacd(const SurfaceMesh& /*mesh*/, const DecompositionDef& /*definition*/) {
  return fail("HACD is not in this build; install libbullet-extras-dev and configure again");
}

}  // namespace scatter::bench
