#include "level_report.h"

#include <scatter/levels/mass_properties.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>

#include "lab/text_table.h"

namespace scatter::app {

namespace {

using Cells = std::vector<std::string>;

std::string percent(double share) {
  return fmt::format("{:.2f}", 100.0 * share);
}

/// What sticks out of what, and where.
std::string describeOne(const EnclosureCheck& check, const std::string& inner, const std::string& outer,
                        const std::string& item) {
  if (check.outside == 0) {
    std::string text = fmt::format("inside   {} in {}: {} {}", inner, outer, check.count, item);
    if (check.shared > 0) text += fmt::format(", {} of them in several parts together", check.shared);
    if (check.shared < check.count) text += fmt::format(", clearance {}", lengthText(check.clearance));
    return text + "\n";
  }
  std::string text =
      fmt::format("OUTSIDE  {} in {}: {} of {} {} stick out", inner, outer, check.outside, check.count, item);
  if (check.areaOutside > 0.0) text += fmt::format(", {} % of the area", percent(check.areaOutside));
  if (check.worst) {
    const Vec3& p = check.worst->point;
    text += fmt::format(", furthest {} {} by {} at ({:.6g}, {:.6g}, {:.6g})", item.substr(0, item.size() - 1),
                        check.worst->index + 1, lengthText(check.worst->distance), p.x, p.y, p.z);
  }
  return text + "\n";
}

/// Files hold the principal axes, in single precision.
bool isAbout(const MassProperties& a, const MassProperties& b) {
  constexpr float kShare = 1e-3F;
  const float size = std::max({a.inertia[0][0], a.inertia[1][1], a.inertia[2][2]});
  bool same = glm::length(a.centerOfMass - b.centerOfMass) <= kShare * std::sqrt(size);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row)
      same = same && std::abs(a.inertia[column][row] - b.inertia[column][row]) <= kShare * size;
  }
  return same;
}

std::string knownTo(const SolidMass& mass, const std::string& pieces) {
  if (mass.error == 0.0F && mass.shared == 0.0F) return "exact";
  const auto shared = static_cast<double>(mass.shared);
  return fmt::format("{} share {:.1f} % of it, volume within {:.2g} %", pieces, 100.0 * shared,
                     100.0 * std::max(2e-3, static_cast<double>(mass.error)));
}

/// Found out by comparing, as files do not say it.
std::string sourceOfMass(const LevelModel& model, const LevelMeasures& measures) {
  const MassProperties& own = model.levels->mass();
  if (const auto& mesh = measures.meshMass; mesh && isAbout(mesh->properties, own)) {
    return fmt::format("what the mesh encloses, {:.4g} m3 ({})", mesh->properties.volume,
                       knownTo(*mesh, "shells"));
  }
  if (const auto& parts = measures.levels.back().mass; parts && isAbout(parts->properties, own)) {
    return fmt::format("what the finest level fills, {:.4g} m3 ({})", parts->properties.volume,
                       knownTo(*parts, "parts"));
  }
  return "given in the file";
}

std::string nameOf(const std::vector<MeshRegion>& regions, std::size_t index) {
  return index < regions.size() ? regions[index].name : "elsewhere";
}

nlohmann::ordered_json jsonOf(const LevelFigures& level, double diagonal,
                              const std::vector<MeshRegion>& regions) {
  auto gaps = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < level.regionGaps.size(); ++i) {
    const GapFigures& region = level.regionGaps[i];
    gaps.push_back({{"region", nameOf(regions, i)},
                    {"samples", region.samples},
                    {"mean_gap_m", region.mean},
                    {"p95_gap_m", region.p95},
                    {"max_gap_m", region.max}});
  }
  const auto share = [diagonal](double gap) { return diagonal > 0.0 ? gap / diagonal : 0.0; };
  return {{"parts", level.parts},
          {"vertices", level.vertices},
          {"most_vertices", level.mostVertices},
          {"part_volume_m3", level.partVolume},
          {"union_volume_m3", level.unionVolume},
          {"volume_ratio", level.volumeRatio},
          {"mean_gap_m", level.meanGap},
          {"p95_gap_m", level.p95Gap},
          {"max_gap_m", level.maxGap},
          {"mean_gap_share", share(level.meanGap)},
          {"p95_gap_share", share(level.p95Gap)},
          {"max_gap_share", share(level.maxGap)},
          {"predicted_cost", level.predictedCost},
          {"regions", std::move(gaps)}};
}

