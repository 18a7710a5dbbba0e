#include "viewer/levels_window.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "viewer/palette.h"
#include "viewer/panels/panels.h"
#include "viewer/window_commands.h"

namespace scatter::viewer {
namespace {

constexpr float kTurn = 2.0F * std::numbers::pi_v<float> / 900.0F;  // a step: once in 15 s
constexpr float kApartStep = 0.2F;
constexpr float kMostApart = 2.0F;
constexpr float kOutline = 0.30F;         // alpha
constexpr float kGlow = 0.25F;            // so that colours are told on the side away from the light
constexpr Vec3 kLamp{-0.4F, 0.7F, 1.0F};  // as the camera sees it
constexpr float kTight = 0.9F;            // few models fill the ball around them
constexpr std::size_t kNumberedLevels = 9;

/// "94.9 mm".
std::string lengthText(double metres) {
  const std::array<std::pair<double, const char*>, 3> units{{{1.0, "m"}, {1e-3, "mm"}, {1e-6, "um"}}};
  const auto* unit = std::find_if(units.begin(), units.end() - 1,
                                  [metres](const auto& each) { return metres >= each.first; });
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %s", metres / unit->first, unit->second);
  return text;
}

}  // namespace

LevelsWindow::LevelsWindow(Renderer& renderer, const LevelsViewerDef& def)
    : WindowLoop(renderer, def), def_(def), looks_(def.models.size()) {
  addLevels();
  addLooks();
  addCamera();
  addWindow(switches_, outputs_, commands_);
}

Result<std::unique_ptr<LevelsWindow>> LevelsWindow::create(Renderer& renderer, const LevelsViewerDef& def) {
  std::unique_ptr<LevelsWindow> window(new LevelsWindow(renderer, def));
  if (def.script && !def.script->hands().empty())
    return fail("nothing in a window of levels can be moved by hand");
  if (auto sound = window->script_.check(); !sound) return tl::unexpected(sound.error());
  return window->show(0).map([&] { return std::move(window); });
}

void LevelsWindow::addLevels() {
  commands_.add({"all", "Levels", "all", "All levels side by side", Key::k0, [this] { showLevel({}); },
                 [this] { return !only_; }});
  std::size_t most = 0;
  for (const ShownModel& model : def_.models)
    most = std::max(most, static_cast<std::size_t>(model.levels->count()));
  for (std::size_t i = 0; i < std::min(most, kNumberedLevels); ++i) {
    const std::string number = std::to_string(i + 1);
    commands_.add({"level-" + number, "Levels", number, "Level " + number + " alone",
                   static_cast<Key>(static_cast<std::size_t>(Key::k1) + i), [this, i] { showLevel(i); },
                   [this, i] { return only_ == i; }});
  }
  if (def_.models.size() < 2) return;
  commands_.add({"next-model",
                 "Levels",
                 "next model",
                 "The next model of the file",
                 Key::kN,
                 [this] { showOrClose((model_ + 1) % looks_.size()); },
                 {}});
  commands_.add({"previous-model",
                 "Levels",
                 "previous model",
                 "The model before",
                 Key::kP,
                 [this] { showOrClose((model_ + looks_.size() - 1) % looks_.size()); },
                 {}});
}

void LevelsWindow::addLooks() {
  commands_.add({"apart",
                 "Looks",
                 "apart",
                 "Pull the parts further apart",
                 Key::kPlus,
                 [this] { apart_ = std::min(kMostApart, apart_ + kApartStep); },
                 {}});
  commands_.add({"together",
                 "Looks",
                 "together",
                 "Move the parts closer to where they belong",
                 Key::kMinus,
                 [this] { apart_ = std::max(0.0F, apart_ - kApartStep); },
                 {}});
  commands_.add({"outlines", "Looks", "outlines", "The level's edges around the mesh", Key::kE,
                 [this] { outlines_ = !outlines_; }, [this] { return outlines_; }});
  commands_.add({"one-scale", "Looks", "one scale", "The same colours for the same gap at all levels",
                 Key::kS, [this] { oneScale_ = !oneScale_; }, [this] { return oneScale_; }});
}

void LevelsWindow::addCamera() {
  commands_.add({"turn", "Camera", "turn", "Turn the model around; a drag turns it by hand", Key::kSpace,
                 [this] { turning_ = !turning_; }, [this] { return turning_; }});
  commands_.add({"frame",
                 "Camera",
                 "see all",
                 "Go where the whole model is in the picture",
                 Key::kB,
                 [this] { frame(); },
                 {}});
}

Result<void> LevelsWindow::show(std::size_t model) {
  if (!looks_[model]) {
    auto looks = LevelLooks::create(renderer_, def_.models[model]);
    if (!looks) return tl::unexpected(looks.error());
    looks_[model] = std::move(*looks);
  }
  model_ = model;
  setTitle(def_.models[model].name);
  showLevel({});
  return {};
}

void LevelsWindow::showLevel(std::optional<std::size_t> level) {
  if (level && *level >= static_cast<std::size_t>(model().levels->count())) return;
  only_ = level;
  frame();
}

void LevelsWindow::showOrClose(std::size_t model) {
  if (auto shown = show(model); !shown) close(shown.error().message);
}

Result<void> LevelsWindow::perform(const ScriptAction& action) {
  const auto* input = std::get_if<DoInput>(&action);
  if (input == nullptr) return fail("nothing can be pointed at, nor opened, in a window of levels");
  inject(input->event);
  return {};
}

Result<LevelsViewerReport> LevelsWindow::run() {
  return runLoops().map([this] { return LevelsViewerReport{.loops = loop_.report().loops}; });
}

void LevelsWindow::step() {
  if (turning_) camera_.turn(kTurn, 0.0F);
  if (apart_ == framedApart_) return;
  // What leaves its place stays in the picture.
  camera_.zoom(looks_[model_]->reach(framedApart_) / looks_[model_]->reach(apart_));
  framedApart_ = apart_;
}

void LevelsWindow::frame() {
  framedApart_ = apart_;
  camera_.frame({looks_[model_]->middle(), kTight * looks_[model_]->reach(apart_)}, aspect());
}

Layout LevelsWindow::layout() const {
  return {renderer_.size(), 1, switches_.panels ? &open_ : nullptr};
}

std::vector<LevelsWindow::Cell> LevelsWindow::cells() const {
  const Area all = layout().area(0);
  const bool hasGaps = !model().mesh.triangles.empty();
  const std::size_t first = only_.value_or(0);
  const std::size_t count = only_ ? 1 : static_cast<std::size_t>(model().levels->count());
  // One level has its pictures beside each other.
  const std::size_t columns = hasGaps && count == 1 ? 2 : count;
  const std::size_t rows = hasGaps && count > 1 ? 2 : 1;
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < columns * rows; ++i) {
    const std::size_t row = i / columns;
    const Area area{all.left + all.width * static_cast<float>(i % columns) / static_cast<float>(columns),
                    all.top + all.height * static_cast<float>(row) / static_cast<float>(rows),
                    all.width / static_cast<float>(columns), all.height / static_cast<float>(rows)};
    const bool isGap = hasGaps && (count == 1 ? i == 1 : i >= columns);
    cells.push_back({first + (count == 1 ? 0 : i % columns), isGap, area});
  }
  return cells;
}

