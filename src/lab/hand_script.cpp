#include <scatter/lab/hand_script.h>

#include "io/numbers.h"
#include "lab/names.h"

#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

namespace scatter {

namespace {

// By index in HandAction.
constexpr std::array<std::string_view, std::variant_size_v<HandAction>> kNames{
    "drag",   "drag-to", "drop",   "push", "throw",   "spawn",  "remove",
    "gather", "release", "freeze", "thaw", "request", "retract"};

// Lists an action's members for whatever writes or reads them, in the order of the text.
template <class Visit>
void visitMembers(DragAction& action, Visit&& visit) {
  visit(action.body);
  visit(action.point);
}
template <class Visit>
void visitMembers(DragToAction& action, Visit&& visit) {
  visit(action.target);
}
template <class Visit>
void visitMembers(DropAction& /*action*/, Visit&& /*visit*/) {}
template <class Visit>
void visitMembers(PushAction& action, Visit&& visit) {
  visit(action.body);
  visit(action.impulse);
  visit(action.point);
}
template <class Visit>
void visitMembers(ThrowAction& action, Visit&& visit) {
  visit(action.model);
  visit(action.from);
  visit(action.through);
  visit(action.speed);
}
template <class Visit>
void visitMembers(SpawnAction& action, Visit&& visit) {
  visit(action.model);
  visit(action.pose.position);
  visit(action.pose.rotation.w);
  visit(action.pose.rotation.x);
  visit(action.pose.rotation.y);
  visit(action.pose.rotation.z);
}
template <class Visit>
void visitMembers(RemoveAction& action, Visit&& visit) {
  visit(action.body);
}
template <class Visit>
void visitMembers(GatherAction& action, Visit&& visit) {
  visit(action.point);
  visit(action.bodies);
}
template <class Visit>
void visitMembers(ReleaseAction& /*action*/, Visit&& /*visit*/) {}
template <class Visit>
void visitMembers(FreezeAction& action, Visit&& visit) {
  visit(action.bodies);
}
template <class Visit>
void visitMembers(ThawAction& action, Visit&& visit) {
  visit(action.bodies);
}
template <class Visit>
void visitMembers(RequestAction& action, Visit&& visit) {
  visit(action.level);
  visit(action.scope);
  visit(action.bodies);
}
template <class Visit>
void visitMembers(RetractAction& action, Visit&& visit) {
  visit(action.bodies);
}

class Writer {
 public:
  explicit Writer(std::string& text) : text_(text) {}

  void operator()(float value) { text_ += ' ' + io::formatNumber(value); }
  void operator()(int value) { text_ += ' ' + std::to_string(value); }
  void operator()(BodyId body) { text_ += ' ' + std::to_string(static_cast<std::uint32_t>(body)); }
  void operator()(Scope scope) { text_ += std::string(1, ' ') + nameOf(scope); }
  void operator()(const Vec3& value) {
    (*this)(value.x);
    (*this)(value.y);
    (*this)(value.z);
  }
  void operator()(const std::vector<BodyId>& bodies) {
    for (const BodyId body : bodies) {
      (*this)(body);
    }
  }

 private:
  std::string& text_;
};

// Takes words from a line; the first that does not fit is kept as what is wrong.
class Reader {
 public:
  explicit Reader(std::string_view& line) : line_(line) {}

  void operator()(float& value) {
    const std::string_view word = take();
    const auto number = io::parseNumber(word);
    if (!number || !std::isfinite(static_cast<float>(*number))) {
      blame(word, "a number");
    } else {
      value = static_cast<float>(*number);
    }
  }
  void operator()(int& value) { value = static_cast<int>(index("a level").value_or(1)); }
  void operator()(BodyId& body) { body = BodyId{index("a body's number").value_or(0)}; }
  void operator()(Scope& scope) {
    const std::string_view word = take();
    for (const Scope known : {Scope::kLocal, Scope::kGroup, Scope::kGlobal}) {
      if (word == nameOf(known)) {
        scope = known;
        return;
      }
    }
    blame(word, "local, group or global");
  }
  void operator()(Vec3& value) {
    (*this)(value.x);
    (*this)(value.y);
    (*this)(value.z);
  }
  void operator()(std::vector<BodyId>& bodies) {
    while (wrong_.empty() && !blank()) {
      (*this)(bodies.emplace_back());
    }
  }

