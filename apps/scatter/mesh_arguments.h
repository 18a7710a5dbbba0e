#pragma once

#include <scatter/io/mesh_file.h>
#include <scatter/result.h>

#include <string>

namespace CLI {
class App;
}

namespace scatter::app {

/// How a mesh file is to be read, as the user gave it.
struct MeshArguments {
  std::string unit;
  std::string up;
};

void addMeshArguments(CLI::App& command, MeshArguments& arguments);

[[nodiscard]] Result<MeshFile> readMesh(const std::string& path, const MeshArguments& arguments);

}  // namespace scatter::app
