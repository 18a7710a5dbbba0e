#pragma once

#include "io/collada/bodies.h"
#include "io/collada/frame.h"
#include "io/collada/visuals.h"

#include <scatter/io/physics_document.h>

#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace scatter::io {

/// What an instance of a `<rigid_body>` makes of it.
struct BodyLook {
  pugi::xml_node instance;  ///< May say other mass properties, material or shapes.
  Vec3 scale{1.0F};         ///< Along the axes of the body.
  std::vector<VisualPart> visuals;
};

/// The models of a document: one for each `<rigid_body>`, and one more for each that is instanced in another
/// look than the first time.
class ColladaModels {
 public:
  [[nodiscard]] static Result<ColladaModels> read(const ColladaFrame& frame, ColladaMaterials& materials,
                                                  ColladaVisuals& visuals);

  /// The model of an instance; none if the `<rigid_body>` was left out.
  [[nodiscard]] Result<std::optional<std::size_t>> find(const pugi::xml_node& body, const BodyLook& look);

  /// Every `<rigid_body>` that was not left out.
  [[nodiscard]] const std::vector<pugi::xml_node>& bodies() const { return bodies_; }

  [[nodiscard]] ColladaMaterials& materials() const { return *materials_; }
  [[nodiscard]] ColladaVisuals& visuals() const { return *visuals_; }
  [[nodiscard]] std::vector<DocumentModel>& all() { return models_; }

 private:
  ColladaModels(const ColladaFrame& frame, ColladaMaterials& materials, ColladaVisuals& visuals)
      : frame_(&frame), materials_(&materials), visuals_(&visuals) {}

  /// The mesh of a model that no node shows, in its SCATTER data.
  [[nodiscard]] Result<void> readOwnMesh(const pugi::xml_node& body, DocumentModel& model);
  [[nodiscard]] Result<void> override(const pugi::xml_node& instance, DocumentModel& model);
  [[nodiscard]] Result<void> dress(const BodyLook& look, DocumentModel& model);
  [[nodiscard]] Result<void> scale(const pugi::xml_node& body, const Vec3& scale, DocumentModel& model) const;

  struct Original {
    std::size_t index = 0;
    bool used = false;
  };

  const ColladaFrame* frame_;
  ColladaMaterials* materials_;
  ColladaVisuals* visuals_;
  std::vector<DocumentModel> models_;
  std::vector<pugi::xml_node> bodies_;
  std::map<std::size_t, Original> originals_;  ///< By the hash value of the `<rigid_body>`.
  std::map<std::string, std::size_t> looks_;
};

}  // namespace scatter::io
