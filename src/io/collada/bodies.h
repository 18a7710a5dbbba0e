#pragma once

#include "io/collada/frame.h"
#include "io/collada/materials.h"

#include <scatter/io/physics_document.h>

#include <optional>
#include <string>
#include <string_view>

namespace scatter::io {

/// What a `<rigid_body>` says of its body besides the shapes, and what an `<instance_rigid_body>` can say
/// instead.
struct BodyProperties {
  std::optional<DocumentMotion> motion{};
  std::optional<float> mass{};  ///< Kilograms.
  std::optional<DocumentMassFrame> massFrame{};
  std::optional<std::size_t> material{};
};

/// Of a `<rigid_body>` or `<instance_rigid_body>`.
[[nodiscard]] Result<BodyProperties> readProperties(const ColladaFrame& frame, ColladaMaterials& materials,
                                                    const pugi::xml_node& body);

/// The `<shape>` children of an element, with their materials; those that are not supported are left out.
[[nodiscard]] Result<std::vector<DocumentShape>> readBodyShapes(const ColladaFrame& frame,
                                                                ColladaMaterials& materials,
                                                                const pugi::xml_node& common);

/// A `<rigid_body>` without the mesh that shows it. Nothing, and a note, if none of its shapes is supported.
[[nodiscard]] Result<std::optional<DocumentModel>> readBody(const ColladaFrame& frame,
                                                            ColladaMaterials& materials,
                                                            const pugi::xml_node& body);

/// What a `<rigid_body>` is called: by itself or by the `<physics_model>` around it, and else `fallback`.
[[nodiscard]] std::string bodyName(const pugi::xml_node& body, std::string_view fallback);

}  // namespace scatter::io
