#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/result.h>

#include <optional>
#include <string>

namespace scatter::io {

/// Whether a document can be written and read again: all indices exist, names of bodies are unique, names are
/// UTF-8, numbers are finite and in range, shapes have volume, every joint joins two things. The message
/// names what is wrong, such as "body \"ship\": model 7 does not exist".
[[nodiscard]] Result<void> checkDocument(const PhysicsDocument& document);

/// What is wrong with a shape, as a phrase; nothing if it can be written and read again.
[[nodiscard]] std::optional<std::string> findShapeDefect(const DocumentShape& shape);

}  // namespace scatter::io
