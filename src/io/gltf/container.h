#pragma once

#include <string>

namespace scatter::io {

/// A GLB file of this JSON and, unless it is empty, the binary chunk `data`.
[[nodiscard]] std::string packGlb(std::string json, std::string data);

}  // namespace scatter::io
