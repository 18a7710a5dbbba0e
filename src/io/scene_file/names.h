#pragma once

#include <scatter/io/scene_file.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/scene_file/table.h"

namespace scatter::io {

/// Of objects that name none.
inline constexpr const char* kDefaultGroup = "default";

/// What the names in a scene file mean. Objects, their bodies and groups share one set of names.
class SceneNames {
 public:
  explicit SceneNames(SceneProblem& problem) : problem_(problem) {}

  /// Names of other things, such as materials; refuses a second one in the same `kind`.
  void define(const SceneTable& table, std::string_view kind, const std::string& name, std::size_t index);

  /// The thing of that kind that `key` names.
  [[nodiscard]] std::optional<std::size_t> find(const SceneTable& table, std::string_view key,
                                                std::string_view kind) const;

  /// Bodies `first` to `first + count - 1`; refuses a name that is taken.
  void addBodies(int line, const std::string& name, std::size_t first, std::size_t count);

  /// The bit of a collision group, a new one if it has no bit yet. Refuses more than 32.
  [[nodiscard]] std::uint32_t groupBit(const SceneTable& table, const std::string& group);
  void addToGroup(int line, const std::string& group, std::size_t first, std::size_t count);

  /// Bits of the groups below `key`, which must have members by now.
  [[nodiscard]] std::uint32_t groupBits(const SceneTable& table, std::string_view key) const;

  /// To be called once all objects are known: groups become names of bodies.
  void addGroups();

  /// Bodies of all the names below `key`, in ascending order, each once.
  [[nodiscard]] std::vector<std::size_t> bodies(const SceneTable& table, std::string_view key) const;

  /// The one body that `key` names.
  [[nodiscard]] std::optional<std::size_t> body(const SceneTable& table, std::string_view key) const;

 private:
  struct Range {
    std::size_t first;
    std::size_t count;
  };
  struct Named {
    int line = 0;
    std::vector<Range> bodies{};
  };
  struct Group {
    std::uint32_t bit = 0;
    int line = 0;
    std::vector<Range> bodies{};
  };
  struct Thing {
    int line = 0;
    std::size_t index = 0;
  };

  [[nodiscard]] const Named* named(const SceneTable& table, std::string_view key,
                                   const std::string& name) const;

  SceneProblem& problem_;
  std::map<std::string, std::map<std::string, Thing>, std::less<>> things_;
  std::map<std::string, Named> named_;
  std::map<std::string, Group> groups_;
};

/// The name of an object, field or the like; refuses one that is not of letters, digits, '-', '_' and '.', or
/// longer than 64. Empty if absent.
[[nodiscard]] std::string readName(const SceneTable& table, std::string_view key);

}  // namespace scatter::io
