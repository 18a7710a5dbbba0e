#include "ship.h"

namespace scatter::tools {
namespace {

Loft hull() {
  Loft loft;
  loft.exponent = 3.2;
  loft.sections = {{-2.40, 0.34, 0.18, 0.18}, {-2.10, 0.58, 0.31, 0.28}, {-1.60, 0.84, 0.41, 0.35},
                   {-1.00, 0.98, 0.45, 0.38}, {-0.35, 0.98, 0.43, 0.37}, {0.20, 0.84, 0.37, 0.33},
                   {0.65, 0.62, 0.28, 0.27},  {1.00, 0.42, 0.19, 0.21},  {1.20, 0.24, 0.10, 0.13}};
  loft.cuts = {{2, "hull"}, {3, "hull"}, {3, "hull"}};
  return loft;
}

/// A gun under the hull.
Loft keel() {
  Loft loft;
  loft.origin = {0.0, -0.38, 0.0};
  loft.exponent = 3.0;
  loft.sections = {{-1.20, 0.07, 0.10, 0.05}, {-0.85, 0.15, 0.18, 0.16}, {-0.10, 0.16, 0.18, 0.18},
                   {0.45, 0.12, 0.16, 0.14},  {0.60, 0.06, 0.06, 0.06},  {1.55, 0.05, 0.05, 0.05}};
  loft.cuts = {{5, "hull"}};
  return loft;
}

Loft bridge() {
  Loft loft;
  loft.origin = {0.0, 0.36, 0.0};
  loft.exponent = 2.8;
  loft.sections = {{-1.75, 0.16, 0.12, 0.10},
                   {-1.45, 0.32, 0.40, 0.10},
                   {-1.05, 0.36, 0.52, 0.10},
                   {-0.70, 0.33, 0.46, 0.10},
                   {-0.35, 0.24, 0.18, 0.10}};
  loft.cuts = {{4, "bridge"}};
  return loft;
}

Loft cockpit() {
  Loft loft;
  loft.origin = {0.0, 0.28, 0.0};
  loft.exponent = 2.2;
  loft.sections = {{-0.55, 0.26, 0.20, 0.10, 0.08},
                   {-0.15, 0.31, 0.28, 0.10, 0.04},
                   {0.35, 0.25, 0.20, 0.10, -0.02},
                   {0.80, 0.10, 0.05, 0.05, -0.06}};
  loft.cuts = {{3, "bridge"}};
  return loft;
}

Loft shoulder() {
  Loft loft;
  loft.origin = {-0.45, -0.02, 0.70};
  loft.direction = {0.10, -0.02, 1.0};
  loft.exponent = 2.6;
  loft.sections = {{0.0, 0.66, 0.20, 0.20}, {0.40, 0.54, 0.16, 0.16}, {0.85, 0.50, 0.13, 0.13}};
  loft.cuts = {{2, "shoulder"}};
  return loft;
}

/// Bends inward at its tip like a claw.
Loft prong() {
  Loft loft;
  loft.origin = {0.0, -0.03, 1.50};
  loft.exponent = 2.8;
  loft.sections = {{-1.25, 0.08, 0.10, 0.10, 0.0, -0.10},   {-1.05, 0.18, 0.20, 0.18, 0.0, -0.06},
                   {-0.60, 0.25, 0.26, 0.22, 0.0, 0.00},    {0.00, 0.26, 0.27, 0.22, 0.0, 0.04},
                   {0.40, 0.24, 0.25, 0.21, -0.01, 0.06},   {0.75, 0.22, 0.23, 0.20, -0.02, 0.06},
                   {1.10, 0.20, 0.21, 0.18, -0.03, 0.04},   {1.45, 0.18, 0.19, 0.17, -0.04, 0.00},
                   {1.80, 0.165, 0.17, 0.15, -0.05, -0.07}, {2.15, 0.145, 0.15, 0.13, -0.06, -0.17},
                   {2.45, 0.12, 0.12, 0.11, -0.07, -0.28},  {2.75, 0.085, 0.09, 0.08, -0.08, -0.42},
                   {3.05, 0.03, 0.03, 0.03, -0.09, -0.58}};
  loft.cuts = {{4, "shoulder"}, {4, "prong"}, {4, "prong"}};
  return loft;
}

/// A nacelle that ends in a flared nozzle.
Loft engine() {
  Loft loft;
  loft.origin = {0.0, 0.10, 0.76};
  loft.sections = {{-3.00, 0.31, 0.31, 0.31}, {-2.72, 0.24, 0.24, 0.24}, {-2.58, 0.33, 0.33, 0.33},
                   {-2.10, 0.38, 0.38, 0.38}, {-1.65, 0.36, 0.36, 0.36}, {-1.35, 0.28, 0.28, 0.28},
                   {-1.15, 0.14, 0.14, 0.14}};
  loft.cuts = {{6, "engine"}};
  return loft;
}

/// A third nozzle, in the middle.
Loft thruster() {
  Loft loft;
  loft.origin = {0.0, 0.02, 0.0};
  loft.sections = {{-2.85, 0.24, 0.24, 0.24}, {-2.62, 0.18, 0.18, 0.18}, {-2.30, 0.22, 0.22, 0.22}};
  loft.cuts = {{2, "hull"}};
  return loft;
}

Loft hunterFin() {
  Loft loft;
  loft.origin = {-1.62, 0.34, 0.0};
  loft.direction = {-0.75, 0.80, 0.0};
  loft.up = {0.0, 0.0, 1.0};
  loft.sections = {{0.0, 0.52, 0.07, 0.07}, {0.45, 0.36, 0.05, 0.05}, {0.90, 0.19, 0.03, 0.03}};
  loft.cuts = {{2, "bridge"}};
  return loft;
}

}  // namespace

Ship makeHunter() {
  Ship ship("hunter", 1000.0F, {-0.73, 0.055, 0.0});
  ship.add(hull());
  ship.add(keel());
  ship.add(bridge());
  ship.add(cockpit());
  ship.add(hunterFin());
  ship.add(thruster());
  ship.addPair(shoulder());
  ship.addPair(prong());
  ship.addPair(engine());
  ship.alignGroup("prong", {2.30, -0.08, -0.50});
  return ship;
}

}  // namespace scatter::tools
