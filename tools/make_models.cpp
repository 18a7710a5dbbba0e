#include <scatter/io/collada.h>

#include <cstdio>
#include <filesystem>
#include <vector>

#include "prop.h"
#include "ship.h"

namespace scatter::tools {
namespace {

/// `Maker` is a ship or a prop.
template <typename Maker>
Result<void> write(const std::vector<Maker>& makers, const std::filesystem::path& folder) {
  for (const Maker& maker : makers) {
    const auto written = maker.build().and_then(
        [&](const Model& model) { return writeCollada(model, folder / (maker.name() + ".dae")); });
    if (!written) return written;
  }
  return {};
}

Result<void> writeModels(const std::filesystem::path& folder) {
  return write<Ship>({makeHunter(), makeFighter()}, folder).and_then([&] {
    return write<Prop>(
        {makeTable(), makeChair(), makeShelf(), makeCrate(), makeBarrel(), makeLamp(), makeMug()}, folder);
  });
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
