#include "lab/pile_size.h"

#include <scatter/lab/summary.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace scatter::lab {

PileSize pileSize(const World& world) {
  std::vector<glm::dvec3> centers;
  glm::dvec3 mean(0.0);
  for (const auto& object : world.objects()) {
    if (dynamic_cast<const HybridObject*>(object.get()) != nullptr) {
      centers.emplace_back(object->state().centerOfMass);
      mean += centers.back();
    }
  }
  if (centers.empty()) {
    return {};
  }
  mean /= static_cast<double>(centers.size());
  std::vector<double> distances;
  double squares = 0.0;
  for (const glm::dvec3& center : centers) {
    distances.push_back(glm::length(center - mean));
    squares += distances.back() * distances.back();
  }
  return {.radius = std::sqrt(squares / static_cast<double>(centers.size())),
          .medianDistance = medianOf(std::move(distances))};
}

}  // namespace scatter::lab
