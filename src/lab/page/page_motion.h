#pragma once

#include <scatter/recording/recording.h>
#include <scatter/result.h>

#include "lab/page/page_blobs.h"
#include "lab/page/page_shapes.h"
#include "lab/summary_json.h"

namespace scatter::lab {

/// Where the bodies of a world are, frame by frame, as a page plays it: less exact than the recording, and a
/// fraction of its size. Fails if the recording is damaged.
[[nodiscard]] Result<Json> pageMotion(const Recording& recording, PageShapes& shapes, PageBlobs& blobs);

}  // namespace scatter::lab
