#pragma once

#include "io/collada/frame.h"
#include "io/collada/joints.h"
#include "io/collada/models.h"
#include "io/collada/nodes.h"

#include <scatter/io/physics_document.h>

#include <map>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace scatter::io {

/// Makes bodies and joints of the physics models that physics scenes instance.
class ColladaScene {
 public:
  ColladaScene(const ColladaFrame& frame, ColladaModels& models, ColladaNodes& nodes,
               PhysicsDocument& document)
      : frame_(&frame), models_(&models), nodes_(&nodes), document_(&document) {}

  /// Adds the bodies of an `<instance_physics_model>`.
  [[nodiscard]] Result<void> addInstance(const pugi::xml_node& instance);

  /// Adds a body of every rigid body, at the origin.
  [[nodiscard]] Result<void> addEveryBody();

  /// Notes the constraints that no instance named.
  void noteUnusedConstraints() const;

  /// Adds the joints of all instances, after their bodies.
  [[nodiscard]] Result<void> addJoints();

 private:
  /// An instanced physics model.
  struct Context {
    pugi::xml_node instance;
    pugi::xml_node model;
    std::size_t scope = 0;  ///< In scopes_.
  };

  /// Bodies by what constraints call them: sid, id or name of their `<rigid_body>`.
  using Scope = std::map<std::string_view, std::size_t>;

  /// A `<rigid_constraint>` and the bodies that it can name.
  struct Constraint {
    pugi::xml_node node;
    std::size_t scope = 0;
  };

  /// Where a body starts, and what its node makes of it.
  struct Start {
    Transform pose{};
    BodyLook look;
    std::string_view nodeName;
    std::string_view nodeId;
  };

  [[nodiscard]] Result<void> addNested(const pugi::xml_node& instance, std::size_t scope);
  [[nodiscard]] Result<void> addContent(const Context& context);
  [[nodiscard]] Result<void> addBody(const pugi::xml_node& instance, const Context& context);
  [[nodiscard]] Result<void> addConstraint(const pugi::xml_node& instance, const Context& context);

  /// The `<rigid_body>` or `<rigid_constraint>` of the model that an instance names.
  [[nodiscard]] pugi::xml_node findChild(const pugi::xml_node& instance, const pugi::xml_node& model);
  [[nodiscard]] static std::string wishedName(const pugi::xml_node& instance, const pugi::xml_node& body,
                                              const Start& start);

  /// The body that is about to be added, for the constraints that name it.
  void rememberBody(const pugi::xml_node& instance, const pugi::xml_node& body, std::size_t scope);
  [[nodiscard]] Result<Start> readStart(const pugi::xml_node& instance, const Context& context);
  [[nodiscard]] Result<void> readPlace(const pugi::xml_node& node, Start& start);
  [[nodiscard]] Result<void> readMovement(const pugi::xml_node& instance, const pugi::xml_node& body,
                                          DocumentBody& result);
  [[nodiscard]] Result<std::optional<Anchor>> findAnchor(const pugi::xml_node& attachment, std::size_t scope);
  [[nodiscard]] std::string uniqueName(const std::string& wish);

  const ColladaFrame* frame_;
  ColladaModels* models_;
  ColladaNodes* nodes_;
  PhysicsDocument* document_;
  std::vector<Scope> scopes_;
  std::vector<Constraint> constraints_;
  // By the elements' hash values, which are unique.
  std::map<std::size_t, std::size_t> bodyOfNode_;
  std::map<std::size_t, std::map<std::string_view, pugi::xml_node>> sids_;
  std::set<std::size_t> open_;  ///< Physics models whose content is being added.
  std::set<std::size_t> usedConstraints_;
  std::set<std::string> names_;
  std::map<std::string, std::size_t> suffixes_;
};

}  // namespace scatter::io
