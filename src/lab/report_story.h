#pragma once

#include <scatter/lab/report_test.h>

#include <vector>

#include "lab/report_run.h"

namespace scatter::lab {

/// The time line of Scene 1 (report, section 5.1.5.1).
[[nodiscard]] std::vector<StoryLine> tellTwoShips(const ReportRun& run);

/// The time line of Scene 2 (report, section 5.1.5.2).
[[nodiscard]] std::vector<StoryLine> tellCrowd(const ReportRun& run);

}  // namespace scatter::lab
