#pragma once

#include <scatter/io/mesh_file.h>
#include <scatter/lab/comparison.h>
#include <scatter/result.h>

#include <functional>
#include <string>
#include <vector>

namespace scatter::app {

/// One way to make levels of a mesh.
struct LevelMethod {
  std::string name;
  std::vector<int> parts;  ///< Coarsest first.
  int maxVertices = 16;    ///< 0: any number.
  bool isPiled = false;    ///< Whether its bodies are piled up, too.
  std::string command{};   ///< Of another program, see decompose(); empty: ours.
};

/// Ours: 32 and 64 parts in three levels, which are piled up, and 64 parts in six.
[[nodiscard]] std::vector<LevelMethod> ownLevelMethods();

struct LevelBenchDef {
  std::vector<LevelMethod> methods;
  bool piles = false;
  int repeat = 3;          ///< Runs of each pile.
  int limitSeconds = 120;  ///< Processor time for each decomposition by others.

  /// Called now and then while levels are made, and while they are piled up; may throw.
  std::function<void()> tick;
  std::function<void(const CompareProgress&)> piling;
};

/// What grows mesh by mesh; tables have their lines of names from the start.
struct LevelBenchTables {
  LevelBenchTables();

  std::string levels;  ///< CSV: a row for each level.
  std::string piles;   ///< CSV: a row for each method that is piled up.
  bool passed = true;  ///< All of ours hold the mesh and each other.
};

/// Makes levels of a mesh in every way, proves and measures them by the same code, and piles them up; calls
/// `print(line)` for each. A method that fails has a line that says why, and is no error unless it is ours.
[[nodiscard]] Result<void> benchLevels(const MeshFile& file, const LevelBenchDef& definition,
                                       LevelBenchTables& tables,
                                       const std::function<void(const std::string& line)>& print);

}  // namespace scatter::app
