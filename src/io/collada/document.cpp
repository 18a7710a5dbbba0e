#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <glm/geometric.hpp>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "io/collada/fields.h"
#include "io/collada/frame.h"
#include "io/collada/materials.h"
#include "io/collada/models.h"
#include "io/collada/nodes.h"
#include "io/collada/scene.h"
#include "io/collada/visuals.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

/// The nodes that bodies move, by hash value.
std::set<std::size_t> findMovedNodes(const ColladaFrame& frame) {
  struct Walker : pugi::xml_tree_walker {
    const ColladaFrame* frame = nullptr;
    std::set<std::size_t> found;
    bool for_each(pugi::xml_node& node) override {
      const std::string_view target = node.attribute("target").value();
      if (!target.empty() && std::string_view(node.name()) == "instance_rigid_body") {
        const pugi::xml_node moved = frame->xml().findId(target.substr(target.front() == '#' ? 1 : 0));
        if (moved) {
          found.insert(moved.hash_value());
        }
      }
      return true;
    }
  };
  Walker walker;
  walker.frame = &frame;
  for (pugi::xml_node library : frame.xml().root().children()) {
    if (std::string_view(library.name()).substr(0, 15) == "library_physics") {
      library.traverse(walker);
    }
  }
  return std::move(walker.found);
}

/// The physics scenes that `<scene>` instances; the first of the file if it does not say.
Result<std::vector<pugi::xml_node>> findScenes(const ColladaFrame& frame) {
  std::vector<pugi::xml_node> scenes;
  const pugi::xml_node root = frame.xml().root();
  for (const pugi::xml_node& instance : root.child("scene").children("instance_physics_scene")) {
    const auto scene = frame.followOrMend(instance, "url", "physics_scene", "it is left out");
    if (!scene) {
      return tl::unexpected(scene.error());
    }
    if (*scene) {
      scenes.push_back(*scene);
    }
  }
  const pugi::xml_node library = root.find_child([](const pugi::xml_node& child) {
    return std::string_view(child.name()) == "library_physics_scenes" && child.child("physics_scene");
  });
  if (const pugi::xml_node first = library.child("physics_scene"); scenes.empty() && first) {
    frame.note(first, "no <instance_physics_scene> names a physics scene; the first one is read");
    scenes.push_back(first);
  }
  std::set<std::size_t> used;
  for (const pugi::xml_node& scene : scenes) {
    used.insert(scene.hash_value());
  }
  frame.noteUnused("library_physics_scenes", "physics_scene", used);
  return scenes;
}

void noteUnitOfGravity(const ColladaFrame& frame, const pugi::xml_node& node, const Vec3& gravity) {
  const float length = glm::length(gravity);
  if (length > 9.5F && length < 10.1F && frame.metersPerUnit() != 1.0) {
    frame.note(node, "is in the file's unit, which makes it " +
                         formatNumber(static_cast<double>(length) * frame.metersPerUnit(), 3) +
                         " m/s²; that of the Earth would be " +
                         formatNumber(9.81 / frame.metersPerUnit(), 6));
  }
}

/// Gravity and time step.
Result<void> readWorld(const ColladaFrame& frame, const pugi::xml_node& scene, PhysicsDocument& document) {
  const pugi::xml_node common = scene.child("technique_common");
  frame.noteUnknown(scene, {"technique_common", "instance_force_field", "instance_physics_model"});
  frame.noteUnknown(common, {"gravity", "time_step"});
  document.saysGravity = document.saysGravity && common.child("gravity");
  if (const pugi::xml_node node = common.child("gravity")) {
    const auto gravity = frame.plainVector(node);
    if (!gravity) {
      return tl::unexpected(gravity.error());
    }
    noteUnitOfGravity(frame, node, *gravity);
    document.gravity = frame.turnYUp(*gravity * static_cast<float>(frame.metersPerUnit()));
    if (glm::length(document.gravity) > 1e9F) {
      return frame.xml().failAt(node, "is more than 1e9 m/s²");
    }
  }
  const pugi::xml_node node = common.child("time_step");
  const auto step = frame.scalar(node, 0.0, 1e3);
  if (!step) {
    return tl::unexpected(step.error());
  }
  if (*step && **step < 1e-9F) {
    frame.note(node, "is no time and is ignored");
  } else {
    document.timeStep = *step;
  }
  return {};
}

