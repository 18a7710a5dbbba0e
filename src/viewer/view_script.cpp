#include "viewer/view_script.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "viewer/commands.h"

namespace scatter::viewer {
namespace {

using Kind = InputEvent::Kind;

InputEvent pointer(Kind kind, const glm::vec2& position) {
  InputEvent event;
  event.kind = kind;
  event.position = position;
  return event;
}

Result<ScriptAction> readKey(std::istringstream& words) {
  std::string name;
  words >> name;
  InputEvent event;
  event.kind = Kind::kKeyDown;
  event.key = keyNamed(name);
  if (event.key == Key::kNone) return fail("no key is called \"" + name + "\"; the help panel names them");
  return DoInput{event};
}

Result<ScriptAction> readButton(std::istringstream& words, Kind kind) {
  std::string name;
  words >> name;
  InputEvent event;
  event.kind = kind;
  if (name != "left" && name != "right" && name != "middle") {
    return fail("a mouse button is left, right or middle, not \"" + name + "\"");
  }
  event.button = name == "left"    ? MouseButton::kLeft
                 : name == "right" ? MouseButton::kRight
                                   : MouseButton::kMiddle;
  return DoInput{event};
}

Result<ScriptAction> readPosition(std::istringstream& words, Kind kind) {
  glm::vec2 position(0.0F);
  if (!(words >> position.x >> position.y)) return fail("two numbers of pixels are missing");
  const bool sensible = position.x >= 0.0F && position.y >= 0.0F && position.x < 1e5F && position.y < 1e5F;
  if (!sensible) return fail("pixels are from 0 to 100000");
  return DoInput{pointer(kind, position)};
}

Result<ScriptAction> readWheel(std::istringstream& words) {
  InputEvent event;
  event.kind = Kind::kWheel;
  if (!(words >> event.wheel)) return fail("the number of notches is missing");
  return DoInput{event};
}

Result<ScriptAction> readSet(std::istringstream& words) {
  SetCommand set;
  std::string state;
  words >> set.name >> state;
  if (state != "on" && state != "off") return fail(R"(write "set NAME on" or "set NAME off")");
  set.on = state == "on";
  return set;
}

Result<ScriptAction> readLook(std::istringstream& words) {
  LookFrom look;
  if (!(words >> look.at.x >> look.at.y >> look.at.z >> look.right >> look.up >> look.distance)) {
    return fail("write \"look X Y Z RIGHT UP DISTANCE\": metres, degrees, metres");
  }
  if (!(look.distance > 0.0F)) return fail("the distance must be above 0 m");
  return look;
}

bool isHand(std::string_view verb) {
  const auto known = HandScript::actionNames();
  return std::ranges::find(known, verb) != known.end();
}

std::string allVerbs() {
  std::string names = "key, do, set, look, point, move, down, up, wheel, resize, open, screenshot, close";
  for (const std::string_view hand : HandScript::actionNames()) names += ", " + std::string(hand);
  return names;
}

Result<std::string> readName(std::istringstream& words, const char* what) {
  std::string name;
  if (!(words >> name)) return fail(std::string(what) + " is missing");
  return name;
}

Result<ScriptAction> readAction(const std::string& verb, std::istringstream& words) {
  const auto named = [&](const char* what, auto make) -> Result<ScriptAction> {
    auto name = readName(words, what);
    if (!name) return tl::unexpected(name.error());
    return make(std::move(*name));
  };
  if (verb == "key") return readKey(words);
  if (verb == "down") return readButton(words, Kind::kMouseDown);
  if (verb == "up") return readButton(words, Kind::kMouseUp);
  if (verb == "move") return readPosition(words, Kind::kMouseMove);
  if (verb == "resize") return readPosition(words, Kind::kResize);
  if (verb == "wheel") return readWheel(words);
  if (verb == "set") return readSet(words);
  if (verb == "look") return readLook(words);
  if (verb == "close") return DoInput{pointer(Kind::kClose, {})};
  if (verb == "do") return named("the command", [](std::string name) { return DoCommand{std::move(name)}; });
  if (verb == "point") return named("the object", [](std::string name) { return PointAt{std::move(name)}; });
  if (verb == "open") return named("the scene", [](std::string name) { return OpenScene{std::move(name)}; });
  if (verb == "screenshot")
    return named("the file", [](std::string name) { return TakeScreenshot{std::move(name)}; });
  return fail("\"" + verb + "\" is no action; known: " + allVerbs());
}

}  // namespace

Result<void> ViewScript::addLine(const std::string& line) {
  std::istringstream words(line);
  std::string first;
  std::string verb;
  words >> first >> verb;
  std::istringstream digits(first);
  std::uint64_t number = 0;
  if (first.front() == '-' || !(digits >> number) || !digits.eof())
    return fail("\"" + first + "\" is not the number of a loop");
  if (isHand(verb)) {
    auto action = HandScript::parseAction(line.substr(line.find(verb)));
    if (!action) return fail(action.error().message);
    if (!hands_.empty() && number < hands_.actions().back().frame) return fail("frames may not decrease");
    hands_.add(number, std::move(*action));
    return {};
  }
  if (!lines_.empty() && number < lines_.back().loop) return fail("loops may not decrease");
  auto action = readAction(verb, words);
  if (!action) return tl::unexpected(action.error());
  if (std::string rest; words >> rest) return fail("\"" + rest + "\" is too much");
  lines_.push_back({number, std::move(*action)});
  return {};
}

Result<ViewScript> ViewScript::parse(std::string_view text, const std::string& source) {
  ViewScript script;
  std::istringstream input{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(input, line); ++number) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (const auto added = script.addLine(line); !added)
      return fail(source + ": line " + std::to_string(number) + ": " + added.error().message);
  }
  return script;
}

}  // namespace scatter::viewer
