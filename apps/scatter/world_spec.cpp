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

}  // namespace

Result<WorldSpec> parseWorld(const std::string& text) {
  const std::size_t at = text.find('@');
  auto world = choose(worldChoices(), "world", text.substr(0, at));
  if (!world) {
    return tl::unexpected(world.error());
  }
  WorldSpec spec{.world = std::move(*world), .label = text.substr(0, at)};
  if (at == std::string::npos) {
    return spec;
  }
  const std::string budget = text.substr(at + 1);
  spec.budget = parseBudget(budget);
  if (!spec.budget) {
    return fail("the budget of the world \"" + text + "\" is not understood; write it like " +
                spec.world.name + "@5ms or " + spec.world.name + "@3000units");
  }
  if (spec.world.kind != WorldKind::kHybrid || spec.world.policy || spec.world.switching) {
    return fail("the world " + spec.world.name + " takes no budget; leave out @" + budget +
                " or use the hybrid world");
  }
  spec.label += '-' + budget;
  return spec;
}

}  // namespace scatter::app