Result<void> readScene(const ColladaFrame& frame, const pugi::xml_node& scene, ColladaScene& bodies,
                       std::set<std::size_t>& usedFields, PhysicsDocument& document) {
  for (const pugi::xml_node& instance : scene.children("instance_force_field")) {
    auto field = readField(frame, instance, usedFields);
    if (!field) {
      return tl::unexpected(field.error());
    }
    if (*field) {
      document.fields.push_back(std::move(**field));
    }
  }
  for (const pugi::xml_node& instance : scene.children("instance_physics_model")) {
    if (const auto added = bodies.addInstance(instance); !added) {
      return added;
    }
  }
  return {};
}

Result<void> readScenes(const ColladaFrame& frame, ColladaScene& bodies, PhysicsDocument& document) {
  const auto scenes = findScenes(frame);
  if (!scenes) {
    return tl::unexpected(scenes.error());
  }
  if (scenes->empty()) {
    frame.note(frame.xml().root(), "has no physics scene; each of its rigid bodies stands at the origin");
    frame.noteUnused("library_force_fields", "force_field", {});
    bodies.noteUnusedConstraints();
    return bodies.addEveryBody();
  }
  const std::string_view name = scenes->front().attribute("name").value();
  document.name = name.empty() ? document.name : name;
  if (const auto world = readWorld(frame, scenes->front(), document); !world) {
    return world;
  }
  std::set<std::size_t> usedFields;
  for (const pugi::xml_node& scene : *scenes) {
    if (scene != scenes->front()) {
      frame.note(scene, "is read together with the first one, whose gravity and time step are taken");
    }
    if (const auto read = readScene(frame, scene, bodies, usedFields, document); !read) {
      return read;
    }
  }
  frame.noteUnused("library_force_fields", "force_field", usedFields);
  bodies.noteUnusedConstraints();
  return bodies.addJoints();
}

/// What moves bodies and is not read. Cameras, lights and what surfaces look like are no part of a document.
void noteLibraries(const ColladaFrame& frame) {
  for (const pugi::xml_node& library : frame.xml().root().children()) {
    const std::string_view name = library.name();
    for (const char* moving : {"animation", "kinematics", "articulated", "joints", "formulas"}) {
      if (name.starts_with("library_") && name.find(moving) != std::string_view::npos) {
        frame.note(library, "is not supported; the scene is read as it starts");
      }
    }
  }
}

Result<PhysicsDocument> readDocument(const ColladaFrame& frame, std::string_view fileName) {
  PhysicsDocument document;
  document.name = std::filesystem::path(fileName).stem().string();
  noteLibraries(frame);
  auto materials = ColladaMaterials::read(frame);
  if (!materials) {
    return tl::unexpected(materials.error());
  }
  const std::set<std::size_t> moved = findMovedNodes(frame);
  auto nodes = ColladaNodes::read(frame, moved);
  if (!nodes) {
    return tl::unexpected(nodes.error());
  }
  ColladaVisuals visuals(frame, moved);
  auto models = ColladaModels::read(frame, *materials, visuals);
  if (!models) {
    return tl::unexpected(models.error());
  }
  if (models->all().empty()) {
    return frame.xml().failAt(frame.xml().root(),
                              "has no <rigid_body> that can be read; export the scene with its physics");
  }
  ColladaScene bodies(frame, *models, *nodes, document);
  if (const auto read = readScenes(frame, bodies, document); !read) {
    return tl::unexpected(read.error());
  }
  document.models = std::move(models->all());
  document.materials = materials->all();
  return document;
}

}  // namespace
}  // namespace scatter::io

namespace scatter {

Result<PhysicsDocument> parseColladaDocument(std::string_view xml, std::string_view nameForMessages) {
  io::ColladaNotes notes(true);
  auto document = io::parseColladaXml(xml, nameForMessages).and_then([&](const io::XmlSource& source) {
    return io::ColladaFrame::read(source, notes).and_then([&](const io::ColladaFrame& frame) {
      return io::readDocument(frame, nameForMessages);
    });
  });
  if (document) {
    document->warnings = notes.lines();
  }
  return document;
}

Result<PhysicsDocument> readColladaDocument(const std::filesystem::path& path) {
  return readFile(path).and_then(
      [&](const std::string& text) { return parseColladaDocument(text, path.string()); });
}

}  // namespace scatter