float LevelsWindow::aspect() const {
  const Area area = cells().front().area;
  const glm::vec2 window(renderer_.size());
  return area.width * window.x / std::max(1.0F, area.height * window.y);
}

void LevelsWindow::addParts(const LevelLook& look, View& view) const {
  const Vec3 middle = looks_[model_]->middle();
  for (std::size_t i = 0; i < look.parts.size(); ++i) {
    Item item;
    item.mesh = look.parts[i].mesh;
    item.pose.position = look.parts[i].center + apart_ * (look.parts[i].center - middle);
    item.color = distinctColor(i);
    view.items.push_back(item);
  }
}

void LevelsWindow::addGaps(const LevelLook& look, View& view) const {
  Item item;
  item.mesh = oneScale_ ? *look.gapsOnOneScale : *look.gaps;
  item.color = Color(1.0F);
  item.glow = kGlow;
  view.items.push_back(item);
  if (!outlines_) return;
  Item outline;
  outline.mesh = look.whole;
  outline.color = {0.9F, 0.95F, 1.0F, kOutline};
  outline.wireframe = true;
  outline.glow = 1.0F;
  view.items.push_back(outline);
}

View LevelsWindow::view(const Cell& cell) const {
  View view;
  view.area = cell.area;
  view.camera = camera_.camera();
  view.scenery.stars = false;
  // The lamp stays with the camera, so that what is looked at is never in the dark.
  const Vec3 away = glm::normalize(view.camera.target - view.camera.eye);
  const Vec3 right = glm::normalize(glm::cross(away, view.camera.up));
  view.scenery.toLight = kLamp.x * right + kLamp.y * glm::cross(right, away) - kLamp.z * away;
  const LevelLooks& looks = *looks_[model_];
  const LevelLook& look = looks.levels()[cell.level];
  if (cell.isGap) {
    // There nothing is pulled apart.
    view.camera.eye = glm::mix(view.camera.target, view.camera.eye, looks.reach(0.0F) / looks.reach(apart_));
    addGaps(look, view);
  } else {
    addParts(look, view);
  }
  return view;
}

