#include "scenes/props.h"

#include <scatter/io/model_library.h>

#include <utility>

namespace scatter {

Result<std::vector<std::shared_ptr<const Model>>> loadProps(std::initializer_list<const char*> names) {
  std::vector<std::shared_ptr<const Model>> models;
  for (const char* name : names) {
    auto model = loadModel(name);
    if (!model) return fail(model.error().message);
    models.push_back(std::move(*model));
  }
  return models;
}

BodyDef propBody(const std::shared_ptr<const Model>& model, std::string name, const Transform& pose) {
  BodyDef def;
  def.name = std::move(name);
  def.shape = model->levels;
  def.mesh = drawnMesh(model);
  def.mass = model->mass;
  def.pose = pose;
  def.material.friction = model->friction;
  def.material.restitution = model->restitution;
  def.material.linearDamping = 0.1F;
  def.material.angularDamping = 0.6F;
  return def;
}

}  // namespace scatter
