#pragma once

#include <scatter/result.h>

#include <filesystem>
#include <vector>

namespace scatter {

/// What a unit of predicted cost has taken on a machine, in milliseconds, step by step, as BudgetDef::machine
/// takes it: the column ms_per_unit of a CSV file; where there is none, physics_cpu_ms over cost_units of the
/// frames.csv of a run, in frames that cost at least a quarter of its dearest one, as in lighter ones most of
/// the time goes into what no unit stands for. Fails if the file cannot be read, has neither, or a number
/// that is not above 0; the message names the file.
[[nodiscard]] Result<std::vector<double>> readMachine(const std::filesystem::path& file);

/// What frames of so many units take on a machine, in milliseconds: those that cost some are its steps, as
/// BudgetDef::machine counts them. `machine` is not empty.
[[nodiscard]] std::vector<double> timeOnMachine(const std::vector<double>& units,
                                                const std::vector<double>& machine);

}  // namespace scatter
