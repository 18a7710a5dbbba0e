#pragma once

#include <scatter/io/physics_document.h>

#include <string>

namespace scatter::test {

/// Where two documents differ first, such as "models[2].shapes[0].pose"; empty if they are the same. Warnings
/// are not compared; axes of joints that are free are the same, whatever pair of limits says so.
[[nodiscard]] std::string findDifference(const PhysicsDocument& a, const PhysicsDocument& b);

}  // namespace scatter::test
