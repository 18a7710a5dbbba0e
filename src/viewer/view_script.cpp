#include "viewer/view_script.h"

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
  if (verb == "screenshot")
    return named("the file", [](std::string name) { return TakeScreenshot{std::move(name)}; });
  return fail(
      "\"" + verb +
      "\" is no action; known: key, do, set, look, point, move, down, up, wheel, resize, screenshot, close");
}

}  // namespace

Result<ViewScript> ViewScript::parse(std::string_view text, const std::string& source) {
  ViewScript script;
  std::istringstream input{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(input, line); ++number) {
    const auto refuse = [&](const std::string& what) {
      return fail(source + ": line " + std::to_string(number) + ": " + what);
    };
    std::istringstream words(line.substr(0, line.find('#')));
    std::string first;
    if (!(words >> first)) continue;
    std::istringstream digits(first);
    ScriptLine entry;
    if (first.front() == '-' || !(digits >> entry.loop) || !digits.eof()) {
      return refuse("\"" + first + "\" is not the number of a loop");
    }
    if (!script.lines_.empty() && entry.loop < script.lines_.back().loop)
      return refuse("loops may not decrease");
    std::string verb;
    words >> verb;
    auto action = readAction(verb, words);
    if (!action) return refuse(action.error().message);
    if (std::string rest; words >> rest) return refuse("\"" + rest + "\" is too much");
    entry.action = std::move(*action);
    script.lines_.push_back(std::move(entry));
  }
  return script;
}

}  // namespace scatter::viewer
