#pragma once

#include <scatter/io/model.h>
#include <scatter/io/physics_document.h>
#include <scatter/result.h>

#include <filesystem>
#include <string_view>

namespace scatter {

/// Reads the one rigid body of a COLLADA 1.4.1 physics file. Its shapes are the finest level; coarser
/// ones stand in its `<extra><technique profile="SCATTER">` as
/// `<levels margin="0.02" count="3"><level index="1">shapes</level><level index="2">…`, coarsest first.
/// Without that element the model has a single level. Lengths become metres and the y axis points up,
/// whatever the file uses. The mesh is that of the first geometry instance in the visual scenes, without its
/// node's transform. Elements that are not known are ignored. Errors read `FILE:LINE: <element>: what is
/// wrong`.
[[nodiscard]] Result<Model> readCollada(const std::filesystem::path& path);

/// The same from text. `nameForMessages` stands for the file name.
[[nodiscard]] Result<Model> parseCollada(std::string_view xml, std::string_view nameForMessages);

/// Writes a file that is valid against the COLLADA 1.4.1 schema and reads back as the same model; the same
/// model always gives the same bytes. Two things are not kept: characters of the name that COLLADA does
/// not allow become '_', and mass properties given by hand are lost, because the reader takes them from the
/// finest level. Fails, leaving nothing behind, if the model has a value that is out of range or the
/// file cannot be written whole.
[[nodiscard]] Result<void> writeCollada(const Model& model, const std::filesystem::path& path);

/// Reads the physics scene of a COLLADA 1.4.0, 1.4.1 or 1.5 file. Bodies stand where the nodes stand that
/// they move. What the reader leaves out or mends is named in the document's warnings, as `FILE:LINE:
/// <element>: what`; what makes no sense is an error in the same form. Of several physics scenes, those that
/// `<scene>` instances are read.
[[nodiscard]] Result<PhysicsDocument> readColladaDocument(const std::filesystem::path& path);

/// The same from text. `nameForMessages` stands for the file name.
[[nodiscard]] Result<PhysicsDocument> parseColladaDocument(std::string_view xml,
                                                           std::string_view nameForMessages);

/// Writes a file that is valid against the COLLADA 1.4.1 schema and reads back as the same document, but for
/// warnings and for names that are empty or have characters that COLLADA does not allow. Fails, leaving
/// nothing behind, if the document has a value that is out of range, an index that names nothing, or the
/// file cannot be written whole.
[[nodiscard]] Result<void> writeColladaDocument(const PhysicsDocument& document,
                                                const std::filesystem::path& path);

}  // namespace scatter