Picture LevelsWindow::picture() {
  Picture picture;
  for (const Cell& cell : cells()) picture.views.push_back(view(cell));
  return picture;
}

void LevelsWindow::showCaption(const Cell& cell) const {
  const LevelLook& look = looks_[model_]->levels()[cell.level];
  char text[160];
  if (cell.isGap) {
    const double percent = 100.0 / looks_[model_]->diagonal();
    std::snprintf(text, sizeof text, "level %zu: gap p95 %.2f %%,\nmax %.2f %%, %s", cell.level + 1,
                  percent * look.measured->p95Gap, percent * look.measured->maxGap,
                  lengthText(look.measured->maxGap).c_str());
  } else {
    std::snprintf(text, sizeof text, "level %zu: %zu part%s", cell.level + 1, look.parts.size(),
                  look.parts.size() == 1 ? "" : "s");
  }
  const Layout place = layout();
  const glm::vec2 corner = glm::vec2(cell.area.left, cell.area.top) * place.window();
  const float inset = 8.0F * place.scale();
  const float row = cell.area.top > 0.0F ? 0.0F : ImGui::GetTextLineHeight();  // under the model's name
  ImGui::GetBackgroundDrawList()->AddText({corner.x + inset, corner.y + inset + row},
                                          IM_COL32(235, 240, 245, 255), text);
  if (cell.isGap) showScale(cell, place.scale());
}

void LevelsWindow::showScale(const Cell& cell, float scale) const {
  const LevelLook& look = looks_[model_]->levels()[cell.level];
  const glm::vec2 window(renderer_.size());
  const float inset = 8.0F * scale;
  const glm::vec2 size(std::min(160.0F * scale, 0.5F * cell.area.width * window.x), 10.0F * scale);
  const float x = cell.area.left * window.x + inset;
  const float top = (cell.area.top + cell.area.height) * window.y - inset - size.y;
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const float letters = top - ImGui::GetTextLineHeight() - 0.25F * inset;
  const std::string end = lengthText(oneScale_ ? looks_[model_]->scaleEnd() : look.scaleEnd);
  list->AddText({x, letters}, IM_COL32(235, 240, 245, 255), "0");
  list->AddText({x + size.x - ImGui::CalcTextSize(end.c_str()).x, letters}, IM_COL32(235, 240, 245, 255),
                end.c_str());
  drawColorBar(*list, {{x, top}, size}, gapColor);
}

void LevelsWindow::showPanels() {
  const Layout place = layout();
  ImGui::GetBackgroundDrawList()->AddText({8.0F * place.scale(), 6.0F * place.scale()},
                                          IM_COL32(255, 255, 255, 255), model().name.c_str());
  for (const Cell& cell : cells()) showCaption(cell);
  if (switches_.help) showHelpPanel(commands_, cameraHelp(), place);
  if (switches_.help || !switches_.panels) return;
  if (beginPanel("Levels", place.time(), false)) {
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::SliderFloat("##apart", &apart_, 0.0F, kMostApart, "parts pulled apart by %.1f");
    for (const char* group : {"Levels", "Looks", "Camera", "Window"}) {
      commandButtons(commands_, group);
      ImGui::SameLine();
    }
    ImGui::TextUnformatted(outputs_.message().c_str());
  }
  ImGui::End();
}

Result<LevelsViewerReport> runLevelsViewer(Renderer& renderer, const LevelsViewerDef& def) {
  return LevelsWindow::create(renderer, def).and_then([](const std::unique_ptr<LevelsWindow>& window) {
    return window->run();
  });
}

}  // namespace scatter::viewer
