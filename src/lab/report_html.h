#pragma once

#include <scatter/lab/comparison.h>
#include <scatter/lab/figures.h>

#include <string>
#include <vector>

#include "lab/page/page_bundle.h"

namespace scatter::lab {

/// A page that says in its first line what was compared and what came out. It needs no other file: its plots,
/// the worlds in 3D and what they are made from are in it. With an empty bundle it has neither and says so,
/// and shows the figures' files, "figures/NAME.svg".
[[nodiscard]] std::string reportHtml(const Comparison& comparison, const std::vector<Figure>& figures,
                                     const PageBundle& bundle);

}  // namespace scatter::lab
