#include "scenes/family_scene.h"

#include <scatter/io/collada.h>
#include <scatter/io/file.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <system_error>

#include "io/atomic_file.h"
#include "io/numbers.h"
#include "scenes/shape_measures.h"

namespace scatter {
namespace {

constexpr double kFilled = 0.25;      // share of a region that the balls around its bodies fill
constexpr float kRoomToGrow = 0.15F;  // of the height of a region, that it may need below itself

}  // namespace

std::string tomlNumber(float value) {
  return io::formatNumber(std::round(static_cast<double>(value) * 1000.0) / 1000.0, 9);
}

std::string tomlVector(const Vec3& value) {
  return "[" + tomlNumber(value.x) + ", " + tomlNumber(value.y) + ", " + tomlNumber(value.z) + "]";
}

std::string tomlText(std::string_view text) {
  return '"' + std::string(text) + '"';
}

FamilyScene::FamilyScene(std::string family, const FamilyOptions& options)
    : name_(std::move(family) + "-" + std::to_string(options.seed)),
      options_(options),
      random_(options.seed) {
  text_ = "# Made by `scatter families`: " + name_ + ", scale " + io::formatNumber(options.scale, 9) + ".\n";
}

int FamilyScene::varyWhole(int nominal) {
  return static_cast<int>(std::lround(vary(static_cast<float>(nominal))));
}

int FamilyScene::count(int nominal) {
  return std::max(1, static_cast<int>(std::lround(options_.scale *
                                                  static_cast<double>(vary(static_cast<float>(nominal))))));
}

float FamilyScene::side(float nominal, float least) const {
  return std::max(least, nominal * static_cast<float>(std::sqrt(options_.scale)));
}

void FamilyScene::begin(std::string_view summary, int frames, bool gravity) {
  add("[scene]", {{"summary", tomlText(summary)},
                  {"frames", std::to_string(frames)},
                  {"seed", std::to_string(options_.seed)},
                  {"gravity", gravity ? "[0, -9.81, 0]" : "[0, 0, 0]"}});
}

void FamilyScene::add(std::string_view table, std::initializer_list<Entry> entries) {
  text_ += "\n" + std::string(table) + "\n";
  for (const auto& [key, value] : entries) text_ += std::string(key) + " = " + value + "\n";
}

void FamilyScene::addBodies(std::string_view region, const std::vector<FamilyModel>& models, int count,
                            std::string_view velocity) {
  const int kinds = static_cast<int>(models.size());
  for (int i = 0; i < kinds; ++i) {
    const int share = count / kinds + (i < count % kinds ? 1 : 0);
    if (share == 0) continue;
    const std::string file = models[static_cast<std::size_t>(i)].file;
    add("[[object]]", {{"name", tomlText(std::string(region) + "-kind-" + std::to_string(i + 1))},
                       {"model", tomlText(file)},
                       {"in", tomlText(region)},
                       {"count", std::to_string(share)},
                       {"orientation", tomlText("random")},
                       {"velocity", std::string(velocity)},
                       {"spin", "{ random = 1.5 }"}});
  }
}

void FamilyScene::addBodiesAt(std::string_view name, const std::vector<FamilyModel>& models,
                              const std::vector<Vec3>& places, std::initializer_list<Entry> more) {
  for (std::size_t kind = 0; kind < std::min(models.size(), places.size()); ++kind) {
    std::string list;
    for (std::size_t i = kind; i < places.size(); i += models.size()) {
      list += (list.empty() ? "" : ", ") + tomlVector(places[i]);
    }
    add("[[object]]", {{"name", tomlText(std::string(name) + "-kind-" + std::to_string(kind + 1))},
                       {"model", tomlText(models[kind].file)},
                       {"list", "[" + list + "]"}});
    for (const auto& [key, value] : more) text_ += std::string(key) + " = " + value + "\n";
  }
}

void FamilyScene::addRain(std::string_view name, const std::vector<FamilyModel>& models, int count,
                          float side, float low) {
  float radius = 0.0F;
  double volume = 0.0;
  for (const FamilyModel& model : models) {
    radius = std::max(radius, model.radius);
    volume += 4.0 / 3.0 * std::numbers::pi * std::pow(static_cast<double>(model.radius), 3.0);
  }
  const double ball = volume / static_cast<double>(models.size());
  const auto area = static_cast<double>(side) * static_cast<double>(side);
  const auto height = std::max(radius, static_cast<float>(count * ball / (kFilled * area)));
  add("[[region]]", {{"name", tomlText(name)},
                     {"kind", tomlText("box")},
                     {"center", tomlVector({0.0F, low + radius + (0.5F + kRoomToGrow) * height, 0.0F})},
                     {"size", tomlVector({side, height, side})}});
}

FamilyModel FamilyScene::addModel(std::string_view name, const HullGroups& groups, float mass) {
  auto model = nestedModel(std::string(name), groups, std::round(mass));
  if (!model) {
    if (made_) made_ = fail("the model " + std::string(name) + ": " + model.error().message);
    return {};
  }
  FamilyModel added{.file = name_ + "/" + std::string(name) + ".dae",
                    .radius = boundingRadius(*model->levels)};
  models_.emplace_back(added.file, std::move(*model));
  return added;
}

std::string FamilyScene::addMesh(std::string_view name, const SurfaceMesh& mesh) {
  std::string text;
  for (const Vec3& vertex : mesh.vertices) {
    text += "v " + tomlNumber(vertex.x) + " " + tomlNumber(vertex.y) + " " + tomlNumber(vertex.z) + "\n";
  }
  for (const auto& triangle : mesh.triangles) {
    text += "f";
    for (const std::uint32_t index : triangle) text += " " + std::to_string(index + 1);
    text += "\n";
  }
  std::string file = name_ + "/" + std::string(name) + ".obj";
  meshes_.emplace_back(file, std::move(text));
  return file;
}

Result<std::filesystem::path> FamilyScene::write(const std::filesystem::path& folder) const {
  if (!made_) return tl::unexpected(made_.error());
  if (!models_.empty() || !meshes_.empty()) {
    std::error_code error;
    std::filesystem::create_directory(folder / name_, error);
    if (error) return cannotWrite(folder / name_, error.value());
  }
  for (const auto& [file, model] : models_) {
    if (auto written = writeCollada(model, folder / file); !written) return tl::unexpected(written.error());
  }
  for (const auto& [file, text] : meshes_) {
    if (auto written = writeFile(folder / file, text); !written) return tl::unexpected(written.error());
  }
  std::filesystem::path scene = folder / (name_ + ".toml");
  if (auto written = writeFile(scene, text_); !written) return tl::unexpected(written.error());
  return scene;
}

}  // namespace scatter
