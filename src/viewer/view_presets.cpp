#include "viewer/view_presets.h"

#include <initializer_list>
#include <string>

namespace scatter::viewer {
namespace {

DebugViewSet setOf(std::initializer_list<DebugView> views) {
  DebugViewSet set;
  for (const DebugView view : views) set.set(view, true);
  return set;
}

}  // namespace

const std::array<ViewPreset, kViewPresetCount>& viewPresets() {
  static const std::array<ViewPreset, kViewPresetCount> kPresets{{
      {"show-plain", "plain", "Bodies as they are; a flash where a level has changed", Key::kF5,
       setOf({DebugView::kMarks})},
      {"show-levels", "levels", "Which levels are in use, of bodies and of pairs", Key::kF6,
       setOf({DebugView::kLevels, DebugView::kPairLevels, DebugView::kMarks})},
      {"show-contacts", "contacts", "Contact points, normals, and what is on penetration credit", Key::kF7,
       setOf({DebugView::kContacts, DebugView::kCredit, DebugView::kSleeping})},
      {"show-cost", "cost", "What bodies and pairs took of the last step", Key::kF8,
       setOf({DebugView::kCost})},
  }};
  return kPresets;
}

void addPresets(DebugViewSet& views, Commands& commands) {
  for (const ViewPreset& preset : viewPresets()) {
    commands.add({std::string(preset.name), "Show", std::string(preset.label), std::string(preset.help),
                  preset.key, [&views, &preset] { views = preset.views; },
                  [&views, &preset] { return views == preset.views; }});
  }
}

}  // namespace scatter::viewer