/// Whether the margin of hulls means anything to them.
bool hasHulls(const LevelSet& levels) {
  for (int level = 1; level <= levels.count(); ++level) {
    const std::vector<ConvexPart>& parts = levels.level(level).parts;
    if (std::any_of(parts.begin(), parts.end(),
                    [](const ConvexPart& part) { return std::holds_alternative<ConvexHull>(part.shape); })) {
      return true;
    }
  }
  return false;
}

nlohmann::ordered_json massJson(const LevelModel& model, const LevelMeasures& measures) {
  const MassProperties& mass = model.levels->mass();
  auto inertia = nlohmann::ordered_json::array();
  for (int row = 0; row < 3; ++row)
    inertia.push_back({mass.inertia[0][row], mass.inertia[1][row], mass.inertia[2][row]});
  return {{"center_of_mass_m", {mass.centerOfMass.x, mass.centerOfMass.y, mass.centerOfMass.z}},
          {"inertia_of_1_kg_m2", std::move(inertia)},
          {"source", sourceOfMass(model, measures)}};
}

nlohmann::ordered_json symmetryJson(const LevelSet& set) {
  const std::optional<LevelSymmetry> symmetry = symmetryOf(set);
  if (!symmetry) return nullptr;
  auto levels = nlohmann::ordered_json::array();
  for (const auto& [pairs, own] : symmetry->levels) levels.push_back({{"pairs", pairs}, {"symmetric", own}});
  return {{"axis", std::string(1, "xyz"[symmetry->plane.axis])},
          {"offset_m", symmetry->plane.offset},
          {"levels", std::move(levels)}};
}

}  // namespace

std::string lengthText(double metres) {
  const double size = std::abs(metres);
  if (size < 1e-9) return "0";
  if (size < 1e-3) return fmt::format("{:.3g} um", metres * 1e6);
  return size < 1.0 ? fmt::format("{:.3g} mm", metres * 1e3) : fmt::format("{:.4g} m", metres);
}

std::string describe(const LevelCheck& check, int levels) {
  std::string text;
  if (check.mesh) {
    text += describeOne(*check.mesh, "mesh", fmt::format("level {}", levels), "triangles");
  }
  for (std::size_t i = check.levels.size(); i-- > 0;) {
    text +=
        describeOne(check.levels[i], fmt::format("level {}", i + 2), fmt::format("level {}", i + 1), "parts");
  }
  return text;
}

std::string describeMesh(const LevelModel& model, const LevelMeasures& measures) {
  const std::string volume = measures.isSolid ? fmt::format("solid, volume {:.4g} m3", measures.meshVolume)
                                              : "not solid: a surface only";
  const std::string margin = hasHulls(*model.levels)
                                 ? fmt::format("; hull margin {}, counted in gaps",
                                               lengthText(static_cast<double>(model.levels->hullMargin())))
                                 : "";
  return fmt::format("{}: {} triangles, diagonal {}, {}{}\n", model.name, model.mesh.triangles.size(),
                     lengthText(measures.diagonal), volume, margin);
}

std::string describeMass(const LevelModel& model, const LevelMeasures& measures) {
  const MassProperties& mass = model.levels->mass();
  const Vec3& c = mass.centerOfMass;
  const Mat3& i = mass.inertia;
  return fmt::format(
      "mass properties: centre of mass ({:.4g}, {:.4g}, {:.4g}) m; inertia of 1 kg ({:.4g}, {:.4g}, {:.4g}) "
      "m2; {}\n",
      c.x, c.y, c.z, i[0][0], i[1][1], i[2][2], sourceOfMass(model, measures));
}

std::string describe(const SymmetryPlane& plane) {
  return fmt::format("the plane {} = {:.6g}", "xyz"[plane.axis], plane.offset);
}

