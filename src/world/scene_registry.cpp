#include <scatter/world/scene.h>

#include <algorithm>
#include <cassert>
#include <string_view>

#include "text/nearest_name.h"

namespace scatter {

namespace {

std::string unknownScene(const std::string& name, const std::vector<std::string>& known) {
  if (known.empty()) return "unknown scene \"" + name + "\": this program has no scenes";
  const std::string_view nearest = nearestName(name, known);
  std::string message = "unknown scene \"" + name + "\"; ";
  message +=
      nearest.empty() ? "known scenes:" : "did you mean \"" + std::string(nearest) + "\"? Known scenes:";
  for (const std::string& one : known) message += (&one == &known.front() ? " " : ", ") + one;
  return message;
}

/// Stands for a scene that cannot be read.
class UnreadableScene final : public Scene {
 public:
  explicit UnreadableScene(Error error) : error_(std::move(error)) {}
  Result<void> build(World& /*world*/, const SceneOptions& /*options*/) override {
    return tl::unexpected(error_);
  }

 private:
  Error error_;
};

SceneInfo unreadable(const std::string& name, const Error& error) {
  SceneInfo info;
  info.name = name;
  info.summary = "cannot be read: " + error.message;
  info.frames = 1;
  info.make = [error] { return std::make_unique<UnreadableScene>(error); };
  return info;
}

}  // namespace

SceneRegistry& SceneRegistry::instance() {
  static SceneRegistry registry;
  return registry;
}

void SceneRegistry::add(SceneInfo info) {
  assert(info.make);
  assert(!findAdded(info.name));
  scenes_.push_back(std::make_shared<SceneInfo>(std::move(info)));
}

void SceneRegistry::addSource(std::unique_ptr<SceneSource> source) {
  assert(source);
  sources_.push_back(std::move(source));
}

std::vector<std::string> SceneRegistry::names() const {
  std::vector<std::string> names;
  for (const auto& scene : scenes_) names.push_back(scene->name);
  for (const auto& source : sources_) {
    for (std::string& name : source->names()) names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::shared_ptr<const SceneInfo> SceneRegistry::findAdded(const std::string& name) const {
  const auto found = std::find_if(scenes_.begin(), scenes_.end(),
                                  [&name](const auto& scene) { return scene->name == name; });
  return found == scenes_.end() ? nullptr : *found;
}

const SceneSource* SceneRegistry::sourceOf(const std::string& name) const {
  const auto found = std::find_if(sources_.begin(), sources_.end(), [&name](const auto& source) {
    const std::vector<std::string> names = source->names();
    return source->claims(name) || std::find(names.begin(), names.end(), name) != names.end();
  });
  return found == sources_.end() ? nullptr : found->get();
}

std::vector<std::shared_ptr<const SceneInfo>> SceneRegistry::all() const {
  std::vector<std::shared_ptr<const SceneInfo>> scenes;
  for (const std::string& name : names()) {
    const auto found = find(name);
    scenes.push_back(found ? *found : std::make_shared<const SceneInfo>(unreadable(name, found.error())));
  }
  return scenes;
}

Result<std::shared_ptr<const SceneInfo>> SceneRegistry::find(const std::string& name) const {
  if (auto added = findAdded(name)) return added;
  const SceneSource* source = sourceOf(name);
  if (source == nullptr) return fail(unknownScene(name, names()));
  return source->find(name).map([](SceneInfo info) -> std::shared_ptr<const SceneInfo> {
    return std::make_shared<SceneInfo>(std::move(info));
  });
}

}  // namespace scatter
