#include <scatter/levels/containment.h>

namespace scatter {

Result<std::optional<ContainmentGap>> findContainmentGap(const Level&, const Level&, float, float) {
  return std::optional<ContainmentGap>{};
}

}  // namespace scatter
