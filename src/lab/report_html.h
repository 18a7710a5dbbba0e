#pragma once

#include <scatter/lab/comparison.h>
#include <scatter/lab/figures.h>

#include <filesystem>
#include <string>
#include <vector>

namespace scatter::lab {

/// A page that needs no other file: the figures, read as SVG from `figureFolder`, are in it.
[[nodiscard]] Result<std::string> reportHtml(const Comparison& comparison, const std::vector<Figure>& figures,
                                             const std::filesystem::path& figureFolder);

}  // namespace scatter::lab
