#include <scatter/io/collada.h>
#include <scatter/io/model_library.h>

#include <utility>

#include "io/collada/xml_source.h"
#include "io/data_folders.h"

namespace scatter {
namespace {

namespace fs = std::filesystem;

constexpr io::DataKind kModels{"SCATTER_MODEL_PATH", "models", SCATTER_SOURCE_MODEL_DIR,
                               SCATTER_INSTALL_MODEL_DIR, ".dae"};

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) {
    result += (result.empty() ? "" : ", ") + name;
  }
  return result;
}

}  // namespace

std::vector<fs::path> modelFolders() {
  return io::dataFolders(kModels);
}

std::vector<std::string> modelNames() {
  return io::dataNames(kModels);
}

Result<fs::path> findModel(std::string_view name) {
  fs::path file = io::findData(kModels, name);
  if (!file.empty()) {
    return file;
  }
  const std::vector<std::string> known = modelNames();
  return fail("unknown model " + io::inQuotes(name) + "; " +
              (known.empty() ? "no models were found, set SCATTER_MODEL_PATH to the folder that holds them"
                             : "known are " + joined(known)));
}

Result<std::shared_ptr<const Model>> loadModel(std::string_view name) {
  return findModel(name)
      .and_then([](const fs::path& file) { return readCollada(file); })
      .map([](Model model) {
        return std::shared_ptr<const Model>(std::make_shared<Model>(std::move(model)));
      });
}

}  // namespace scatter
