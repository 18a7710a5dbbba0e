#include "viewer/panels/replay_panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <utility>

#include "viewer/panels/frame_plots.h"
#include "viewer/panels/panels.h"

namespace scatter::viewer {
namespace {

// Of a line: more than most panels have pixels, and so few that all lines fit into what Dear ImGui draws at
// once.
constexpr std::size_t kMostValues = 1000;
constexpr std::size_t kMostOthers = 12;
constexpr ImU32 kCurve = IM_COL32(90, 215, 160, 255);

/// Plots of the recording's frame data, all of one time.
class ReplayPlots {
 public:
  ReplayPlots(const ReplayPanels& panels, float scale)
      : panels_(panels),
        recording_(*panels.history.replayed()),
        scale_(scale),
        each_((panels.curves.frames() + kMostValues - 1) / kMostValues) {}

  void show() const {
    PlotDef time = plotOf("physics", "physics_cpu_ms");
    time.height = 100.0F;
    draw(std::move(time), "physics_cpu_ms");
    draw(stagesPlot(values(), {}), "physics_cpu_ms");
    draw(plotOf("manifolds", "manifolds"), "manifolds");
    draw(plotOf("contacts", "contacts"), "contacts");
    draw(plotOf("pairs", "narrowphase_pairs"), "narrowphase_pairs");
    draw(levelsPlot(values(), {}), "narrowphase_pairs");
    chooseChannel();
    if (!panels_.channel.empty()) draw(plotOf(panels_.channel.c_str(), panels_.channel), panels_.channel);
  }

 private:
  [[nodiscard]] ChannelValues values() const {
    return [this](std::string_view channel) { return mostOfEach(panels_.curves.values(channel), each_); };
  }

  [[nodiscard]] PlotDef plotOf(const char* title, std::string_view channel) const {
    PlotDef plot;
    plot.title = title;
    if (const auto found = recording_.info().channel(channel))
      plot.unit = recording_.info().channels[*found].unit;
    plot.lines.push_back({{}, kCurve, values()(channel)});
    return plot;
  }

  /// A click goes to the frame in which `channel` is largest, of those that a value stands for.
  void draw(PlotDef plot, std::string_view channel) const {
    const bool isEmpty =
        std::ranges::all_of(plot.lines, [](const PlotLine& line) { return line.values.empty(); });
    if (isEmpty) return;
    const std::uint64_t first = panels_.time.first();
    plot.time = PlotTime{.values = (panels_.curves.frames() + each_ - 1) / each_,
                         .now = (panels_.time.frame() - first) / each_,
                         .firstFrame = first,
                         .framesEach = each_};
    if (const auto held = drawPlot(plot, scale_))
      panels_.time.show(first + largestFrom(*held * each_, panels_.curves.values(channel)));
  }

  [[nodiscard]] std::size_t largestFrom(std::size_t index, std::span<const float> values) const {
    if (index >= values.size()) return index;
    const auto some = values.subspan(index, std::min(each_, values.size() - index));
    return index + static_cast<std::size_t>(std::max_element(some.begin(), some.end()) - some.begin());
  }

  void chooseChannel() const {
    ImGui::SetNextItemWidth(-1.0F);
    const char* shown = panels_.channel.empty() ? "another curve" : panels_.channel.c_str();
    if (!ImGui::BeginCombo("##channel", shown)) return;
    for (const std::size_t channel : panels_.curves.channels()) {
      const std::string& name = recording_.info().channels[channel].name;
      if (ImGui::Selectable(name.c_str(), name == panels_.channel)) panels_.channel = name;
    }
    ImGui::EndCombo();
  }

  const ReplayPanels& panels_;
  const Recording& recording_;
  float scale_;
  std::size_t each_;  ///< Frames that a value of a plot stands for.
};

std::string textOf(const RecordedChannel& channel, std::uint64_t bits) {
  char text[48];
  if (channel.kind == RecordedKind::kHash) {
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(bits));
  } else {
    const auto value = std::bit_cast<double>(bits);
    const bool isWhole = std::abs(value) < 1e15 && std::nearbyint(value) == value;
    std::snprintf(text, sizeof text, isWhole ? "%.0f %s" : "%.4g %s", value, channel.unit.c_str());
  }
  return text;
}

void showValues(const RecordingInfo& info, const RecordedFrame& frame) {
  if (!ImGui::BeginTable("values", 2)) return;
  for (std::size_t i = 0; i < std::min(info.channels.size(), frame.values.size()); ++i) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", info.channels[i].name.c_str());
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", textOf(info.channels[i], frame.values[i]).c_str());
  }
  ImGui::EndTable();
}

/// What two bodies have with each other in a frame.
struct Meeting {
  int level = 0;  ///< 0: not known.
  int contacts = 0;
  float least = 0.0F;  ///< Distance of the contacts, metres.
};

std::map<BodyId, Meeting> meetingsOf(const RecordedFrame& frame, BodyId body) {
  std::map<BodyId, Meeting> meetings;
  for (const PairLevel& pair : frame.pairs) {
    if (pair.a == body) meetings[pair.b].level = pair.level;
    if (pair.b == body) meetings[pair.a].level = pair.level;
  }
  for (const RecordedContact& contact : frame.contacts) {
    if (contact.a != body && contact.b != body) continue;
    Meeting& meeting = meetings[contact.a == body ? contact.b : contact.a];
    meeting.least = meeting.contacts++ == 0 ? contact.distance : std::min(meeting.least, contact.distance);
  }
  return meetings;
}

