#pragma once

#include <scatter/math.h>
#include <scatter/result.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/scene_file/keys.h"
#include "io/scene_file/toml_tree.h"

namespace scatter::io {

/// The first thing that is wrong with a scene file. What is read after it is of no use.
class SceneProblem {
 public:
  explicit SceneProblem(std::string file) : file_(std::move(file)) {}

  /// `what` becomes "FILE:LINE: what"; ignored if something was wrong before.
  void report(int line, const std::string& what);

  [[nodiscard]] bool any() const { return error_.has_value(); }
  [[nodiscard]] const Error& error() const { return *error_; }

 private:
  std::string file_;
  std::optional<Error> error_;
};

/// A table of a scene file, read by its section's keys. Whatever is wrong goes to the SceneProblem: a key
/// that the section does not have, a value of the wrong type or out of range, a key that is missing. What
/// could not be read stays as it was.
class SceneTable {
 public:
  /// `table` and `problem` must outlive this.
  SceneTable(const TomlNode& table, std::string_view section, SceneProblem& problem);

  [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] int lineOf(std::string_view key) const;  ///< That of the table if the key is absent.

  void read(std::string_view key, std::string& value) const;
  void read(std::string_view key, bool& value) const;
  void read(std::string_view key, float& value) const;
  void read(std::string_view key, Vec3& value) const;
  void read(std::string_view key, Quat& value) const;  ///< [w, x, y, z], made a unit quaternion.
  void read(std::string_view key, std::vector<float>& values) const;  ///< Of any length.
  void read(std::string_view key, std::vector<Vec3>& values) const;
  void readTexts(std::string_view key, std::vector<std::string>& values) const;  ///< Or one text.

  template <class Integer>
  void readWhole(std::string_view key, Integer& value) const {
    if (const auto whole = this->whole(key)) value = static_cast<Integer>(*whole);
  }

  template <class Value>
  void read(std::string_view key, std::optional<Value>& value) const {
    if (!has(key)) return;
    value.emplace();
    read(key, *value);
  }

  /// The same, and the key must be there.
  template <class Value>
  void need(std::string_view key, Value& value) const {
    if (require(key)) read(key, value);
  }

  /// A direction of any length but zero, made a unit vector.
  void needDirection(std::string_view key, Vec3& direction) const;

  /// The place of the text `key` among `words`, or none. The message lists them.
  [[nodiscard]] std::optional<std::size_t> choose(std::string_view key,
                                                  const std::vector<std::string_view>& words) const;

  /// The same for a key that must be there and says which other keys may be.
  [[nodiscard]] std::optional<std::size_t> needKind(std::string_view key,
                                                    const std::vector<std::string_view>& kinds) const;

  /// Refuses keys that belong to other kinds than this one.
  void keepToKind(std::string_view kindKey, std::string_view kind) const;

  /// The one of `keys` that is there; refuses two, and none if `required`.
  [[nodiscard]] std::string_view oneOf(std::initializer_list<std::string_view> keys, bool required) const;

  /// The same, for its refusals.
  void checkOneOf(std::initializer_list<std::string_view> keys, bool required) const {
    static_cast<void>(oneOf(keys, required));
  }

  /// The table below `key`, if it is one.
  [[nodiscard]] std::optional<SceneTable> table(std::string_view key, std::string_view section) const;

  /// The tables of the list below `key`.
  [[nodiscard]] std::vector<SceneTable> tables(std::string_view key, std::string_view section) const;

  /// Whether the value of `key` is a list, a text or a table.
  template <class Kind>
  [[nodiscard]] bool is(std::string_view key) const {
    const TomlEntry* entry = find(key);
    return entry != nullptr && entry->node.as<Kind>() != nullptr;
  }

  /// Whether the key is there; refuses if not.
  [[nodiscard]] bool require(std::string_view key) const;
  void demand(std::string_view key) const { static_cast<void>(require(key)); }
  void report(std::string_view key, const std::string& what) const { problem_->report(lineOf(key), what); }
  [[nodiscard]] SceneProblem& problem() const { return *problem_; }
  [[nodiscard]] std::string_view title() const { return section_->title; }

 private:
  [[nodiscard]] const TomlEntry* find(std::string_view key) const;
  [[nodiscard]] std::optional<std::int64_t> whole(std::string_view key) const;
  [[nodiscard]] float number(const SceneKey& key, const TomlNode& node) const;
  [[nodiscard]] Vec3 vector(const SceneKey& key, const TomlNode& node) const;
  [[nodiscard]] const TomlNode::Array* array(const SceneKey& key, const TomlNode& node,
                                             std::size_t length) const;
  template <class Value>
  void readList(std::string_view key, std::vector<Value>& values,
                Value (SceneTable::*readOne)(const SceneKey& key, const TomlNode& node) const) const;
  void reportType(const SceneKey& key, const TomlNode& node) const;
  void checkKeys() const;

  const TomlNode::Table* table_ = nullptr;
  int line_ = 0;
  const SceneSection* section_;
  SceneProblem* problem_;
};

}  // namespace scatter::io
