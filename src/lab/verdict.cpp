#include "lab/verdict.h"

#include "lab/comparison_table.h"
#include "lab/repeats.h"
#include "lab/text.h"
#include "lab/text_table.h"

#include <functional>

namespace scatter::lab {

namespace {

std::string framesOf(const Comparison& comparison) {
  const int frames = comparison.options.runs.front().frames;
  return frames == 1 ? "one frame" : std::to_string(frames) + " frames";
}

// "a in standard, b in finest and c in hybrid".
std::string inEachWorld(const Comparison& comparison,
                        const std::function<std::string(const ComparedWorld&)>& figure) {
  std::string text;
  const std::size_t worlds = comparison.worlds.size();
  for (std::size_t i = 0; i < worlds; ++i) {
    const char* join = i == 0 ? "" : i + 1 == worlds ? " and " : ", ";
    text += join + figure(comparison.worlds[i]) + " in " + comparison.worlds[i].label();
  }
  return text;
}

std::string milliseconds(const ComparedWorld& world, double TimeStatistics::*figure) {
  return readableNumber(
             medianOver(world, [figure](const Summary& run) { return run.physicsCpuMs.*figure; })) +
         " ms";
}

}  // namespace

std::string verdict(const Comparison& comparison) {
  const ComparedWorld& first = comparison.worlds.front();
  const std::string scene = comparison.options.runs.front().scene;
  if (comparison.worlds.size() == 1) {
    return scene + " in the " + first.label() + " world: the physics of " + framesOf(comparison) + " took " +
           milliseconds(first, &TimeStatistics::total);
  }
  std::string text = scene + " in " + std::to_string(comparison.worlds.size()) + " worlds: the physics of ";
  for (std::size_t i = 1; i < comparison.worlds.size(); ++i) {
    const ComparedWorld& world = comparison.worlds[i];
    text += i == 1 ? world.label() + " took " : ", of " + world.label() + ' ';
    text += ratioText(world.physicsCpuMs.total, false);
  }
  return text + " of the processor time of " + first.label();
}

std::string verdictDetails(const Comparison& comparison) {
  const double budget = comparison.options.runs.front().budgetMs;
  return "The dearest of " + framesOf(comparison) + " took " +
         inEachWorld(comparison,
                     [](const ComparedWorld& world) { return milliseconds(world, &TimeStatistics::peak); }) +
         ". Frames that took more than the budget of " + readableNumber(budget) + " ms: " +
         inEachWorld(
             comparison,
             [budget](const ComparedWorld& world) { return fixedNumber(framesOver(world, budget), 0); }) +
         (comparison.options.repeat == 1
              ? ". Each world was run once."
              : ". Figures are medians of " + std::to_string(comparison.options.repeat) + " repeats.");
}

}  // namespace scatter::lab
