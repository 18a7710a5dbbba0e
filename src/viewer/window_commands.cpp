#include "viewer/window_commands.h"

#include <array>
#include <string>

namespace scatter::viewer {

void addView(const DebugViewInfo& info, DebugViewSet& views, Commands& commands) {
  static constexpr std::array<Key, kDebugViewCount> kKeys{Key::k1, Key::k2, Key::k3, Key::k4,
                                                          Key::k5, Key::k6, Key::k7, Key::k8,
                                                          Key::k9, Key::k0, Key::kM, Key::kX};
  commands.add({std::string(info.name), "Views", std::string(info.name), std::string(info.shows),
                kKeys[static_cast<std::size_t>(info.view)],
                [&views, view = info.view] { views.toggle(view); },
                [&views, view = info.view] { return views.has(view); }});
}

Shadows usualShadows(const Renderer& renderer) {
  return renderer.isSoftware() ? Shadows::kGround : Shadows::kEverything;
}

void addShadows(Shadows& shadows, Commands& commands) {
  const auto add = [&](const char* where, const char* help, Shadows value) {
    commands.add({"shadows-" + std::string(where), "Shadows", where, help, Key::kNone,
                  [&shadows, value] { shadows = value; }, [&shadows, value] { return shadows == value; }});
  };
  add("off", "No shadows", Shadows::kNothing);
  add("ground", "Shadows on the ground and on floors", Shadows::kGround);
  add("all", "Shadows on everything: bodies shade each other", Shadows::kEverything);
}

void addPanels(WindowSwitches& switches, Commands& commands) {
  commands.add({"help", "Window", "help", "This panel", Key::kF1,
                [&switches] { switches.help = !switches.help; }, [&switches] { return switches.help; }});
  commands.add({"panels", "Window", "panels", "Show or hide all panels", Key::kTab,
                [&switches] { switches.panels = !switches.panels; },
                [&switches] { return switches.panels; }});
}

void addFold(const std::string& panel, Key key, bool& open, Commands& commands) {
  commands.add({panel + "-panel", "Window", "fold " + panel, "Leave only the panel's title, or open it", key,
                [&open] { open = !open; }, [&open] { return !open; }});
}

void addScreenshot(Outputs& outputs, Commands& commands) {
  commands.add({"screenshot",
                "Window",
                "screenshot",
                "Write the window's picture as PNG",
                Key::kF12,
                [&outputs] { outputs.askForScreenshot(); },
                {}});
}

void addFilm(Outputs& outputs, Commands& commands) {
  commands.add({"film", "Window", "film", "Write every picture, for a video", Key::kF11,
                [&outputs] { outputs.setFilming(!outputs.filming()); },
                [&outputs] { return outputs.filming(); }});
}

void addClose(WindowSwitches& switches, Commands& commands) {
  commands.add({"close",
                "Window",
                "close",
                "Close the window",
                Key::kEscape,
                [&switches] { switches.closing = true; },
                {}});
}

void addWindow(WindowSwitches& switches, Outputs& outputs, Commands& commands) {
  addPanels(switches, commands);
  addScreenshot(outputs, commands);
  addFilm(outputs, commands);
  addClose(switches, commands);
}

}  // namespace scatter::viewer
