#include <scatter/io/collada.h>
#include <scatter/io/model_library.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "io/xml_source.h"

namespace scatter {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".dae";

void addSearchPath(std::string_view list, std::vector<fs::path>& folders) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(':'), list.size());
    if (end > 0) {
      folders.emplace_back(list.substr(0, end));
    }
    list.remove_prefix(std::min(end + 1, list.size()));
  }
}

/// Beside the `bin` folder that the program runs from, so that an installed tree can be moved.
void addProgramFolder(std::vector<fs::path>& folders) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    folders.push_back(program.parent_path().parent_path() / "share" / "scatter" / "models");
  }
}

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) {
    result += (result.empty() ? "" : ", ") + name;
  }
  return result;
}

}  // namespace

std::vector<fs::path> modelFolders() {
  std::vector<fs::path> folders;
  if (const char* list = std::getenv("SCATTER_MODEL_PATH")) {
    addSearchPath(list, folders);
  }
  folders.emplace_back(SCATTER_SOURCE_MODEL_DIR);
  addProgramFolder(folders);
  folders.emplace_back(SCATTER_INSTALL_MODEL_DIR);
  return folders;
}

std::vector<std::string> modelNames() {
  std::vector<std::string> names;
  for (const fs::path& folder : modelFolders()) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      if (entry->path().extension() == kExtension) {
        names.push_back(entry->path().stem().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

Result<fs::path> findModel(std::string_view name) {
  const std::vector<std::string> known = modelNames();
  if (std::binary_search(known.begin(), known.end(), name)) {
    for (const fs::path& folder : modelFolders()) {
      const fs::path file = folder / (std::string(name) + kExtension);
      std::error_code ignored;
      if (fs::exists(file, ignored)) {
        return file;
      }
    }
  }
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
