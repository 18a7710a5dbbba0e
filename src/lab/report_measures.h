#pragma once

#include <scatter/lab/report_test.h>

#include <vector>

#include "lab/report_run.h"

namespace scatter::lab {

/// Tests 1 and 2: what the report says in section 5.1.5.1, and what the run has.
[[nodiscard]] std::vector<ReportMeasure> measureTwoShips(const ReportRun& run, bool hybrid);

/// Tests 3 and 4, section 5.1.5.2.
[[nodiscard]] std::vector<ReportMeasure> measureCrowd(const ReportRun& run, bool hybrid);

}  // namespace scatter::lab