std::string describeSymmetry(const LevelSet& levels) {
  const std::optional<LevelSymmetry> symmetry = symmetryOf(levels);
  if (!symmetry) return "";
  std::string text = "symmetric about " + describe(symmetry->plane) + ":";
  for (std::size_t i = 0; i < symmetry->levels.size(); ++i) {
    const auto [pairs, own] = symmetry->levels[i];
    text += fmt::format("{} level {}: {} pair{} of parts and {} symmetric", i > 0 ? ";" : "", i + 1, pairs,
                        pairs == 1 ? "" : "s", own);
  }
  return text + "\n";
}

std::string formatFigures(const LevelMeasures& measures) {
  std::vector<Cells> lines{{"level", "parts", "vertices", "most", "volume m3", "ratio", "overlap",
                            "mean gap %", "p95 gap %", "max gap %", "max gap", "cost"}};
  const double diagonal = measures.diagonal;
  for (std::size_t i = 0; i < measures.levels.size(); ++i) {
    const LevelFigures& level = measures.levels[i];
    lines.push_back({fmt::format("{}", i + 1), fmt::format("{}", level.parts),
                     fmt::format("{}", level.vertices), fmt::format("{}", level.mostVertices),
                     fmt::format("{:.4g}", level.unionVolume),
                     measures.isSolid ? fmt::format("{:.2f}", level.volumeRatio) : "-",
                     level.unionVolume > 0.0 ? fmt::format("{:.2f}", level.overlap()) : "-",
                     percent(level.meanGap / diagonal), percent(level.p95Gap / diagonal),
                     percent(level.maxGap / diagonal), lengthText(level.maxGap),
                     fmt::format("{:.1f}", level.predictedCost)});
  }
  return lab::textTable(lines);
}

std::string formatRegions(const LevelMeasures& measures, const std::vector<MeshRegion>& regions) {
  if (regions.empty()) return "";
  std::vector<Cells> lines{{"region", "level", "mean gap %", "p95 gap %", "max gap %", "max gap"}};
  for (std::size_t i = 0; i <= regions.size(); ++i) {
    std::string name = nameOf(regions, i);
    if (i < regions.size() && regions[i].weight != 1.0F)
      name += fmt::format(" (weight {:.4g})", regions[i].weight);
    if (i < regions.size() && regions[i].isKept) name += ", kept apart";
    for (std::size_t level = 0; level < measures.levels.size(); ++level) {
      const GapFigures& gap = measures.levels[level].regionGaps.at(i);
      const auto sampled = [&gap, &measures](double value) {
        return gap.samples > 0 ? percent(value / measures.diagonal) : "-";
      };
      lines.push_back({name, fmt::format("{}", level + 1), sampled(gap.mean), sampled(gap.p95),
                       percent(gap.max / measures.diagonal), lengthText(gap.max)});
    }
  }
  return "\n" + lab::textTable(lines);
}

std::string figuresJson(const std::vector<LevelModel>& models, const std::vector<LevelMeasures>& measures,
                        const std::vector<MeshRegion>& regions) {
  auto list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < models.size(); ++i) {
    const LevelMeasures& figures = measures.at(i);
    auto levels = nlohmann::ordered_json::array();
    for (const LevelFigures& level : figures.levels)
      levels.push_back(jsonOf(level, figures.diagonal, regions));
    list.push_back({{"name", models[i].name},
                    {"triangles", models[i].mesh.triangles.size()},
                    {"diagonal_m", figures.diagonal},
                    {"mesh_volume_m3", figures.meshVolume},
                    {"solid", figures.isSolid},
                    {"hull_margin_m", models[i].levels->hullMargin()},
                    {"mass_properties", massJson(models[i], figures)},
                    {"symmetry", symmetryJson(*models[i].levels)},
                    {"levels", std::move(levels)}});
  }
  // Names come from files and need not be text.
  return nlohmann::ordered_json{{"models", std::move(list)}}.dump(2, ' ', false,
                                                                  nlohmann::json::error_handler_t::replace) +
         "\n";
}

}  // namespace scatter::app
