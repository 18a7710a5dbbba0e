#include "levels/build/place_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>

namespace scatter::levels {
namespace {

/// Below these, planes that meet say too little about where: the squared sine of two, the determinant of
/// three.
constexpr double kLeastSquaredSine = 1e-8;
constexpr double kLeastDeterminant = 1e-5;

class PlaceSearch {
 public:
  PlaceSearch(std::span<const HalfSpace> planes, const glm::dvec3& gradient, const glm::dvec3& middle,
              double epsilon)
      : planes_(planes), gradient_(gradient), middle_(middle), epsilon_(epsilon) {}

  Places run() {
    const std::size_t count = planes_.size();
    tryNearest(middle_);
    for (std::size_t i = 0; i < count; ++i) {
      tryNearest(middle_ - planes_[i].normal * planes_[i].signedDistance(middle_));
      for (std::size_t j = i + 1; j < count; ++j) {
        const glm::dvec3 along = glm::cross(planes_[i].normal, planes_[j].normal);
        if (glm::dot(along, along) < kLeastSquaredSine) continue;
        tryNearest(nearestOnEdge(planes_[i], planes_[j]));
        for (std::size_t k = j + 1; k < count; ++k) tryCorner(i, j, k, along);
      }
    }
    return places_;
  }

 private:
  [[nodiscard]] glm::dvec3 nearestOnEdge(const HalfSpace& a, const HalfSpace& b) const {
    const double toA = -a.signedDistance(middle_);
    const double toB = -b.signedDistance(middle_);
    const double cosine = glm::dot(a.normal, b.normal);
    const double scale = 1.0 / (1.0 - cosine * cosine);
    return middle_ + scale * ((toA - cosine * toB) * a.normal + (toB - cosine * toA) * b.normal);
  }

  void tryCorner(std::size_t i, std::size_t j, std::size_t k, const glm::dvec3& along) {
    const HalfSpace& a = planes_[i];
    const HalfSpace& b = planes_[j];
    const HalfSpace& c = planes_[k];
    const double determinant = glm::dot(along, c.normal);
    if (std::abs(determinant) < kLeastDeterminant) return;
    const glm::dvec3 corner = (glm::cross(b.normal, c.normal) * a.offset +
                               glm::cross(c.normal, a.normal) * b.offset + along * c.offset) /
                              determinant;
    const double volume = glm::dot(gradient_, corner);
    if (volume < leastVolume_ && isBeyond(corner)) {
      leastVolume_ = volume;
      places_.leastVolume = corner;
    }
    tryNearest(corner);
  }

  void tryNearest(const glm::dvec3& point) {
    const double distance = glm::dot(point - middle_, point - middle_);
    if (distance < leastDistance_ && isBeyond(point)) {
      leastDistance_ = distance;
      places_.nearest = point;
    }
  }

  [[nodiscard]] bool isBeyond(const glm::dvec3& point) const {
    return std::all_of(planes_.begin(), planes_.end(),
                       [&](const HalfSpace& plane) { return plane.signedDistance(point) >= -epsilon_; });
  }

  std::span<const HalfSpace> planes_;
  glm::dvec3 gradient_;
  glm::dvec3 middle_;
  double epsilon_;
  double leastVolume_ = std::numeric_limits<double>::infinity();
  double leastDistance_ = std::numeric_limits<double>::infinity();
  Places places_;
};

}  // namespace

Places findPlaces(std::span<const HalfSpace> planes, const glm::dvec3& gradient, const glm::dvec3& middle,
                  double epsilon) {
  return PlaceSearch(planes, gradient, middle, epsilon).run();
}

}  // namespace scatter::levels
