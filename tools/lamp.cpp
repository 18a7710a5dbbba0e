#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include "boxes.h"
#include "prop.h"

namespace scatter::tools {

Prop makeLamp() {
  Prop lamp("lamp", 9.0F);
  const glm::dvec3 up(0.0, 1.0, 0.0);
  const auto pole = [&](double y, double radius) { return polygonAcross(up, {0.0, y, 0.0}, 8, radius); };
  lamp.beginGroup();
  lamp.addFrustum(polygon(8, 0.30, 0.01), polygon(8, 0.30, 0.05));
  lamp.addFrustum(polygon(8, 0.26, 0.05), polygon(8, 0.06, 0.12));
  lamp.beginGroup();
  lamp.addLoft({pole(0.10, 0.035), pole(0.40, 0.03), pole(0.70, 0.03), pole(1.00, 0.03), pole(1.30, 0.03)});
  lamp.addBox({0.0, 1.32, 0.0}, {0.05, 0.05, 0.05});

  // The arm and what sticks out behind rise from the pole, so that nothing slides off either.
  const auto addArm = [&](const glm::dvec3& from, const glm::dvec3& to, int segments) {
    lamp.beginGroup(axesAlong(to - from, up));
    std::vector<Ring> rings;
    for (int i = 0; i <= segments; ++i) {
      const glm::dvec3 center = from + (to - from) * (static_cast<double>(i) / segments);
      rings.push_back(polygonAcross(to - from, center, 6, 0.025));
    }
    lamp.addLoft(rings);
  };
  addArm({0.0, 1.32, 0.0}, {0.55, 1.56, 0.0}, 3);
  addArm({0.0, 1.32, 0.0}, {-0.45, 1.56, 0.0}, 2);

  lamp.beginGroup();
  const glm::dvec3 head(0.55, 0.0, 0.0);
  const auto shade = [&](double y, double radius) {
    Ring ring = polygon(10, radius, y);
    for (glm::dvec3& point : ring) point += head;
    return ring;
  };
  const Ring outerLow = shade(1.22, 0.28);
  const Ring innerLow = shade(1.22, 0.25);
  const Ring outerHigh = shade(1.52, 0.13);
  const Ring innerHigh = shade(1.52, 0.10);
  for (std::size_t i = 0; i < outerLow.size(); ++i) {
    const std::size_t next = (i + 1) % outerLow.size();
    lamp.addFrustum({innerLow[i], outerLow[i], outerLow[next], innerLow[next]},
                    {innerHigh[i], outerHigh[i], outerHigh[next], innerHigh[next]});
  }
  lamp.addFrustum(shade(1.54, 0.12), shade(1.58, 0.10));
  lamp.addFrustum(shade(1.34, 0.05), shade(1.53, 0.04));
  return lamp;
}

}  // namespace scatter::tools
