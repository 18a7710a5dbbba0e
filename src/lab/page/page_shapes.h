#pragma once

#include <scatter/levels/surface_mesh.h>
#include <scatter/math.h>
#include <scatter/world/body.h>

#include <cstddef>
#include <map>
#include <string>

#include "lab/page/page_blobs.h"
#include "lab/summary_json.h"

namespace scatter::lab {

/// What bodies look like, of all worlds of a page: what looks the same is there once.
class PageShapes {
 public:
  /// A shape by its number, and how large the body is in it.
  struct Look {
    std::size_t shape = 0;
    Vec3 scale{1.0F};
    int levels = 1;
  };

  [[nodiscard]] Look lookOf(const BodyDef& def);

  /// Adds the meshes to the blobs. "box" and "sphere" are what the page has itself, of half a side and a
  /// radius of one.
  [[nodiscard]] Json finish(PageBlobs& blobs) const;

 private:
  [[nodiscard]] std::size_t meshOf(const SurfaceMesh& surface);
  [[nodiscard]] std::size_t shapeOf(const Json& shape);
  [[nodiscard]] Look makeLook(const BodyDef& def);

  std::string bytes_;
  Json meshes_ = Json::array();
  Json shapes_ = Json::array();
  std::map<std::string, std::size_t> knownMeshes_;
  std::map<std::string, std::size_t> knownShapes_;
  std::map<const void*, Look> knownModels_;
};

}  // namespace scatter::lab
