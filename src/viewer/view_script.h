#pragma once

#include <scatter/lab/hand_script.h>
#include <scatter/math.h>
#include <scatter/result.h>

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "viewer/input.h"

namespace scatter::viewer {

/// Does a command of the help panel by its name.
struct DoCommand {
  std::string name;
};

/// Makes a command that is a switch be on or off.
struct SetCommand {
  std::string name;
  bool on = true;
};

/// What a hand does at the window; a kResize resizes it.
struct DoInput {
  InputEvent event;
};

/// Points at an object of that name, wherever it is in the picture.
struct PointAt {
  std::string object;
};

/// Opens another scene in all worlds.
struct OpenScene {
  std::string name;
};

/// Writes what the window shows.
struct TakeScreenshot {
  std::string file;
};

/// Looks at a point from a direction: degrees to the right and up, metres away.
struct LookFrom {
  Vec3 at{0.0F};
  float right = 0.0F;
  float up = 0.0F;
  float distance = 10.0F;
};

using ScriptAction =
    std::variant<DoCommand, SetCommand, DoInput, PointAt, OpenScene, TakeScreenshot, LookFrom>;

struct ScriptLine {
  std::uint64_t loop = 0;  ///< Of the window: the action is done before that loop's step.
  ScriptAction action;
};

/// What is done to a window in a user's place, and when. A line is a loop's number and an action; what
/// follows a '#' means nothing:
///
///     60 key P                60 do pause               60 set contacts on        60 look 0 0 0 30 -20 60
///     70 move 640 360         71 down left              90 up left                70 point hunter-3
///     80 wheel -2             90 resize 1920 1080       95 screenshot peak.png    99 close
///     96 open telekinesis     97 gather 0 2 0
///
/// The last one is a line of a HandScript, in which bodies have numbers and points are the world's. Its
/// number is that of a frame, as there, so that the hands.txt that a window writes is such a script.
class ViewScript {
 public:
  /// Fails on what is not such a line, and on loops that decrease; the message names `source` and the line.
  [[nodiscard]] static Result<ViewScript> parse(std::string_view text, const std::string& source);

  [[nodiscard]] const std::vector<ScriptLine>& lines() const { return lines_; }
  void add(ScriptLine line) { lines_.push_back(std::move(line)); }

  /// What hands do, by frames.
  [[nodiscard]] const HandScript& hands() const { return hands_; }

 private:
  [[nodiscard]] Result<void> addLine(const std::string& line);

  std::vector<ScriptLine> lines_;
  HandScript hands_;
};

}  // namespace scatter::viewer
