#pragma once

#include <scatter/io/model.h>
#include <scatter/levels/surface_mesh.h>
#include <scatter/result.h>

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenes/detailed_bodies.h"
#include "scenes/families.h"
#include "scenes/placement.h"

namespace scatter {

/// A model file of a family's scene.
struct FamilyModel {
  std::string file{};   ///< Relative to the scene file.
  float radius = 0.0F;  ///< Of a ball around its origin that holds it, metres.
};

/// Values as a scene file has them, rounded to a millimetre and the like.
[[nodiscard]] std::string tomlNumber(float value);
[[nodiscard]] std::string tomlVector(const Vec3& value);
[[nodiscard]] std::string tomlText(std::string_view text);

/// The scene file of a family in the making, and the files that it needs. What goes wrong is kept until
/// write().
class FamilyScene {
 public:
  FamilyScene(std::string family, const FamilyOptions& options);

  [[nodiscard]] Random& random() { return random_; }

  /// Numbers within a fifth of `nominal`; a count also times the options' scale, and at least 1.
  [[nodiscard]] float vary(float nominal) { return nominal * random_.uniform(0.8F, 1.2F); }
  [[nodiscard]] int varyWhole(int nominal);
  [[nodiscard]] int count(int nominal);

  /// The side of a square ground on which bodies are as dense as on a full one, but no less than `least`.
  [[nodiscard]] float side(float nominal, float least) const;

  /// The table [scene]; gravity is that of the earth or none.
  void begin(std::string_view summary, int frames, bool gravity = true);

  using Entry = std::pair<std::string_view, std::string>;
  void add(std::string_view table, std::initializer_list<Entry> entries);

  /// Bodies of these models in a region of that name, `count` altogether.
  void addBodies(std::string_view region, const std::vector<FamilyModel>& models, int count,
                 std::string_view velocity);

  /// Bodies of these models, by turns, at these places; `more` is added to each object.
  void addBodiesAt(std::string_view name, const std::vector<FamilyModel>& models,
                   const std::vector<Vec3>& places, std::initializer_list<Entry> more);

  /// A box-shaped region high enough for so many bodies of these models, its underside at `low`.
  void addRain(std::string_view name, const std::vector<FamilyModel>& models, int count, float side,
               float low);

  [[nodiscard]] FamilyModel addModel(std::string_view name, const HullGroups& groups, float mass);
  [[nodiscard]] std::string addMesh(std::string_view name, const SurfaceMesh& mesh);

  /// The scene file in `folder`, with the others in a folder below it.
  [[nodiscard]] Result<std::filesystem::path> write(const std::filesystem::path& folder) const;

 private:
  std::string name_;
  FamilyOptions options_;
  Random random_;
  std::string text_;
  std::vector<std::pair<std::string, Model>> models_;
  std::vector<std::pair<std::string, std::string>> meshes_;
  Result<void> made_{};
};

}  // namespace scatter
