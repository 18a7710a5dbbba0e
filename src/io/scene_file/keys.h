#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scatter::io {

/// A key of a scene file. The reader checks against this, and the manual is made from it.
struct SceneKey {
  std::string_view name;
  std::string_view type;      ///< Such as "number".
  std::string_view unit;      ///< Empty: none.
  std::string_view standard;  ///< The default, or "required"; empty: nothing.
  std::string_view meaning;

  /// Of every number in the value; without meaning if least > most.
  double least = 1.0;
  double most = -1.0;

  /// The kinds that the key belongs to, separated by spaces; empty: all.
  std::string_view of{};

  [[nodiscard]] bool hasRange() const { return least <= most; }
};

struct SceneSection {
  std::string_view name;   ///< Such as "object" or "object.grid".
  std::string_view title;  ///< As it stands in a file, such as "[[object]]".
  std::string_view meaning;
  std::vector<SceneKey> keys;

  [[nodiscard]] const SceneKey* find(std::string_view key) const;
};

/// In the order of the manual.
[[nodiscard]] const std::vector<SceneSection>& sceneSections();

/// One that exists.
[[nodiscard]] const SceneSection& sceneSection(std::string_view name);

/// Whether a word is among words separated by spaces.
[[nodiscard]] bool hasWord(std::string_view words, std::string_view word);

}  // namespace scatter::io