  [[nodiscard]] const std::string& wrong() const { return wrong_; }
  [[nodiscard]] bool blank() const {
    std::string_view rest = line_;
    return io::takeWord(rest).empty();
  }
  void blame(std::string_view word, const char* wanted) {
    if (wrong_.empty()) {
      wrong_ = word.empty() ? std::string("ends where it should have ") + wanted
                            : "has '" + std::string(word) + "' where it should have " + wanted;
    }
  }
  std::string_view take() { return io::takeWord(line_); }

 private:
  std::optional<std::uint32_t> index(const char* wanted) {
    const std::string_view word = take();
    const auto number = io::parseIndex(word);
    if (!number || *number > 0x7FFFFFFFU) {
      blame(word, wanted);
      return std::nullopt;
    }
    return number;
  }

  std::string_view& line_;
  std::string wrong_;
};

template <std::size_t Index = 0>
std::optional<HandAction> actionNamed(std::string_view name) {
  if constexpr (Index < kNames.size()) {
    return name == kNames[Index] ? HandAction(std::in_place_index<Index>) : actionNamed<Index + 1>(name);
  } else {
    return std::nullopt;
  }
}

// Fails with words that follow "line N".
Result<HandAction> readAction(Reader& reader) {
  const std::string_view name = reader.take();
  auto action = actionNamed(name);
  if (!action) {
    std::string known;
    for (const std::string_view candidate : kNames) {
      known += (known.empty() ? "" : ", ") + std::string(candidate);
    }
    return fail("has '" + std::string(name) + "' where it should have one of " + known);
  }
  std::visit([&reader](auto& kind) { visitMembers(kind, reader); }, *action);
  if (reader.wrong().empty() && !reader.blank()) {
    reader.blame(reader.take(), "nothing more");
  }
  if (!reader.wrong().empty()) {
    return fail(reader.wrong());
  }
  return std::move(*action);
}

Result<TimedHandAction> parseLine(std::string_view line) {
  Reader reader(line);
  const std::string_view first = reader.take();
  const auto frame = io::parseIndex(first);
  if (!frame) {
    return fail("has '" + std::string(first) + "' where it should have the number of a frame");
  }
  return readAction(reader).map([&frame](HandAction action) {
    return TimedHandAction{*frame, std::move(action)};
  });
}

}  // namespace

void HandScript::add(std::uint64_t frame, HandAction action) {
  assert(empty() || frame >= actions_.back().frame);
  actions_.push_back({frame, std::move(action)});
}

std::string HandScript::text() const {
  std::string text;
  for (TimedHandAction timed : actions_) {
    text += std::to_string(timed.frame) + ' ';
    text += kNames[timed.action.index()];
    std::visit([&text](auto& action) { visitMembers(action, Writer(text)); }, timed.action);
    text += '\n';
  }
  return text;
}

Result<HandAction> HandScript::parseAction(std::string_view text) {
  Reader reader(text);
  return readAction(reader);
}

std::span<const std::string_view> HandScript::actionNames() {
  return kNames;
}

Result<HandScript> HandScript::parse(std::string_view text, const std::string& source) {
  HandScript script;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    line = line.substr(0, line.find('#'));
    if (std::string_view words = line; io::takeWord(words).empty()) {
      continue;
    }
    auto action = parseLine(line);
    if (action && !script.empty() && action->frame < script.actions_.back().frame) {
      action = fail("goes back to frame " + std::to_string(action->frame) + "; sort the lines by frame");
    }
    if (!action) {
      return fail(source + ": line " + std::to_string(number) + ' ' + action.error().message);
    }
    script.actions_.push_back(std::move(*action));
  }
  return script;
}

}  // namespace scatter
