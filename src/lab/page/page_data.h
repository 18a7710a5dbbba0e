#pragma once

#include <scatter/lab/comparison.h>

#include <string>

namespace scatter::lab {

/// All that the page of a comparison shows beside its text, as elements of HTML: a description in JSON,
/// `page-data`, and blobs. web/report/src/data.js is its reader.
[[nodiscard]] std::string pageData(const Comparison& comparison);

}  // namespace scatter::lab
