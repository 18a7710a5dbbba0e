#include <scatter/io/file.h>
#include <scatter/io/level_export.h>

#include <string>

#include "io/export/export_parts.h"

namespace scatter {

Result<void> writeObj(const Model& model, int level, const std::filesystem::path& path) {
  const auto parts = io::partsOf(model, level);
  if (!parts) return fail(parts.error().message);
  const std::string stem = io::wordOf(model.name) + "_level" + std::to_string(level) + "_part";
  std::string text = "# metres, y up; an object for each convex part\n";
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < parts->size(); ++i) {
    const Result<SurfaceMesh> surface = io::surfaceOf((*parts)[i]);
    if (!surface) return fail("part " + std::to_string(i + 1) + ": " + surface.error().message);
    text += io::objObject(stem + std::to_string(i + 1), *surface, vertices);
    vertices += surface->vertices.size();
  }
  return writeFile(path, text);
}

}  // namespace scatter
