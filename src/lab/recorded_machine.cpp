#include <scatter/lab/recorded_machine.h>

#include <scatter/lab/frame_csv.h>

#include <algorithm>
#include <cstddef>

namespace scatter {

namespace {

constexpr double kLight = 0.25;

Result<std::vector<double>> ratesOfRun(const std::filesystem::path& file, const FrameFile& frames) {
  const auto units = frames.column("cost_units");
  if (!units) {
    return tl::unexpected(units.error());
  }
  const auto milliseconds = frames.column("physics_cpu_ms");
  if (!milliseconds) {
    return tl::unexpected(milliseconds.error());
  }
  const double dearest = *std::max_element(units->begin(), units->end());
  if (!(dearest > 0.0)) {
    return fail("the run in " + file.string() +
                " cost no units; record a machine with a hybrid world and pair switching");
  }
  std::vector<double> rates;
  for (std::size_t i = 0; i < units->size(); ++i) {
    if ((*units)[i] >= kLight * dearest) rates.push_back((*milliseconds)[i] / (*units)[i]);
  }
  return rates;
}

}  // namespace

Result<std::vector<double>> readMachine(const std::filesystem::path& file) {
  const auto frames = FrameFile::read(file);
  if (!frames) {
    return tl::unexpected(frames.error());
  }
  auto rates = frames->has("ms_per_unit") ? frames->column("ms_per_unit") : ratesOfRun(file, *frames);
  if (rates && std::any_of(rates->begin(), rates->end(), [](double rate) { return !(rate > 0.0); })) {
    return fail("in " + file.string() + " a unit takes no time in some step; give milliseconds above 0");
  }
  return rates;
}

std::vector<double> timeOnMachine(const std::vector<double>& units, const std::vector<double>& machine) {
  std::vector<double> milliseconds = units;
  std::size_t step = 0;
  for (double& taken : milliseconds) {
    if (taken > 0.0) taken *= machine[step++ % machine.size()];
  }
  return milliseconds;
}

}  // namespace scatter
