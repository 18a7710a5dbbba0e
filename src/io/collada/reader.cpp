#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <pugixml.hpp>
#include <string>
#include <utility>

#include "io/collada/bodies.h"
#include "io/collada/frame.h"
#include "io/collada/geometry.h"
#include "io/collada/levels.h"
#include "io/document_mass.h"

namespace scatter::io {
namespace {

/// The one rigid body of the file and the physics model around it.
struct BodyNodes {
  pugi::xml_node model;
  pugi::xml_node body;
  pugi::xml_node common;
};

Result<BodyNodes> findBody(const XmlSource& xml) {
  BodyNodes nodes;
  std::size_t models = 0;
  std::size_t bodies = 0;
  for (const pugi::xml_node& library : xml.root().children("library_physics_models")) {
    for (const pugi::xml_node& model : library.children("physics_model")) {
      ++models;
      for (const pugi::xml_node& body : model.children("rigid_body")) {
        ++bodies;
        nodes = {model, body, body.child("technique_common")};
      }
    }
  }
  if (models == 0) {
    return xml.failAt(xml.root(), "has no <physics_model>; export the model with its physics");
  }
  if (bodies != 1) {
    return xml.failAt(xml.root(), "should hold one <rigid_body>, but holds " + std::to_string(bodies));
  }
  if (!nodes.common) {
    return xml.failAt(nodes.body, "has no <technique_common>; mass and shapes are read from it");
  }
  return nodes;
}

/// The first mesh that the visual scenes show; without any, the first in the geometry library.
Result<pugi::xml_node> findMesh(const XmlSource& xml) {
  for (const pugi::xml_node& scenes : xml.root().children("library_visual_scenes")) {
    const auto isInstance = [](const pugi::xml_node& node) {
      return std::string_view(node.name()) == "instance_geometry";
    };
    if (const pugi::xml_node instance = scenes.find_node(isInstance)) {
      const auto geometry = xml.follow(instance, "url", "geometry");
      return geometry.map([](const pugi::xml_node& node) { return node.child("mesh"); });
    }
  }
  for (const pugi::xml_node& library : xml.root().children("library_geometries")) {
    for (const pugi::xml_node& geometry : library.children("geometry")) {
      if (const pugi::xml_node mesh = geometry.child("mesh")) {
        return mesh;
      }
    }
  }
  return pugi::xml_node();
}

Result<void> readMass(const ColladaFrame& frame, const BodyNodes& nodes, const BodyProperties& properties,
                      Model& model) {
  const auto node = frame.xml().child(nodes.common, "mass", "give the body's mass in kilograms");
  if (!node) {
    return tl::unexpected(node.error());
  }
  model.mass = properties.mass.value_or(model.mass);
  return {};
}

Result<void> readVisual(const ColladaFrame& frame, Model& model) {
  const auto node = findMesh(frame.xml());
  if (!node || !*node) {
    return node.map([](const pugi::xml_node&) {});
  }
  return readMesh(frame, *node).map([&](VisualMesh mesh) { model.mesh = std::move(mesh); });
}

/// The levels with the centre and inertia that the file gives, if it does.
Result<std::shared_ptr<const LevelSet>> withMassFrame(std::shared_ptr<const LevelSet> levels,
                                                      const std::optional<DocumentMassFrame>& massFrame,
                                                      float mass) {
  if (!massFrame) return levels;
  DocumentModel model;
  model.name = levels->name();
  model.levels = levels;
  model.massFrame = massFrame;
  return documentMassProperties(model, levels->finest().parts, mass)
      .and_then([&](const std::optional<MassProperties>& properties) {
        return levelsWithMass(model, levels->finest().parts, properties);
      });
}

Result<Model> readModel(const ColladaFrame& frame, std::string_view fileName) {
  const auto nodes = findBody(frame.xml());
  if (!nodes) {
    return tl::unexpected(nodes.error());
  }
  Model model;
  model.name = bodyName(nodes->body, std::filesystem::path(fileName).stem().string());
  auto materials = ColladaMaterials::read(frame);
  if (!materials) {
    return tl::unexpected(materials.error());
  }
  const auto properties = readProperties(frame, *materials, nodes->body);
  if (!properties) {
    return tl::unexpected(properties.error());
  }
  if (properties->material) {
    const DocumentMaterial& material = materials->all()[*properties->material];
    model.friction = material.dynamicFriction;
    model.restitution = material.restitution;
  }
  const auto rest =
      readMass(frame, *nodes, *properties, model).and_then([&] { return readVisual(frame, model); });
  if (!rest) {
    return tl::unexpected(rest.error());
  }
  return readLevels(frame, nodes->body, model.name)
      .and_then([&](std::shared_ptr<const LevelSet> levels) {
        return withMassFrame(std::move(levels), properties->massFrame, model.mass);
      })
      .map([&](std::shared_ptr<const LevelSet> levels) {
        model.levels = std::move(levels);
        return std::move(model);
      });
}

}  // namespace
}  // namespace scatter::io

namespace scatter {

Result<Model> parseCollada(std::string_view xml, std::string_view nameForMessages) {
  io::ColladaNotes notes(false);
  return io::parseColladaXml(xml, nameForMessages).and_then([&](const io::XmlSource& source) {
    return io::ColladaFrame::read(source, notes).and_then([&](const io::ColladaFrame& frame) {
      return io::readModel(frame, nameForMessages);
    });
  });
}

Result<Model> readCollada(const std::filesystem::path& path) {
  return readFile(path).and_then([&](const std::string& text) { return parseCollada(text, path.string()); });
}

}  // namespace scatter
