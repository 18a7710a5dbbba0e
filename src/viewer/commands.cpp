#include "viewer/commands.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <utility>

namespace scatter::viewer {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(Key::kCount)> kNames{
    "",     "A",     "B",     "C",    "D",     "E",         "F",   "G",   "H",    "I",     "J",   "K",
    "L",    "M",     "N",     "O",    "P",     "Q",         "R",   "S",   "T",    "U",     "V",   "W",
    "X",    "Y",     "Z",     "0",    "1",     "2",         "3",   "4",   "5",    "6",     "7",   "8",
    "9",    "F1",    "F2",    "F3",   "F4",    "F5",        "F6",  "F7",  "F8",   "F9",    "F10", "F11",
    "F12",  "Space", "Enter", "Esc",  "Tab",   "Backspace", "Del", "Ins", "Left", "Right", "Up",  "Down",
    "Home", "End",   "PgUp",  "PgDn", "Shift", "Ctrl",      "Alt", ",",   ".",    "-",     "+"};

bool sameLetters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

void Commands::add(Command command) {
  assert(find(command.name) == nullptr);
  assert(command.key == Key::kNone || find(command.key) == nullptr);
  commands_.push_back(std::move(command));
}

const Command* Commands::find(std::string_view name) const {
  const auto found =
      std::find_if(commands_.begin(), commands_.end(), [&](const Command& c) { return c.name == name; });
  return found == commands_.end() ? nullptr : &*found;
}

const Command* Commands::find(Key key) const {
  if (key == Key::kNone) return nullptr;
  const auto found =
      std::find_if(commands_.begin(), commands_.end(), [&](const Command& c) { return c.key == key; });
  return found == commands_.end() ? nullptr : &*found;
}

std::string_view keyName(Key key) {
  return kNames[static_cast<std::size_t>(key)];
}

Key keyNamed(std::string_view name) {
  for (std::size_t i = 1; i < kNames.size(); ++i) {
    if (sameLetters(kNames[i], name)) return static_cast<Key>(i);
  }
  return Key::kNone;
}

}  // namespace scatter::viewer
