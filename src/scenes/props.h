#pragma once

#include <scatter/io/model.h>
#include <scatter/result.h>
#include <scatter/world/body.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace scatter {

/// The models of household things with these names, in their order.
[[nodiscard]] Result<std::vector<std::shared_ptr<const Model>>> loadProps(
    std::initializer_list<const char*> names);

/// A body with the model's shape, mesh, mass and material, which may fall asleep.
[[nodiscard]] BodyDef propBody(const std::shared_ptr<const Model>& model, std::string name,
                               const Transform& pose);

}  // namespace scatter
