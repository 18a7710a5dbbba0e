#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/result.h>

namespace scatter::io {

/// Whether the sizes and the place of a shape are in the range that the reader takes.
[[nodiscard]] bool isWritable(const DocumentShape& shape);

/// Fails on what the reader would refuse or change: the message names the thing and its value.
[[nodiscard]] Result<void> checkWritable(const PhysicsDocument& document);

}  // namespace scatter::io
