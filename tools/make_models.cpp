#include <scatter/io/collada.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include "prop.h"
#include "ship.h"

namespace scatter::tools {
namespace {

Result<void> writeShip(const Ship& ship, FinestLevel finest, const std::filesystem::path& file) {
  return ship.build(finest).and_then([&](const Model& model) { return writeCollada(model, file); });
}

Result<void> writeModels(const std::filesystem::path& folder) {
  for (const Ship& ship : {makeHunter(), makeFighter()}) {
    for (const auto& [finest, suffix] :
         {std::pair(FinestLevel::kBoxes, ".dae"), std::pair(FinestLevel::kHulls, "_hulls.dae")}) {
      if (auto written = writeShip(ship, finest, folder / (ship.name() + suffix)); !written) {
        return written;
      }
    }
  }
  for (const Prop& prop :
       {makeTable(), makeChair(), makeShelf(), makeCrate(), makeBarrel(), makeLamp(), makeMug()}) {
    const auto written = prop.build().and_then(
        [&](const Model& model) { return writeCollada(model, folder / (prop.name() + ".dae")); });
    if (!written) return written;
  }
  return {};
}

}  // namespace
}  // namespace scatter::tools

/// Writes the model files into a folder that exists.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_models FOLDER\nWrites the model files into FOLDER.\n", stderr);
    return 2;
  }
  if (const auto written = scatter::tools::writeModels(argv[1]); !written) {
    std::fprintf(stderr, "make_models: %s\n", written.error().message.c_str());
    return 2;
  }
  return 0;
}
