#include "io/collada/bodies.h"

#include <pugixml.hpp>
#include <utility>

#include "io/collada/levels.h"
#include "io/collada/shapes.h"
#include "io/collada/transforms.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

constexpr double kMaxMass = 1e12;

/// 0 is the mass of what does not move.
Result<std::optional<float>> readMass(const ColladaFrame& frame, const pugi::xml_node& node,
                                      BodyProperties& properties) {
  if (!node) {
    return std::nullopt;
  }
  const auto values = frame.numbers(node, 1);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const double mass = values->front();
  if (mass >= 1e-9 && mass <= kMaxMass) {
    return static_cast<float>(mass);
  }
  const std::string what =
      formatNumber(mass, 6) + " is not a mass; give kilograms, more than 0 and at most 1e+12";
  if (mass != 0.0) {
    return frame.xml().failAt(node, what);
  }
  if (!properties.motion || *properties.motion == DocumentMotion::kDynamic) {
    properties.motion = DocumentMotion::kStatic;
  }
  return frame.mend(node, what, "the body does not move").map([] { return std::optional<float>(); });
}

Result<std::optional<DocumentMotion>> readMotion(const ColladaFrame& frame, const pugi::xml_node& body) {
  const pugi::xml_node node = body.child("technique_common").child("dynamic");
  const auto dynamic = frame.flag(node, true);
  if (!dynamic) {
    return tl::unexpected(dynamic.error());
  }
  const pugi::xml_node motion = scatterChild(body, "motion");
  std::string_view text = motion.child_value();
  const std::string_view word = takeWord(text);
  if (motion && word != "kinematic") {
    return frame.xml().failAt(motion, inQuotes(word) + " is not \"kinematic\"");
  }
  if (motion && !*dynamic) {
    return DocumentMotion::kKinematic;
  }
  if (!node) {
    return std::nullopt;
  }
  return *dynamic ? DocumentMotion::kDynamic : DocumentMotion::kStatic;
}

/// In kilograms times the square of the file's unit.
Result<std::optional<Vec3>> readInertia(const ColladaFrame& frame, const pugi::xml_node& node) {
  if (!node) {
    return std::nullopt;
  }
  const auto values = frame.numbers(node, 3);
  if (!values) {
    return tl::unexpected(values.error());
  }
  Vec3 inertia(0.0F);
  for (std::size_t i = 0; i < 3; ++i) {
    const double moment = (*values)[i] * frame.metersPerUnit() * frame.metersPerUnit();
    if (moment == 0.0) {
      frame.note(node, "a moment of 0 is none; the inertia is taken from the shapes");
      return std::nullopt;
    }
    if (!(moment >= 1e-18 && moment <= 1e18)) {
      return frame.xml().failAt(node, formatNumber(moment, 6) + " kg m² is not a moment of inertia");
    }
    inertia[static_cast<int>(i)] = static_cast<float>(moment);
  }
  return inertia;
}

Result<std::optional<DocumentMassFrame>> readMassFrame(const ColladaFrame& frame,
                                                       const pugi::xml_node& common) {
  const pugi::xml_node node = common.child("mass_frame");
  const auto inertia = readInertia(frame, common.child("inertia"));
  const auto pose = readPose(frame, node);
  if (!inertia || !pose) {
    return tl::unexpected(inertia ? pose.error() : inertia.error());
  }
  frame.noteUnknown(node, {"translate", "rotate"});
  if (!node && !*inertia) {
    return std::nullopt;
  }
  return DocumentMassFrame{frame.inYUp(*pose), *inertia};
}

}  // namespace

Result<BodyProperties> readProperties(const ColladaFrame& frame, ColladaMaterials& materials,
                                      const pugi::xml_node& body) {
  BodyProperties result;
  const pugi::xml_node common = body.child("technique_common");
  frame.noteUnknown(body, {"technique_common"});
  frame.noteUnknown(common, {"dynamic", "mass", "mass_frame", "inertia", "instance_physics_material",
                             "physics_material", "shape", "velocity", "angular_velocity"});
  const auto motion = readMotion(frame, body);
  if (!motion) {
    return tl::unexpected(motion.error());
  }
  result.motion = *motion;
  const auto mass = readMass(frame, common.child("mass"), result);
  const auto massFrame = readMassFrame(frame, common);
  if (!mass || !massFrame) {
    return tl::unexpected(mass ? massFrame.error() : mass.error());
  }
  const auto material = materials.find(common);
  if (!material) {
    return tl::unexpected(material.error());
  }
  result.mass = *mass;
  result.massFrame = *massFrame;
  result.material = *material;
  return result;
}

Result<std::vector<DocumentShape>> readBodyShapes(const ColladaFrame& frame, ColladaMaterials& materials,
                                                  const pugi::xml_node& common) {
  std::vector<DocumentShape> shapes;
  for (const pugi::xml_node& node : common.children("shape")) {
    auto shape = readShape(frame, node);
    if (!shape) {
      return tl::unexpected(shape.error());
    }
    if (!*shape) {
      continue;
    }
    const auto material = materials.find(node);
    if (!material) {
      return tl::unexpected(material.error());
    }
    (*shape)->material = *material;
    shapes.push_back(std::move(**shape));
  }
  return shapes;
}

Result<std::optional<DocumentModel>> readBody(const ColladaFrame& frame, ColladaMaterials& materials,
                                              const pugi::xml_node& body) {
  DocumentModel model;
  model.name = bodyName(body, "body");
  const auto properties = readProperties(frame, materials, body);
  if (!properties) {
    return tl::unexpected(properties.error());
  }
  auto shapes = readBodyShapes(frame, materials, body.child("technique_common"));
  if (!shapes) {
    return tl::unexpected(shapes.error());
  }
  if (shapes->empty()) {
    frame.note(body, "has no shape that can be read and is left out");
    return std::nullopt;
  }
  model.shapes = std::move(*shapes);
  model.motion = properties->motion.value_or(DocumentMotion::kDynamic);
  model.mass = properties->mass;
  model.massFrame = properties->massFrame;
  model.material = properties->material;
  if (findLevels(body)) {
    auto levels = readLevels(frame, body, model.name);
    if (!levels) {
      return tl::unexpected(levels.error());
    }
    model.levels = std::move(*levels);
  }
  return model;
}

std::string bodyName(const pugi::xml_node& body, std::string_view fallback) {
  const pugi::xml_node model = body.parent();
  // A model of one body is called what the user called it; of several, the body has to have its own name.
  const bool only = model.child("rigid_body") == body && !body.next_sibling("rigid_body");
  for (const char* attribute : {"name", "id", "sid"}) {
    for (const pugi::xml_node& node : {model, body}) {
      const std::string_view name = node.attribute(attribute).value();
      if (!name.empty() && (only || node == body)) {
        return std::string(name);
      }
    }
  }
  return std::string(fallback);
}

}  // namespace scatter::io
