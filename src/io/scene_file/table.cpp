#include "io/scene_file/table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "io/collada/xml_source.h"
#include "io/nearest_name.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

constexpr std::size_t kLongestText = 1000;
const TomlNode::Table kEmpty{};

std::string listed(const std::vector<std::string_view>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + std::string(words[i]);
  }
  return text;
}

std::string rangeOf(const SceneKey& key) {
  return "from " + formatNumber(key.least, 12) + " to " + formatNumber(key.most, 12) +
         (key.unit.empty() ? "" : " " + std::string(key.unit));
}

}  // namespace

void SceneProblem::report(int line, const std::string& what) {
  if (!error_) error_ = Error{file_ + ":" + std::to_string(line) + ": " + what};
}

SceneTable::SceneTable(const TomlNode& table, std::string_view section, SceneProblem& problem)
    : table_(table.as<TomlNode::Table>()),
      line_(table.line),
      section_(&sceneSection(section)),
      problem_(&problem) {
  if (table_ == nullptr) {
    problem.report(table.line, "expected the table " + std::string(section_->title) + ", not " +
                                   std::string(table.kind()));
    table_ = &kEmpty;
  }
  checkKeys();
}

void SceneTable::checkKeys() const {
  for (const TomlEntry& entry : *table_) {
    if (section_->find(entry.key) != nullptr) continue;
    std::vector<std::string_view> known;
    for (const SceneKey& key : section_->keys) known.push_back(key.name);
    problem_->report(entry.line, "unknown key " + inQuotes(entry.key) + " in " + std::string(title()) +
                                     didYouMean(entry.key, known));
    return;
  }
}

const TomlEntry* SceneTable::find(std::string_view key) const {
  assert(section_->find(key) != nullptr);
  const auto found =
      std::find_if(table_->begin(), table_->end(), [key](const auto& e) { return e.key == key; });
  return found == table_->end() ? nullptr : &*found;
}

int SceneTable::lineOf(std::string_view key) const {
  const TomlEntry* entry = find(key);
  return entry == nullptr ? line_ : entry->line;
}

bool SceneTable::require(std::string_view key) const {
  if (has(key)) return true;
  problem_->report(line_, std::string(title()) + " needs " + inQuotes(key) + ", " +
                              std::string(section_->find(key)->type));
  return false;
}

void SceneTable::reportType(const SceneKey& key, const TomlNode& node) const {
  problem_->report(node.line, inQuotes(key.name) + " in " + std::string(title()) + " must be " +
                                  std::string(key.type) + ", not " + std::string(node.kind()));
}

float SceneTable::number(const SceneKey& key, const TomlNode& node) const {
  double value = 0.0;
  if (const auto* whole = node.as<std::int64_t>()) {
    value = static_cast<double>(*whole);
  } else if (const auto* real = node.as<double>()) {
    value = *real;
  } else {
    reportType(key, node);
  }
  // Written so that a value that is not a number is refused, too.
  if (key.hasRange() && !(value >= key.least && value <= key.most)) {
    problem_->report(node.line, inQuotes(key.name) + " in " + std::string(title()) + " must be " +
                                    rangeOf(key) + ", not " + formatNumber(value, 9));
    return static_cast<float>(key.least);
  }
  return static_cast<float>(value);
}

const TomlNode::Array* SceneTable::array(const SceneKey& key, const TomlNode& node,
                                         std::size_t length) const {
  const auto* array = node.as<TomlNode::Array>();
  if (array == nullptr) {
    reportType(key, node);
  } else if (length > 0 && array->size() != length) {
    problem_->report(node.line, inQuotes(key.name) + " in " + std::string(title()) + " must be " +
                                    std::string(key.type) + ", not a list of " +
                                    std::to_string(array->size()));
    return nullptr;
  }
  return array;
}

Vec3 SceneTable::vector(const SceneKey& key, const TomlNode& node) const {
  const auto* numbers = array(key, node, 3);
  if (numbers == nullptr) return Vec3(0.0F);
  return {number(key, (*numbers)[0]), number(key, (*numbers)[1]), number(key, (*numbers)[2])};
}

