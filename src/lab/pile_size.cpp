#include "lab/pile_size.h"

#include <scatter/lab/summary.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace scatter::lab {

namespace {

double meanHeight(const World& world) {
  double sum = 0.0;
  int count = 0;
  for (const auto& object : world.objects()) {
    if (object->def().motion != Motion::kDynamic) continue;
    sum += static_cast<double>(object->state().centerOfMass.y);
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace

PileSize pileSize(const World& world) {
  std::vector<glm::dvec3> centers;
  glm::dvec3 mean(0.0);
  for (const auto& object : world.objects()) {
    if (dynamic_cast<const HybridObject*>(object.get()) != nullptr) {
      centers.emplace_back(object->state().centerOfMass);
      mean += centers.back();
    }
  }
  const double height = meanHeight(world);
  if (centers.empty()) {
    return {.meanHeight = height};
  }
  mean /= static_cast<double>(centers.size());
  std::vector<double> distances;
  double squares = 0.0;
  for (const glm::dvec3& center : centers) {
    distances.push_back(glm::length(center - mean));
    squares += distances.back() * distances.back();
  }
  return {.radius = std::sqrt(squares / static_cast<double>(centers.size())),
          .medianDistance = medianOf(std::move(distances)),
          .meanHeight = height};
}

}  // namespace scatter::lab