/// The inspector's view of one body in one frame.
class PickedBody {
 public:
  PickedBody(const Recording& recording, const RecordedFrame& frame, BodyId body)
      : recording_(recording), frame_(frame), body_(body) {}

  void show(bool knowsContacts) const {
    const std::optional<std::size_t> index = indexIn(frame_);
    if (!index) return ImGui::TextUnformatted("not there in this frame");
    showState(frame_.bodies[*index]);
    showEvents();
    showOthers(knowsContacts);
  }

 private:
  [[nodiscard]] std::optional<std::size_t> indexIn(const RecordedFrame& frame) const {
    const auto found = std::ranges::find(*frame.roster, body_);
    if (found == frame.roster->end()) return std::nullopt;
    return static_cast<std::size_t>(found - frame.roster->begin());
  }

  /// By where it was in the frame before: velocities are not stored.
  [[nodiscard]] std::optional<Vec3> velocity(const Vec3& position) const {
    if (!recording_.has(frame_.number - 1)) return std::nullopt;
    const auto before = recording_.frame(frame_.number - 1);
    const auto index = before ? indexIn(**before) : std::nullopt;
    if (!index) return std::nullopt;
    return (position - (*before)->bodies[*index].pose.position) /
           static_cast<float>(recording_.info().stepSeconds);
  }

  void showState(const RecordedBody& body) const {
    const BodyDef* def = recording_.def(body_);
    if (def != nullptr)
      ImGui::Text("mass %.4g kg%s", static_cast<double>(def->mass), body.asleep ? ", asleep" : "");
    const Vec3& at = body.pose.position;
    ImGui::Text("position %.2f, %.2f, %.2f m", static_cast<double>(at.x), static_cast<double>(at.y),
                static_cast<double>(at.z));
    if (const auto moves = velocity(at)) {
      ImGui::Text("velocity %.2f, %.2f, %.2f m/s", static_cast<double>(moves->x),
                  static_cast<double>(moves->y), static_cast<double>(moves->z));
      ImGui::Text("in all %.2f m/s", static_cast<double>(glm::length(*moves)));
    }
    const auto* levels = def != nullptr ? std::get_if<std::shared_ptr<const LevelSet>>(&def->shape) : nullptr;
    if (levels != nullptr && (*levels)->count() > 1)
      ImGui::Text("level %d of %d", int{body.level}, (*levels)->count());
  }

  void showEvents() const {
    static constexpr std::array<const char*, 5> kTexts{"asks for level", "is heard: level",
                                                       "not safe yet: level", "switches to level",
                                                       "asks no more for level"};
    for (const LevelEvent& event : frame_.events) {
      if (event.body != body_ && event.other != body_) continue;
      std::string text =
          std::string(kTexts[static_cast<std::size_t>(event.kind)]) + " " + std::to_string(event.to);
      const BodyId other = event.body == body_ ? event.other : event.body;
      if (other != BodyId{}) text += " with " + recording_.nameOf(other);
      if (!event.policy.empty()) text += " (" + std::string(event.policy) + ")";
      ImGui::TextUnformatted(text.c_str());
    }
  }

  void showOthers(bool knowsContacts) const {
    const auto meetings = meetingsOf(frame_, body_);
    std::size_t shown = 0;
    for (const auto& [other, meeting] : meetings) {
      if (++shown > kMostOthers) break;
      std::string text = "- " + recording_.nameOf(other);
      if (meeting.level > 0) text += ", level " + std::to_string(meeting.level);
      if (meeting.contacts > 0) {
        char contacts[64];
        std::snprintf(contacts, sizeof contacts, ": %d contact%s, the least distance %.1f mm",
                      meeting.contacts, meeting.contacts == 1 ? "" : "s",
                      1000.0 * static_cast<double>(meeting.least));
        text += contacts;
      }
      ImGui::TextUnformatted(text.c_str());
    }
    if (meetings.size() > kMostOthers) ImGui::Text("and %zu more", meetings.size() - kMostOthers);
    if (!meetings.empty()) return;
    ImGui::TextUnformatted(
        knowsContacts ? "near nothing" : "no contacts are in this recording; --record-contacts stores them");
  }

  const Recording& recording_;
  const RecordedFrame& frame_;
  BodyId body_;
};

}  // namespace

void showReplayNumbers(const ReplayPanels& panels, const Layout& layout) {
  const Place place = layout.numbers(panels.picked.has_value());
  if (beginFoldingPanel("Numbers", place, panels.open.numbers)) {
    ReplayPlots(panels, layout.scale()).show();
    if (!panels.curves.isWhole())
      ImGui::Text("read %llu of %llu frames", static_cast<unsigned long long>(panels.curves.framesRead()),
                  static_cast<unsigned long long>(panels.curves.frames()));
    const Recording& recording = *panels.history.replayed();
    const auto frame = recording.frame(panels.time.frame());
    if (frame && ImGui::CollapsingHeader("All values of this frame")) showValues(recording.info(), **frame);
  }
  ImGui::End();
}

void showReplayInspector(const ReplayPanels& panels, const Layout& layout) {
  if (!panels.picked) return;
  const Recording& recording = *panels.history.replayed();
  const std::string title = recording.nameOf(*panels.picked) + "###picked";
  if (beginPanel(title.c_str(), layout.inspector())) {
    ImGui::PushTextWrapPos(0.0F);
    if (const auto frame = recording.frame(panels.time.frame()))
      PickedBody(recording, **frame, *panels.picked).show(panels.curves.hasContacts());
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
}

}  // namespace scatter::viewer