void SceneTable::read(std::string_view key, std::string& value) const {
  const TomlEntry* entry = find(key);
  if (entry == nullptr) return;
  const auto* text = entry->node.as<std::string>();
  if (text == nullptr) return reportType(*section_->find(key), entry->node);
  const bool visible = std::none_of(text->begin(), text->end(),
                                    [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
  if (!visible || text->size() > kLongestText) {
    report(key,
           inQuotes(key) + " must be one line of at most " + std::to_string(kLongestText) + " characters");
  }
  value = *text;
}

void SceneTable::read(std::string_view key, bool& value) const {
  const TomlEntry* entry = find(key);
  if (entry == nullptr) return;
  const auto* flag = entry->node.as<bool>();
  if (flag == nullptr) return reportType(*section_->find(key), entry->node);
  value = *flag;
}

void SceneTable::read(std::string_view key, float& value) const {
  if (const TomlEntry* entry = find(key)) value = number(*section_->find(key), entry->node);
}

void SceneTable::read(std::string_view key, Vec3& value) const {
  if (const TomlEntry* entry = find(key)) value = vector(*section_->find(key), entry->node);
}

void SceneTable::read(std::string_view key, Quat& value) const {
  const TomlEntry* entry = find(key);
  if (entry == nullptr) return;
  const SceneKey& info = *section_->find(key);
  const auto* numbers = array(info, entry->node, 4);
  if (numbers == nullptr) return;
  const Quat given(number(info, (*numbers)[0]), number(info, (*numbers)[1]), number(info, (*numbers)[2]),
                   number(info, (*numbers)[3]));
  const float length = glm::length(given);
  if (!(length > 1e-6F && length < 1e12F)) return report(key, inQuotes(key) + " must not be zero");
  value = glm::normalize(given);
}

template <class Value>
void SceneTable::readList(std::string_view key, std::vector<Value>& values,
                          Value (SceneTable::*readOne)(const SceneKey& key, const TomlNode& node)
                              const) const {
  const TomlEntry* entry = find(key);
  if (entry == nullptr) return;
  const SceneKey& info = *section_->find(key);
  const auto* list = array(info, entry->node, 0);
  if (list == nullptr) return;
  for (const TomlNode& node : *list) values.push_back((this->*readOne)(info, node));
}

void SceneTable::read(std::string_view key, std::vector<float>& values) const {
  readList(key, values, &SceneTable::number);
}

void SceneTable::read(std::string_view key, std::vector<Vec3>& values) const {
  readList(key, values, &SceneTable::vector);
}

void SceneTable::readTexts(std::string_view key, std::vector<std::string>& values) const {
  const TomlEntry* entry = find(key);
  if (entry == nullptr) return;
  const SceneKey& info = *section_->find(key);
  if (const auto* text = entry->node.as<std::string>()) {
    values.push_back(*text);
    return;
  }
  const auto* texts = array(info, entry->node, 0);
  if (texts == nullptr) return;
  for (const TomlNode& node : *texts) {
    const auto* text = node.as<std::string>();
    if (text == nullptr) return reportType(info, node);
    values.push_back(*text);
  }
}

std::optional<std::int64_t> SceneTable::whole(std::string_view key) const {
  const TomlEntry* entry = find(key);
  if (entry == nullptr) return std::nullopt;
  const SceneKey& info = *section_->find(key);
  const auto* whole = entry->node.as<std::int64_t>();
  if (whole == nullptr) {
    reportType(info, entry->node);
    return std::nullopt;
  }
  static_cast<void>(number(info, entry->node));
  return problem_->any() ? std::nullopt : std::optional(*whole);
}

void SceneTable::needDirection(std::string_view key, Vec3& direction) const {
  Vec3 given(0.0F);
  need(key, given);
  const float length = glm::length(given);
  if (!(length > 1e-6F))
    return report(key, inQuotes(key) + " in " + std::string(title()) + " must not be zero");
  direction = given / length;
}

std::optional<std::size_t> SceneTable::choose(std::string_view key,
                                              const std::vector<std::string_view>& words) const {
  std::string word;
  read(key, word);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  if (has(key)) {
    report(key, inQuotes(key) + " in " + std::string(title()) + " must be " + listed(words) + ", not " +
                    inQuotes(word));
  }
  return std::nullopt;
}

std::optional<std::size_t> SceneTable::needKind(std::string_view key,
                                                const std::vector<std::string_view>& kinds) const {
  demand(key);
  const auto kind = choose(key, kinds);
  if (kind) keepToKind(key, kinds[*kind]);
  return kind;
}

void SceneTable::keepToKind(std::string_view kindKey, std::string_view kind) const {
  for (const TomlEntry& entry : *table_) {
    const SceneKey* key = section_->find(entry.key);
    if (key == nullptr || key->of.empty() || hasWord(key->of, kind)) continue;
    problem_->report(entry.line, inQuotes(entry.key) + " has no meaning in " + std::string(title()) +
                                     " with " + std::string(kindKey) + " = " + inQuotes(kind) +
                                     "; leave it out");
  }
}

std::string_view SceneTable::oneOf(std::initializer_list<std::string_view> keys, bool required) const {
  std::string_view given;
  for (const std::string_view key : keys) {
    if (!has(key)) continue;
    if (!given.empty()) {
      report(key, std::string(title()) + " has both " + inQuotes(given) + " and " + inQuotes(key) +
                      "; leave one out");
      return given;
    }
    given = key;
  }
  if (given.empty() && required) {
    problem_->report(line_, std::string(title()) + " needs one of " + listed(std::vector(keys)));
  }
  return given;
}

std::optional<SceneTable> SceneTable::table(std::string_view key, std::string_view section) const {
  const TomlEntry* entry = find(key);
  if (entry == nullptr) return std::nullopt;
  if (entry->node.as<TomlNode::Table>() == nullptr) {
    reportType(*section_->find(key), entry->node);
    return std::nullopt;
  }
  return SceneTable(entry->node, section, *problem_);
}

std::vector<SceneTable> SceneTable::tables(std::string_view key, std::string_view section) const {
  std::vector<SceneTable> result;
  const TomlEntry* entry = find(key);
  if (entry == nullptr) return result;
  const auto* list = entry->node.as<TomlNode::Array>();
  if (list == nullptr) {
    reportType(*section_->find(key), entry->node);
    return result;
  }
  for (const TomlNode& node : *list) {
    result.emplace_back(node, section, *problem_);
    if (problem_->any()) break;
  }
  return result;
}

}  // namespace scatter::io
