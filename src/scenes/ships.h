#pragma once

#include <scatter/io/model.h>
#include <scatter/result.h>
#include <scatter/world/world.h>

#include <memory>
#include <string>

#include "scenes/placement.h"

namespace scatter {

/// The two ships of the report's scenes, in one version of their levels.
struct ShipModels {
  std::shared_ptr<const Model> hunter;
  std::shared_ptr<const Model> fighter;
};

/// `suffix` is "" for levels of boxes, "_hulls" for many hulls.
[[nodiscard]] Result<ShipModels> loadShips(const std::string& suffix);

/// The radius of a ball around the model's origin that holds its coarsest level.
[[nodiscard]] float boundingRadius(const Model& model);

/// A body with the model's shape, mass and material.
[[nodiscard]] BodyDef shipBody(const Model& model, std::string name, const Transform& pose);

/// A swarm that a point field draws together (report, section 5.1.2.2).
struct SwarmDef {
  int hunters = 0;
  int fighters = 0;
  int asteroids = 0;
  float innerRadius = 60.0F;  ///< Of the shell in which everything starts, metres.
  float outerRadius = 110.0F;
  float asteroidMinRadius = 0.8F;
  float asteroidMaxRadius = 1.6F;
  float restitution = 0.6F;  ///< Enough for the first to arrive to be thrown back.
};

/// Places the swarm at random on a shell around the origin, at rest but slowly turning, clear of one
/// another.
[[nodiscard]] Result<void> addSwarm(World& world, const ShipModels& models, const SwarmDef& def,
                                    Random& random);

}  // namespace scatter
