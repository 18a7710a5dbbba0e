#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/world/scene.h>

#include <memory>
#include <string>
#include <vector>

#include "scenes/document_joints.h"

namespace scatter {

/// A physics document, ready to be put into worlds.
struct DocumentPlan {
  std::string file{};  ///< For messages.
  DocumentBodies bodies{};
  std::vector<DocumentJointDef> joints{};
  std::vector<DocumentField> fields{};
  Vec3 gravity{0.0F};

  /// Those of the document, and what a world cannot do.
  std::vector<std::string> warnings{};
};

/// Fails on a document without bodies, and on a body of which nothing can be made.
[[nodiscard]] Result<DocumentPlan> planDocument(const PhysicsDocument& document, std::string file);

/// The scene of a physics document.
class DocumentScene final : public Scene {
 public:
  explicit DocumentScene(std::shared_ptr<const DocumentPlan> plan) : plan_(std::move(plan)) {}

  void configure(PhysicsDef& physics) const override { physics.gravity = plan_->gravity; }
  Result<void> build(World& world, const SceneOptions& options) override;

 private:
  std::shared_ptr<const DocumentPlan> plan_;
};

}  // namespace scatter
