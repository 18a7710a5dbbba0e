#include "io/collada/scene.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "io/collada/transforms.h"

namespace scatter::io {
namespace {

/// Instances in instances can multiply; each costs as much as some vertices.
constexpr std::size_t kInstanceCost = 50;
constexpr std::size_t kMaxNesting = 64;

/// The children of a physics model of that kind by their sid, id or name, in this order of precedence.
std::map<std::string_view, pugi::xml_node> indexChildren(const pugi::xml_node& model) {
  std::map<std::string_view, pugi::xml_node> result;
  for (const char* attribute : {"sid", "id", "name"}) {
    for (const char* kind : {"rigid_body", "rigid_constraint"}) {
      for (const pugi::xml_node& child : model.children(kind)) {
        if (const std::string_view name = child.attribute(attribute).value(); !name.empty()) {
          result.emplace(name, child);
        }
      }
    }
  }
  return result;
}

std::string_view lastStep(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

Vec3 scaleWithoutNoise(const Vec3& scale) {
  const auto isOne = [](float s) { return s > 1.0F - 1e-5F && s < 1.0F + 1e-5F; };
  return isOne(scale.x) && isOne(scale.y) && isOne(scale.z) ? Vec3(1.0F) : scale;
}

}  // namespace

Result<void> ColladaScene::addInstance(const pugi::xml_node& instance) {
  scopes_.emplace_back();
  return addNested(instance, scopes_.size() - 1);
}

Result<void> ColladaScene::addNested(const pugi::xml_node& instance, std::size_t scope) {
  const auto model = frame_->followOrMend(instance, "url", "physics_model", "its bodies are left out");
  if (!model || !*model) {
    return model.map([](const pugi::xml_node&) {});
  }
  if (open_.size() >= kMaxNesting || open_.contains(model->hash_value())) {
    frame_->note(instance, "leads back to the physics model around it, or too deep, and is left out");
    return {};
  }
  frame_->noteUnknown(*model, {"rigid_body", "rigid_constraint", "instance_physics_model"});
  open_.insert(model->hash_value());
  const auto added = addContent({instance, *model, scope});
  open_.erase(model->hash_value());
  return added;
}

Result<void> ColladaScene::addContent(const Context& context) {
  frame_->noteUnknown(context.instance, {"instance_rigid_body", "instance_rigid_constraint"});
  if (context.model.child("rigid_body") && !context.instance.child("instance_rigid_body")) {
    frame_->note(context.instance, "has no <instance_rigid_body>; the model's bodies are left out");
  }
  if (context.instance.attribute("parent")) {
    frame_->note(context.instance, "parent is not supported; bodies stand where their target nodes stand");
  }
  for (const pugi::xml_node& nested : context.model.children("instance_physics_model")) {
    if (const auto added = addNested(nested, context.scope); !added) {
      return added;
    }
  }
  for (const pugi::xml_node& body : context.instance.children("instance_rigid_body")) {
    if (const auto added = addBody(body, context); !added) {
      return added;
    }
  }
  for (const pugi::xml_node& constraint : context.instance.children("instance_rigid_constraint")) {
    if (const auto added = addConstraint(constraint, context); !added) {
      return added;
    }
  }
  return frame_->take(context.instance, kInstanceCost);
}

pugi::xml_node ColladaScene::findChild(const pugi::xml_node& instance, const pugi::xml_node& model) {
  const auto [index, isNew] = sids_.try_emplace(model.hash_value());
  if (isNew) {
    index->second = indexChildren(model);
  }
  const bool wantsBody = std::string_view(instance.name()) == "instance_rigid_body";
  const std::string_view path = instance.attribute(wantsBody ? "body" : "constraint").value();
  const char* kind = wantsBody ? "rigid_body" : "rigid_constraint";
  const std::string_view sid = path.empty() || path.front() != '#' ? path : path.substr(1);
  for (const std::string_view name : {sid, lastStep(sid)}) {
    const auto found = index->second.find(name);
    if (found != index->second.end() && std::string_view(found->second.name()) == kind) {
      return found->second;
    }
  }
  const pugi::xml_node only = model.child(kind);
  if (path.empty() && only && !only.next_sibling(kind)) {
    frame_->note(instance, std::string("names no <") + kind + ">; the only one of its model is taken");
    return only;
  }
  return {};
}

Result<void> ColladaScene::addBody(const pugi::xml_node& instance, const Context& context) {
  const pugi::xml_node body = findChild(instance, context.model);
  if (!body) {
    frame_->note(instance, "body " + inQuotes(instance.attribute("body").value()) +
                               " names no <rigid_body> of its model; it is left out");
    return {};
  }
  auto start = readStart(instance, context);
  if (!start) {
    return tl::unexpected(start.error());
  }
  const auto model = models_->find(body, start->look);
  if (!model || !*model) {
    return model.map([](std::optional<std::size_t>) {});
  }
  DocumentBody result;
  result.model = **model;
  result.pose = start->pose;
  if (const auto movement = readMovement(instance, body, result); !movement) {
    return movement;
  }
  result.name = uniqueName(wishedName(instance, body, *start));
  rememberBody(instance, body, context.scope);
  document_->bodies.push_back(std::move(result));
  return frame_->take(instance, kInstanceCost);
}

std::string ColladaScene::wishedName(const pugi::xml_node& instance, const pugi::xml_node& body,
                                     const Start& start) {
  std::string name(start.nodeName);
  for (const char* attribute : {"name", "sid"}) {
    name = name.empty() ? instance.attribute(attribute).value() : name;
  }
  return name.empty() ? bodyName(body, start.nodeId) : name;
}

void ColladaScene::rememberBody(const pugi::xml_node& instance, const pugi::xml_node& body,
                                std::size_t scope) {
  const std::size_t index = document_->bodies.size();
  for (const char* attribute : {"sid", "id", "name"}) {
    if (const std::string_view key = body.attribute(attribute).value(); !key.empty()) {
      scopes_[scope].emplace(key, index);
    }
  }
  const std::string_view target = instance.attribute("target").value();
  const bool hash = !target.empty() && target.front() == '#';
  if (const pugi::xml_node node = frame_->xml().findId(target.substr(hash ? 1 : 0))) {
    bodyOfNode_.emplace(node.hash_value(), index);
  }
}

Result<ColladaScene::Start> ColladaScene::readStart(const pugi::xml_node& instance, const Context& context) {
  Start start;
  start.look.instance = instance;
  const bool parent = !instance.attribute("target") && context.instance.attribute("parent");
  const auto node = frame_->followOrMend(parent ? context.instance : instance, parent ? "parent" : "target",
                                         "node", "the body stands at the origin");
  if (!node || !*node) {
    return node.map([&](const pugi::xml_node&) { return std::move(start); });
  }
  if (!parent) {
    start.nodeName = node->attribute("name").value();
    start.nodeId = node->attribute("id").value();
  }
  return readPlace(*node, start).map([&] { return std::move(start); });
}

Result<void> ColladaScene::readPlace(const pugi::xml_node& node, Start& start) {
  const auto place = nodes_->placement(node);
  if (!place) {
    return tl::unexpected(place.error());
  }
  Placement residue;
  start.pose = place->pose;
  if (!place->rigid) {
    const auto apart = takeApart(place->matrix);
    if (!apart) {
      return frame_->xml().failAt(node, "its transform " + apart.error().message);
    }
    start.pose = apart->pose;
    start.look.scale = scaleWithoutNoise(apart->scale);
    if (apart->sheared) {
      frame_->note(node, "its transform has a shear, which the shapes of its body do not get");
    }
    if (start.look.scale != Vec3(1.0F) || apart->sheared) {
      residue = {{}, glm::inverse(matrixOf(start.pose)) * place->matrix, false};
    }
    if (start.look.scale != Vec3(1.0F)) {
      frame_->note(node, "its scale goes into the shapes of its body");
    }
  }
  constexpr auto kFar = static_cast<float>(ColladaFrame::kMaxLength);
  if (!(glm::length(start.pose.position) <= kFar)) {
    return frame_->xml().failAt(node, "is too far from the origin");
  }
  return models_->visuals().find(node, residue).map([&](std::vector<VisualPart> parts) {
    start.look.visuals = std::move(parts);
  });
}

Result<void> ColladaScene::readMovement(const pugi::xml_node& instance, const pugi::xml_node& body,
                                        DocumentBody& result) {
  const auto properties = readProperties(*frame_, models_->materials(), instance);
  if (!properties) {
    return tl::unexpected(properties.error());
  }
  result.motion = properties->motion;
  result.mass = properties->mass;
  const auto find = [&](const char* name) {
    const pugi::xml_node own = instance.child("technique_common").child(name);
    return own ? own : body.child("technique_common").child(name);
  };
  if (const pugi::xml_node node = find("velocity")) {
    const auto velocity = frame_->vector(node);
    if (!velocity) {
      return tl::unexpected(velocity.error());
    }
    result.linearVelocity = frame_->turnYUp(*velocity);
  }
  if (const pugi::xml_node node = find("angular_velocity")) {
    const auto degrees = frame_->numbers(node, 3);
    if (!degrees) {
      return tl::unexpected(degrees.error());
    }
    const auto radians = [&](std::size_t i) { return (*degrees)[i] * kDegreesToRadians; };
    const Vec3 velocity(radians(0), radians(1), radians(2));
    const Vec3 sizes = glm::abs(velocity);
    if (!(std::max({sizes.x, sizes.y, sizes.z}) <= 1e6F)) {
      return frame_->xml().failAt(node, "is faster than 1e6 radians a second");
    }
    result.angularVelocity = frame_->turnYUp(velocity);
  }
  return {};
}

Result<void> ColladaScene::addConstraint(const pugi::xml_node& instance, const Context& context) {
  if (const pugi::xml_node constraint = findChild(instance, context.model)) {
    frame_->noteUnknown(instance, {});
    usedConstraints_.insert(constraint.hash_value());
    constraints_.push_back({constraint, context.scope});
  } else {
    frame_->note(instance, "constraint " + inQuotes(instance.attribute("constraint").value()) +
                               " names no <rigid_constraint> of its model; it is left out");
  }
  return frame_->take(instance, kInstanceCost);
}

Result<std::optional<Anchor>> ColladaScene::findAnchor(const pugi::xml_node& attachment, std::size_t scope) {
  const std::string_view link = attachment.attribute("rigid_body").value();
  if (link.empty()) {
    return Anchor{};
  }
  const std::string_view name = link.substr(link.front() == '#' ? 1 : 0);
  const Scope& bodies = scopes_[scope];
  for (const std::string_view key : {name, lastStep(name)}) {
    // With a '#', a node of that id comes first.
    if (const auto found = bodies.find(key); found != bodies.end() && link.front() != '#') {
      return Anchor{found->second, {}};
    }
  }
  const pugi::xml_node node = frame_->xml().findId(name);
  if (std::string_view(node.name()) == "node") {
    if (const auto found = bodyOfNode_.find(node.hash_value()); found != bodyOfNode_.end()) {
      return Anchor{found->second, {}};
    }
    return nodes_->placement(node).map([](const Placement& place) {
      const auto apart = takeApart(place.matrix);
      const Transform pose = place.rigid || !apart ? place.pose : apart->pose;
      return std::optional(Anchor{{}, pose});
    });
  }
  for (const std::string_view key : {name, lastStep(name)}) {
    if (const auto found = bodies.find(key); found != bodies.end()) {
      return Anchor{found->second, {}};
    }
  }
  frame_->note(attachment,
               "rigid_body " + inQuotes(link) + " names no body of its model; the joint is left out");
  return std::nullopt;
}

void ColladaScene::noteUnusedConstraints() const {
  for (const pugi::xml_node& library : frame_->xml().root().children("library_physics_models")) {
    for (const pugi::xml_node& model : library.children("physics_model")) {
      for (const pugi::xml_node& constraint : model.children("rigid_constraint")) {
        if (!usedConstraints_.contains(constraint.hash_value())) {
          const pugi::xml_attribute sid = constraint.attribute("sid");
          frame_->note(constraint, inQuotes((sid ? sid : constraint.attribute("name")).value()) +
                                       " is named by no <instance_rigid_constraint>; it is left out");
        }
      }
    }
  }
}

Result<void> ColladaScene::addJoints() {
  for (const Constraint& constraint : constraints_) {
    auto joint = readJoint(*frame_, constraint.node, [&](const pugi::xml_node& attachment) {
      return findAnchor(attachment, constraint.scope);
    });
    if (!joint) {
      return tl::unexpected(joint.error());
    }
    if (*joint) {
      document_->joints.push_back(std::move(**joint));
    }
  }
  return {};
}

Result<void> ColladaScene::addEveryBody() {
  for (const pugi::xml_node& body : models_->bodies()) {
    const auto model = models_->find(body, {});
    if (!model) {
      return tl::unexpected(model.error());
    }
    DocumentBody result;
    result.model = model->value_or(0);
    result.name = uniqueName(bodyName(body, "body"));
    document_->bodies.push_back(std::move(result));
  }
  return {};
}

std::string ColladaScene::uniqueName(const std::string& wish) {
  std::string name = wish.empty() ? "body" : wish;
  const std::string stem = name;
  while (!names_.insert(name).second) {
    std::size_t& suffix = suffixes_.try_emplace(stem, 1).first->second;
    name = stem + "-" + std::to_string(++suffix);
  }
  return name;
}

}  // namespace scatter::io
