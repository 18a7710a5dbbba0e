#pragma once

#include <scatter/math.h>

#include <pugixml.hpp>
#include <string>
#include <vector>

namespace scatter::io {

/// Parts of a COLLADA file that is being written.
/// @{

pugi::xml_node append(pugi::xml_node& parent, const char* name);
pugi::xml_node appendText(pugi::xml_node& parent, const char* name, const std::string& text);
void setAttribute(pugi::xml_node& node, const char* name, const std::string& value);

/// The id of the element of a kind with that index: "mesh", "mesh-2", "mesh-3" …
[[nodiscard]] std::string makeId(const char* kind, std::size_t index);

[[nodiscard]] std::string link(const std::string& id);

[[nodiscard]] std::string formatVector(const Vec3& v);

/// The name as an XML NCName, which is all that COLLADA's attributes allow.
[[nodiscard]] std::string formatName(const std::string& name);

/// Sets the attribute `name` if there is one.
void setName(pugi::xml_node& node, const std::string& name);

/// The library of an `element`: one for each item, with an id of that kind and the item's name, whose content
/// `writeContent` adds. Without items there is no library: the schema wants none that is empty.
template <class Item, class WriteContent>
void writeLibrary(pugi::xml_node& root, const std::string& element, const char* idKind,
                  const std::vector<Item>& items, const WriteContent& writeContent) {
  if (items.empty()) {
    return;
  }
  pugi::xml_node library = append(root, ("library_" + element + "s").c_str());
  for (std::size_t index = 0; index < items.size(); ++index) {
    pugi::xml_node node = append(library, element.c_str());
    setAttribute(node, "id", makeId(idKind, index));
    setName(node, items[index].name);
    writeContent(node, items[index]);
  }
}

/// Degrees with as few digits as give back the same number of radians.
[[nodiscard]] std::string formatDegrees(float radians);

/// `<translate>` and `<rotate>`, where they do something.
void writePose(pugi::xml_node& parent, const Transform& pose);

/// The `<technique profile="SCATTER">` in the last `<extra>` of an element, which is made if need be.
[[nodiscard]] pugi::xml_node scatterTechnique(pugi::xml_node& parent);

/// A `<source>` and `<vertices>` with these positions, with ids that begin with `id`.
void writePositions(pugi::xml_node& mesh, const std::string& id, const std::vector<Vec3>& positions);

/// The outermost element with its `<asset>`.
[[nodiscard]] pugi::xml_node writeRoot(pugi::xml_document& document);

[[nodiscard]] std::string textOf(const pugi::xml_document& document);

/// @}

}  // namespace scatter::io
