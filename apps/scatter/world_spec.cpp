#include "world_spec.h"

#include <cmath>
#include <string_view>

#include "number_checks.h"

namespace scatter::app {

namespace {

std::optional<double> numberBefore(const std::string& text, std::string_view unit) {
  if (text.size() <= unit.size() || !text.ends_with(unit)) {
    return std::nullopt;
  }
  const auto number = parseNumber<double>(text.substr(0, text.size() - unit.size()));
  return number && std::isfinite(*number) && *number > 0.0 ? number : std::nullopt;
}

std::optional<BudgetDef> parseBudget(const std::string& text) {
  BudgetDef budget;
  if (const auto milliseconds = numberBefore(text, "ms")) {
    budget.milliseconds = *milliseconds;
    return budget;
  }
  if (const auto units = numberBefore(text, "units")) {
    budget.units = *units;
    return budget;
  }
  return std::nullopt;
}

Result<void> addBudget(WorldSpec& spec, const std::string& budget) {
  if (spec.world.kind != WorldKind::kHybrid || spec.world.policy || spec.world.switching) {
    return fail("the world " + spec.world.name + " takes no budget; leave out @" + budget +
                " or use the hybrid world");
  }
  spec.budget = parseBudget(budget);
  return {};
}

Result<void> addThreads(WorldSpec& spec, double number, const std::string& text) {
  if (spec.world.kind != WorldKind::kHybrid) {
    return fail("the world " + spec.world.name + " has one thread; leave out @" + text +
                " or use a hybrid world");
  }
  if (number > kMostThreads || number != std::floor(number)) {
    return fail("a world works on 1 to " + std::to_string(kMostThreads) + " threads, not on " + text);
  }
  spec.threads = static_cast<int>(number);
  return {};
}

Result<void> addPart(WorldSpec& spec, const std::string& part) {
  if (const auto threads = numberBefore(part, "threads")) return addThreads(spec, *threads, part);
  if (parseBudget(part)) return addBudget(spec, part);
  return fail("\"@" + part + "\" is not understood; write a budget like " + spec.world.name + "@5ms or " +
              spec.world.name + "@3000units, threads like " + spec.world.name + "@2threads");
}

}  // namespace

Result<WorldSpec> parseWorld(const std::string& text) {
  std::size_t at = text.find('@');
  auto world = choose(worldChoices(), "world", text.substr(0, at));
  if (!world) {
    return tl::unexpected(world.error());
  }
  WorldSpec spec{.world = std::move(*world), .label = text.substr(0, at)};
  while (at != std::string::npos) {
    const std::size_t next = text.find('@', at + 1);
    const std::string part = text.substr(at + 1, next == std::string::npos ? next : next - at - 1);
    if (auto added = addPart(spec, part); !added) {
      return tl::unexpected(added.error());
    }
    spec.label += '-' + part;
    at = next;
  }
  return spec;
}

}  // namespace scatter::app
