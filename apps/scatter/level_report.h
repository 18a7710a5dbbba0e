#pragma once

#include <scatter/levels/level_check.h>
#include <scatter/levels/level_symmetry.h>
#include <scatter/levels/measure_levels.h>

#include <string>
#include <vector>

#include "level_file.h"

namespace scatter::app {

/// A line for each thing that was checked, and where it fails, by how much.
[[nodiscard]] std::string describe(const LevelCheck& check, int levels);

/// What the figures are about, in a line.
[[nodiscard]] std::string describeMesh(const LevelModel& model, const LevelMeasures& measures);

/// Volume, centre of mass and inertia, in a line, and whose they are.
[[nodiscard]] std::string describeMass(const LevelModel& model, const LevelMeasures& measures);

/// "the plane x = 0".
[[nodiscard]] std::string describe(const SymmetryPlane& plane);

/// How levels are symmetric, in a line; nothing if they are not.
[[nodiscard]] std::string describeSymmetry(const LevelSet& levels);

/// The figures of each level, coarsest first.
[[nodiscard]] std::string formatFigures(const LevelMeasures& measures);

/// The gaps in each of the regions that were measured, and outside of them; nothing without regions.
[[nodiscard]] std::string formatRegions(const LevelMeasures& measures,
                                        const std::vector<MeshRegion>& regions);

/// The same and more, for programs.
[[nodiscard]] std::string figuresJson(const std::vector<LevelModel>& models,
                                      const std::vector<LevelMeasures>& measures,
                                      const std::vector<MeshRegion>& regions);

/// "0.42 mm" or "1.3 m": the unit in which a length reads best; less than a nanometre is 0.
[[nodiscard]] std::string lengthText(double metres);

}  // namespace scatter::app
