#include "scenes/document_scene.h"

#include <cmath>
#include <utility>

#include "scenes/anchor.h"

namespace scatter {
namespace {

constexpr float kStep = 1.0F / 60.0F;

class Builder {
 public:
  Builder(const DocumentPlan& plan, World& world) : plan_(plan), world_(world) {}

  Result<void> build() {
    world_.physics().setGravity(plan_.gravity);
    for (const BodyDef& def : plan_.bodies.defs) {
      const auto added = world_.add(def);
      if (!added) return fail(plan_.file + ": " + added.error().message);
      objects_.push_back(*added);
    }
    for (const DocumentField& field : plan_.fields) {
      world_.addField(std::make_unique<PointField>(field.center, field.acceleration, field.radius));
    }
    return join();
  }

 private:
  Result<void> join() {
    for (const DocumentJointDef& joint : plan_.joints) {
      JointDef def{.kind = joint.kind, .frame = joint.frame, .bodiesCollide = joint.bodiesCollide};
      const auto a = bodyOf(joint.bodyA);
      const auto b = bodyOf(joint.bodyB);
      if (!a || !b) return tl::unexpected(a ? b.error() : a.error());
      def.bodyA = *a;
      def.bodyB = *b;
      if (const auto joined = world_.join(def); !joined) {
        return fail(plan_.file + ": " + joined.error().message);
      }
    }
    return {};
  }

  Result<BodyId> bodyOf(const std::optional<std::size_t>& index) {
    if (index) return objects_[plan_.bodies.first[*index]]->body();
    if (anchor_ == nullptr) {
      const auto added = addAnchor(world_);
      if (!added) return tl::unexpected(added.error());
      anchor_ = *added;
    }
    return anchor_->body();
  }

  const DocumentPlan& plan_;
  World& world_;
  std::vector<WorldObject*> objects_;
  WorldObject* anchor_ = nullptr;
};

void warnOfUnusedModels(const PhysicsDocument& document, DocumentWarnings& warnings) {
  std::vector<bool> isUsed(document.models.size(), false);
  for (const DocumentBody& body : document.bodies) isUsed[body.model] = true;
  for (std::size_t i = 0; i < isUsed.size(); ++i) {
    if (!isUsed[i])
      warnings.add("model \"" + document.models[i].name + "\": no body is of it; it is left out");
  }
}

}  // namespace

Result<DocumentPlan> planDocument(const PhysicsDocument& document, std::string file) {
  DocumentWarnings warnings(file);
  auto bodies = makeDocumentBodies(document, warnings);
  if (!bodies) return fail(file + ": " + bodies.error().message);
  warnOfUnusedModels(document, warnings);
  DocumentPlan plan;
  plan.file = std::move(file);
  plan.bodies = std::move(*bodies);
  plan.joints = makeDocumentJoints(document, warnings);
  plan.fields = document.fields;
  plan.gravity = document.gravity;
  if (!document.saysGravity) warnings.add("the file does not say what gravity is; there is none");
  if (document.timeStep && std::abs(*document.timeStep - kStep) > 1e-4F) {
    warnings.add("a frame is always 1/60 s; the time step of the file is left out");
  }
  plan.warnings = document.warnings;
  plan.warnings.insert(plan.warnings.end(), warnings.lines().begin(), warnings.lines().end());
  return plan;
}

Result<void> DocumentScene::build(World& world, const SceneOptions& /*options*/) {
  return Builder(*plan_, world).build();
}

}  // namespace scatter
