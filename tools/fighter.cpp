#include "ship.h"

namespace scatter::tools {
namespace {

Loft fuselage() {
  Loft loft;
  loft.exponent = 2.5;
  loft.sections = {{-2.00, 0.25, 0.23, 0.22}, {-1.70, 0.31, 0.28, 0.25}, {-1.35, 0.35, 0.31, 0.27},
                   {-1.00, 0.38, 0.33, 0.28}, {-0.60, 0.40, 0.34, 0.29}, {-0.20, 0.40, 0.34, 0.29},
                   {0.20, 0.39, 0.33, 0.28},  {0.55, 0.37, 0.31, 0.27},  {0.85, 0.34, 0.29, 0.25},
                   {1.10, 0.31, 0.26, 0.23},  {1.35, 0.27, 0.22, 0.20},  {1.60, 0.225, 0.18, 0.17},
                   {1.85, 0.18, 0.14, 0.14},  {2.10, 0.135, 0.10, 0.11}, {2.30, 0.095, 0.07, 0.08},
                   {2.46, 0.055, 0.04, 0.05}};
  loft.cuts = {{3, "rear"}, {3, "body"}, {3, "body"}, {3, "nose"}, {3, "nose"}};
  return loft;
}

Loft needle() {
  Loft loft;
  loft.sections = {{2.40, 0.035, 0.035, 0.035}, {2.60, 0.028, 0.028, 0.028}, {2.85, 0.014, 0.014, 0.014}};
  loft.cuts = {{2, "nose"}};
  return loft;
}

Loft canopy() {
  Loft loft;
  loft.sections = {{-0.65, 0.08, 0.05, 0.05, 0.31},
                   {-0.25, 0.20, 0.20, 0.08, 0.30},
                   {0.20, 0.245, 0.27, 0.08, 0.28},
                   {0.65, 0.215, 0.20, 0.08, 0.25},
                   {1.15, 0.10, 0.05, 0.05, 0.22}};
  loft.cuts = {{4, "body"}};
  return loft;
}

Loft intake() {
  Loft loft;
  loft.origin = {0.0, -0.02, 0.42};
  loft.exponent = 4.0;
  loft.sections = {{-1.25, 0.06, 0.12, 0.12, 0.0, -0.06},
                   {-0.80, 0.15, 0.20, 0.19},
                   {-0.10, 0.18, 0.23, 0.21},
                   {0.40, 0.16, 0.21, 0.19, 0.0, 0.01}};
  loft.cuts = {{3, "body"}};
  return loft;
}

Loft nozzle() {
  Loft loft;
  loft.sections = {{-2.42, 0.19, 0.19, 0.19},
                   {-2.28, 0.24, 0.24, 0.24},
                   {-2.10, 0.26, 0.26, 0.26},
                   {-1.92, 0.22, 0.22, 0.22}};
  loft.cuts = {{3, "rear"}};
  return loft;
}

Loft wing() {
  Loft loft;
  loft.origin = {-0.18, -0.06, 0.28};
  loft.direction = {-0.62, -0.05, 1.0};
  for (int i = 0; i <= 9; ++i) {
    const double along = i / 9.0;
    const double halfThickness = 0.065 - 0.035 * along;
    loft.sections.push_back({1.55 * along, 0.66 - 0.45 * along, halfThickness, halfThickness});
  }
  loft.cuts = {{3, "wing"}, {3, "wing"}, {3, "wing"}};
  return loft;
}

/// A gun at the tip of a wing.
Loft pod() {
  Loft loft;
  loft.origin = {-0.97, -0.126, 1.61};
  loft.sections = {{-0.50, 0.05, 0.05, 0.05},
                   {-0.30, 0.085, 0.085, 0.085},
                   {0.30, 0.075, 0.075, 0.075},
                   {0.95, 0.022, 0.022, 0.022}};
  loft.cuts = {{3, "wing"}};
  return loft;
}

Loft stabiliser() {
  Loft loft;
  loft.origin = {-1.72, 0.02, 0.22};
  loft.direction = {-0.55, 0.16, 1.0};
  loft.sections = {{0.0, 0.32, 0.05, 0.05},
                   {0.28, 0.26, 0.042, 0.042},
                   {0.55, 0.20, 0.034, 0.034},
                   {0.82, 0.13, 0.025, 0.025}};
  loft.cuts = {{3, "stabiliser"}};
  return loft;
}

Loft fighterFin() {
  Loft loft;
  loft.origin = {-1.45, 0.22, 0.0};
  loft.direction = {-0.62, 1.0, 0.0};
  loft.up = {0.0, 0.0, 1.0};
  loft.sections = {{0.0, 0.46, 0.055, 0.055},
                   {0.25, 0.38, 0.048, 0.048},
                   {0.50, 0.30, 0.041, 0.041},
                   {0.75, 0.22, 0.034, 0.034},
                   {1.0, 0.14, 0.025, 0.025}};
  loft.cuts = {{2, "fighterFin"}, {2, "fighterFin"}};
  return loft;
}

}  // namespace

Ship makeFighter() {
  Ship ship("fighter", 600.0F, {-0.355, 0.04, 0.0});
  ship.add(fuselage());
  ship.add(needle());
  ship.add(canopy());
  ship.addPair(intake(), {"body"});
  ship.add(nozzle());
  ship.addPair(wing());
  ship.addPair(pod());
  ship.addPair(stabiliser());
  ship.add(fighterFin());
  return ship;
}

}  // namespace scatter::tools
