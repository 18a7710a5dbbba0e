#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <pugixml.hpp>
#include <string>
#include <utility>

#include "io/collada_frame.h"
#include "io/collada_geometry.h"
#include "io/collada_shapes.h"
#include "io/numbers.h"

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

/// A number in `low` to `high`, or the fallback if the element is absent.
Result<float> readScalar(const ColladaFrame& frame, const pugi::xml_node& node, float fallback, double low,
                         double high) {
  if (!node) {
    return fallback;
  }
  const auto values = frame.numbers(node, 1);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const double value = values->front();
  if (value < low || value > high) {
    return frame.xml().failAt(node, formatNumber(value, 6) + " is not from " + formatNumber(low, 6) + " to " +
                                        formatNumber(high, 6));
  }
  return static_cast<float>(value);
}

Result<float> readMass(const ColladaFrame& frame, const pugi::xml_node& common) {
  const auto node = frame.xml().child(common, "mass", "give the body's mass in kilograms");
  if (!node) {
    return tl::unexpected(node.error());
  }
  const auto values = frame.numbers(*node, 1);
  if (!values) {
    return tl::unexpected(values.error());
  }
  if (!(values->front() >= 1e-9 && values->front() <= 1e12)) {
    return frame.xml().failAt(*node, formatNumber(values->front(), 6) +
                                         " is not a mass; give kilograms, more than 0 and at most 1e+12");
  }
  return static_cast<float>(values->front());
}

Result<pugi::xml_node> findMaterial(const ColladaFrame& frame, const pugi::xml_node& common) {
  const pugi::xml_node instance = common.child("instance_physics_material");
  if (!instance) {
    return common.child("physics_material");
  }
  return frame.xml().follow(instance, "url", "physics_material");
}

Result<void> readMaterial(const ColladaFrame& frame, const pugi::xml_node& common, Model& model) {
  const auto material = findMaterial(frame, common);
  if (!material) {
    return tl::unexpected(material.error());
  }
  const pugi::xml_node technique = material->child("technique_common");
  const pugi::xml_node dynamic = technique.child("dynamic_friction");
  const auto friction =
      readScalar(frame, dynamic ? dynamic : technique.child("static_friction"), model.friction, 0.0, 1e3);
  const auto restitution = readScalar(frame, technique.child("restitution"), model.restitution, 0.0, 1.0);
  if (!friction || !restitution) {
    return tl::unexpected(friction ? restitution.error() : friction.error());
  }
  model.friction = *friction;
  model.restitution = *restitution;
  return {};
}

pugi::xml_node findCoarserLevels(const pugi::xml_node& body) {
  for (const pugi::xml_node& extra : body.children("extra")) {
    const pugi::xml_node technique = extra.find_child_by_attribute("technique", "profile", "SCATTER");
    if (const pugi::xml_node levels = technique.child("levels")) {
      return levels;
    }
  }
  return {};
}

Result<void> readMargin(const ColladaFrame& frame, const pugi::xml_node& levels, LevelSetDef& def) {
  const pugi::xml_attribute attribute = levels.attribute("margin");
  if (!attribute) {
    return {};
  }
  const auto margin = parseNumber(attribute.value());
  if (!margin || !(*margin >= 0.0 && *margin <= ColladaFrame::kMaxLength)) {
    return frame.xml().failAt(levels,
                              "margin " + inQuotes(attribute.value()) + " is not a length of 0 or more");
  }
  def.hullMargin = frame.toMeters(*margin);
  return {};
}

/// `count` is that of all levels; the finest stands outside the element.
Result<void> checkLevelCount(const ColladaFrame& frame, const pugi::xml_node& levels, std::uint32_t found) {
  const auto count = frame.indexAttribute(levels, "count", found);
  if (!count) {
    return tl::unexpected(count.error());
  }
  if (*count != found) {
    return frame.xml().failAt(levels, "should hold " + std::to_string(*count) +
                                          " levels with the body's own shapes, but holds " +
                                          std::to_string(found));
  }
  if (found == 1 && !levels.attribute("count")) {
    return frame.xml().failAt(levels, "has no <level>; list the coarser levels or leave the element out");
  }
  return {};
}

