#include "io/data_folders.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace scatter::io {
namespace {

namespace fs = std::filesystem;

void addSearchPath(std::string_view list, std::vector<fs::path>& folders) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(':'), list.size());
    if (end > 0) {
      folders.emplace_back(list.substr(0, end));
    }
    list.remove_prefix(std::min(end + 1, list.size()));
  }
}

}  // namespace

std::vector<fs::path> dataFolders(const DataKind& kind) {
  std::vector<fs::path> folders;
  if (const char* list = std::getenv(kind.variable)) {
    addSearchPath(list, folders);
  }
  const fs::path shared = fs::path("share") / "scatter" / kind.folder;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    folders.push_back(program.parent_path().parent_path() / shared);
  }
  folders.emplace_back(kind.source);
  folders.emplace_back(kind.installed);
  folders.push_back("/usr" / shared);
  return folders;
}

std::vector<std::string> dataNames(const DataKind& kind) {
  std::vector<std::string> names;
  for (const fs::path& folder : dataFolders(kind)) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      if (entry->path().extension() == kind.extension) {
        names.push_back(entry->path().stem().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

fs::path findData(const DataKind& kind, std::string_view name) {
  const std::vector<std::string> known = dataNames(kind);
  if (std::binary_search(known.begin(), known.end(), name)) {
    for (const fs::path& folder : dataFolders(kind)) {
      const fs::path file = folder / (std::string(name) + kind.extension);
      std::error_code ignored;
      if (fs::exists(file, ignored)) {
        return file;
      }
    }
  }
  return {};
}

}  // namespace scatter::io
