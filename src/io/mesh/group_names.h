#pragma once

#include <scatter/io/mesh_file.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace scatter::io {

/// Collects which triangles go by which name, as they are read one after the other.
class GroupNames {
 public:
  /// Triangles `first` to before `last` belong to a group, which must not know later ones yet. Without a
  /// name, or without triangles, nothing happens.
  void add(MeshGroupKind kind, const std::string& name, std::size_t first, std::size_t last);

  [[nodiscard]] std::vector<MeshGroup> take();

 private:
  std::map<std::pair<MeshGroupKind, std::string>, std::size_t> places_;
  std::vector<MeshGroup> groups_;
};

}  // namespace scatter::io
