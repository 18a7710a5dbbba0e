#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "prop.h"

namespace scatter::tools {
namespace {

/// A turned leg of three segments that ends a little below its top.
void addLeg(Prop& prop, double x, double z, double top, double thickness) {
  prop.addLoft({polygonAcross({0.0, 1.0, 0.0}, {x, 0.01, z}, 6, 0.55 * thickness),
                polygonAcross({0.0, 1.0, 0.0}, {x, 0.35 * top, z}, 6, thickness),
                polygonAcross({0.0, 1.0, 0.0}, {x, 0.65 * top, z}, 6, 0.7 * thickness),
                polygonAcross({0.0, 1.0, 0.0}, {x, top, z}, 6, thickness)});
}

}  // namespace

Prop makeTable() {
  Prop table("table", 25.0F);
  const glm::dvec2 leg(0.70, 0.32);
  table.beginGroup();
  for (int i = 0; i < 6; ++i) table.addBox({0.0, 0.74, -0.345 + 0.138 * i}, {0.80, 0.02, 0.067});
  table.beginGroup();
  for (const double side : {-1.0, 1.0}) table.addBox({0.0, 0.67, side * leg.y}, {leg.x - 0.05, 0.05, 0.015});
  for (const double side : {-1.0, 1.0}) table.addBox({side * leg.x, 0.67, 0.0}, {0.015, 0.05, leg.y - 0.05});
  for (const double x : {-leg.x, leg.x}) {
    for (const double z : {-leg.y, leg.y}) {
      table.beginGroup();
      addLeg(table, x, z, 0.71, 0.045);
    }
  }
  table.beginGroup();
  for (const double side : {-1.0, 1.0}) table.addBox({side * leg.x, 0.16, 0.0}, {0.02, 0.025, leg.y - 0.03});
  table.addBox({0.0, 0.16, 0.0}, {leg.x - 0.02, 0.025, 0.02});
  return table;
}

Prop makeChair() {
  Prop chair("chair", 7.0F);
  constexpr double kHalf = 0.20;
  chair.beginGroup();
  for (int i = 0; i < 4; ++i) chair.addBox({-0.165 + 0.11 * i, 0.46, 0.0}, {0.053, 0.02, 0.22});
  for (const double x : {-kHalf, kHalf}) {
    for (const double z : {-kHalf, kHalf}) {
      chair.beginGroup();
      addLeg(chair, x, z, 0.43, 0.03);
    }
  }
  chair.beginGroup();
  for (const double z : {-kHalf, kHalf}) {
    chair.addBar({-kHalf, 0.48, z}, {-kHalf - 0.04, 0.74, z}, 0.02, 0.02);
    chair.addBar({-kHalf - 0.04, 0.74, z}, {-kHalf - 0.10, 1.0, z}, 0.02, 0.02);
  }
  chair.addBar({-kHalf - 0.09, 0.97, -kHalf}, {-kHalf - 0.09, 0.97, kHalf}, 0.015, 0.04);
  for (int i = 0; i < 4; ++i) {
    const double z = -0.12 + 0.08 * i;
    chair.addBar({-kHalf, 0.48, z}, {-kHalf - 0.08, 0.94, z}, 0.015, 0.01);
  }
  chair.beginGroup();
  for (const double side : {-kHalf, kHalf}) {
    chair.addBox({0.0, 0.20, side}, {kHalf, 0.015, 0.015});
    chair.addBox({side, 0.15, 0.0}, {0.015, 0.015, kHalf});
  }
  return chair;
}

Prop makeShelf() {
  Prop shelf("shelf", 45.0F);
  constexpr double kHalfWidth = 0.45;
  constexpr double kHalfDepth = 0.16;
  for (const double side : {-1.0, 1.0}) {
    shelf.beginGroup();
    for (int i = 0; i < 3; ++i)
      shelf.addBox({side * kHalfWidth, 0.30 + 0.6 * i, 0.0}, {0.02, 0.298, kHalfDepth});
  }
  shelf.beginGroup();
  for (int i = 0; i < 4; ++i) shelf.addBox({-0.318 + 0.212 * i, 0.9, -kHalfDepth}, {0.104, 0.88, 0.012});
  for (int board = 0; board < 5; ++board) {
    const double y = 0.06 + 0.425 * board;
    shelf.beginGroup();
    shelf.addBox({0.0, y, -0.07}, {kHalfWidth - 0.03, 0.018, 0.07});
    shelf.addBox({0.0, y, 0.08}, {kHalfWidth - 0.03, 0.018, 0.07});
    if (board == 4) break;
    // Books, some of them fallen to a slant.
    for (int book = 0; book < 4; ++book) {
      const double x = -0.36 + 0.17 * book + 0.03 * board;
      const double height = 0.22 + 0.03 * ((book + board) % 3);
      const double lean = book == 3 ? 0.08 : 0.0;
      shelf.addBar({x, y + 0.035, 0.0}, {x - lean, y + 0.035 + height, 0.0}, 0.11, 0.03);
    }
  }
  return shelf;
}

Prop makeCrate() {
  Prop crate("crate", 30.0F);
  constexpr double kHalf = 0.40;
  constexpr double kBeam = 0.035;
  constexpr double kMiddle = kHalf - kBeam;
  for (const double side : {-1.0, 1.0}) {
    const double height = kHalf + side * kMiddle;
    crate.beginGroup();
    for (const double z : {-kMiddle, kMiddle}) crate.addBox({0.0, height, z}, {kHalf, kBeam, kBeam});
    for (const double x : {-kMiddle, kMiddle})
      crate.addBox({x, height, 0.0}, {kBeam, kBeam, kMiddle - kBeam});
    for (int i = 0; i < 3; ++i)
      crate.addBox({-0.22 + 0.22 * i, height, 0.0}, {0.105, 0.015, kMiddle - kBeam});
  }
  for (const double side : {-1.0, 1.0}) {
    crate.beginGroup();
    for (const double x : {-kMiddle, kMiddle}) {
      crate.addBox({x, kHalf, side * kMiddle}, {kBeam, kMiddle - kBeam, kBeam});
    }
    for (int i = 0; i < 3; ++i) {
      crate.addBox({0.0, kHalf - 0.22 + 0.22 * i, side * kMiddle}, {kMiddle - kBeam, 0.105, 0.015});
    }
    crate.addBar({-0.31, kHalf - 0.31, side * (kMiddle + 0.02)},
                 {0.31, kHalf + 0.31, side * (kMiddle + 0.02)}, 0.012, 0.04);
  }
  for (const double side : {-1.0, 1.0}) {
    crate.beginGroup();
    for (int i = 0; i < 3; ++i) {
      crate.addBox({side * kMiddle, kHalf - 0.22 + 0.22 * i, 0.0}, {0.015, 0.105, kMiddle - kBeam});
    }
    crate.addBar({side * (kMiddle + 0.02), kHalf - 0.31, -0.31},
                 {side * (kMiddle + 0.02), kHalf + 0.31, 0.31}, 0.012, 0.04);
  }
  return crate;
}

}  // namespace scatter::tools
