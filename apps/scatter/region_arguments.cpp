#include "region_arguments.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "number_checks.h"
#include "unknown_name.h"

namespace scatter::app {

namespace {

constexpr std::string_view kBox = "box:";
constexpr float kLeastWeight = 0.01F;
constexpr float kMostWeight = 100.0F;

struct KindName {
  MeshGroupKind kind;
  std::string_view prefix;
};
constexpr std::array<KindName, 3> kKinds{{{MeshGroupKind::kMaterial, "material:"},
                                          {MeshGroupKind::kObject, "object:"},
                                          {MeshGroupKind::kVertexGroup, "group:"}}};

/// A REGION and what is asked of it.
struct Wish {
  std::string region;
  std::optional<float> weight;
  bool isKept = false;
};

Result<Bounds> parseBox(const std::string& region) {
  std::array<float, 6> corners{};
  std::istringstream stream(region.substr(kBox.size()) + ",");
  std::size_t count = 0;
  for (std::string word; std::getline(stream, word, ','); ++count) {
    const std::optional<double> number = parseNumber<double>(word);
    if (!number || !(std::abs(*number) < 1e30) || count >= corners.size()) {
      count = 0;
      break;
    }
    corners[count] = static_cast<float>(*number);
  }
  if (count != corners.size())
    return fail("region \"" + region + "\": give a box as two corners, box:X0,Y0,Z0,X1,Y1,Z1");
  const Vec3 a(corners[0], corners[1], corners[2]);
  const Vec3 b(corners[3], corners[4], corners[5]);
  return Bounds{glm::min(a, b), glm::max(a, b)};
}

/// REGION=WEIGHT; names may have a "=" of their own.
Result<Wish> parseImportance(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  const std::optional<double> weight =
      equals == std::string::npos ? std::nullopt : parseNumber<double>(text.substr(equals + 1));
  if (!weight || equals == 0 || !(*weight >= static_cast<double>(kLeastWeight)) ||
      !(*weight <= static_cast<double>(kMostWeight))) {
    return fail("--importance: \"" + text +
                "\" is no region with a weight of 0.01 to 100; give such as handle=4");
  }
  return Wish{text.substr(0, equals), static_cast<float>(*weight), false};
}

Result<std::vector<Wish>> wishesOf(const RegionArguments& arguments) {
  std::vector<Wish> wishes;
  const auto of = [&wishes](const std::string& region) -> Wish& {
    const auto known = std::find_if(wishes.begin(), wishes.end(),
                                    [&region](const Wish& wish) { return wish.region == region; });
    return known != wishes.end() ? *known : wishes.emplace_back(Wish{region, {}, false});
  };
  for (const std::string& region : arguments.kept) of(region).isKept = true;
  for (const std::string& text : arguments.importance) {
    const Result<Wish> parsed = parseImportance(text);
    if (!parsed) return fail(parsed.error().message);
    Wish& wish = of(parsed->region);
    if (wish.weight) return fail("--importance: \"" + wish.region + "\" is given twice");
    wish.weight = parsed->weight;
  }
  for (const std::string& region : arguments.watched) of(region);
  for (const Wish& wish : wishes) {
    if (!wish.region.starts_with(kBox)) continue;
    if (const Result<Bounds> box = parseBox(wish.region); !box) return fail(box.error().message);
  }
  return wishes;
}

/// What a REGION may mean: a kind, unless it is any, and a name.
struct Meaning {
  std::optional<MeshGroupKind> kind;
  std::string_view name;
};

/// As it stands first: names may begin with a prefix themselves.
std::vector<Meaning> meaningsOf(const std::string& region) {
  std::vector<Meaning> meanings{{{}, region}};
  for (const auto& [kind, prefix] : kKinds) {
    if (region.starts_with(prefix))
      meanings.push_back({kind, std::string_view(region).substr(prefix.size())});
  }
  return meanings;
}

std::vector<const MeshGroup*> groupsCalled(const Meaning& meaning, const MeshFile& file) {
  std::vector<const MeshGroup*> found;
  for (const MeshGroup& group : file.groups) {
    if (group.name == meaning.name && (!meaning.kind || *meaning.kind == group.kind)) found.push_back(&group);
  }
  return found;
}

std::string prefixOf(MeshGroupKind kind) {
  const auto* known =
      std::find_if(kKinds.begin(), kKinds.end(), [kind](const KindName& name) { return name.kind == kind; });
  return std::string(known->prefix);
}

std::vector<std::string> knownNames(const MeshFile& file) {
  std::vector<std::string> names;
  for (const MeshGroup& group : file.groups) names.push_back(prefixOf(group.kind) + group.name);
  return names;
}

Result<std::vector<std::uint32_t>> trianglesCalled(const std::string& region, const MeshFile& file) {
  for (const Meaning& meaning : meaningsOf(region)) {
    const std::vector<const MeshGroup*> found = groupsCalled(meaning, file);
    if (found.empty()) continue;
    // An object and its mesh, or its only material, often have the same name.
    for (const MeshGroup* group : found) {
      if (group->runs != found.front()->runs) {
        return fail(fmt::format("\"{}\" is the name of {} and {}; say which", region,
                                prefixOf(found.front()->kind) + region, prefixOf(group->kind) + region));
      }
    }
    std::vector<std::uint32_t> triangles;
    for (const auto& [first, last] : found.front()->runs) {
      for (std::uint32_t i = first; i < last; ++i) triangles.push_back(i);
    }
    return triangles;
  }
  if (file.groups.empty())
    return fail("unknown region \"" + region + "\"; the mesh has no names, give a box:X0,Y0,Z0,X1,Y1,Z1");
  for (const auto& [kind, prefix] : kKinds) {
    if (region.starts_with(prefix)) return fail(unknownName("region", region, knownNames(file)));
  }
  std::vector<std::string> plain;
  for (const MeshGroup& group : file.groups) plain.push_back(group.name);
  std::sort(plain.begin(), plain.end());
  plain.erase(std::unique(plain.begin(), plain.end()), plain.end());
  return fail(unknownName("region", region, plain) + ", or box:X0,Y0,Z0,X1,Y1,Z1");
}

/// Corner by corner: axes stay axes, or the box is that around the turned one.
Bounds toModel(const Bounds& box, const Mat3& fromFile) {
  Bounds result{fromFile * box.min, fromFile * box.min};
  for (unsigned corner = 1; corner < 8; ++corner) {
    const Vec3 point = fromFile * Vec3((corner & 1U) != 0 ? box.max.x : box.min.x,
                                       (corner & 2U) != 0 ? box.max.y : box.min.y,
                                       (corner & 4U) != 0 ? box.max.z : box.min.z);
    result.min = glm::min(result.min, point);
    result.max = glm::max(result.max, point);
  }
  return result;
}

}  // namespace

Result<void> checkRegions(const RegionArguments& arguments) {
  const auto wishes = wishesOf(arguments);
  if (!wishes) return fail(wishes.error().message);
  return {};
}

Result<std::vector<MeshRegion>> findRegions(const RegionArguments& arguments, const MeshFile& file) {
  const auto wishes = wishesOf(arguments);
  if (!wishes) return fail(wishes.error().message);
  std::vector<MeshRegion> regions;
  for (const Wish& wish : *wishes) {
    MeshRegion region{.name = wish.region, .extent = {}, .isKept = wish.isKept};
    region.weight = wish.weight.value_or(wish.isKept ? kKeptWeight : 1.0F);
    if (wish.region.starts_with(kBox)) {
      region.extent = toModel(*parseBox(wish.region), file.fromFile);
    } else {
      auto triangles = trianglesCalled(wish.region, file);
      if (!triangles) return fail(triangles.error().message);
      region.extent = std::move(*triangles);
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace scatter::app
