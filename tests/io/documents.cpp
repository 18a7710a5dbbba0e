#include "io/documents.h"

namespace scatter::test {

std::string Document::text() const {
  return "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n"
         "<asset>" +
         asset + "</asset>\n" + libraries + "\n<library_physics_models><physics_model " + modelAttributes +
         "><rigid_body sid=\"body\"><technique_common>\n" + mass + "\n" + material + "\n" + finest +
         "</technique_common>\n" + extra +
         "</rigid_body></physics_model></library_physics_models></COLLADA>\n";
}

std::string coarser(const std::string& levels, const std::string& attributes) {
  return "<extra><technique profile=\"SCATTER\"><levels " + attributes + ">" + levels +
         "</levels></technique></extra>";
}

std::string boxLevel(int index, const std::string& halfExtents) {
  return "<level index=\"" + std::to_string(index) + "\"><shape><box><half_extents>" + halfExtents +
         "</half_extents></box></shape></level>";
}

std::string geometry(const std::string& id, const std::string& kind, int count, const std::string& numbers,
                     const std::string& primitives) {
  const std::string array = std::to_string(3 * count);
  const std::string accessor = std::to_string(count);
  std::string text =
      "<geometry id=\"ID\"><KIND><source id=\"ID-p\"><float_array id=\"ID-a\" count=\"ARRAY\">";
  text += numbers +
          "</float_array><technique_common><accessor source=\"#ID-a\" count=\"COUNT\" stride=\"3\"/>"
          "</technique_common></source><vertices id=\"ID-v\"><input semantic=\"POSITION\" source=\"#ID-p\"/>"
          "</vertices>";
  text += primitives + "</KIND></geometry>";
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
  };
  replace("ID", id);
  replace("KIND", kind);
  replace("ARRAY", array);
  replace("COUNT", accessor);
  return text;
}

Document richDocument() {
  Document document;
  const std::string input = "<input semantic=\"VERTEX\" source=\"#mesh-v\" offset=\"0\"/>";
  document.libraries =
      "<library_geometries>" +
      geometry("mesh", "mesh", 4, "0 0 0  0.2 0 0  0 0.2 0  0 0 0.2",
               "<triangles count=\"1\">" + input + "<p>0 2 1</p></triangles><polylist count=\"1\">" + input +
                   "<vcount>3</vcount><p>0 1 3</p></polylist>") +
      geometry("hull", "convex_mesh", 4, "0 0 0  0.2 0 0  0 0.2 0  0 0 0.2") +
      "<geometry id=\"of\"><convex_mesh convex_hull_of=\"#mesh\"/></geometry></library_geometries>"
      "<library_physics_materials><physics_material id=\"steel\"><technique_common>"
      "<dynamic_friction>0.7</dynamic_friction><restitution>0.2</restitution></technique_common>"
      "</physics_material></library_physics_materials>";
  document.material = "<instance_physics_material url=\"#steel\"/>";
  document.finest =
      "<shape><box><half_extents>0.3 0.2 0.1</half_extents></box><translate>0.1 0 0</translate></shape>"
      "<shape><sphere><radius>0.3</radius></sphere></shape>"
      "<shape><capsule><height>0.4</height><radius>0.1 0.1</radius></capsule><rotate>1 0 0 "
      "30</rotate></shape>"
      "<shape><cylinder><height>0.4</height><radius>0.2 0.2</radius></cylinder></shape>"
      "<shape><instance_geometry url=\"#hull\"/></shape><shape><instance_geometry url=\"#of\"/></shape>";
  document.extra = coarser(boxLevel(1, "2 2 2") + boxLevel(2, "1 1 1"), "margin=\"0.01\" count=\"3\"");
  return document;
}

}  // namespace scatter::test
