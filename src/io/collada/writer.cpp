#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <pugixml.hpp>
#include <string>

#include "io/collada/check.h"
#include "io/collada/model_writer.h"
#include "io/collada/scene_writer.h"
#include "io/collada/xml.h"
#include "io/collada/xml_source.h"
#include "io/document_mass.h"

namespace scatter::io {
namespace {

/// A document of one model and one body of it.
PhysicsDocument documentOf(const Model& model) {
  PhysicsDocument document;
  document.materials.push_back({"", model.friction, model.friction, model.restitution});
  DocumentModel body;
  body.name = model.name;
  for (const ConvexPart& part : model.levels->finest().parts) {
    body.shapes.push_back({part.shape, part.pose, {}, {}, {}});
  }
  body.levels = model.levels;
  body.mesh = model.mesh;
  body.mass = model.mass;
  body.massFrame = massFrameOf(*model.levels, model.mass);
  body.material = 0;
  document.models.push_back(std::move(body));
  document.bodies.emplace_back();
  return document;
}

}  // namespace
}  // namespace scatter::io

namespace scatter {

Result<void> writeColladaDocument(const PhysicsDocument& document, const std::filesystem::path& path) {
  if (const auto sound = io::checkDocument(document, io::kColladaBounds); !sound) {
    return fail("cannot write " + path.string() + ": " + sound.error().message);
  }
  pugi::xml_document xml;
  pugi::xml_node root = io::writeRoot(xml);
  io::writeGeometries(root, document);
  io::writeFields(root, document);
  io::writeMaterials(root, document);
  io::writePhysicsModels(root, document);
  io::writeScenes(root, document);
  return writeFile(path, io::textOf(xml));
}

Result<void> writeCollada(const Model& model, const std::filesystem::path& path) {
  if (model.levels == nullptr) {
    return fail("cannot write " + path.string() + ": model " + io::inQuotes(model.name) + " has no levels");
  }
  return writeColladaDocument(io::documentOf(model), path);
}

}  // namespace scatter
