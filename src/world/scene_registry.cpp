#include <scatter/world/scene.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string_view>

namespace scatter {

namespace {

/// Levenshtein distance: insertions, deletions and replacements that turn `a` into `b`.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::string unknownScene(const std::string& name, const std::vector<const SceneInfo*>& known) {
  if (known.empty()) return "unknown scene \"" + name + "\": this program has no scenes";
  const SceneInfo* nearest = *std::min_element(known.begin(), known.end(), [&](const auto* a, const auto* b) {
    return editDistance(name, a->name) < editDistance(name, b->name);
  });
  std::string message =
      "unknown scene \"" + name + "\"; did you mean \"" + nearest->name + "\"? Known scenes:";
  for (const SceneInfo* info : known) {
    message += (info == known.front() ? " " : ", ") + info->name;
  }
  return message;
}

}  // namespace

SceneRegistry& SceneRegistry::instance() {
  static SceneRegistry registry;
  return registry;
}

void SceneRegistry::add(SceneInfo info) {
  assert(info.make);
  assert(std::none_of(scenes_.begin(), scenes_.end(), [&](const auto& s) { return s->name == info.name; }));
  scenes_.push_back(std::make_unique<SceneInfo>(std::move(info)));
}

std::vector<const SceneInfo*> SceneRegistry::all() const {
  std::vector<const SceneInfo*> sorted;
  sorted.reserve(scenes_.size());
  for (const auto& scene : scenes_) sorted.push_back(scene.get());
  std::sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) { return a->name < b->name; });
  return sorted;
}

Result<const SceneInfo*> SceneRegistry::find(const std::string& name) const {
  const std::vector<const SceneInfo*> known = all();
  const auto found = std::find_if(known.begin(), known.end(), [&](const auto* s) { return s->name == name; });
  if (found == known.end()) return fail(unknownScene(name, known));
  return *found;
}

}  // namespace scatter
