#include "run_report.h"

#include <scatter/lab/contact_survey.h>
#include <spdlog/fmt/fmt.h>

namespace scatter::app {

namespace {

std::string timeRow(const std::string& name, double cpu, double wall) {
  return fmt::format("{:<24}{:>12.3f}{:>12.3f}\n", name, cpu, wall);
}

std::string times(const Summary& summary) {
  const TimeStatistics& cpu = summary.physicsCpuMs;
  const TimeStatistics& wall = summary.physicsMs;
  return fmt::format("{:<24}{:>12}{:>12}\n", "physics, milliseconds", "processor", "wall") +
         timeRow("  peak", cpu.peak, wall.peak) + timeRow("  p99.9", cpu.p999, wall.p999) +
         timeRow("  p99", cpu.p99, wall.p99) + timeRow("  median", cpu.median, wall.median) +
         timeRow("  total", cpu.total, wall.total) +
         fmt::format("{:<24}{:>12}{:>12}\n", fmt::format("  frames over {:.4g} ms", summary.budgetMs),
                     cpu.framesOverBudget, wall.framesOverBudget);
}

std::string countRow(const Summary& summary, const std::string& name, const std::string& column) {
  const CounterStatistics& counter = summary.counter(column);
  return fmt::format("  {:<22}{:>12.0f}{:>12.0f}\n", name, counter.peak, counter.total);
}

std::string counts(const Summary& summary) {
  std::string text = fmt::format("{:<24}{:>12}{:>12}\n", "counts", "peak", "total") +
                     countRow(summary, "manifolds", "manifolds") +
                     countRow(summary, "narrowphase pairs", "narrowphase_pairs") +
                     countRow(summary, "contacts", "contacts");
  if (summary.physics.world == WorldKind::kHybrid) {
    text += countRow(summary, "standing requests", "requests") +
            countRow(summary, "switches to coarser", "switches_coarser") +
            countRow(summary, "switches to finer", "switches_finer") +
            countRow(summary, "retractions", "retractions");
  }
  if (summary.counter("child_pairs").total > 0) {
    text += countRow(summary, "child pairs", "child_pairs") + countRow(summary, "GJK runs", "gjk_runs") +
            countRow(summary, "detector runs", "detector_runs");
  }
  return text;
}

}  // namespace

std::string formatSummary(const Summary& summary) {
  return fmt::format("{}, {} world, {}: {} frames, seed {}\n\n", summary.scene, summary.label, summary.engine,
                     summary.frames, summary.seed) +
         times(summary) + "\n" + counts(summary) +
         fmt::format("\nstate hash of the last frame: {:016x}\n", summary.stateHash);
}

std::string formatFidelity(const FidelityStatistics& fidelity) {
  std::string text = fmt::format(
      "fidelity, {} samples\n"
      "  visible overlaps      mean {:.2f}, peak {}, {:.2f} per 100 touching pairs\n"
      "  contact gap p95       {:.3f} m, {:.2f} % of {:.3g} m\n",
      fidelity.samples, fidelity.visibleOverlapMean, fidelity.visibleOverlapPeak,
      fidelity.visibleOverlapPer100, fidelity.contactGapP95, fidelity.contactGapP95Percent(),
      fidelity.length);
  text += fmt::format("  touching finely       mean {:.1f} %, worst {:.1f} %",
                      100.0 * fidelity.finestShareMean, 100.0 * fidelity.finestShareWorst);
  if (fidelity.finestShareWorstFrame > 0) {
    text += fmt::format(" (frame {})", fidelity.finestShareWorstFrame);
  }
  text += '\n';
  for (std::size_t below = 1; below < fidelity.touchingByLevel.size(); ++below) {
    text += fmt::format("  {} below the finest    {:.1f} % of touching pairs\n", below,
                        100.0 * fidelity.share(below));
  }
  return text +
         fmt::format(
             "  impact, from frame {}: {:.1f} % touch finely, gap p95 {:.3f} m, {:.2f} overlaps per 100\n"
             "  largest jump          {:.4f} m (frame {})\n"
             "  pile at the end       radius {:.3f} m, kinetic energy {:.4g} J\n",
             fidelity.impactFrame, 100.0 * fidelity.impactFinestShare, fidelity.impactContactGapP95,
             fidelity.impactVisibleOverlapPer100, fidelity.largestJump, fidelity.largestJumpFrame,
             fidelity.pileRadius, fidelity.kineticEnergyEnd);
}

std::string formatContactCheck(const Summary& summary) {
  const ContactCheck& check = summary.contactCheck;
  return fmt::format(
             "contacts, {} world: {} frames verified, {} expected, {} missed, {} extra, {} doubtful\n",
             summary.label, check.steps, check.expected, check.missed, check.extra, check.doubtful) +
         formatMisses(check);
}

}  // namespace scatter::app
