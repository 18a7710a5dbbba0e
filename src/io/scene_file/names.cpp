#include "io/scene_file/names.h"

#include <algorithm>

#include "io/collada/xml_source.h"
#include "io/nearest_name.h"

namespace scatter::io {
namespace {

constexpr std::size_t kLongestName = 64;
constexpr std::size_t kMostGroups = 32;

template <class Map>
std::vector<std::string_view> keysOf(const Map& map) {
  std::vector<std::string_view> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '.';
}

}  // namespace

std::string readName(const SceneTable& table, std::string_view key) {
  std::string name;
  table.read(key, name);
  const bool good =
      !name.empty() && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), isNameCharacter);
  if (table.has(key) && !good) {
    table.report(key, inQuotes(key) + " must be 1 to " + std::to_string(kLongestName) +
                          " letters, digits, '-', '_' and '.', not " + inQuotes(name));
  }
  return name;
}

void SceneNames::define(const SceneTable& table, std::string_view kind, const std::string& name,
                        std::size_t index) {
  auto& things = things_[std::string(kind)];
  const auto [entry, isNew] = things.emplace(name, Thing{table.line(), index});
  if (!isNew) {
    problem_.report(table.lineOf("name"), "the name " + inQuotes(name) + " is already that of the " +
                                              std::string(kind) + " in line " +
                                              std::to_string(entry->second.line));
  }
}

std::optional<std::size_t> SceneNames::find(const SceneTable& table, std::string_view key,
                                            std::string_view kind) const {
  std::string name;
  table.read(key, name);
  const auto things = things_.find(kind);
  if (things == things_.end()) {
    table.report(key, "there is no " + std::string(kind) + " " + inQuotes(name) + ", nor any other");
    return std::nullopt;
  }
  const auto found = things->second.find(name);
  if (found == things->second.end()) {
    table.report(key, "there is no " + std::string(kind) + " " + inQuotes(name) +
                          didYouMean(name, keysOf(things->second)));
    return std::nullopt;
  }
  return found->second.index;
}

void SceneNames::addBodies(int line, const std::string& name, std::size_t first, std::size_t count) {
  const auto [entry, isNew] = named_.emplace(name, Named{line, {{first, count}}});
  if (!isNew) {
    problem_.report(line, "the name " + inQuotes(name) + " is already taken by the object in line " +
                              std::to_string(entry->second.line));
  }
}

std::uint32_t SceneNames::groupBit(const SceneTable& table, const std::string& group) {
  const auto found = groups_.find(group);
  if (found != groups_.end()) return found->second.bit;
  if (groups_.size() == kMostGroups) {
    table.report("group", "more than " + std::to_string(kMostGroups) + " groups");
    return 1;
  }
  const std::uint32_t bit = std::uint32_t{1} << groups_.size();
  groups_.emplace(group, Group{bit, table.line(), {}});
  return bit;
}

void SceneNames::addToGroup(int line, const std::string& group, std::size_t first, std::size_t count) {
  Group& members = groups_[group];
  members.line = line;
  members.bodies.push_back({first, count});
}

std::uint32_t SceneNames::groupBits(const SceneTable& table, std::string_view key) const {
  std::vector<std::string> names;
  table.readTexts(key, names);
  std::uint32_t bits = 0;
  for (const std::string& name : names) {
    const auto found = groups_.find(name);
    if (found == groups_.end()) {
      table.report(key, "no object is in the group " + inQuotes(name) + didYouMean(name, keysOf(groups_)));
      return bits;
    }
    bits |= found->second.bit;
  }
  return bits;
}

void SceneNames::addGroups() {
  for (const auto& [name, group] : groups_) {
    const auto [entry, isNew] = named_.emplace(name, Named{group.line, group.bodies});
    // Nobody chose the name of the group of all that have none.
    if (!isNew && name != kDefaultGroup) {
      problem_.report(group.line, "the group " + inQuotes(name) + " has the name of the object in line " +
                                      std::to_string(entry->second.line));
    }
  }
}

const SceneNames::Named* SceneNames::named(const SceneTable& table, std::string_view key,
                                           const std::string& name) const {
  const auto found = named_.find(name);
  if (found != named_.end()) return &found->second;
  table.report(key, "there is no object, body or group " + inQuotes(name) + didYouMean(name, keysOf(named_)));
  return nullptr;
}

std::vector<std::size_t> SceneNames::bodies(const SceneTable& table, std::string_view key) const {
  std::vector<std::string> names;
  table.readTexts(key, names);
  std::vector<std::size_t> bodies;
  for (const std::string& name : names) {
    const Named* found = named(table, key, name);
    if (found == nullptr) break;
    for (const Range& range : found->bodies) {
      for (std::size_t i = 0; i < range.count; ++i) bodies.push_back(range.first + i);
    }
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  }
  return bodies;
}

std::optional<std::size_t> SceneNames::body(const SceneTable& table, std::string_view key) const {
  std::string name;
  table.read(key, name);
  const Named* found = named(table, key, name);
  if (found == nullptr) return std::nullopt;
  if (found->bodies.size() != 1 || found->bodies.front().count != 1) {
    table.report(key,
                 inQuotes(name) + " is several bodies; name one of them, such as " + inQuotes(name + "-1"));
    return std::nullopt;
  }
  return found->bodies.front().first;
}

}  // namespace scatter::io