Result<void> readCoarserLevels(const ColladaFrame& frame, const pugi::xml_node& levels, LevelSetDef& def) {
  if (const auto margin = readMargin(frame, levels, def); !margin) {
    return margin;
  }
  std::uint32_t expected = 1;
  for (const pugi::xml_node& node : levels.children("level")) {
    const auto index = frame.indexAttribute(node, "index", 0);
    if (!index) {
      return tl::unexpected(index.error());
    }
    if (*index != expected) {
      return frame.xml().failAt(node, "should have index=\"" + std::to_string(expected) +
                                          "\"; levels are numbered from 1, the coarsest, in order");
    }
    auto level = readShapes(frame, node);
    if (!level) {
      return tl::unexpected(level.error());
    }
    def.levels.push_back(std::move(*level));
    ++expected;
  }
  return checkLevelCount(frame, levels, expected);
}

Result<std::shared_ptr<const LevelSet>> readLevels(const ColladaFrame& frame, const BodyNodes& nodes,
                                                   const std::string& name) {
  LevelSetDef def;
  def.name = name;
  const pugi::xml_node coarser = findCoarserLevels(nodes.body);
  if (coarser) {
    if (const auto read = readCoarserLevels(frame, coarser, def); !read) {
      return tl::unexpected(read.error());
    }
  }
  auto finest = readShapes(frame, nodes.common);
  if (!finest) {
    return tl::unexpected(finest.error());
  }
  def.levels.push_back(std::move(*finest));
  auto levels = LevelSet::create(std::move(def));
  if (!levels) {
    return frame.xml().failAt(coarser ? coarser : nodes.body, levels.error().message);
  }
  return levels;
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

std::string findName(const BodyNodes& nodes, std::string_view fileName) {
  for (const char* attribute : {"name", "id", "sid"}) {
    for (const pugi::xml_node& node : {nodes.model, nodes.body}) {
      if (const std::string_view name = node.attribute(attribute).value(); !name.empty()) {
        return std::string(name);
      }
    }
  }
  return std::filesystem::path(fileName).stem().string();
}

Result<Model> readModel(const ColladaFrame& frame, std::string_view fileName) {
  const XmlSource& xml = frame.xml();
  const auto nodes = findBody(xml);
  if (!nodes) {
    return tl::unexpected(nodes.error());
  }
  Model model;
  model.name = findName(*nodes, fileName);
  const auto mass = readMass(frame, nodes->common);
  if (!mass) {
    return tl::unexpected(mass.error());
  }
  model.mass = *mass;
  if (const auto material = readMaterial(frame, nodes->common, model); !material) {
    return tl::unexpected(material.error());
  }
  const auto meshNode = findMesh(xml);
  if (!meshNode) {
    return tl::unexpected(meshNode.error());
  }
  if (*meshNode) {
    auto mesh = readMesh(frame, *meshNode);
    if (!mesh) {
      return tl::unexpected(mesh.error());
    }
    model.mesh = std::move(*mesh);
  }
  auto levels = readLevels(frame, *nodes, model.name);
  if (!levels) {
    return tl::unexpected(levels.error());
  }
  model.levels = std::move(*levels);
  return model;
}

}  // namespace
}  // namespace scatter::io

namespace scatter {

Result<Model> parseCollada(std::string_view xml, std::string_view nameForMessages) {
  const auto source = io::XmlSource::parse(xml, nameForMessages);
  if (!source) {
    return tl::unexpected(source.error());
  }
  if (std::string_view(source->root().name()) != "COLLADA") {
    return source->failAt(source->root(), "is not a COLLADA document");
  }
  return io::ColladaFrame::read(*source).and_then(
      [&](const io::ColladaFrame& frame) { return io::readModel(frame, nameForMessages); });
}

Result<Model> readCollada(const std::filesystem::path& path) {
  return readFile(path).and_then([&](const std::string& text) { return parseCollada(text, path.string()); });
}

}  // namespace scatter
