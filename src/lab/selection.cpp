#include <scatter/lab/selection.h>

#include <memory>
#include <type_traits>
#include <variant>

namespace scatter {

namespace {

// What bodies of one model share; null if the shape is their own.
const void* modelOf(const BodyDef& def) {
  return std::visit(
      [](const auto& shape) -> const void* {
        using Kind = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Kind, std::shared_ptr<const LevelSet>> ||
                      std::is_same_v<Kind, std::shared_ptr<const TriangleMesh>> ||
                      std::is_same_v<Kind, std::shared_ptr<const HeightField>>) {
          return shape.get();
        } else {
          return nullptr;
        }
      },
      def.shape);
}

template <class IsMember>
std::vector<BodyId> select(const World& world, const IsMember& isMember) {
  std::vector<BodyId> bodies;
  for (const auto& object : world.objects()) {
    if (isMember(*object)) {
      bodies.push_back(object->body());
    }
  }
  return bodies;
}

}  // namespace

std::string_view nameStem(std::string_view name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  if (end == std::string_view::npos || end + 1 == name.size()) {
    return name;
  }
  const std::size_t last = name.find_last_not_of("-_. #", end);
  return last == std::string_view::npos ? name : name.substr(0, last + 1);
}

std::vector<BodyId> objectsOfModel(const World& world, const WorldObject& like) {
  const void* model = modelOf(like.def());
  if (model == nullptr) {
    return objectsNamedLike(world, like);
  }
  return select(world, [model](const WorldObject& object) { return modelOf(object.def()) == model; });
}

std::vector<BodyId> objectsNamedLike(const World& world, const WorldObject& like) {
  const std::string_view stem = nameStem(like.name());
  return select(world, [stem](const WorldObject& object) { return nameStem(object.name()) == stem; });
}

}  // namespace scatter
