#pragma once

#include <string>

namespace scatter::test {

/// Parts of a small COLLADA file; a test replaces the one that it is about.
struct Document {
  std::string asset = "<unit meter=\"1\"/><up_axis>Y_UP</up_axis>";
  std::string libraries;
  std::string mass = "<mass>12.5</mass>";
  std::string material;
  std::string finest = "<shape><box><half_extents>0.5 0.4 0.3</half_extents></box></shape>";
  std::string extra;
  std::string modelAttributes = "name=\"brick\"";

  /// The file. The line numbers of its elements do not depend on the parts, if those have no line breaks:
  /// asset 2, libraries 3, physics_model 4, mass 5, material 6, finest 7, extra 8.
  [[nodiscard]] std::string text() const;
};

/// The element that holds coarser levels, around `levels`.
[[nodiscard]] std::string coarser(const std::string& levels, const std::string& attributes = "");

/// A `<level>` that is a box around the origin.
[[nodiscard]] std::string boxLevel(int index, const std::string& halfExtents);

/// A `<geometry>` with these positions in a mesh or convex_mesh, and primitives.
[[nodiscard]] std::string geometry(const std::string& id, const std::string& kind, int count,
                                   const std::string& numbers, const std::string& primitives = "");

/// A document that uses every element the reader knows.
[[nodiscard]] Document richDocument();

}  // namespace scatter::test
