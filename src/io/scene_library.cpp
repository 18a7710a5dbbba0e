#include <scatter/io/scene_library.h>

#include "io/collada/xml_source.h"
#include "io/data_folders.h"
#include "io/nearest_name.h"

namespace scatter {
namespace {

constexpr io::DataKind kScenes{"SCATTER_SCENE_PATH", "scenes", SCATTER_SOURCE_SCENE_DIR,
                               SCATTER_INSTALL_SCENE_DIR, ".toml"};

}  // namespace

std::vector<std::filesystem::path> sceneFolders() {
  return io::dataFolders(kScenes);
}

std::vector<std::string> sceneFileNames() {
  return io::dataNames(kScenes);
}

Result<std::filesystem::path> findSceneFile(std::string_view name) {
  std::filesystem::path file = io::findData(kScenes, name);
  if (!file.empty()) return file;
  const std::vector<std::string> known = sceneFileNames();
  return fail("unknown scene file " + io::inQuotes(name) +
              io::didYouMean(name, std::vector<std::string_view>(known.begin(), known.end())));
}

}  // namespace scatter
